// What holds for every text, however mad: it is read, or refused with a reason; nothing else is thrown and nothing that is not finite
// passes.
#pragma once

#include <cmath>
#include <core/scenario/loaded.hpp>
#include <reports/section/comparison/comparison.hpp>
#include <reports/section/kinds.hpp>
#include <reports/section/singularity/singularity.hpp>
#include <string>
#include <tests/given/stage.hpp>

namespace fuzz {

// The promise that `text` breaks, or nothing.
inline std::string broken_by_scenario(const std::string& text) {
  using namespace pmreport::scenario;
  try {
    const Loaded loaded = load_text(text, "fuzz.toml", stage::source(), pmreport::section::kinds());
    const pmreport::mechanics::Trajectory& m = loaded.trajectory;
    if (loaded.machine == nullptr) return "a scenario without a machine";
    if (loaded.scenario.motion.has_value() != !m.time.empty()) return "samples without a motion, or a motion without samples";
    if (m.time.size() == 1) return "a motion of one sample";
    for (const Eigen::MatrixXd* part : {&m.value, &m.rate, &m.acceleration}) {
      if (part->rows() != static_cast<Eigen::Index>(m.time.size()) || (!m.time.empty() && part->cols() != loaded.machine->dof()))
        return "a motion of another size";
      if (!part->allFinite() && m.ending.empty()) return "a motion that is not finite, without a reason";
    }
    for (const Eigen::Vector3d& f : loaded.scenario.load.force)
      if (!f.allFinite()) return "a force that is not finite";
    for (const pmreport::mechanics::DriveTrain& d : loaded.scenario.drives)
      if (!(d.efficiency > 0 && d.efficiency <= 1) || !std::isfinite(d.ratio) || d.ratio < 0 || !(d.inertia >= 0) ||
          (d.inertia > 0 && d.ratio == 0))
        return "a drive that cannot be";
    const auto& limits = loaded.scenario.limits;
    for (const auto* list : {&limits.force, &limits.speed, &limits.power, &limits.joint_force, &limits.joint_moment})
      for (const double limit : *list)
        if (!(limit > 0)) return "a limit that nothing can keep";
    if (loaded.scenario.sections.empty()) return "a scenario without sections";
    for (const Check& c : loaded.scenario.checks)
      if (c.columns.empty() == c.quantity.empty() || (!c.below && !c.above)) return "a check of nothing";
    for (const Section& s : loaded.scenario.sections) {
      if (s.kind == nullptr) return "a section of no kind";
      if (const auto* comparison = dynamic_cast<const pmreport::section::ComparisonOptions*>(s.options.get()))
        for (const pmreport::section::ComparisonRow& row : comparison->rows)
          if (row.here.columns.empty() == row.here.quantity.empty() || !std::isfinite(row.published) || !(row.tolerance >= 0))
            return "a comparison of nothing";
      if (const auto* singularity = dynamic_cast<const pmreport::section::SingularityOptions*>(s.options.get())) {
        for (const Eigen::VectorXd& q : singularity->poses)
          if (q.size() != loaded.machine->dof() || !q.allFinite()) return "a pose that is none";
        const auto& map = singularity->map;
        if (map && !(map->from[0] < map->to[0] && map->from[1] < map->to[1])) return "a map of nothing";
      }
    }
  } catch (const ScenarioError& e) {
    if (e.diagnostics.empty()) return "a refusal without a reason";
    for (const Diagnostic& d : e.diagnostics) {
      if (d.message.empty() || d.line < 0 || d.column < 0) return "a reason without words or place";
      for (const char c : to_string(d))
        if (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') return "a control character in a sentence to the user";
    }
  }
  return {};
}

}  // namespace fuzz
