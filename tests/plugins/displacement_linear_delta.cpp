// The linear Delta against the formula of printers' firmware, and its forces against virtual work by differences.
#include <core/mechanics/displacement/displacement.hpp>
#include <core/numbers.hpp>
#include <tests/plugins/plugin.hpp>

#include <Eigen/LU>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Matrix3d, Eigen::Vector3d;

namespace {

// delta_radius, arm_length and angle of each tower, [m] and [rad].
struct Printer {
  Vector3d radius, rod, angle;
};
constexpr double on_platform = 0.03;

std::vector<double> three(const Vector3d& v, double add = 0) { return {v(0) + add, v(1) + add, v(2) + add}; }

Machine machine_of(const Printer& p, std::map<std::string, std::vector<double>> more = {}) {
  more.insert({{"tower_radii", three(p.radius, on_platform)},
               {"platform_radius", {on_platform}},
               {"rod_lengths", three(p.rod)},
               {"tower_angles", three(p.angle)}});
  const pm_mechanism& table = test::plugin("linear-delta");
  return Machine(table, test::values_with(table, more));
}

// Of firmware: z + sqrt(arm^2 - (tower - nozzle)^2).
Vector3d carriages(const Printer& p, const Vector3d& at, double side = 1) {
  Vector3d out;
  for (int i = 0; i < 3; ++i)
    out(i) = at.z() + side * std::sqrt(std::pow(p.rod(i), 2) - std::pow(p.radius(i) * std::cos(p.angle(i)) - at.x(), 2) -
                                       std::pow(p.radius(i) * std::sin(p.angle(i)) - at.y(), 2));
  return out;
}

const Printer printers[] = {{{0.17475, 0.17475, 0.17475}, {0.333, 0.333, 0.333}, {210 * deg, 330 * deg, 90 * deg}},
                            {{0.1056, 0.1062, 0.1049}, {0.2153, 0.215, 0.2148}, {210.2 * deg, 329.9 * deg, 91 * deg}}};

}  // namespace

TEST_CASE("carriages of the linear Delta stand where printers' firmware has them, above and below") {
  std::mt19937_64 random(30);
  std::uniform_real_distribution<double> side(-0.05, 0.05), height(0, 0.3);
  for (const Printer& p : printers)
    for (const double up : {1.0, -1.0}) {
      const double choice = up > 0 ? 0 : 1;
      const Machine machine = machine_of(p, {{"carriage1", {choice}}, {"carriage2", {choice}}, {"carriage3", {choice}}});
      for (int k = 0; k < 100; ++k) {
        const Vector3d at(side(random), side(random), height(random));
        const Pose pose = machine.pose({at.data(), 3});
        REQUIRE(pose.status == PM_OK);
        const Vector3d expected = carriages(p, at, up);
        CAPTURE(at.transpose());
        for (int i = 0; i < 3; ++i) CHECK(std::abs(pose.numbers[machine.layout().actuator(i)] - expected(i)) < 1e-14);  // [m]: rounding
      }
    }
}

TEST_CASE("forward displacement of the linear Delta finds the nozzle again") {
  std::mt19937_64 random(31);
  std::uniform_real_distribution<double> side(-0.05, 0.05), height(0.05, 0.15);
  for (const Printer& p : printers) {
    const Machine machine = machine_of(p);
    ForwardSolver forward(machine);
    for (int k = 0; k < 50; ++k) {
      const Vector3d at(side(random), side(random), height(random));
      const Eigen::VectorXd s = carriages(p, at);
      const ForwardSolution found = forward.solve(s, machine.home());
      CAPTURE(at.transpose(), found.why);
      REQUIRE(found.outcome == Outcome::good);
      CHECK((found.coordinates - at).norm() < 1e-11);
    }
  }
}

TEST_CASE("what the linear Delta's wrenches carry is what the carriages' ways make of it") {
  const Printer& p = printers[1];
  const Machine machine = machine_of(p);
  const Vector3d at(0.03, -0.02, 0.1);
  const Pose pose = machine.pose({at.data(), 3});
  REQUIRE(pose.status == PM_OK);
  const Jacobian g = machine.jacobian(pose);
  REQUIRE(g.known());
  // ds/dp by central differences of the firmware's formula: 1e-5 m leave some ten digits.
  Matrix3d by_differences;
  constexpr double h = 1e-5;
  for (int k = 0; k < 3; ++k)
    by_differences.col(k) = (carriages(p, at + h * Vector3d::Unit(k)) - carriages(p, at - h * Vector3d::Unit(k))) / (2 * h);
  CHECK((g.matrix.topLeftCorner<3, 3>() - by_differences).norm() < 1e-8);
}

TEST_CASE("a rod that is too short reaches no farther than it is long") {
  const Machine machine = machine_of(printers[0]);
  const double reach = 0.333 - 0.17475;  // away from all towers no more than from the one opposite
  const Vector3d inside(0, -reach + 1e-9, 0.1), beyond(0, -reach - 1e-9, 0.1);
  CHECK(machine.pose({inside.data(), 3}).status == PM_OK);
  CHECK(machine.pose({beyond.data(), 3}).status == PM_UNREACHABLE);
}
