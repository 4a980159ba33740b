// Singularities that the sources state, or that follow from them: ranks of lines and wrenches, yaw angles, mobility.
#include <core/mechanics/mobility/mobility_count.hpp>
#include <core/mechanics/model/random_poses.hpp>
#include <core/mechanics/singularity/singularity.hpp>

#include <core/numbers.hpp>
#include <tests/plugins/plugin.hpp>

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>

using namespace pmreport;
using namespace pmreport::mechanics;

namespace {

struct Expected {
  const char* plugin;
  int freedoms, idle, redundant, rows, rank;
};

Singularity at(const Machine& machine, const Eigen::VectorXd& q, double length) {
  const Mobility home = mobility(machine, state_at_rest(machine, machine.home()));
  const auto s = singularity_at(machine, q, home, length);
  REQUIRE(s.has_value());
  return *s;
}

// The yaw between `low` and `high` at which det G changes its sign, the platform level at (0, 0, z).
double singular_yaw(const Machine& machine, double z, double low, double high) {
  const auto det = [&](double yaw) {
    Eigen::VectorXd q = Eigen::VectorXd::Zero(6);
    q(2) = z, q(3) = yaw;
    return dimensionless_determinant(machine, q, 0.2);
  };
  REQUIRE(det(low) * det(high) < 0);
  for (int k = 0; k < 60; ++k) (det(low) * det(0.5 * (low + high)) > 0 ? low : high) = 0.5 * (low + high);
  return low / deg;
}

}  // namespace

TEST_CASE("mobility is what the sources count, at home and at random poses") {
  const Expected all[] = {{"4sps-spr", 5, 4, 0, 57, 57},      {"2q-spr", 5, 0, 6, 103, 97}, {"5pus-upu", 5, 0, 0, 73, 73},
                          {"p2prpu-prps", 5, 0, 2, 51, 49},   {"gough", 6, 0, 0, 72, 72},   {"stewart", 6, 0, 0, 72, 72},
                          {"parallel-cross", 6, 0, 0, 72, 72}};
  for (const Expected& e : all) DYNAMIC_SECTION(e.plugin) {
      const pm_mechanism& table = test::plugin(e.plugin);
      const Machine machine(table, default_values(describe(table)));
      std::vector<Eigen::VectorXd> poses = random_poses(machine, 20, 51);
      REQUIRE(poses.size() == 20);
      poses.push_back(machine.home());
      for (const Eigen::VectorXd& q : poses) {
        const Mobility m = mobility(machine, state_at_rest(machine, q));
        CHECK(m.freedoms == e.freedoms);
        CHECK(m.idle == e.idle);
        CHECK(m.redundant == e.redundant);
        CHECK(m.rows == e.rows);
        CHECK(m.rank == e.rank);
      }
    }
}

TEST_CASE("the 5PUS-UPU's ranks of lines and wrenches are those of an independent model in its singular poses") {
  std::ifstream file(std::string(TEST_DATA) + "/5pus-upu.json");
  REQUIRE(file);
  const nlohmann::json data = nlohmann::json::parse(file);
  const pm_mechanism& table = test::plugin("5pus-upu");
  int judged = 0;
  for (const auto& c : data.at("singularity")) {
    const std::string name = c.at("name"), model = c.at("model");
    std::map<std::string, std::vector<double>> changes{
        {"constraint", {test::choice(table, "constraint", model == "upu_exact" ? "upu" : "ideal")}},
        {"platform", {test::choice(table, "platform", name.starts_with("pentagon") ? "pentagon" : "improved")}}};
    if (name.find("twisted 20deg") != std::string::npos) changes["pentagon_angle"] = {20 * deg};
    DYNAMIC_SECTION(name) {
      const Machine machine(table, test::values_with(table, changes));
      const std::vector<double> pose = c.at("pose");
      const Singularity s = at(machine, Eigen::Map<const Eigen::VectorXd>(pose.data(), 5), 0.06);
      CHECK(s.ranks.lines == c.at("rank_lines").get<int>());
      CHECK(s.ranks.wrenches == c.at("rank_total").get<int>());
      CHECK(s.freedoms.platform == 6 - c.at("rank_total").get<int>());
      CHECK((s.type == SingularityType::direct) == (s.ranks.wrenches < 6));
    }
    ++judged;
  }
  CHECK(judged >= 12);
}

TEST_CASE("with limbs 3 and 4 in its plane the 5PUS-UPU's platform turns about the line of S1, S2 and S5") {
  const pm_mechanism& table = test::plugin("5pus-upu");
  const Machine machine(table, default_values(describe(table)));
  Eigen::VectorXd q = machine.home();
  q.setZero();
  q(3) = -62.688 * deg;  // as printed: the pose that it means is near
  const auto on = onto_surface(machine, q, 0.06);
  REQUIRE(on.has_value());
  CHECK(on->coordinate == 3);
  const Singularity s = at(machine, on->coordinates, 0.06);
  CHECK(s.ranks.lines == 4);
  CHECK(s.ranks.wrenches == 5);
  const Screw turn = screw_of_twist(s.conditioning.escape, s.freedoms.escapes.origin, 0.06);
  CHECK(std::abs(turn.pitch) < 1e-9);
  for (const char* ball : {"S1", "S2", "S5"})
    CHECK(turn.distance(s.state.joints[static_cast<std::size_t>(test::joint_named(machine, ball))].centre) < 1e-9);
}

TEST_CASE("the improved 5PUS-UPU has the condition number of an independent model at home") {
  const pm_mechanism& table = test::plugin("5pus-upu");
  const Machine machine(table, test::values_with(table, {{"constraint", {test::choice(table, "constraint", "ideal")}}}));
  // Lines and couple as unit rows, moments per 60 mm. G's own rows count slider rates: unit(n) / n_z.
  std::vector<double> placement(machine.layout().size());
  const Eigen::VectorXd q = Eigen::VectorXd::Zero(5);
  double numbers[36];
  machine.place(PM_VALUE, 1, q.data(), placement.data());
  machine.jacobian(PM_VALUE, 1, placement.data(), numbers);
  Matrix6d g = Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>>(numbers);
  for (int i = 0; i < 5; ++i) g.row(i) /= g.row(i).head<3>().norm();
  CHECK(conditioning(machine, g, 0.06).condition() == Approx(6.295).epsilon(1e-4));  // four printed digits
}

TEST_CASE("hexapods level at 0.95 m are singular at the yaw angles of an independent model") {
  const auto machine = [](const char* name) { return Machine(test::plugin(name), default_values(describe(test::plugin(name)))); };
  const Machine gough = machine("gough"), stewart = machine("stewart"), cross = machine("parallel-cross");
  CHECK(singular_yaw(gough, 0.95, 60 * deg, 110 * deg) == Approx(90).epsilon(1e-9));
  CHECK(singular_yaw(gough, 0.95, -110 * deg, -60 * deg) == Approx(-90).epsilon(1e-9));
  CHECK(singular_yaw(stewart, 0.95, -60 * deg, 0) == Approx(-30).epsilon(1e-9));
  CHECK(singular_yaw(cross, 0.95, 0, 60 * deg) == Approx(25.80).margin(0.005));  // two printed decimals
  const pm_mechanism& table = test::plugin("parallel-cross");
  const Machine outer(table, test::values_with(table, {{"variant", {test::choice(table, "variant", "outer")}}}));
  CHECK(singular_yaw(outer, 0.95, 0, 30 * deg) == Approx(9.70).margin(0.005));
}
