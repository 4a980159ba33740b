// The parallel-cross mechanisms, both variants, against a separately derived model (tests/data/parallel-cross.json).
#include <tests/plugins/hexapods.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Vector3d;
using Eigen::VectorXd;
using nlohmann::json;
using test::check_equal;

namespace {

constexpr const char* variants[] = {"cross1", "cross2"};  // inner, outer

}  // namespace

TEST_CASE("every reference case of the parallel-cross mechanisms comes out to nine digits") {
  for (const char* variant : variants) test::check_cases(variant);
}

TEST_CASE("the parallel-cross mechanisms lose a freedom of control at known yaws") {
  // The reference's angles, printed to a hundredth of a degree.
  constexpr double printed = 0.005;  // [deg]
  const auto inner = test::hexapod("cross1"), outer = test::hexapod("cross2");
  CHECK(std::abs(test::singular_yaw(*inner, 20, 30) - 25.80) < printed);
  CHECK(std::abs(test::singular_yaw(*inner, -160, -150) + 154.94) < printed);
  CHECK(std::abs(test::singular_yaw(*outer, 5, 15) - 9.70) < printed);
  CHECK(std::abs(test::singular_yaw(*outer, -175, -165) + 169.97) < printed);
}

TEST_CASE("at a singular yaw of a parallel-cross mechanism all drives stand still while the platform moves") {
  // To first order, so the lengths change by the square of a small motion along the uncontrolled twist, far less than by any other.
  const auto machine = test::hexapod("cross1");
  VectorXd q = machine->home();
  q(3) = test::singular_yaw(*machine, 20, 30) * deg;
  const Pose pose = machine->pose({q.data(), 6});
  Eigen::Matrix<double, 6, 6, Eigen::RowMajor> g;
  machine->jacobian(PM_VALUE, 1, pose.numbers.data(), g.data());
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(g, Eigen::ComputeFullV);
  const VectorXd twist = svd.matrixV().col(5);
  Eigen::Matrix3d axes;  // of alpha, beta, gamma at an upright pose
  axes << Vector3d::UnitZ(), Vector3d(cos(q(3)), sin(q(3)), 0), Vector3d(-sin(q(3)), cos(q(3)), 0);
  VectorXd rates(6);
  rates << twist.head<3>(), axes.inverse() * twist.tail<3>();
  const auto lengths = [&](const VectorXd& at) {
    const Pose p = machine->pose({at.data(), 6});
    return VectorXd(Eigen::Map<const VectorXd>(p.numbers.data() + machine->layout().actuator(0), 6));
  };
  const double step = 1e-4;
  CHECK((lengths(q + step * rates) - lengths(q)).lpNorm<Eigen::Infinity>() < 10 * step * step);
  CHECK((lengths(q + step * VectorXd::Unit(6, 2)) - lengths(q)).lpNorm<Eigen::Infinity>() > 0.5 * step);
}

TEST_CASE("the bodies of the parallel-cross mechanisms have the masses and inertias of the reference") {
  const json file = test::reference("parallel-cross.json"), &bodies = file["bodies"];
  const auto length = [&](const char* of) { return test::number(bodies[of]["L"]); };
  for (const json& c : file["cases"]) {
    const std::string variant = c["mechanism"];
    if (variant != "cross1" && variant != "cross2") continue;
    const auto machine = test::hexapod(variant);
    REQUIRE(machine->topology().bodies.size() == 14);  // the base, and the 13 mobile links of the paper
    // A leg's cylinder reaches from the lowest joint on it to a fixed length beyond A.
    const double lowest = std::min({0.0, test::number(c["geometry"]["l1"]), test::number(c["geometry"]["l2"])});
    for (int i = 1; i <= 3; ++i) {
      const std::string leg = std::to_string(i), cross = std::to_string(3 + i);
      test::check_cylinder(test::body_named(*machine, "leg cylinder " + leg), bodies["leg cylinder"], lowest, length("leg cylinder"));
      test::check_cylinder(test::body_named(*machine, "leg rod " + leg), bodies["leg rod"], -length("leg rod"), 0);
      test::check_cylinder(test::body_named(*machine, "cross cylinder " + cross), bodies["cross cylinder"], 0, length("cross cylinder"));
      test::check_cylinder(test::body_named(*machine, "cross rod " + cross), bodies["cross rod"], -length("cross rod"), 0);
    }
  }
}

TEST_CASE("no chain of the parallel-cross mechanisms spins about itself") {
  const json file = test::reference("parallel-cross.json");
  for (const json& c : file["cases"])
    for (const char* variant : variants)
      if (c["mechanism"] == variant) test::check_spins(c, file["cross_cardan_axis"][variant]);
}

TEST_CASE("the hinge angles of the parallel-cross mechanisms are those between legs and cross chains") {
  for (const json& c : test::reference("parallel-cross.json")["cases"]) {
    const std::string variant = c["mechanism"];
    if (variant != "cross1" && variant != "cross2") continue;
    const auto machine = test::hexapod(variant);
    const State s = test::state_of(*machine, c);
    const auto value = [&](const std::string& name) {
      for (std::size_t i = 0; i < s.derived.size(); ++i)
        if (machine->topology().derived[i].name == name) return s.derived[i].value;
      throw std::out_of_range(name);
    };
    const auto leg = [&](std::size_t i) { return Vector3d(test::vector(c["B_points"][i]) - test::vector(c["A_points"][i])); };
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const Vector3d cross = test::vector3(c["D_points"][i]) - test::vector3(c["C_points"][i]);
      check_equal("hinge at C", value("hinge_c" + std::to_string(i + 1)), test::angle(leg(i), cross));
      check_equal("hinge at D", value("hinge_d" + std::to_string(j + 1)), test::angle(leg(j), cross));
    }
  }
}

TEST_CASE("attachments of one's own replace those of the variant") {
  const pm_mechanism& table = test::plugin("parallel-cross");
  const auto at_home = [&](const std::map<std::string, std::vector<double>>& changes) {
    const Machine machine(table, test::values_with(table, changes));
    return std::vector<double>(machine.home_pose().numbers);
  };
  const double outer = test::choice(table, "variant", "outer");
  CHECK(at_home({{"attachments", {-0.3, -0.75}}}) == at_home({{"variant", {outer}}}));
  CHECK(at_home({{"attachments", {-0.3, -0.75}}}) != at_home({}));
}

TEST_CASE("the parallel-cross mechanisms refuse attachments that make no mechanism") {
  CHECK_THAT(test::refusal("parallel-cross", {{"attachments", {0.2}}}), Catch::Contains("expected l1 and l2"));
  CHECK_THAT(test::refusal("parallel-cross", {{"attachments", {0.2, 0.9}}}), Catch::Contains("leg_cylinder_length"));
  CHECK_THAT(test::refusal("parallel-cross", {{"attachments", {0, 0}}}), Catch::Contains("both zero"));
  CHECK_THAT(test::refusal("parallel-cross", {{"leg_min", {2}}}), Catch::Contains("leg_min must be less than leg_max"));
}
