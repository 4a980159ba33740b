#include <core/analysis/breaches.hpp>

#include <core/analysis/columns.hpp>
#include <core/mechanics/machine/joint_words.hpp>
#include <core/mechanics/model/joint_motion.hpp>

#include <algorithm>
#include <cmath>

namespace pmreport::analysis {

std::vector<LimitBreach> find_breaches(const Topology& t, const ColumnStore& columns) {
  std::vector<LimitBreach> out;
  const auto look = [&](const ColumnId& column, const std::string& subject, const std::string& unit, const Range& range, bool stroke) {
    for (const bool above : {false, true}) {
      LimitBreach b{subject, unit, {}, 0, 0, above ? range.max : range.min, above, stroke};
      double worst = 0;
      const std::vector<double>& x = columns[column];
      // A limit that is met exactly is kept: rounding may not break it.
      const double slack = 1e-12 * std::max({1.0, std::abs(range.min), std::abs(range.max)});
      for (int k = 0; k < static_cast<int>(x.size()); ++k) {
        const double value = x[static_cast<std::size_t>(k)], excess = above ? value - range.max : range.min - value;
        if (!(excess > slack)) continue;
        b.samples.push_back(k);
        if (excess > worst) worst = excess, b.worst = k, b.value = value;
      }
      if (!b.samples.empty()) out.push_back(b);
    }
  };
  for (const Actuator& a : t.actuators) look(column_of(a), a.name + " (" + a.title + ")", a.unit, a.stroke, true);
  for (const Joint& j : t.joints) {
    const std::string subject = "joint " + j.name + (j.from.isZero() ? "" : " (from " + mechanics::origin_of(t, j) + ")");
    for (std::size_t i = 0; i < j.limits.size(); ++i)
      if (mechanics::is_told(j, i)) look(joint_column(j, i), subject, mechanics::motion_unit(j), j.limits[i], false);
  }
  return out;
}

std::vector<SampleRun> broken_runs(const std::vector<LimitBreach>& breaches, int samples) {
  std::vector<bool> bad(static_cast<std::size_t>(samples));
  for (const LimitBreach& b : breaches)
    for (const int k : b.samples) bad[static_cast<std::size_t>(k)] = true;
  return runs(samples, [&](int k) { return bad[static_cast<std::size_t>(k)]; });
}

}  // namespace pmreport::analysis
