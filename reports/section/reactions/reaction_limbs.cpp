// What the limbs exert on the platform, and what a 6 x 6 formula takes them to exert, in words, tables and figures.
#include <core/text/text.hpp>
#include <reports/section/common/plots.hpp>
#include <reports/section/common/words/words.hpp>
#include <reports/section/reactions/reactions.hpp>

#include <core/mechanics/mobility/mobility.hpp>
#include <core/mechanics/model/closed_form.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/statics/statics.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace pmreport::section {

using document::Paragraph;
using mechanics::Vector6d;

namespace {

std::string limbs_words(const std::vector<int>& limbs) {
  std::vector<std::string> names;
  for (const int n : limbs) names.push_back(std::to_string(n));
  return limbs.size() == 1 ? "limb " + names[0] : "limbs " + listed(names) + " together";
}

}  // namespace

figure::Figure limb_figure(const Analysis& a, const LimbWrenches& limbs) {
  figure::Figure f{"limb-wrenches",
                   "What each limb exerts on the platform: force, and moment about the reference point, in base axes.",
                   "data/reactions.csv",
                   figure::Width::full,
                   2,
                   {}};
  bool any_doubtful = false;
  for (const int axis : {0, 1, 2})
    for (const int c : {axis, axis + 3}) {
      std::vector<Trace> curves;
      for (const int limb : limbs.limbs()) {
        curves.push_back({analysis::limb_column(limb, c), fmt::format("limb {}{}", limb, limbs.doubtful(limb, c) ? least_norm_mark : "")});
        any_doubtful |= limbs.doubtful(limb, c);
      }
      f.panels.push_back(panel(a, fmt::format("{} along {}", c < 3 ? "force" : "moment", "XYZ"[axis]), c < 3 ? "force" : "moment",
                               c < 3 ? "N" : "N*m", curves));
    }
  if (any_doubtful) f.caption += fmt::format(" {} marks least-norm values.", least_norm_mark);
  return f;
}

document::Table limb_table(const Analysis& a, const LimbWrenches& limbs) {
  double force = 0, moment = 0;
  for (const auto& p : limbs.peaks()) force = std::max(force, p.force.peak), moment = std::max(moment, p.moment.peak);
  const DisplayUnit in = display_unit("N", force), about = display_unit("N*m", moment);
  document::Table out{"Largest wrenches of the limbs on the platform.",
                      {"limb", "force [" + in.label + "]", "at", "moment [" + about.label + "]", "at"},
                      {true, true, true, true, true},
                      {}};
  for (const auto& p : limbs.peaks()) {
    const auto mark = [&](int first) {
      return limbs.doubtful(p.limb, first) || limbs.doubtful(p.limb, first + 1) || limbs.doubtful(p.limb, first + 2);
    };
    const auto cells = [&](const JointLoad::Size& s, const DisplayUnit& unit, bool marked) {
      return std::vector<std::string>{
          s.sample < 0 ? "–" : (marked ? least_norm_mark : "") + typeset(format_number(s.peak * unit.per_si, 4)),
          s.sample < 0 ? "–" : show_time(a, s.sample)};
    };
    std::vector<std::string> row{std::to_string(p.limb)};
    for (const std::string& cell : cells(p.force, in, mark(0))) row.push_back(cell);
    for (const std::string& cell : cells(p.moment, about, mark(3))) row.push_back(cell);
    out.rows.push_back(std::move(row));
  }
  return out;
}

std::vector<document::Block> limb_formula(const Analysis& a, const LimbWrenches& limbs) {
  const LimbWrenches::Difference& d = limbs.difference();
  if (d.sample < 0 || d.share < 1e-6) return {};
  const Topology& t = a.machine().topology();
  std::vector<std::string> values;
  for (const auto& [row, value] : d.constraints) {
    const Constraint& c = t.constraints[static_cast<std::size_t>(row - a.machine().dof())];
    values.push_back(fmt::format("{} = {}", c.name, show(value, c.unit)));
  }
  const bool one = d.constraints.size() == 1;
  std::vector<document::Block> out;
  out.push_back(Paragraph{
      Paragraph::Tone::note,
      fmt::format("A constraint wrench is not the reaction of a joint. The 6 × 6 formula G⁻ᵀ, with which section statics finds {}, takes "
                  "every limb for massless, so that it can exert on the platform only what the rows of G say. A limb with mass hands its "
                  "own weight and inertia on to the platform as well, in other directions. The sum over all limbs is the same, and so "
                  "are the totals that the platform feels; what a single limb exerts, and so what its joints carry, is another. They "
                  "differ most at t = {} in {}, by {} % of the wrench: fed with load, weight and inertia of the platform, the formula "
                  "gives {}. Choose bearings by the reactions in this section, not by {}.",
                  one ? "it" : "them", show_time(a, d.sample), limbs_words(d.limbs), format_number(100 * d.share, 3), listed(values),
                  one ? "this number" : "these numbers")});
  const DisplayUnit force = display_unit("N", std::max(d.by_formula.head<3>().norm(), d.by_bodies.head<3>().norm())),
                    moment = display_unit("N*m", std::max(d.by_formula.tail<3>().norm(), d.by_bodies.tail<3>().norm()));
  document::Table table{
      fmt::format("What {} on the platform at t = {}, base axes; forces in {}, moments about the reference point in {}.",
                  limbs_words(d.limbs) + (d.limbs.size() == 1 ? " exerts" : " exert"), show_time(a, d.sample), force.label, moment.label),
      {"by", "force X", "Y", "Z", "moment X", "Y", "Z"},
      {false, true, true, true, true, true, true},
      {}};
  const auto add = [&](const std::string& by, const Vector6d& w) {
    std::vector<std::string> row{by};
    for (int c = 0; c < 6; ++c) {
      const double largest = c < 3 ? w.head<3>().norm() : w.tail<3>().norm();
      row.push_back(typeset(format_number(rounded(w(c), largest) * (c < 3 ? force : moment).per_si, 4)));
    }
    table.rows.push_back(std::move(row));
  };
  add("6 × 6 formula, massless limbs", d.by_formula);
  add("Newton and Euler on every body", d.by_bodies);
  add("difference", d.by_bodies - d.by_formula);
  out.push_back(std::move(table));
  return out;
}

document::Evidence platform_in_balance(const LimbWrenches& limbs) {
  // Rounding of a few sums of columns; the reactions themselves are good to 1e-10 or better.
  return {"The limbs carry the platform",
          "wrenches of all limbs, load and weight against the platform's own inertia, largest over the samples, relative to the largest of "
          "them",
          limbs.imbalance(), 1e-9, ""};
}

}  // namespace pmreport::section
