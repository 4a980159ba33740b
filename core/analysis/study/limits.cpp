#include <core/analysis/study/limits.hpp>

#include <core/mechanics/model/effort.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace pmreport::analysis {

namespace {

// Calls f(column, subject, unit, limit) for every limit that is given.
template <class F>
void each_limit(const Analysis& a, F&& f) {
  const Topology& t = a.machine().topology();
  const mechanics::MotionLimits& limits = a.scenario().limits;
  const auto of = [](const std::vector<double>& list, std::size_t i) { return i < list.size() ? list[i] : mechanics::MotionLimits::none; };
  for (std::size_t i = 0; i < t.actuators.size(); ++i) {
    const Actuator& x = t.actuators[i];
    const std::string name = x.name + " (" + x.title + ")";
    if (std::isfinite(of(limits.force, i)))
      f(column_of(x, OfActuator::dynamic_force), mechanics::word_of_effort(x.sense()) + (" of " + name),
        mechanics::unit_of_effort(x.sense()), limits.force[i]);
    if (std::isfinite(of(limits.speed, i))) f(column_of(x, OfMotion::rate), "speed of " + name, x.unit + "/s", limits.speed[i]);
    if (std::isfinite(of(limits.power, i))) f(column_of(x, OfActuator::power), "power of " + name, "W", limits.power[i]);
  }
  for (std::size_t j = 0; j < t.joints.size(); ++j) {
    const Joint& joint = t.joints[j];
    if (std::isfinite(of(limits.joint_force, j)))
      f(column_of(joint, OfJoint::force), "force in joint " + joint.name, "N", limits.joint_force[j]);
    if (std::isfinite(of(limits.joint_moment, j)) && joint.kind != JointKind::spherical)
      f(column_of(joint, OfJoint::moment), "moment in joint " + joint.name, "N*m", limits.joint_moment[j]);
  }
}

}  // namespace

std::vector<LimitBreach> limit_breaches(const Analysis& a) {
  std::vector<LimitBreach> out;
  if (!a.has_dynamics()) return out;
  each_limit(a, [&](const ColumnId& column, const std::string& subject, const std::string& unit, double limit) {
    LimitBreach b{subject, unit, {}, 0, 0, limit, true, false};
    const std::vector<double>& x = a.column(column);
    for (int k = 0; k < a.samples(); ++k) {
      const double value = std::abs(x[static_cast<std::size_t>(k)]);
      if (!(value > limit * (1 + met_exactly))) continue;
      b.samples.push_back(k);
      if (value > b.value) b.value = value, b.worst = k;
    }
    if (!b.samples.empty()) out.push_back(std::move(b));
  });
  std::stable_sort(out.begin(), out.end(),
                   [](const LimitBreach& x, const LimitBreach& y) { return x.samples.front() < y.samples.front(); });
  return out;
}

LimitCount count_limits(const Analysis& a) {
  std::set<int> missing, broken;
  for (const LimitBreach& b : limit_breaches(a)) broken.insert(b.samples.begin(), b.samples.end());
  if (!a.has_dynamics()) return {0, 0};
  each_limit(a, [&](const ColumnId& column, const std::string&, const std::string&, double) {
    const std::vector<double>& x = a.column(column);
    for (int k = 0; k < a.samples(); ++k)
      if (!std::isfinite(x[static_cast<std::size_t>(k)])) missing.insert(k);
  });
  return {a.samples() - static_cast<int>(missing.size()), static_cast<int>(broken.size())};
}

}  // namespace pmreport::analysis
