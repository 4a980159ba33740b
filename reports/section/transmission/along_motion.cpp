// Indices along the motion.
#include <reports/section/common/plots.hpp>
#include <reports/section/common/words/words.hpp>
#include <reports/section/transmission/transmission.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pmreport::section {

namespace {

const figure::Line good{analysis::good_transmission, "0.7"};

double mean_of(const std::vector<double>& column, double (*of)(double)) {
  double sum = 0;
  int count = 0;
  for (const double x : column)
    if (std::isfinite(x)) sum += of(x), ++count;
  return count > 0 ? sum / count : std::nan("");
}

// Whether a curve is 1 all along: it says so in a sentence better than in a panel.
bool all_one(const Analysis& a, const std::vector<Trace>& curves) {
  constexpr double one = 1 - 1e-9;
  return std::ranges::all_of(curves,
                             [&](const Trace& c) { return std::ranges::all_of(a.column(c.column), [](double x) { return !(x < one); }); });
}

}  // namespace

WorstSample extreme_of(const Analysis& a, const std::vector<Trace>& columns, bool largest) {
  WorstSample out{std::nan(""), -1, ""};
  for (const Trace& c : columns) {
    const std::vector<double>& x = a.column(c.column);
    for (int k = 0; k < a.samples(); ++k) {
      const double v = x[static_cast<std::size_t>(k)];
      if (std::isfinite(v) && (out.sample < 0 || (largest ? v > out.value : v < out.value))) out = {v, k, c.column.name()};
    }
  }
  return out;
}

figure::Figure transmission_figure(const Analysis& a) {
  figure::Figure f{"transmission",
                   "Along the motion. 0.7, a pressure angle of 45.6°, is what the literature calls good.",
                   "data/transmission.csv",
                   figure::Width::full,
                   2,
                   {}};
  const auto add = [&](const char* name, const char* title, const char* axis, const char* unit, const figure::Line& line, bool reach_line) {
    const std::vector<Trace> curves = group(a, analysis::transmission_columns, name);
    if (curves.empty() || (std::string_view(name) == "input_transmission" && all_one(a, curves))) return;
    figure::Panel p = panel(a, title, axis, unit, curves);
    p.lines.push_back(line);
    // A dot that no curve draws: how far the curves stay from the line is what they are looked at for.
    if (reach_line) p.series.push_back({"", {a.time().front()}, {line.y}, 0});
    f.panels.push_back(std::move(p));
  };
  add("pressure_angle", "pressure angles", "pressure angle", "rad",
      {std::acos(analysis::good_transmission) * 180 / std::numbers::pi, "cos = 0.7"}, true);
  add("output_transmission", "output transmission", "index", "", good, true);
  add("input_transmission", "input transmission", "index", "", good, false);
  add("constraint_transmission", "constraint transmission", "index", "", good, false);
  std::vector<Trace> locals;
  for (const auto& [what, label] :
       {std::pair{OfMachine::local_transmission, "transmission"}, {OfMachine::local_conditioning, "conditioning"}})
    if (a.has(column_of(what))) locals.push_back({column_of(what), label});
  figure::Panel p = panel(a, "local indices", "index", "", locals);
  if (locals.size() > 1) p.lines.push_back(good);
  f.panels.push_back(std::move(p));
  return f;
}

document::Table transmission_worst(const Analysis& a) {
  document::Table t{"The worst of the motion, and means over its samples.",
                    {"force", "largest pressure angle [°]", "at", "mean cosine", "least output", "at", "mean", "least input", "at"},
                    {false, true, true, true, true, true, true, true, true},
                    {}};
  const auto number = [](double x, int digits) { return std::isfinite(x) ? typeset(format_number(x, digits)) : std::string("–"); };
  const auto add = [&](const std::string& name, const ColumnId& pressure, const ColumnId& output, const ColumnId& input) {
    const auto worst = [&](const ColumnId& column, bool largest) {
      return a.has(column) ? extreme_of(a, {{column, ""}}, largest) : WorstSample{std::nan(""), -1, ""};
    };
    const auto when = [&](const WorstSample& e) { return e.sample >= 0 ? show_time(a, e.sample) : std::string("–"); };
    const auto mean = [&](const ColumnId& column, double (*of)(double)) {
      return a.has(column) ? mean_of(a.column(column), of) : std::nan("");
    };
    const WorstSample p = worst(pressure, true), o = worst(output, false), i = worst(input, false);
    t.rows.push_back({name, number(p.value * 180 / std::numbers::pi, 4), when(p),
                      number(mean(pressure, [](double x) { return std::cos(x); }), 4), number(o.value, 4), when(o),
                      number(mean(output, [](double x) { return x; }), 4), number(i.value, 4), when(i)});
  };
  const Topology& topology = a.machine().topology();
  for (const Actuator& x : topology.actuators)
    add(symbol(x.name), column_of(x, OfActuator::pressure), column_of(x, OfActuator::output), column_of(x, OfActuator::input));
  for (const Constraint& c : topology.constraints)
    if (a.has(analysis::transmission_of(c))) add(c.name, ColumnId::named(""), analysis::transmission_of(c), ColumnId::named(""));
  return t;
}

}  // namespace pmreport::section
