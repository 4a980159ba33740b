// What the cones of balls count from: home, or the normal of the socket, as the sources count.
#include <core/mechanics/model/closure.hpp>
#include <core/mechanics/model/random_poses.hpp>
#include <tests/plugins/plugin.hpp>

#include <catch2/catch.hpp>

#include <memory>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Vector3d;

namespace {

constexpr double rounding_of_cosines = 1e-12;  // of cosines

// A ball and the joint at the other end of what its stud belongs to: together they lie on the stud's axis.
struct Ball {
  std::string foot, head;  // joints on the stud, in the direction of its axis
  bool on_platform;        // where the ball's socket is; else the base
  double side = 1;         // of the normal that the cone stands on: 1 along z, -1 against it
};

struct Kind {
  std::string plugin;
  std::map<std::string, std::vector<double>> changes;
  std::vector<Ball> balls;
};

std::vector<Ball> numbered(const std::string& foot, const std::string& head, int count, bool on_platform, double side = 1) {
  std::vector<Ball> out;
  for (int i = 1; i <= count; ++i) out.push_back({foot + std::to_string(i), head + std::to_string(i), on_platform, side});
  return out;
}

std::unique_ptr<Machine> machine_of(const std::string& name, std::map<std::string, std::vector<double>> changes,
                                    const std::string& origin) {
  const pm_mechanism& table = test::plugin(name);
  changes["cones_from"] = {test::choice(table, "cones_from", origin)};
  return std::make_unique<Machine>(table, test::values_with(table, changes));
}

std::vector<Kind> every_kind() {
  const auto below = [] {
    std::map<std::string, std::vector<double>> out;
    for (int i = 1; i <= 5; ++i) out["slider" + std::to_string(i)] = {1};
    return out;
  };
  std::vector<Ball> sps = numbered("A", "B", 5, false);
  for (const Ball& b : numbered("A", "B", 4, true)) sps.push_back(b);
  return {{"gough", {}, numbered("A", "B", 6, true)},
          {"gough", {{"home_position", {0, 0, -0.95}}}, numbered("A", "B", 6, true, -1)},
          {"stewart", {}, numbered("A", "B", 3, false)},
          {"parallel-cross", {}, numbered("A", "B", 3, false)},
          {"parallel-cross", {{"variant", {1}}}, numbered("A", "B", 3, false)},
          {"4sps-spr", {}, sps},
          {"5pus-upu", {}, numbered("U", "S", 5, true, -1)},
          {"5pus-upu", {{"constraint", {1}}}, numbered("U", "S", 5, true, -1)},
          {"5pus-upu", below(), numbered("U", "S", 5, true)},
          {"p2prpu-prps", {}, {{"R11", "S1", true}}}};
}

}  // namespace

TEST_CASE("a cone that counts from the normal bounds the angle between leg and normal") {
  for (const Kind& kind : every_kind()) DYNAMIC_SECTION(kind.plugin << ", " << kind.changes.size() << " changes") {
      const auto machine = machine_of(kind.plugin, kind.changes, "normal");
      const Closure closure(*machine);
      std::vector<Eigen::VectorXd> poses = random_poses(*machine, 20, 17);
      REQUIRE(poses.size() == 20);
      poses.push_back(machine->home());
      for (const Eigen::VectorXd& q : poses) {
        const Pose pose = machine->pose({q.data(), static_cast<std::size_t>(q.size())});
        REQUIRE(pose.status == PM_OK);
        const std::vector<BodyState> bodies = bodies_at_rest(*machine, pose);
        for (const Ball& b : kind.balls) {
          CAPTURE(q.transpose(), b.foot, b.head);
          const int foot = test::joint_named(*machine, b.foot), head = test::joint_named(*machine, b.head);
          const Vector3d along = (machine->centre(pose, head) - machine->centre(pose, foot)).normalized();
          const Vector3d normal = machine->rotation(pose, b.on_platform ? machine->topology().platform : 0).col(2);
          const double seen = closure.motion(bodies, b.on_platform ? head : foot).at(0);
          CHECK(std::abs(std::cos(seen) - b.side * along.dot(normal)) < rounding_of_cosines);
          CHECK((seen >= 0 && seen <= std::numbers::pi));
        }
      }
    }
}

TEST_CASE("left at its default a cone counts from home, where no ball is deflected") {
  for (const Kind& kind : every_kind()) DYNAMIC_SECTION(kind.plugin << ", " << kind.changes.size() << " changes") {
      const pm_mechanism& table = test::plugin(kind.plugin);
      const Machine machine(table, test::values_with(table, kind.changes));
      const std::vector<BodyState> bodies = bodies_at_rest(machine, machine.home_pose());
      const Closure closure(machine);
      for (std::size_t j = 0; j < machine.topology().joints.size(); ++j)
        if (machine.topology().joints[j].kind == JointKind::spherical)
          CHECK(closure.motion(bodies, static_cast<int>(j)).at(0) < 1e-7);  // an angle from a dot product near 1 may know half the digits
    }
}

// Level at the far end of its workspace along X, limb 1 of the paper has its greatest length, 1.49 m, and leans 30 degrees (its Equations
// 16 and 18): x = h + 1.49 m sin 30, z = 1.49 m cos 30. There both limits are met exactly.
TEST_CASE("counted from the normal the ball of the P(2PRPU)/PRPS has the limit of Equation 18 to the letter") {
  const auto exact = machine_of("p2prpu-prps", {}, "normal"), wide = machine_of("p2prpu-prps", {}, "home");
  const int ball = test::joint_named(*exact, "S1");
  const auto limit = [&](const Machine& machine) { return machine.topology().joints[static_cast<std::size_t>(ball)].limits.at(0).max; };
  const double lean = std::numbers::pi / 6, h = 0.24, longest = 1.49;
  CHECK(limit(*exact) == Approx(lean).epsilon(rounding_of_cosines));
  CHECK(limit(*wide) == Approx(lean + std::atan2(0.8 - h, 1.15)).epsilon(rounding_of_cosines));  // home leans by as much the other way

  const auto deflection = [&](double angle) {
    const Eigen::VectorXd q = (Eigen::VectorXd(5) << h + longest * std::sin(angle), 0, longest * std::cos(angle), 0, 0).finished();
    const Pose pose = exact->pose({q.data(), 5});
    REQUIRE(pose.status == PM_OK);
    return Closure(*exact).motion(bodies_at_rest(*exact, pose), ball).at(0);
  };
  CHECK(deflection(lean) == Approx(limit(*exact)).epsilon(rounding_of_cosines));
  CHECK(deflection(lean + 1e-6) > limit(*exact));
  CHECK(deflection(lean - 1e-6) < limit(*exact));
}
