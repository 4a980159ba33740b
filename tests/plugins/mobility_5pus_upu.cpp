// What lets the 5PUS-UPU move, and where it moves too much: mobility, ranks at singular poses, assembly modes (tests/data/5pus-upu.json).
#include <core/mechanics/mobility/mobility_count.hpp>
#include <core/mechanics/model/closed_form.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/numbers.hpp>
#include <tests/plugins/five_pus_upu.hpp>

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <set>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using nlohmann::json;
using test::check_equal, test::number, test::vector;

namespace {

Machine make_five_pus_upu(const test::Changes& changes = {}) {
  return Machine(test::five_pus_upu(), test::values_with(test::five_pus_upu(), changes));
}

// The lines of the rods with unit forces, and below them the constraint wrench; moments in 60 mm, as the reference has them.
Matrix6d wrenches(const Machine& machine, const VectorXd& pose) {
  Matrix6d w = closed_form(machine, test::state_at(machine, pose), characteristic_length(machine)).jacobian;
  for (int i = 0; i < 5; ++i) w.row(i) /= w.row(i).head(3).norm();
  w.rightCols<3>() /= 0.060;
  return w;
}
int rank(const MatrixXd& m) {
  Eigen::JacobiSVD<MatrixXd> svd(m);
  svd.setThreshold(1e-9);  // the reference's; smallest values are below 1e-15 or above 1e-3
  return static_cast<int>(svd.rank());
}

}  // namespace

TEST_CASE("the 5PUS-UPU has 14 links, 18 joints and five freedoms by 73 independent constraints") {
  const json expected = test::reference("5pus-upu.json")["mobility"];
  const Machine machine = make_five_pus_upu();
  REQUIRE(expected["jacobian_rank"].size() == 2);
  for (const json& at : expected["jacobian_rank"]) {
    const Mobility m = mobility(machine, test::state_at(machine, vector(at[0])));
    CHECK(m.bodies == expected["n"]);
    CHECK(m.joints == expected["g"]);
    CHECK(m.freedoms_sum == expected["sum_f"]);
    CHECK(m.gruebler == expected["gk"]);
    CHECK(m.rank == at[1]);
    CHECK(m.freedoms == at[2]);
    CHECK(m.idle == 0);
    CHECK(m.redundant == 0);
  }
}

TEST_CASE("the ideal constraint leaves five freedoms without redundant constraints") {
  const Machine machine = make_five_pus_upu(test::model("ideal_gamma0"));
  const Mobility m = mobility(machine, test::state_at(machine, (VectorXd(5) << 0.02, -0.035, 0.01, 8 * deg, -6 * deg).finished()));
  CHECK(m.freedoms == 5);
  CHECK(m.idle == 0);
  CHECK(m.redundant == 0);
}

TEST_CASE("rods and constraint of the 5PUS-UPU lose the ranks of the reference at its singular poses") {
  const json all = test::reference("5pus-upu.json")["singularity"];
  REQUIRE(all.size() == 12);
  for (const json& c : all) {
    const std::string name = c["name"];
    DYNAMIC_SECTION(name) {
      test::Changes changes = test::model(c["model"]);
      if (name.starts_with("pentagon")) changes["platform"] = {test::choice(test::five_pus_upu(), "platform", "pentagon")};
      if (name.find("twisted 20deg") != std::string::npos) changes["pentagon_angle"] = {20 * deg};
      const Machine machine = make_five_pus_upu(changes);
      const Pose& home = machine.home_pose();
      for (int i = 0; i < 5; ++i) {  // the platform is the reference's
        const Vector3d s = machine.centre(home, test::joint_named(machine, "S" + std::to_string(i + 1)));
        check_equal("ball", s - machine.origin(home, machine.topology().platform), vector(c["s"][static_cast<std::size_t>(i)]));
      }
      const Matrix6d w = wrenches(machine, vector(c["pose"]));
      const VectorXd expected = vector(c["sv_total"]);
      check_equal("singular values", Eigen::JacobiSVD<MatrixXd>(w).singularValues(), expected, expected(0));
      CHECK(rank(w.topRows(5)) == c["rank_lines"]);
      CHECK(rank(w) == c["rank_total"]);
    }
  }
}

TEST_CASE("singular values along the reference cases of the 5PUS-UPU come out to nine digits") {
  const json file = test::reference("5pus-upu.json");
  for (const json& c : file["cases"]) {
    if (!c.contains("sv_W6_scaled_moment_by_0p06m")) continue;
    CAPTURE(c["name"], c["model"]);
    const Machine machine = make_five_pus_upu(test::model(c["model"]));
    const Matrix6d w = wrenches(machine, vector(c["pose_x_y_z_alpha_beta"]));
    check_equal("singular values", Eigen::JacobiSVD<MatrixXd>(w).singularValues(), vector(c["sv_W6_scaled_moment_by_0p06m"]));
  }
}

TEST_CASE("the rule rank of lines plus one fails beside the singular pose of the 5PUS-UPU") {
  // Beside x = 0, beta = 0 the lines are independent, yet the couple lies in their span: five and five, not five and six. The angle is
  // given to a thousandth of a degree, so that the smallest singular value is merely near zero; bisection on the determinant finds it.
  const Machine machine = make_five_pus_upu(test::model("ideal_gamma0"));
  const auto at = [&](double alpha) { return wrenches(machine, (VectorXd(5) << 0.020, 0, 0, alpha, 0).finished()); };
  double low = -62.6 * deg, high = -62.4 * deg;
  REQUIRE(at(low).determinant() * at(high).determinant() < 0);
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (at(low).determinant() * at(middle).determinant() <= 0 ? high : low) = middle;
  }
  CHECK(std::abs(low - -62.491 * deg) < 0.0005 * deg);
  CHECK(rank(at(low).topRows(5)) == 5);
  CHECK(rank(at(low)) == 5);
}

TEST_CASE("ten assembly modes of the 5PUS-UPU have the same sliders, six of them with every slider above its ball") {
  const json expected = test::reference("5pus-upu.json")["forward_assemblies"];
  const VectorXd q = vector(expected["q"]);
  REQUIRE(expected["all"].size() == 10);
  int above = 0;
  for (const json& pose : expected["all"]) {
    CAPTURE(pose);
    const VectorXd at = vector(pose);
    const Machine any = make_five_pus_upu();  // the balls are where they are, whatever side the sliders take
    const VectorXd s = test::balls(any, test::state_at(any, at));
    test::Changes mode;
    for (int i = 0; i < 5; ++i)
      mode["slider" + std::to_string(i + 1)] = {test::choice(test::five_pus_upu(), "slider1", q(i) > s(3 * i + 2) ? "above" : "below")};
    const Machine machine = make_five_pus_upu(mode);
    const State state = test::state_at(machine, at);
    for (int i = 0; i < 5; ++i) check_equal("slider", state.actuators[static_cast<std::size_t>(i)].value, q(i));
    above += std::all_of(mode.begin(), mode.end(), [](const auto& m) { return m.second[0] == 0; });
  }
  CHECK(above == 6);
  CHECK(expected["sliders_above"].size() == 6);
}

TEST_CASE("the UPU limb turns the platform about Z as its second axis demands, over the whole circle of beta") {
  // a2 stands across both the base's X and the leg, and across the platform's x: three vectors in a plane.
  const Machine machine = make_five_pus_upu();
  int reached = 0;
  for (int k = -17; k <= 18; ++k) {
    if (std::abs(std::abs(k) - 9) < 2) continue;  // beside 90 degrees the limb cannot follow this far from the XZ plane
    const State s = test::state_at(machine, (VectorXd(5) << 0.01, 0.03, -0.02, 0.1, 10 * deg * k).finished());
    const BodyState& platform = s.bodies[static_cast<std::size_t>(machine.topology().platform)];
    const Vector3d leg = platform.origin - Vector3d(0, 0, -0.300);
    CHECK(std::abs(Vector3d::UnitX().cross(leg).dot(platform.rotation.col(0))) < 1e-15);  // [m]: rounding of lengths of 0.3 m
    CHECK(std::cos(s.derived[0].value) > 0);
    ++reached;
  }
  CHECK(reached == 30);
  const Pose lost = machine.pose(std::array{0.01, 0.03, -0.02, 0.1, 88 * deg});
  CHECK(lost.status == PM_UNREACHABLE);
  CHECK(lost.why.find("UPU limb") != std::string::npos);
}

TEST_CASE("the ideal constraint keeps the platform's x axis parallel to the XZ plane") {
  const Machine machine = make_five_pus_upu(test::model("ideal_gamma0"));
  const State s = test::state_at(machine, (VectorXd(5) << 0.01, 0.03, -0.02, 0.1, -5 * deg).finished());
  CHECK(s.bodies[static_cast<std::size_t>(machine.topology().platform)].rotation(1, 0) == 0);
}

TEST_CASE("the 5PUS-UPU refuses a UPU limb without length, and a stroke without extent") {
  const auto refusal = [](const test::Changes& changes) -> std::string {
    try {
      make_five_pus_upu(changes);
    } catch (const MechanismError& e) {
      CHECK(e.status == PM_BAD_ARGUMENT);
      return e.what();
    }
    return "";
  };
  CHECK(refusal({{"h6", {0.010}}}).find("h6 must be 50 mm or more from 0") != std::string::npos);
  CHECK(refusal({{"stroke_min", {0.3}}}).find("stroke_min must be less than stroke_max") != std::string::npos);
  CHECK(refusal({{"rod_length", {0.05}}}).find("a rod is shorter") != std::string::npos);
}
