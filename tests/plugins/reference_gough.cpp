// Gough's platform against a separately derived model (tests/data/parallel-cross.json), and hexapods of other points.
#include <tests/plugins/hexapods.hpp>

#include <random>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::AngleAxisd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using nlohmann::json;
using test::check_equal;

namespace {

std::unique_ptr<Machine> make(const std::map<std::string, std::vector<double>>& changes) {
  const pm_mechanism& table = test::plugin("gough");
  return std::make_unique<Machine>(table, test::values_with(table, changes));
}

VectorXd lengths_at(const Machine& machine, const VectorXd& q) {
  const Pose pose = machine.pose({q.data(), 6});
  REQUIRE(pose.status == PM_OK);
  return Eigen::Map<const VectorXd>(pose.numbers.data() + machine.layout().actuator(0), 6);
}

}  // namespace

TEST_CASE("every reference case of Gough's platform comes out to nine digits") { test::check_cases("gough"); }

TEST_CASE("Gough's platform is singular at a yaw of 90 degrees either way") {
  // Two equal hexagons in parallel planes: a right angle is exact, whatever the pair angles. A double of 90 is good to some 1e-14.
  const auto machine = test::hexapod("gough");
  CHECK(std::abs(test::singular_yaw(*machine, 80, 95) - 90) < 1e-11);
  CHECK(std::abs(test::singular_yaw(*machine, -95, -80) + 90) < 1e-11);
}

TEST_CASE("the bodies of Gough's platform have the masses and inertias of the reference") {
  const json bodies = test::reference("parallel-cross.json")["bodies"];
  const auto machine = test::hexapod("gough");
  REQUIRE(machine->topology().bodies.size() == 14);
  const double disc = test::number(bodies["platform"]["t"]), cylinder = test::number(bodies["leg cylinder"]["L"]),
               rod = test::number(bodies["leg rod"]["L"]);
  test::check_cylinder(test::body_named(*machine, "platform"), bodies["platform"], -disc / 2, disc / 2);
  for (int i = 1; i <= 6; ++i) {
    test::check_cylinder(test::body_named(*machine, "cylinder " + std::to_string(i)), bodies["leg cylinder"], 0, cylinder);
    test::check_cylinder(test::body_named(*machine, "rod " + std::to_string(i)), bodies["leg rod"], -rod, 0);
  }
}

TEST_CASE("a leg of Gough's platform turns about two axes and never spins about itself") {
  // The second axis of the Cardan joint lies across the first, which is tangential to the base circle, and across the leg.
  for (const json& c : test::reference("parallel-cross.json")["cases"]) {
    if (c["mechanism"] != "gough") continue;
    const auto machine = test::hexapod("gough");
    const State s = test::state_of(*machine, c);
    for (std::size_t i = 0; i < 6; ++i) {
      const Vector3d a = test::vector(c["A_points"][i]), u = (test::vector3(c["B_points"][i]) - a).normalized();
      const Vector3d e2 = Vector3d::UnitZ().cross(a).cross(u).normalized();
      for (const char* part : {"cylinder ", "rod "}) {
        const BodyState& body = test::body_state(*machine, s, part + std::to_string(i + 1));
        check_equal("x axis", body.rotation.col(0), e2);
        check_equal("z axis", body.rotation.col(2), u);
      }
    }
  }
}

TEST_CASE("a hexapod of any twelve points has the distances between them for its lengths") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<double> a(18), b(18);
  for (double& x : a) x = 0.5 * unit(random);
  for (double& x : b) x = 0.3 * unit(random);
  const auto machine =
      make({{"base_points", a}, {"platform_points", b}, {"home_position", {0.1, -0.2, 1.1}}, {"home_angles", {0.2, 0.1, -0.3}}});
  CHECK(machine->home() == (VectorXd(6) << 0.1, -0.2, 1.1, 0.2, 0.1, -0.3).finished());
  VectorXd q = machine->home();
  for (int k = 0; k < 20; ++k) {
    const Eigen::Matrix3d r =
        (AngleAxisd(q(3), Vector3d::UnitZ()) * AngleAxisd(q(4), Vector3d::UnitX()) * AngleAxisd(q(5), Vector3d::UnitY()))
            .toRotationMatrix();
    VectorXd expected(6);
    for (int i = 0; i < 6; ++i)
      expected(i) = (q.head<3>() + r * Vector3d(&b[std::size_t(3 * i)]) - Vector3d(&a[std::size_t(3 * i)])).norm();
    check_equal("lengths", lengths_at(*machine, q), expected);
    for (int i = 0; i < 6; ++i) q(i) = machine->home()(i) + 0.4 * unit(random);
  }
}

TEST_CASE("points listed or from circles and angles make the same platform") {
  const json file = test::reference("parallel-cross.json");
  std::vector<double> a, b;
  for (const json& p : file["cases"][0]["A_points"])
    for (const json& x : p) a.push_back(test::number(x));
  for (const json& p : file["cases"][0]["B_points"])  // at home, at a height of 0.95 m
    for (std::size_t k = 0; k < 3; ++k) b.push_back(test::number(p[k]) - (k == 2 ? 0.95 : 0.0));
  const auto listed = make({{"base_points", a}, {"platform_points", b}}), made = test::hexapod("gough");
  const VectorXd q = test::vector(file["cases"][1]["pose"]);
  check_equal("lengths", lengths_at(*listed, q), lengths_at(*made, q));
}

TEST_CASE("a base joint on the axis turns about X and its leg is still placed") {
  std::vector<double> a(18, 0.0), b(18);
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (std::size_t i = 3; i < 18; ++i) a[i] = unit(random);
  for (double& x : b) x = unit(random);
  const auto machine = make({{"base_points", a}, {"platform_points", b}});
  CHECK(machine->axis(machine->home_pose(), test::joint_named(*machine, "A1")) == Vector3d::UnitX());
}

TEST_CASE("Gough's platform refuses points that are not six, and a home without length") {
  CHECK_THAT(test::refusal("gough", {{"base_points", std::vector<double>(17, 0.1)}}),
             Catch::Contains("base_points: expected 18 numbers") && Catch::Contains("seen 17"));
  CHECK_THAT(test::refusal("gough", {{"platform_points", std::vector<double>(3, 0.1)}}),
             Catch::Contains("platform_points: expected 18 numbers"));
  const std::vector<double> same(18, 0.1);
  CHECK_THAT(test::refusal("gough", {{"base_points", same}, {"platform_points", same}, {"home_position", {0, 0, 0}}}),
             Catch::Contains("leg 1 has no length"));
  CHECK_THAT(test::refusal("gough", {{"stroke_min", {1.5}}}), Catch::Contains("stroke_min must be less than stroke_max"));
}
