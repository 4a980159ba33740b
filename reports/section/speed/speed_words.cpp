#include <reports/section/common/force_plots.hpp>
#include <reports/section/common/words/words.hpp>
#include <reports/section/speed/speed.hpp>

#include <fmt/core.h>

#include <cmath>

namespace pmreport::section {

using Kind = mechanics::SpeedLimit::Kind;
using mechanics::SpeedLimit;

namespace {
double step_of(double x) { return std::pow(10.0, std::floor(std::log10(x)) - 3); }
constexpr double exact = 1e-9;  // of a step: a number that has four digits keeps them
}  // namespace

std::string speed_words(double scale) {
  const double step = step_of(scale);
  return format_number(std::floor(scale / step + exact) * step, 4);
}

std::string duration_words(double seconds) {
  const double step = step_of(seconds);
  return show(std::ceil(seconds / step - exact) * step, "s");
}

std::string brief_subject(const Analysis& a, const SpeedLimit& l) {
  const Topology& t = a.machine().topology();
  const auto i = static_cast<std::size_t>(l.index);
  if (analysis::of_joint(l)) return fmt::format("{} in joint {}", l.kind == Kind::joint_force ? "force" : "moment", t.joints[i].name);
  const Actuator& x = t.actuators[i];
  return fmt::format("{} of {}",
                     l.kind == Kind::actuator_force   ? effort(x.unit)
                     : l.kind == Kind::actuator_speed ? "speed"
                                                      : "power",
                     symbol(x.name));
}

std::string subject(const Analysis& a, const SpeedLimit& l) {
  if (analysis::of_joint(l)) return brief_subject(a, l);
  return fmt::format("{} ({})", brief_subject(a, l), a.machine().topology().actuators[static_cast<std::size_t>(l.index)].title);
}

std::string unit_of(const Analysis& a, const SpeedLimit& l) {
  const Topology& t = a.machine().topology();
  switch (l.kind) {
    case Kind::actuator_force:
      return effort_unit(t.actuators[static_cast<std::size_t>(l.index)].unit);
    case Kind::actuator_speed:
      return t.actuators[static_cast<std::size_t>(l.index)].unit + "/s";
    case Kind::actuator_power:
      return "W";
    case Kind::joint_force:
      return "N";
    case Kind::joint_moment:
      break;
  }
  return "N*m";
}

std::vector<document::Evidence> evidence(const SpeedStudy& study) {
  const auto proof = study.proof();
  if (!proof) return {};
  // Two ways through systems whose condition numbers stay below 1e5 leave ten digits.
  constexpr double tolerance = 1e-9;
  return {
      {"The limit that binds is just met",
       "the motion run that fast, by the system over all bodies with its rates and accelerations: what is asked there against the limit, "
       "relative",
       proof->binding, tolerance, ""},
      {"Every limit is kept", "the same for each limit at the sample that is worst for it: largest excess, relative", proof->excess,
       tolerance, ""}};
}

}  // namespace pmreport::section
