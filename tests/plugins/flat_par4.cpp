// Where the Par4's plate is flat, all four hinges in one line, it may leave the parallelogram: bars turn against each other, and halves
// against each other. Then only couples of the rods hold it. The limbs opposite each other lean alike while the plate is under the middle
// of the base, and so do their couples: a turn of the halves against each other with a tilt of the plate meets none of them.
#include <core/mechanics/model/closed_form.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/reactions/reactions.hpp>
#include <core/numbers.hpp>
#include <tests/plugins/par4.hpp>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <memory>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Vector3d, Eigen::Vector4d;

namespace {

constexpr double flat = 60 * deg;
constexpr double tool_height = -0.75;            // of the tool [m]
constexpr double rounding_of_flat_par4 = 1e-12;  // of singular values up to some 10
constexpr int bodies = 16, idle = 8;

std::unique_ptr<Machine> skew_plate() {
  return std::make_unique<Machine>(test::par4(), test::values_with(test::par4(), {{"plate_angle", {flat}}}));
}

// The plate's middle at (x, y) under the base.
Vector4d pose(const Machine& machine, double x, double y, double theta) {
  return {machine.home()(0) + x, machine.home()(1) + y, tool_height, theta};
}

// Constraints of all bodies, motors locked: singular values, moments over 0.1 m, and the motion that they hinder least beside the rods'
// spins.
struct Locked {
  double least;
  Eigen::VectorXd motion;  // twists of the bodies 1 to 16, rotations times 0.1 m
};
Locked locked(const Machine& machine, const State& s) {
  const GenericModel model = generic_model(machine, s);
  Eigen::MatrixXd all(model.constraints.rows() + model.actuation.rows(), model.constraints.cols());
  all << model.constraints, model.actuation;
  REQUIRE(all.cols() == 6 * bodies);
  for (Eigen::Index c = 0; c < all.cols(); ++c)
    if (c % 6 >= 3) all.col(c) /= 0.1;
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(all, Eigen::ComputeFullV);
  // A spin is a motion of one rod alone; it is taken out of the others.
  const Eigen::Index least = all.cols() - idle - 1;
  return {svd.singularValues()(least), svd.matrixV().col(least)};
}

double largest_force(const Machine& machine, const State& s, const Vector6d& load) {
  const JointReactions r = dense_reactions(machine, s, generic_model(machine, s), JointFrames(machine), {load, Vector3d::Zero()},
                                           characteristic_length(machine));
  REQUIRE_FALSE(r.singular);
  double largest = 0;
  for (const Vector6d& w : r.joints) largest = std::max(largest, w.head<3>().norm());
  return largest;
}

const Vector6d along_x = (Vector6d() << 10, 0, 0, 0, 0, 0).finished();  // [N]

}  // namespace

TEST_CASE("where the Par4's plate is flat its bodies move though all motors stand and its Jacobian is regular") {
  const auto machine = skew_plate();
  const State s = test::par4_at(*machine, pose(*machine, 0, 0, flat));
  const Locked there = locked(*machine, s);
  CHECK(there.least < rounding_of_flat_par4);
  const ClosedForm at_flat = closed_form(*machine, s, characteristic_length(*machine));
  const ClosedForm square = closed_form(*machine, test::par4_at(*machine, pose(*machine, 0, 0, 0)), characteristic_length(*machine));
  CHECK(at_flat.determinant > 0.5 * square.determinant);  // half of what it is where bars stand across
  CHECK(at_flat.condition < 20);

  // Bars turn against each other, and so do the halves. In one line the hinges' speeds across it must agree: 2 a times the bars' share is 2
  // b times the halves', both being half of the difference.
  const auto yaw = [&](const char* name) {
    for (std::size_t i = 1; i < machine->topology().bodies.size(); ++i)
      if (machine->topology().bodies[i].name == name) return there.motion(6 * static_cast<Eigen::Index>(i - 1) + 5);
    throw std::out_of_range(name);
  };
  const test::Par4Sizes sizes;
  CHECK(std::abs(yaw("half 1")) > 0.1);
  CHECK(yaw("half 2") == Approx(-yaw("half 1")).epsilon(1e-9));
  CHECK(yaw("link bar") == Approx(-yaw("tool bar")).epsilon(1e-9));
  CHECK(yaw("tool bar") * sizes.half_bar == Approx(yaw("half 1") * sizes.half_hinges).epsilon(1e-9));
}

TEST_CASE("near a flat plate forces in the Par4's hinges grow as one over the angle that is left") {
  const auto machine = skew_plate();
  const auto at = [&](double left) { return test::par4_at(*machine, pose(*machine, 0, 0, flat - left)); };
  CHECK(locked(*machine, at(1 * deg)).least == Approx(10 * locked(*machine, at(0.1 * deg)).least).epsilon(0.01));
  const double one = largest_force(*machine, at(1 * deg), along_x), tenth = largest_force(*machine, at(0.1 * deg), along_x);
  CHECK(tenth == Approx(10 * one).epsilon(0.01));
  CHECK(tenth > 3000);                                     // under 10 N
  CHECK(largest_force(*machine, at(flat), along_x) < 15);  // with bars at 60 degrees to the hinge lines
}

TEST_CASE("beside the middle the rods' couples differ, and hold the Par4's flat plate") {
  const auto machine = skew_plate();
  const State s = test::par4_at(*machine, pose(*machine, 0, 0.1, flat));
  CHECK(locked(*machine, s).least > 0.01);  // a sixth of what it is where bars stand across
  CHECK(largest_force(*machine, s, along_x) < 50);
}
