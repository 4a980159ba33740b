// Panels and proofs from the columns and measures of an analysis.
#pragma once

#include <core/text/units.hpp>
#include <reports/document/report.hpp>
#include <reports/section/common/analysis.hpp>

#include <string>
#include <vector>

namespace pmreport::section {

struct Trace {
  ColumnId column;
  std::string label;
};
std::vector<ColumnId> columns_of(const std::vector<Trace>& curves);

// The unit that reads best for all of them.
DisplayUnit unit_of(const Analysis& a, const std::string& unit, const std::vector<Trace>& curves);
// A panel of columns with one SI unit, scaled to the unit that reads best; samples that break a limit are shaded, gaps kept.
figure::Panel panel(const Analysis& a, const std::string& title, const std::string& axis, const std::string& unit,
                    const std::vector<Trace>& curves);
// "x = 0 mm, y = 20 mm", "α = β = 0°": of curves none of which moves beyond its rounding; empty where one does, or none has a value.
std::string constants(const Analysis& a, const std::string& unit, const std::vector<Trace>& curves);
// The panel of these curves, or a sentence of the caption where all of them are constant: a flat panel tells less. None without curves.
void add_panel(figure::Figure& f, const Analysis& a, const std::string& title, const std::string& axis, const std::string& unit,
               const std::vector<Trace>& curves);
// A figure, or its caption alone where no panel is left.
void put(document::Section& s, figure::Figure f);
// The ends of the strokes of the actuators of a unit, hatched beyond, where they are the same for all; else the overview tells them.
void add_stroke_lines(figure::Panel& p, const Analysis& a, const std::string& unit, double per_si);
// The curves of a group of the columns of a list, labelled by the symbols of their quantities: "l1_rate" by l₁. `unit`: only those of it,
// "1" those without one; empty: all.
std::vector<Trace> group(const Analysis& a, ColumnList* list, const std::string& name, const std::string& unit = "");
// Smallest and largest value of columns and when, as a table: with as many digits as set the two apart.
document::Table extremes(const Analysis& a, const std::string& caption, const std::vector<Column>& columns);

struct Claim {
  Measure measure;
  std::string claim, how;
  double tolerance;
  std::string unit;
  std::string unless = {};  // why nothing may be compared though there are samples to compare
};
document::Proof proof(const Analysis& a, const std::vector<Claim>& claims);

// The data file of a list of columns, which the run then has no more.
document::Data handed_over(Analysis& a, const std::string& name, ColumnList* list);

}  // namespace pmreport::section
