// A workspace told by a tool point is that of the poses which put the tool there.
#include <core/mechanics/workspace/pose_limits.hpp>
#include <core/mechanics/workspace/tool_point.hpp>
#include <core/program/evaluate.hpp>
#include <tests/plugins/every_mechanism.hpp>

#include <catch2/catch.hpp>

#include <random>

using namespace pmreport;
using Eigen::Vector3d;
using mechanics::ToolPoint;

namespace {

const Vector3d r{0.02, -0.03, 0.15};  // [m]

Vector3d tool_at(const mechanics::Machine& m, std::span<const double> q) {
  const mechanics::Pose pose = m.pose(q);
  const int platform = m.topology().platform;
  return m.origin(pose, platform) + m.rotation(pose, platform) * r;
}

}  // namespace

TEST_CASE("poses told by the tool point put it there, with the same orientation and the same margins") {
  int mechanisms = 0, poses = 0;
  for (const test::Named& named : test::every_mechanism()) {
    const mechanics::Machine& machine = *named.machine;
    const auto tool = ToolPoint::of(machine, r);
    if (!tool) continue;
    ++mechanisms;
    const mechanics::PoseMargins margins = mechanics::pose_margins(machine, {}).value();
    const program::Program by_tool = tool->of_tool(margins.program);
    std::mt19937_64 random(91);
    const Eigen::VectorXd home = machine.home();
    for (int k = 0; k < 20; ++k) {
      std::vector<double> q(home.data(), home.data() + home.size());
      for (double& x : q) x += std::uniform_real_distribution(-0.02, 0.02)(random);
      if (machine.pose(q).status != PM_OK) continue;
      ++poses;
      CAPTURE(machine.info().name, k);
      const std::vector<double> t = tool->by_tool(q), back = tool->machine_pose(t);
      const Vector3d at = tool_at(machine, q);
      std::string told;
      for (std::size_t i = 0; i < q.size(); ++i) {
        CHECK(back[i] == Approx(q[i]).margin(1e-14));
        const std::string& name = machine.topology().coordinates[i].name;
        if (const std::size_t c = std::string("xyz").find(name); name.size() == 1 && c < 3) {
          CHECK(t[i] == Approx(at(static_cast<Eigen::Index>(c))).margin(1e-14));
          told += name;
        }
        if (machine.topology().coordinates[i].sense() != Sense::linear) CHECK(t[i] == q[i]);
      }
      CHECK(told == "xyz");
      std::vector<double> plain(margins.program.outputs().size()), moved(plain.size());
      program::Evaluator<double>(margins.program).run(q, plain);
      program::Evaluator<double>(by_tool).run(t, moved);
      for (std::size_t m = 0; m < plain.size(); ++m) CHECK(moved[m] == Approx(plain[m]).margin(1e-12));
    }
  }
  CHECK(mechanisms >= 6);
  CHECK(poses >= 60);
}

TEST_CASE("what is judged pose by pose is judged at the mechanism's own poses") {
  const mechanics::Machine machine(test::plugin("gough"), test::values_with(test::plugin("gough"), {}));
  const ToolPoint tool = ToolPoint::of(machine, r).value();
  std::vector<double> seen;
  const auto judge = tool.of_tool([&](std::size_t count, const double* poses, double*) { seen.assign(poses, poses + 6 * count); });
  const Eigen::VectorXd home = machine.home();
  const std::vector<double> t = tool.by_tool({home.data(), 6});
  std::vector<double> two;
  for (const double x : t) two.insert(two.end(), {x, x});
  judge(2, two.data(), nullptr);
  REQUIRE(seen.size() == 12);
  for (std::size_t i = 0; i < 12; ++i) CHECK(seen[i] == Approx(home(static_cast<Eigen::Index>(i / 2))).margin(1e-14));
}

TEST_CASE("a mechanism whose coordinates do not tell the place of its platform has no tool point to scan") {
  const mechanics::Machine machine(test::plugin("4sps-spr"), test::values_with(test::plugin("4sps-spr"), {}));
  std::string why;
  CHECK_FALSE(ToolPoint::of(machine, r, &why));
  CHECK(why == "the coordinates of 4sps-spr do not tell the place of the platform's reference point");
}
