// Trajectories: sampled, followed, forced, and where singular surfaces end them. The slider-crank and the pendulum have closed forms.
#include <catch2/catch.hpp>

#include <core/mechanics/trajectory/followed.hpp>
#include <core/mechanics/trajectory/forced.hpp>
#include <core/mechanics/trajectory/singular_surface.hpp>
#include <tests/given/slider_crank.hpp>
#include <tests/mechanics/swinging.hpp>

#include <cmath>

using namespace pmreport;
using namespace pmreport::mechanics;
using Catch::Contains;

namespace {

std::unique_ptr<Machine> machine_of(const pm_mechanism& table) { return std::make_unique<Machine>(table, default_values(describe(table))); }

std::vector<double> even(double end, int samples) {
  std::vector<double> out;
  for (int k = 0; k < samples; ++k) out.push_back(end * k / (samples - 1));
  return out;
}

// One coordinate or actuator at a constant rate.
Path straight(double from, double rate) {
  return [=](double t, double* value, double* r, double* acceleration) {
    *value = from + rate * t, *r = rate, *acceleration = 0;
    return true;
  };
}

}  // namespace

TEST_CASE("a path known beforehand is sampled as it is") {
  const Trajectory t = sampled(straight(1, 2), even(3, 4), 1);
  CHECK(t.samples() == 4);
  CHECK(t.value.col(0) == Eigen::Vector4d(1, 3, 5, 7));
  CHECK(t.rate.col(0) == Eigen::Vector4d::Constant(2));
  CHECK(t.ending.empty());
  double q, rate, acceleration;
  REQUIRE(t.at(0.5, &q, &rate, &acceleration));
  CHECK(q == 2);
}

TEST_CASE("what is cut off keeps its first samples in every part") {
  Trajectory t = sampled(straight(1, 2), even(3, 4), 1);
  cut_off(t, 2);
  CHECK(t.time == std::vector<double>{0, 1});
  for (const Eigen::MatrixXd* part : {&t.value, &t.rate, &t.acceleration}) CHECK(part->rows() == 2);
  CHECK(t.value(1, 0) == 3);
}

TEST_CASE("a crank that turns through its dead centre meets a singular surface there, and its samples stay") {
  const auto machine = machine_of(test::slider_crank());
  Trajectory t = sampled(straight(machine->home()(0), -1), even(2, 41), 1);
  const auto met = first_singular_surface(t, *machine);
  REQUIRE(met);
  CHECK(t.time[met->before - 1] < met->time);
  CHECK(t.time[met->before] >= met->time);
  // The slider stands still there: its place turns back.
  const auto slide = [&](double time) {
    const double theta = machine->home()(0) - time;
    return machine->pose({&theta, 1}).numbers[machine->layout().actuator(0)];
  };
  CHECK(std::abs(slide(met->time + 1e-3) - slide(met->time - 1e-3)) < 1e-7);
  CHECK(end_at_singular_surface(t, *machine) == met->before);
  CHECK_THAT(t.ending, Contains("meets a singular surface at t = "));
  CHECK(t.samples() == 41);
  Trajectory short_of_it = sampled(straight(machine->home()(0), -0.01), even(2, 41), 1);
  CHECK(end_at_singular_surface(short_of_it, *machine) == 41);
  CHECK(short_of_it.ending.empty());
}

TEST_CASE("the crank follows its slider at and between the samples, to the dead centre and not beyond") {
  const auto machine = machine_of(test::slider_crank());
  const double home = machine->home_pose().numbers[machine->layout().actuator(0)];
  SmallVector start(1);
  start(0) = machine->home()(0);
  const Followed near = followed(*machine, straight(home, 0.01), even(1, 11), start);
  CHECK(near.outcome == Outcome::good);
  CHECK(near.reached == 11);
  for (const double time : {0.0, 0.333, 1.0}) {
    double theta, rate, acceleration;
    REQUIRE(near.trajectory.at(time, &theta, &rate, &acceleration));
    CHECK(machine->pose({&theta, 1}).numbers[machine->layout().actuator(0)] == Approx(home + 0.01 * time).margin(1e-12));
  }
  const Followed far = followed(*machine, straight(home, 0.2), even(1, 21), start);
  CHECK(far.outcome == Outcome::singular);
  REQUIRE(far.reached < 21);
  CHECK(far.trajectory.reaches(static_cast<int>(far.reached) - 1));
  CHECK_FALSE(far.trajectory.reaches(static_cast<int>(far.reached)));
  CHECK_THAT(far.trajectory.ending, Contains("no longer determine the pose"));
}

TEST_CASE("a pendulum at rest where it hangs stays there, and one with work done on it keeps its energy") {
  const auto machine = machine_of(test::pendulum());
  ForwardProblem p;
  p.actuator_forces = [](double, const std::vector<Scalar>&, double* forces) { *forces = 0.5; };
  p.gravity = {0, 0, -9.81};
  p.start = Eigen::VectorXd::Zero(1);
  p.start_rate = Eigen::VectorXd::Zero(1);
  p.times = even(1, 11);
  const Forced pushed = forced(*machine, p);
  CHECK(pushed.outcome == Outcome::good);
  CHECK(pushed.reached == 11);
  // Work of a constant torque: it times the angle.
  CHECK(pushed.trajectory.work == Approx(0.5 * pushed.trajectory.value(10, 0)).epsilon(1e-8));
  CHECK(pushed.trajectory.energy_drift_share < 1e-8);
  p.actuator_forces = [](double, const std::vector<Scalar>&, double* forces) { *forces = 0; };
  const Forced hanging = forced(*machine, p);
  CHECK(hanging.trajectory.value.cwiseAbs().maxCoeff() < 1e-12);
  CHECK(hanging.trajectory.ending.empty());
}

TEST_CASE("a stroke that ends a motion from forces leaves the samples beyond without a pose") {
  const pm_mechanism& table = test::pendulum();
  ParameterValues values = default_values(describe(table));
  values[1] = {-5};  // lower end of the stroke
  const Machine machine(table, values);
  ForwardProblem p;
  p.actuator_forces = [](double, const std::vector<Scalar>&, double* forces) { *forces = -100; };
  p.start = Eigen::VectorXd::Zero(1);
  p.start_rate = Eigen::VectorXd::Zero(1);
  p.times = even(1, 101);
  // Without gravity the angle is -100 t^2 / (2 I): the stroke's end is met at sqrt(0.1 I).
  const Forced f = forced(machine, p);
  const double end = std::sqrt(0.1 * test::Pendulum::about_hinge);
  CHECK(f.outcome == Outcome::at_limit);
  CHECK(f.reached == static_cast<std::size_t>(end / 0.01) + 1);
  CHECK(f.trajectory.reaches(static_cast<int>(f.reached) - 1));
  CHECK_FALSE(f.trajectory.reaches(static_cast<int>(f.reached)));
  CHECK_THAT(f.trajectory.ending, Contains("ends at t = "));
}
