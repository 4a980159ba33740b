#include <reports/section/front/surprises.hpp>

#include <core/analysis/study/reduce.hpp>
#include <core/mechanics/model/effort.hpp>
#include <reports/section/common/words/words.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pmreport::section {

using document::Finding;

namespace {

constexpr double out_of_proportion = 5;  // a force of an actuator over the load that asks for it
constexpr double of_the_peak = 0.01;     // a smaller load is none
constexpr double near_by = 0.1;          // of the characteristic length: another assembly

bool has(const document::Report& r, std::string_view kind) {
  return std::ranges::any_of(r.sections, [&](const document::Section& s) { return s.kind == kind; });
}

// The load's share alone: weights and inertia may ask for much and be no surprise. A force asks forces of sliding actuators, a moment
// torques of turning ones; what a lever makes of the other is no proportion.
void add_disproportion(const Analysis& a, const document::Report& r, std::vector<Finding>& out) {
  if (!a.has_dynamics()) return;
  for (const Sense sense : {Sense::linear, Sense::rotary}) {
    const std::vector<Eigen::Vector3d>& load = sense == Sense::linear ? a.scenario().load.force : a.scenario().load.moment;
    const std::vector<Eigen::Vector3d>& other = sense == Sense::linear ? a.scenario().load.moment : a.scenario().load.force;
    const Actuator* whose = nullptr;
    int at = -1;
    double worst = 0, largest = 0;
    for (const Eigen::Vector3d& l : load) largest = std::max(largest, l.norm());
    for (const Actuator& x : a.machine().topology().actuators) {
      const ColumnId column = column_of(x, OfActuator::load_force);
      if (x.sense() != sense || !a.has(column)) continue;
      for (int k = 0; k < a.samples(); ++k) {
        const auto i = static_cast<std::size_t>(k);
        const double size = load[i].norm(), asked = std::abs(a.column(column)[i]);
        if (size > of_the_peak * largest && other[i].norm() == 0 && asked / size > worst) worst = asked / size, whose = &x, at = k;
      }
    }
    if (whose == nullptr || worst < out_of_proportion) continue;
    const auto i = static_cast<std::size_t>(at);
    const std::string unit = mechanics::unit_of_effort(sense);
    std::string text =
        fmt::format("A load of {} asks {} of {} at t = {}, {} times as much", show(load[i].norm(), unit, 3),
                    show(worst * load[i].norm(), unit, 3), symbol(whose->name), show_time(a, at), typeset(format_number(worst, 2)));
    if (const ColumnId condition = column_of(OfMachine::condition); a.has(condition) && std::isfinite(a.column(condition)[i]))
      text += fmt::format(", where the condition number is {}", typeset(format_number(a.column(condition)[i], 3)));
    out.push_back({Finding::Kind::surprise, text + ".", has(r, "dynamics") ? "dynamics" : ""});
  }
}

// "Of the largest torque, 32.2 N·m of θ₁ at t = 0.6 s, 84 % is for inertia, 12 % for the weights, 4 % for the load."
void add_causes(const Analysis& a, const document::Report& r, std::vector<Finding>& out) {
  if (!a.has_dynamics() || !has(r, "dynamics")) return;
  for (const Sense sense : {Sense::linear, Sense::rotary}) {
    const Actuator* whose = nullptr;
    analysis::Peak peak;
    for (const Actuator& x : a.machine().topology().actuators) {
      if (x.sense() != sense) continue;
      const analysis::Peak p = analysis::peak(a, column_of(x, OfActuator::dynamic_force));
      if (p.sample >= 0 && std::abs(p.value) > std::abs(peak.value)) peak = p, whose = &x;
    }
    if (whose == nullptr || peak.value == 0) continue;
    struct Cause {
      const char* words;
      double share;
    };
    const auto share = [&](OfActuator what) {
      return a.column(column_of(*whose, what))[static_cast<std::size_t>(peak.sample)] / peak.value;
    };
    std::array causes{Cause{"inertia", share(OfActuator::inertia_force)}, Cause{"the weights", share(OfActuator::gravity_force)},
                      Cause{"the load", share(OfActuator::load_force)}};
    std::ranges::sort(causes, [](const Cause& x, const Cause& y) { return x.share > y.share; });
    std::vector<std::string> parts;
    for (const Cause& c : causes)
      if (std::abs(c.share) >= 0.005)
        parts.push_back(fmt::format("{} % {}for {}", typeset(fmt::format("{:.0f}", 100 * c.share)), parts.empty() ? "is " : "", c.words));
    if (parts.size() < 2) continue;  // one cause is all of it
    out.push_back({Finding::Kind::result,
                   fmt::format("Of the largest {}, {} of {} at t = {}, {}.", mechanics::word_of_effort(sense),
                               show(std::abs(peak.value), mechanics::unit_of_effort(sense)), symbol(whose->name), show_time(a, peak.sample),
                               fmt::join(parts, ", ")),
                   "dynamics"});
  }
}

void add_assemblies(const Analysis& a, const document::Report& r, std::vector<Finding>& out) {
  const auto value = [&](std::string_view name) {
    for (const document::Value& v : r.values)
      if (v.section == "assembly" && v.name == name) return v.value;
    return std::nan("");
  };
  const double nearest = value("nearest");
  if (!(nearest < near_by * a.length())) return;
  out.push_back({Finding::Kind::surprise,
                 fmt::format("Another pose with the same actuator values is as near as {}.", show(nearest, "m", 3)), "assembly"});
}

}  // namespace

std::vector<Finding> surprises(const Analysis& a, const document::Report& r) {
  std::vector<Finding> out;
  add_disproportion(a, r, out);
  add_assemblies(a, r, out);
  add_causes(a, r, out);
  return out;
}

}  // namespace pmreport::section
