#include <core/analysis/asked.hpp>

#include <core/analysis/transmission/request.hpp>
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
  const scenario::Needs needs = s.needs();
  Asked out;
  out.displacement_evidence = needs.displacement_evidence;
  out.velocity_evidence = needs.velocity_evidence;
  out.acceleration_evidence = needs.acceleration_evidence;
  out.statics = needs.statics;
  out.forces = needs.dynamics || s.limits.any();
  out.force_evidence = needs.force_evidence;
  out.power_evidence = needs.power_evidence;
  out.drives = needs.drives;
  out.reactions = needs.reactions || bounds(s.limits.joint_force) || bounds(s.limits.joint_moment);
  out.transmission = needs.transmission;
  for (const scenario::Section& section : s.sections)
    if (const auto* request = dynamic_cast<const TransmissionRequest*>(section.options.get()))
      out.transmission_length = request->length.value_or(0);
  out.stiffness = needs.stiffness;
  return out;
}

}  // namespace pmreport::analysis
