#include <core/analysis/transmission/transmission_numbers.hpp>

#include <core/text/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pmreport::analysis {

namespace {

std::size_t count_of(const mechanics::Machine& m) { return 3 * static_cast<std::size_t>(m.dof()) + m.topology().constraints.size() + 4; }

// "rho4 and rho5 have none: " and the reason of the first.
std::string those_without(const Topology& topology, const std::vector<std::string>& reasons) {
  std::vector<std::string> names;
  std::string first;
  for (std::size_t i = 0; i < reasons.size(); ++i) {
    if (reasons[i].empty()) continue;
    if (names.empty()) first = reasons[i];
    names.push_back(topology.actuators[i].name);
  }
  if (names.empty()) return "";
  return fmt::format("{} {} none of {}: {}", listed(names, "and"), names.size() > 1 ? "have" : "has",
                     names.size() > 1 ? "their own" : "its own", first);
}

}  // namespace

void transmission_numbers(const mechanics::Transmission& t, std::span<const double> coordinates, mechanics::Transmission::Work& work,
                          std::span<double> out) {
  std::ranges::fill(out, std::numeric_limits<double>::quiet_NaN());
  mechanics::TransmissionIndices at;
  if (!t.at(coordinates, work, at)) return;
  const auto dof = static_cast<std::size_t>(t.machine().dof());
  double least_cosine = 1;
  for (std::size_t i = 0; i < dof; ++i) {
    const auto& a = at.actuators[i];
    out[i] = std::acos(a.cosine), out[dof + i] = a.output, out[2 * dof + i] = a.input;
    least_cosine = std::isnan(a.cosine) || std::isnan(least_cosine) ? a.cosine + least_cosine : std::min(least_cosine, a.cosine);
  }
  double* next = &out[3 * dof];
  for (std::size_t i = 0; i < t.machine().topology().constraints.size(); ++i) *next++ = at.constraints[i];
  for (const double x : {at.local, least_cosine, at.conditioning, at.manipulability}) *next++ = x;
}

std::vector<std::string> why_without(const mechanics::Transmission& t) {
  const mechanics::TransmissionPaths& paths = t.paths();
  std::vector<std::string> pressures, outputs;
  for (const mechanics::DrivePath& d : paths.drives) pressures.push_back(d.no_pressure), outputs.push_back(d.no_output);
  std::vector<std::string> out = pressures;
  out.insert(out.end(), outputs.begin(), outputs.end());
  out.insert(out.end(), outputs.begin(), outputs.end());
  for (const mechanics::ConstraintPath& c : paths.constraints) out.push_back(c.none);
  out.push_back(those_without(t.machine().topology(), outputs));
  out.push_back(those_without(t.machine().topology(), pressures));
  out.insert(out.end(), 2, "");
  out.resize(count_of(t.machine()));
  return out;
}

}  // namespace pmreport::analysis
