#include <core/analysis/asked.hpp>

#include <core/scenario/scenario.hpp>

#include <algorithm>
#include <cmath>

namespace pmreport::analysis {

namespace {

bool bounds(const std::vector<double>& limits) {
  return std::any_of(limits.begin(), limits.end(), [](double x) { return std::isfinite(x); });
}

}  // namespace

Asked asked_by(const scenario::Scenario& s) {
  Asked out;
  out.displacement_evidence = s.asks_for("displacement");
  out.velocity_evidence = s.asks_for("velocity");
  out.acceleration_evidence = s.asks_for("acceleration");
  out.statics = s.asks_for("statics");
  out.drives = s.asks_for("drives");
  out.reactions = s.asks_for("reactions") || bounds(s.limits.joint_force) || bounds(s.limits.joint_moment);
  out.power_evidence = s.asks_for("dynamics");
  out.force_evidence = s.asks_for("dynamics") || s.asks_for("reactions");
  out.forces = s.limits.any() || s.asks_for("dynamics") || s.asks_for("drives") || s.asks_for("reactions") || s.asks_for("speed");
  return out;
}

}  // namespace pmreport::analysis
