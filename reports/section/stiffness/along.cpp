// Elasticity along the motion: figures, and the extremes.
#include <reports/section/common/plots.hpp>
#include <reports/section/common/words/words.hpp>
#include <reports/section/stiffness/stiffness.hpp>

#include <core/analysis/columns.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace pmreport::section {

using analysis::stiffness_columns;

namespace {

constexpr std::size_t most_curves = 6;
constexpr double drawn = 1e-5;  // of the largest axial force, times the size of the machine: moments below it are no curve worth a panel

bool any(const Analysis& a, const ColumnId& id) {
  return a.has(id) && std::ranges::any_of(a.column(id), [](double x) { return std::isfinite(x) && x != 0; });
}

double peak(const Analysis& a, const ColumnId& id) {
  double out = 0;
  for (const double x : a.column(id))
    if (std::isfinite(x)) out = std::max(out, std::abs(x));
  return out;
}

// The curves of a column of every element, those of the largest numbers first; `left`: how many are not drawn.
std::vector<Trace> of_elements(const Analysis& a, analysis::OfElement what, std::size_t& left) {
  std::vector<std::pair<double, Trace>> all;
  for (const Element& e : a.machine().topology().elements) {
    if (what != analysis::OfElement::share && e.kind != ElementKind::beam) continue;
    const ColumnId id = column_of(e, what);
    if (any(a, id)) all.push_back({peak(a, id), {id, e.name}});
  }
  std::ranges::stable_sort(all, [](const auto& x, const auto& y) { return x.first > y.first; });
  left = all.size() > most_curves ? all.size() - most_curves : 0;
  std::vector<Trace> out;
  for (std::size_t i = 0; i < std::min(all.size(), most_curves); ++i) out.push_back(all[i].second);
  return out;
}

figure::Figure empty(const char* id, std::string caption) {
  return {id, std::move(caption), "data/stiffness.csv", figure::Width::full, 2, {}};
}

}  // namespace

std::vector<figure::Figure> motion_figures(const Analysis& a) {
  std::vector<figure::Figure> out;
  const auto id = [](analysis::OfStiffness what) { return column_of(what); };
  if (any(a, id(analysis::OfStiffness::deflection_size))) {
    figure::Figure f = empty(
        "deflection", "Deflection of the tool under load, weights and inertia: (a) its size and that of its parts; (b) its components.");
    std::vector<Trace> parts{{id(analysis::OfStiffness::deflection_size), "all"}};
    for (const auto& [what, word] : {std::pair{analysis::OfStiffness::load_deflection, "load"},
                                     {analysis::OfStiffness::weight_deflection, "weights"},
                                     {analysis::OfStiffness::inertia_deflection, "inertia"}})
      if (any(a, id(what))) parts.push_back({id(what), word});
    f.panels.push_back(panel(a, "size", "deflection", "m", parts));
    std::vector<Trace> components;
    for (std::size_t axis = 0; axis < 3; ++axis)
      components.push_back({column_of(analysis::OfPlatform::deflection, axis), std::string(1, "xyz"[axis])});
    f.panels.push_back(panel(a, "components", "deflection", "m", components));
    out.push_back(std::move(f));

    std::size_t left = 0;
    if (const auto shares = of_elements(a, analysis::OfElement::share, left); !shares.empty()) {
      figure::Figure budget = empty("compliance-budget", "Share of the elements in the deflection: what to make stiffer first.");
      if (left > 0) budget.caption += fmt::format(" The {} largest of {}.", shares.size(), shares.size() + left);
      budget.panels.push_back(panel(a, "compliance budget", "share", "", shares));
      out.push_back(std::move(budget));
    }
  }
  {
    figure::Figure f = empty("compliance",
                             "Largest and smallest translation by a unit force pF, rotation by a unit force pT, rotation by a unit moment "
                             "ΦT; natural frequencies.");
    for (const auto& [name, unit, title] : {std::tuple{"pF", "m/N", "translation by force"},
                                            {"pT", "1/N", "rotation by force, translation by moment"},
                                            {"PhiT", "rad/N/m", "rotation by moment"}}) {
      auto curves = group(a, stiffness_columns, name);
      for (Trace& c : curves) c.label = c.column.name().ends_with("max") ? "largest" : "smallest";
      std::erase_if(curves, [&](const Trace& c) { return !any(a, c.column); });
      if (!curves.empty()) f.panels.push_back(panel(a, title, name == std::string("PhiT") ? "ΦT" : name, unit, curves));
    }
    std::vector<Trace> modes;
    for (int m = 1; m <= 3; ++m)
      if (any(a, analysis::frequency_column(m))) modes.push_back({analysis::frequency_column(m), symbol(fmt::format("f{}", m))});
    if (!modes.empty()) f.panels.push_back(panel(a, "natural frequencies", "frequency", "Hz", modes));
    if (!f.panels.empty()) out.push_back(std::move(f));
  }
  figure::Figure beams = empty("beam-forces",
                               "What beams carry, each where it is largest along the beam: axial force (tension positive; a beam's own "
                               "weight and inertia make it step through zero), bending moment, torque.");
  for (const auto& [what, title, unit] : {std::tuple{analysis::OfElement::axial, "axial force", "N"},
                                          {analysis::OfElement::bending, "bending moment", "N*m"},
                                          {analysis::OfElement::torque, "torque", "N*m"}}) {
    std::size_t left = 0;
    const auto curves = of_elements(a, what, left);
    const double scale = what == analysis::OfElement::axial ? 1 : a.length();
    double largest = 0, force = 0;
    for (const Trace& c : curves) largest = std::max(largest, peak(a, c.column));
    for (const Element& e : a.machine().topology().elements)
      if (e.kind == ElementKind::beam) force = std::max(force, peak(a, column_of(e, analysis::OfElement::axial)));
    if (curves.empty() || largest < drawn * force * scale) continue;
    beams.panels.push_back(panel(a, title, title, unit, curves));
    if (left > 0) beams.caption += fmt::format(" Of {} the {} largest of {}.", title, curves.size(), curves.size() + left);
  }
  if (!beams.panels.empty()) out.push_back(std::move(beams));
  return out;
}

document::Table motion_extremes(const Analysis& a) {
  std::vector<Column> told;
  for (const Column& c : a.columns_of(stiffness_columns)) {
    const bool mine = c.group == "deflection_size" || c.group == "deflection_share" || c.group == "pF" || c.group == "pT" ||
                      c.group == "PhiT" || (c.group == "frequency" && c.name <= "frequency3");
    if (mine && any(a, c)) told.push_back(c);
  }
  return extremes(a, "Extremes along the motion.", told);
}

}  // namespace pmreport::section
