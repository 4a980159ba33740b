// Stewart's platform of 1965 against a separately derived model (tests/data/parallel-cross.json), and against the geometry of its
// singularities.
#include <tests/plugins/hexapods.hpp>

#include <random>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Vector3d;
using Eigen::VectorXd;
using nlohmann::json;
using test::check_equal;

namespace {

// Zero where the planes A1A2B1, A2A3B2, A3A1B3 and B1B2B3 meet in one point (which may be infinitely far); unit normals, metres.
double planes_meet(const Machine& machine, const VectorXd& q) {
  const Pose pose = machine.pose({q.data(), 6});
  const auto at = [&](const char* letter, int i) {
    return machine.centre(pose, test::joint_named(machine, letter + std::to_string(i % 3 + 1)));
  };
  const auto plane = [](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    const Vector3d normal = (b - a).cross(c - a).normalized();
    return Eigen::RowVector4d(normal.x(), normal.y(), normal.z(), -normal.dot(a));
  };
  Eigen::Matrix4d planes;
  for (int i = 0; i < 3; ++i) planes.row(i) = plane(at("A", i), at("A", i + 1), at("B", i));
  planes.row(3) = plane(at("B", 0), at("B", 1), at("B", 2));
  return planes.determinant();
}

double determinant(const Machine& machine, const VectorXd& q) {
  const Pose pose = machine.pose({q.data(), 6});
  Eigen::Matrix<double, 6, 6, Eigen::RowMajor> g;
  machine.jacobian(PM_VALUE, 1, pose.numbers.data(), g.data());
  return g.determinant();
}

}  // namespace

TEST_CASE("every reference case of Stewart's platform comes out to nine digits") { test::check_cases("stewart"); }

TEST_CASE("Stewart's platform is singular at yaws of -30 and 150 degrees") {
  // Symmetry makes both exact; a double of 150 is good to some 3e-14.
  const auto machine = test::hexapod("stewart");
  CHECK(std::abs(test::singular_yaw(*machine, -40, -20) + 30) < 1e-11);
  CHECK(std::abs(test::singular_yaw(*machine, 140, 160) - 150) < 1e-11);
}

TEST_CASE("Stewart's platform is singular exactly where four planes meet in a point") {
  // With its drives locked a leg's head moves on a circle about the line of two base joints, so the drives' forces on it span the plane
  // through that line, and the platform is the octahedral one, whose singularity is that of the four planes. det G and the determinant of
  // the planes must change their signs together.
  const auto machine = test::hexapod("stewart");
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  const double same = determinant(*machine, machine->home()) * planes_meet(*machine, machine->home());
  REQUIRE(std::abs(same) > 1e-6);
  int other_side = 0;
  for (int k = 0; k < 2000; ++k) {
    VectorXd q = machine->home();
    for (int i = 0; i < 3; ++i) q(i) += 0.3 * unit(random);
    q(3) = std::numbers::pi * unit(random);
    for (int i = 4; i < 6; ++i) q(i) = 60 * deg * unit(random);
    const double d = determinant(*machine, q), p = planes_meet(*machine, q);
    CAPTURE(q.transpose(), d, p);
    CHECK((d * p > 0) == (same > 0));
    other_side += d * determinant(*machine, machine->home()) < 0;
  }
  CHECK(other_side > 200);  // both signs were met
  VectorXd q = machine->home();
  q(3) = test::singular_yaw(*machine, -40, -20) * deg;
  CHECK(std::abs(planes_meet(*machine, q)) < 1e-13);
}

TEST_CASE("the bodies of Stewart's platform have the masses and inertias of the reference") {
  const json bodies = test::reference("parallel-cross.json")["bodies"];
  const auto machine = test::hexapod("stewart");
  REQUIRE(machine->topology().bodies.size() == 14);  // the base, and the 13 mobile links of the paper
  const auto length = [&](const char* of) { return test::number(bodies[of]["L"]); };
  const double disc = test::number(bodies["platform"]["t"]);
  test::check_cylinder(test::body_named(*machine, "platform"), bodies["platform"], -disc / 2, disc / 2);
  for (const std::string kind : {"leg", "cross"})
    for (int i = 1; i <= 3; ++i) {
      const std::string n = std::to_string(kind == "leg" ? i : 3 + i), cylinder = kind + " cylinder", rod = kind + " rod";
      test::check_cylinder(test::body_named(*machine, cylinder + " " + n), bodies[cylinder], 0, length(cylinder.c_str()));
      test::check_cylinder(test::body_named(*machine, rod + " " + n), bodies[rod], -length(rod.c_str()), 0);
    }
}

TEST_CASE("no chain of Stewart's platform spins about itself") {
  const json file = test::reference("parallel-cross.json");
  for (const json& c : file["cases"])
    if (c["mechanism"] == "stewart") test::check_spins(c, file["cross_cardan_axis"]["stewart"]);
}

TEST_CASE("the hinge angle of Stewart's platform is that between leg and cross chain") {
  for (const json& c : test::reference("parallel-cross.json")["cases"]) {
    if (c["mechanism"] != "stewart") continue;
    const auto machine = test::hexapod("stewart");
    const State s = test::state_of(*machine, c);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto at = [&](const char* letter) { return Vector3d(test::vector(c[letter][i])); };
      CHECK(machine->topology().derived[i].name == "hinge_d" + std::to_string(i + 1));
      check_equal("hinge", s.derived[i].value, test::angle(at("B_points") - at("A_points"), at("D_points") - at("C_points")));
    }
  }
}

TEST_CASE("Stewart's platform refuses an attachment that no drive can use") {
  CHECK_THAT(test::refusal("stewart", {{"attachment", {0}}}), Catch::Contains("attachment must be more than zero"));
  CHECK_THAT(test::refusal("stewart", {{"attachment", {0.8}}}), Catch::Contains("leg_cylinder_length"));
  CHECK_THAT(test::refusal("stewart", {{"cross_min", {1}}}), Catch::Contains("cross_min must be less than cross_max"));
}
