// The table of the section "At every instant": extremes over all of the motion, beside those of the samples.
#include <core/analysis/columns.hpp>
#include <core/numbers.hpp>
#include <core/text/units.hpp>
#include <reports/section/common/words/brackets.hpp>
#include <reports/section/common/words/noise.hpp>
#include <reports/section/common/words/words.hpp>
#include <reports/section/every_instant/every_instant.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pmreport::section {

namespace {

constexpr std::size_t joints_shown = 6;

// The range that bounds a column: a stroke, or the limit of a joint; infinite: none. A deflection is never less than 0, which bounds
// nothing.
Bounds range_of(const Topology& t, const ColumnId& column) {
  for (const Actuator& a : t.actuators)
    if (column_of(a) == column) return {a.stroke.min, a.stroke.max};
  for (const Joint& j : t.joints)
    for (std::size_t i = 0; i < j.limits.size(); ++i)
      if (analysis::joint_column(j, i) == column) return {j.kind == JointKind::spherical ? -infinity : j.limits[i].min, j.limits[i].max};
  return {};
}

Bounds sampled(const Analysis& a, const ColumnId& column) {
  Bounds out{infinity, -infinity};
  for (const double x : a.column(column))
    if (std::isfinite(x)) out = hull(out, Bounds::exactly(x));
  return out;
}

// How much of the range is left beside the extremes, of the range; less than zero beyond it.
double room(const ExtremeShown& e) {
  const bool both = std::isfinite(e.range.low);
  const double above = e.range.high - e.extreme->largest.high, below = both ? e.extreme->least.low - e.range.low : infinity;
  return std::min(above, below) / (both ? e.range.high - e.range.low : e.range.high);
}

bool of_joint(const ExtremeShown& e) { return e.column.group == "joint_angle" || e.column.group == "joint_travel"; }
bool is_limited_joint(const ExtremeShown& e) { return of_joint(e) && std::isfinite(e.range.high); }

// One of the two extremes of a column.
struct Row {
  const ExtremeShown* shown;
  bool largest;

  const Bounds& bounds() const { return largest ? shown->extreme->largest : shown->extreme->least; }
  double at() const { return largest ? shown->extreme->at_largest : shown->extreme->at_least; }
  double limit() const { return largest ? shown->range.high : shown->range.low; }
};

// What is bounded, or moves: of strokes both ends; of rates and accelerations of actuators the end that is larger; of the joints nearest to
// their limits the end that is nearer. The rest is in the data.
std::vector<Row> of_interest(const std::vector<ExtremeShown>& all) {
  std::vector<Row> out, joints;
  for (const ExtremeShown& e : all) {
    const Bounds &least = e.extreme->least, &largest = e.extreme->largest;
    if (!least.bounded() || !largest.bounded()) continue;
    if (e.column.group == "actuator") {
      out.push_back({&e, false});
      out.push_back({&e, true});
    } else if (e.column.group.starts_with("actuator")) {
      out.push_back({&e, largest.high >= -least.low});
    } else if (is_limited_joint(e)) {
      joints.push_back({&e, e.range.high - largest.high <= least.low - e.range.low});
    }
  }
  std::ranges::stable_sort(joints, {}, [](const Row& r) { return room(*r.shown); });
  if (joints.size() > joints_shown) joints.erase(joints.begin() + joints_shown, joints.end());
  out.insert(out.end(), joints.begin(), joints.end());
  return out;
}

}  // namespace

std::vector<ExtremeShown> extremes_shown(const Analysis& a, const Proved& p) {
  std::vector<ExtremeShown> out;
  for (ColumnList* list : {analysis::displacement_columns, analysis::velocity_columns, analysis::acceleration_columns})
    for (const Column& c : a.columns_of(list))
      if (const analysis::Extreme* e = p.proof.extreme(c)) out.push_back({e, c, range_of(p.topology, c)});
  return out;
}

document::Table table_of_extremes(const Analysis& a, const std::vector<ExtremeShown>& extremes) {
  document::Table table{"Least and largest values: of the samples, and between which bounds those over every instant lie.",
                        {"quantity", "", "limit", "of samples", "at every instant", "at t [s]"},
                        {false, false, true, true, true, true},
                        {}};
  std::size_t limited = 0, joints = 0;
  for (const ExtremeShown& e : extremes) limited += is_limited_joint(e);
  for (const Row& r : of_interest(extremes)) {
    const ExtremeShown& e = *r.shown;
    joints += of_joint(e);
    const Bounds samples = sampled(a, e.column);
    const double size = std::max(std::abs(e.extreme->least.low), std::abs(e.extreme->largest.high));
    const DisplayUnit unit = display_unit(e.column.unit, std::isfinite(e.range.high) ? std::max(size, std::abs(e.range.high)) : size);
    const auto number = [&](double si, int digits) { return typeset(format_number(si * unit.per_si, digits)); };
    const double end = r.largest ? samples.high : samples.low, seen = std::abs(end) < noise(a, e.column.unit, {e.column}) ? 0 : end;
    table.rows.push_back({fmt::format("{} [{}]", e.column.name, unit.label), r.largest ? "largest" : "least",
                          std::isfinite(r.limit()) ? number(r.limit(), 5) : "", std::isfinite(seen) ? number(seen, 7) : "",
                          bracket_number(r.bounds(), unit.per_si), format_number(r.at(), 5)});
  }
  if (joints < limited) table.caption += fmt::format(" Of {} limited motions of joints the {} nearest to their limits.", limited, joints);
  return table;
}

}  // namespace pmreport::section
