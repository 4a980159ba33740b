// What each joint carries: the tables from which bearings and bolts are chosen.
#include <reports/section/common/words/words.hpp>
#include <reports/section/reactions/reactions.hpp>

#include <core/mechanics/machine/joint_words.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pmreport::section {

using analysis::component;
using analysis::directionless;
using document::Table;

namespace {

const Joint& joint_at(const Analysis& a, std::size_t j) { return a.machine().topology().joints[j]; }
const std::string& body_name(const Analysis& a, int body) { return a.machine().topology().bodies[static_cast<std::size_t>(body)].name; }

// With whom the joint axes turn (joint_frame.hpp).
std::string axes_words(const Analysis& a, const Joint& joint, const mechanics::JointFrames::Recipe& r) {
  if (r.second_axis) return fmt::format("1 with {}, 2 with {}", body_name(a, joint.a), body_name(a, joint.b));
  if (r.stud >= 0 && r.stud != r.carrier) return fmt::format("1 along {}, 2 with {}", body_name(a, r.stud), body_name(a, r.carrier));
  if (r.carrier != joint.a && r.carrier != joint.b)
    return fmt::format("1 along {}, 2 with {}", body_name(a, joint.a), body_name(a, r.carrier));
  return body_name(a, r.carrier);
}

std::string number(double si, const DisplayUnit& unit, bool doubtful = false) {
  return (doubtful ? least_norm_mark : "") + typeset(format_number(si * unit.per_si + 0.0, 4));
}

std::string verdict(const JointLoad& load) {
  if (load.doubtful == 0) return load.elastic == 0 ? "unique" : "unique by elasticity";
  std::string components;
  for (int c = 0; c < 6; ++c)
    if ((load.doubtful >> c & 1) != 0) components += fmt::format(" {}", symbol(fmt::format("{}{}", c < 3 ? 'F' : 'M', c % 3 + 1)));
  return least_norm_mark + components;
}

struct Units {
  DisplayUnit force, moment;
};
Units units_of(const std::vector<JointLoad>& loads) {
  double force = 0, moment = 0;
  for (const JointLoad& l : loads) force = std::max(force, l.force.peak), moment = std::max(moment, l.moment.peak);
  return {display_unit("N", force), display_unit("N*m", moment)};
}

}  // namespace

double rounded(double x, double largest) {
  if (!(largest > 0)) return 0;
  const double step = std::pow(10.0, std::floor(std::log10(largest)) - 3);
  return std::round(x / step) * step;
}

Table bearing_table(const Analysis& a, const std::vector<JointLoad>& loads) {
  const auto [force, moment] = units_of(loads);
  Table table{
      fmt::format("What the bearings carry: largest and root-mean-square size of force and moment. {} marks least-norm values.",
                  least_norm_mark),
      {"joint", "kind", "from a to b", "force [" + force.label + "]", "at", "RMS", "moment [" + moment.label + "]", "at", "RMS", "verdict"},
      {false, false, false, true, true, true, true, true, true, false},
      {}};
  if (std::none_of(loads.begin(), loads.end(), [](const JointLoad& l) { return l.doubtful != 0; }))
    table.caption = "What the bearings carry: largest and root-mean-square size of force and moment.";
  for (std::size_t j = 0; j < loads.size(); ++j) {
    const Joint& joint = joint_at(a, j);
    const JointLoad& load = loads[j];
    std::vector<std::string> row{joint.name, mechanics::word_of(joint.kind), body_name(a, joint.a) + " → " + body_name(a, joint.b)};
    for (const bool moments : {false, true}) {
      const JointLoad::Size& size = moments ? load.moment : load.force;
      const bool doubtful = moments ? load.doubtful_moment() : load.doubtful_force();
      const DisplayUnit& unit = moments ? moment : force;
      if (size.sample < 0) {
        const bool none = moments && joint.kind == JointKind::spherical;
        row.insert(row.end(), {none ? "–" : "0", "–", none ? "–" : "0"});
        continue;
      }
      row.insert(row.end(), {number(size.peak, unit, doubtful), show_time(a, size.sample), number(size.rms, unit, doubtful)});
    }
    row.push_back(verdict(load));
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table direction_table(const Analysis& a, const std::vector<JointLoad>& loads) {
  Table table{
      fmt::format(
          "Where the forces point, in joint axes: mean direction of the force on body b, and half-angle of the smallest cone about it that "
          "holds the force at every sample. ± marks a force that reverses: the line that it keeps to, and the half-angle of the double "
          "cone. "
          "Forces below {} % of the joint's largest are left out.",
          format_number(100 * directionless, 3)),
      {"joint", "joint axes turn", "direction 1", "2", "3", "half-angle"},
      {false, false, true, true, true, true},
      {}};
  const mechanics::JointFrames frames(a.machine());
  for (std::size_t j = 0; j < loads.size(); ++j) {
    const JointLoad& load = loads[j];
    std::string with = axes_words(a, joint_at(a, j), frames.recipe(static_cast<int>(j)));
    if (!with.starts_with("1 ")) with = "with " + with;
    std::vector<std::string> row{joint_at(a, j).name, with};
    if (load.force.sample < 0) {
      row.insert(row.end(), {"–", "–", "–", "no force"});
    } else {
      for (int c = 0; c < 3; ++c) {
        const double x = load.direction(c);
        row.push_back((load.doubtful_force() ? least_norm_mark : "") + typeset(fmt::format("{:.3f}", std::abs(x) < 5e-4 ? 0.0 : x)));
      }
      row.push_back((load.reverses ? "± " : "") + typeset(format_number(load.cone * 180 / std::numbers::pi, 3)) + "°");
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table component_table(const Analysis& a, const std::vector<JointLoad>& loads) {
  const auto [force, moment] = units_of(loads);
  Table table{
      fmt::format("What body a exerts on body b, in joint axes, where the joint's force is largest, and where its moment is; forces "
                  "in {}, moments about the joint's centre in {}. A dot: the joint gives way there.",
                  force.label, moment.label),
      {"joint", "largest", "at", "F₁", "F₂", "F₃", "M₁", "M₂", "M₃"},
      {false, false, true, true, true, true, true, true, true},
      {}};
  const auto add = [&](std::size_t j, const char* of, int sample) {
    const Joint& joint = joint_at(a, j);
    std::vector<std::string> row{joint.name, of, show_time(a, sample)};
    for (int c = 0; c < 6; ++c) {
      const DisplayUnit& unit = c < 3 ? force : moment;
      const double x = rounded(component(a, joint, c, sample), c < 3 ? loads[j].force.peak : loads[j].moment.peak);
      row.push_back(analysis::transmits(joint.kind, c) ? number(x, unit, (loads[j].doubtful >> c & 1) != 0) : "·");
    }
    table.rows.push_back(std::move(row));
  };
  for (std::size_t j = 0; j < loads.size(); ++j) {
    const int force_at = loads[j].force.sample, moment_at = loads[j].moment.sample;
    if (force_at >= 0) add(j, force_at == moment_at ? "both" : "force", force_at);
    if (moment_at >= 0 && moment_at != force_at) add(j, "moment", moment_at);
  }
  return table;
}

}  // namespace pmreport::section
