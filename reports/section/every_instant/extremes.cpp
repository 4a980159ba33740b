// The table of the section "At every instant": extremes over all of the motion, beside those of the samples.
#include <core/analysis/columns.hpp>
#include <core/text/units.hpp>
#include <reports/section/common/brackets.hpp>
#include <reports/section/common/words.hpp>
#include <reports/section/every_instant/every_instant.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pmreport::section {

namespace {

constexpr std::size_t joints_shown = 6;
constexpr double infinity = std::numeric_limits<double>::infinity();

// The range that bounds a column: a stroke, or the limit of a joint; infinite: none.
Bounds range_of(const Topology& t, const ColumnId& column) {
  for (const Actuator& a : t.actuators)
    if (column_of(a) == column) return {a.stroke.min, a.stroke.max};
  for (const Joint& j : t.joints)
    for (std::size_t i = 0; i < j.limits.size(); ++i)
      if (j.kind != JointKind::prismatic && analysis::joint_column(j, i) == column) return {j.limits[i].min, j.limits[i].max};
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
  const double width = e.range.high - e.range.low;
  return std::min(e.extreme->least.low - e.range.low, e.range.high - e.extreme->largest.high) / width;
}

bool of_joint(const ExtremeShown& e) { return e.column.group == "joint_angle"; }

// What is bounded, or moves: actuators, their rates and accelerations, and the joints nearest to their limits. The rest is in the data.
std::vector<ExtremeShown> of_interest(const std::vector<ExtremeShown>& all) {
  std::vector<ExtremeShown> out, joints;
  for (const ExtremeShown& e : all) {
    if (!e.extreme->least.bounded() || !e.extreme->largest.bounded()) continue;
    if (of_joint(e) && e.range.bounded()) joints.push_back(e);
    if (e.column.group.starts_with("actuator")) out.push_back(e);
  }
  std::ranges::stable_sort(joints, {}, room);
  if (joints.size() > joints_shown) joints.resize(joints_shown, joints.front());
  out.insert(out.end(), joints.begin(), joints.end());
  return out;
}

std::string time_words(double t) { return format_number(t, 5); }

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
                        {"quantity", "range", "samples", "least, at every instant", "at t [s]", "largest, at every instant", "at t [s]"},
                        {false, true, true, true, true, true, true},
                        {}};
  const std::vector<ExtremeShown> shown = of_interest(extremes);
  std::size_t limited = 0, joints = 0;
  for (const ExtremeShown& e : extremes) limited += of_joint(e) && e.range.bounded();
  for (const ExtremeShown& e : shown) {
    const analysis::Extreme& x = *e.extreme;
    const Bounds samples = sampled(a, e.column);
    const double largest = std::max({std::abs(x.least.low), std::abs(x.largest.high), e.range.bounded() ? std::abs(e.range.high) : 0.0});
    const DisplayUnit unit = display_unit(e.column.unit, largest);
    const auto pair = [&](const Bounds& b, int digits) {
      return typeset(format_number(b.low * unit.per_si, digits)) + " to " + typeset(format_number(b.high * unit.per_si, digits));
    };
    table.rows.push_back({fmt::format("{} [{}]", e.column.name, unit.label), e.range.bounded() ? pair(e.range, 4) : "",
                          samples.low <= samples.high ? pair(samples, 5) : "", bracket_number(x.least, unit.per_si), time_words(x.at_least),
                          bracket_number(x.largest, unit.per_si), time_words(x.at_largest)});
    joints += of_joint(e);
  }
  if (joints < limited) table.caption += fmt::format(" Of {} limited motions of joints the {} nearest to their limits.", limited, joints);
  return table;
}

}  // namespace pmreport::section
