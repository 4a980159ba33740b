#include <tests/proof/at_an_instant.hpp>
#include <tests/proof/attack.hpp>

#include <core/mechanics/model/closure.hpp>
#include <core/mechanics/model/overall_jacobian.hpp>

#include <random>

namespace pmreport::test {

using namespace analysis;

std::vector<std::string> contradictions_by_plugin(const mechanics::Machine& machine, const MotionProof& proof, const Law& law, int instants,
                                                  unsigned seed) {
  constexpr double tolerance = 1e-9;  // of the plugin's doubles, and of angles near zero, where a cosine tells half of the digits
  std::vector<std::string> out;
  if (!proof.unexamined.empty()) return out;
  const Topology& topology = machine.topology();
  const mechanics::Closure closure(machine);
  const std::size_t dof = static_cast<std::size_t>(machine.dof());
  std::vector<Number> q(3 * dof);
  int side = 0;
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> anywhere(proof.begin, proof.end);
  const auto against_bracket = [&](const ColumnId& column, double x, double t) {
    const Extreme* e = proof.extreme(column);
    if (e != nullptr && (x < e->least.low - tolerance || x > e->largest.high + tolerance))
      out.push_back(fmt::format("{} is {} at {} s by the plugin", column.name(), x, t));
  };
  for (int k = 0; k < instants && out.size() < most_told_of_attacks; ++k) {
    const double t = anywhere(random);
    law(t, q.data(), q.data() + dof, q.data() + 2 * dof);
    std::vector<double> coordinates(q.begin(), q.begin() + static_cast<std::ptrdiff_t>(dof));
    const mechanics::Pose pose = machine.pose(coordinates);
    const Claim& assembled = proof.claims.front();
    if (pose.status != PM_OK) {
      if (!doubtful(assembled, t) && certainly_broken(assembled, t) == nullptr)
        out.push_back(fmt::format("the plugin has no pose at {} s", t));
      continue;
    }
    if (certainly_broken(assembled, t) != nullptr) out.push_back(fmt::format("the plugin has a pose at {} s", t));
    if (doubtful(assembled, t)) continue;
    const auto bodies = mechanics::bodies_at_rest(machine, pose);
    for (const Claim& c : proof.claims) {
      if (c.state == Claim::State::unexamined) continue;
      const auto i = static_cast<std::size_t>(c.index);
      double x = 0;
      if (c.about == Claim::About::stroke)
        x = pose.numbers[machine.layout().actuator(c.index)], against_bracket(column_of(topology.actuators[i]), x, t);
      else if (c.about == Claim::About::joint_limit)
        x = closure.motion(bodies, c.index)[static_cast<std::size_t>(c.limit)],
        against_bracket(joint_column(topology.joints[i], static_cast<std::size_t>(c.limit)), x, t);
      else
        continue;
      if (const std::string s = against(c, t, x, tolerance); !s.empty()) out.push_back("by the plugin a claim is " + s);
    }
    // Proved regular throughout, the plugin's own G has the sign that it has in the beginning.
    const Claim& regular = proof.claims.back();
    if (regular.about == Claim::About::regular && regular.state == Claim::State::holds && assembled.state == Claim::State::holds) {
      const int now = mechanics::side_of(machine.jacobian(pose).matrix, 1);
      if (side == 0) side = now;
      if (now * side < 0) out.push_back(fmt::format("det G by the plugin changes its sign before {} s", t));
    }
  }
  return out;
}

}  // namespace pmreport::test
