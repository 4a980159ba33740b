// Sentences and tables of a workspace.
#include <reports/section/workspace/workspace.hpp>

#include <core/analysis/workspace/answers.hpp>
#include <core/text/text.hpp>
#include <reports/section/common/words/brackets.hpp>
#include <reports/section/common/words/words.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pmreport::section {

using analysis::ScanMethod;
using document::Paragraph;
using document::Table;
using mechanics::PoseLimit;

namespace {

std::string count(std::uint64_t n) {  // "306 300 225"
  std::string digits = std::to_string(n), out;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) out += " ";
    out += digits[i];
  }
  return out;
}

std::string share(std::uint64_t part, std::uint64_t all) {
  return all == 0 ? "-" : typeset(format_number(100.0 * static_cast<double>(part) / static_cast<double>(all), 3));
}

const Coordinate& coordinate_of(const mechanics::Machine& machine, const scan::Axis& a) {
  return machine.topology().coordinates[static_cast<std::size_t>(a.input)];
}

std::string scanned_words(const Workspace& w, const mechanics::Machine& machine) {
  std::vector<std::string> ranges;
  for (const scan::Axis& a : w.scan.points) {
    const Coordinate& c = coordinate_of(machine, a);
    ranges.push_back(fmt::format("{} from {} to {}", symbol(c.name), show(a.from, c.unit), show(a.to, c.unit)));
  }
  std::string out = "Scanned: " + listed(ranges, "and");
  if (const std::string held = held_words(w, machine); !held.empty()) out += "; held: " + held;
  if (!w.scan.orientations.empty()) out += fmt::format("; at every point {} orientations are tried", count(w.scan.orientation_count()));
  out += ".";
  if (w.tool) {
    const auto r = [&](Eigen::Index k) { return show(w.tool->at()(k), "m"); };
    out += fmt::format(" Coordinates of the place are those of the tool point, in the platform's axes at ({}, {}, {}).", r(0), r(1), r(2));
  }
  return out;
}

std::string limits_words(const Workspace& w) {
  std::vector<std::string> groups;
  std::vector<int> numbers;
  for (const PoseLimit& l : w.margins.limits) {
    if (l.group == PoseLimit::Group::reach) continue;
    const std::string name = mechanics::name_of(l.group);
    const auto found = std::ranges::find(groups, name);
    if (found == groups.end())
      groups.push_back(name), numbers.push_back(1);
    else
      ++numbers[static_cast<std::size_t>(found - groups.begin())];
  }
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < groups.size(); ++i) parts.push_back(fmt::format("{} ({})", groups[i], numbers[i]));
  if (parts.empty()) return "No limit counts but that the mechanism can be assembled.";
  return fmt::format("A pose counts when the mechanism can be assembled there and all of these limits hold, ends included: {}.",
                     listed(parts, "and"));
}

}  // namespace

std::string held_words(const Workspace& w, const mechanics::Machine& machine) {
  std::vector<std::string> held;
  for (std::size_t i = 0; i < machine.topology().coordinates.size(); ++i) {
    const int input = static_cast<int>(i);
    const auto is = [&](const scan::Axis& a) { return a.input == input; };
    if (std::ranges::any_of(w.scan.points, is) || std::ranges::find(w.scan.turned, input) != w.scan.turned.end()) continue;
    const Coordinate& c = machine.topology().coordinates[i];
    held.push_back(fmt::format("{} = {}", symbol(c.name), show(w.scan.at[i], c.unit)));
  }
  return listed(held, "and");
}

SafeEnd safe_end_of(double si, const Coordinate& c, bool upper) {
  constexpr double parts = 1e3;
  const bool length = c.sense() == Sense::linear;
  const double x = si * (length ? 1e3 : 180 / std::numbers::pi);
  double whole = upper ? std::floor(x * parts) : std::ceil(x * parts);
  while (upper ? whole / parts > x : whole / parts < x) whole += upper ? -1 : 1;
  return {whole / parts, length ? "mm" : "deg"};
}

std::string margin_words(const Workspace& w, int margin) {
  if (margin < 0) return "the scanned range";
  const mechanics::PoseMargin& m = w.margins.margins[static_cast<std::size_t>(margin)];
  const PoseLimit& l = w.margins.limits[static_cast<std::size_t>(m.limit)];
  if (l.group == PoseLimit::Group::reach) return "the end of reach";
  return fmt::format("{} at its {}, {}", l.name, m.upper ? "most" : "least", show(m.upper ? l.max : l.min, l.unit));
}

std::vector<Paragraph> workspace_words(const Workspace& w, const mechanics::Machine& machine) {
  std::vector<Paragraph> out;
  const auto tell = [&](std::string text, Paragraph::Tone tone = Paragraph::Tone::plain) { out.push_back({tone, std::move(text)}); };
  tell(scanned_words(w, machine));
  tell(limits_words(w));
  if (!w.home_inside)
    tell(fmt::format("Home lies outside: {} is broken there. No safe limits around it can be told.", w.home_refused_by),
         Paragraph::Tone::warning);
  if (w.proof && w.proof->empty)
    tell("The workspace is empty: that no pose of the range keeps the limits is proved.", Paragraph::Tone::warning);
  if (w.grid && w.grid->tally.accepted == 0)
    tell(fmt::format("No pose of the grid is accepted, of {}.", count(w.grid->tally.poses)), Paragraph::Tone::warning);
  if (w.grid && w.grid->tally.accepted == w.grid->tally.poses && w.grid->tally.poses > 0)
    tell("Every pose of the grid is accepted: the workspace goes on beyond the scanned range.", Paragraph::Tone::note);
  if (!w.not_proved.empty()) tell("No volume is proved: " + w.not_proved + ".", Paragraph::Tone::note);
  if (w.proof && !w.proof->enough && !w.proof->empty)
    tell(fmt::format("The bracket is wider than asked for: {}.", w.proof->why), Paragraph::Tone::note);
  if (w.components && w.grid->tally.accepted > 0) {
    const auto& c = *w.components;
    std::string text =
        c.parts.size() == 1 ? "The accepted points hang together" : fmt::format("The accepted points fall into {} parts", c.parts.size());
    if (c.parts.size() > 1) {
      std::vector<std::string> sizes;
      for (std::size_t i = 0; i < std::min<std::size_t>(c.parts.size(), 4); ++i) sizes.push_back(count(c.parts[i]));
      text += fmt::format(", of {} points{}", listed(sizes, "and"), c.parts.size() > 4 ? " and fewer" : "");
    }
    text += c.holes.empty() ? ", without a hole." : fmt::format(", with {}.", plural(static_cast<int>(c.holes.size()), "hole"));
    tell(text);
  }
  if (w.sheet) {
    if (w.sheet->sign == 0)
      tell("The pose of the grid that is nearest to home is not accepted, and has no sheet.", Paragraph::Tone::warning);
    else
      tell(fmt::format(
          "On the sheet of home, which single steps reach without a change of sign of det G, lie {} of {} accepted poses; {} are "
          "connected with it without regard to the sign.",
          count(w.sheet->poses), count(w.grid->tally.accepted), count(w.sheet->connected)));
  }
  for (const std::string& joint : w.margins.left_out)
    tell(fmt::format("The limit of joint {} is not judged: the geometry leaves its motion open.", joint), Paragraph::Tone::note);
  return out;
}

std::string workspace_summary(const Workspace& w, const std::string& name) {
  const analysis::WorkspaceAnswers answers(w);
  if (!answers.any()) return {};
  const analysis::Bracketed volume = answers.volume();
  std::string out = name.empty() ? "Workspace: " : fmt::format("Workspace {}: ", name);
  if (answers.empty())
    out += "empty";
  else if (volume.width() > 0)
    out += show_bracket({volume.low, volume.high}, w.unit);
  else
    out += show_volume(volume.value, w.unit);
  if (!w.scan.orientations.empty())
    out += fmt::format(" with at least {} of {} orientations", count(w.request.at_least.front()), count(w.scan.orientation_count()));
  switch (*answers.method()) {
    case ScanMethod::proof:
      out += " (proved)";
      break;
    case ScanMethod::grid:
      out += fmt::format(" (a grid of {} poses)", count(w.grid->tally.poses));
      break;
    case ScanMethod::monte_carlo:
      out += " (95 % interval of random poses)";
      break;
  }
  if (!w.home_inside) out += fmt::format("; home lies outside, for {} is broken", w.home_refused_by);
  return out + ".";
}

Table workspace_volumes(const Workspace& w) {
  Table t{"Volume of the workspace",
          {"method", fmt::format("volume [{}]", typographic(w.unit)), "low", "high", "looked at"},
          {false, true, true, true, false},
          {}};
  const auto number = [](double x) { return std::isfinite(x) ? typeset(format_number(x, 7)) : std::string("-"); };
  const auto proved = [&](const std::string& what, const scan::ProvedVolume& p) {
    t.rows.push_back({what, number(p.volume.middle()), number(p.volume.low), number(p.volume.high), count(p.boxes) + " boxes"});
  };
  const bool oriented = !w.scan.orientations.empty();
  for (const ScanMethod m : w.request.methods) {
    if (m == ScanMethod::proof && w.proof && !oriented) proved("proof", *w.proof);
    if (m == ScanMethod::proof)
      for (std::size_t i = 0; i < w.proof_at_least.size(); ++i)
        proved(fmt::format("proof, at least {}", count(w.request.at_least[i])), w.proof_at_least[i]);
    if (m == ScanMethod::grid && w.grid) {
      const double cell = w.scan.cell();
      const std::string looked = fmt::format("{} poses, {} accepted", count(w.grid->tally.poses), count(w.grid->tally.accepted));
      if (!oriented) t.rows.push_back({"grid", number(cell * static_cast<double>(w.grid->tally.accepted)), "", "", looked});
      for (const std::uint64_t n : w.request.at_least) {
        const std::uint64_t points = analysis::points_with(w.grid->accepted_at, n);
        t.rows.push_back({fmt::format("grid, at least {}", count(n)), number(cell * static_cast<double>(points)), "", "",
                          fmt::format("{} of {} points", count(points), count(w.grid->accepted_at.size()))});
      }
    }
    if (m == ScanMethod::monte_carlo && w.estimate) {
      const double range = w.scan.range();
      const std::string need = oriented ? fmt::format(", at least {}", count(w.request.at_least.front())) : "";
      t.rows.push_back({"Monte Carlo, 95 %" + need, number(range * w.estimate->share), number(range * w.estimate->low),
                        number(range * w.estimate->high),
                        fmt::format("{} poses, {} accepted", count(w.estimate->tally.poses), count(w.estimate->tally.accepted))});
    }
  }
  return t;
}

Table workspace_extent(const Workspace& w, const mechanics::Machine& machine) {
  const std::uint64_t need = w.request.at_least.empty() ? 1 : w.request.at_least.front();
  Table t{"Extent of the workspace", {"coordinate", "least", "most"}, {false, true, true}, {}};
  const bool centred = w.grid && !w.grid->centroid.empty();  // by its poses; boxes of a proof do not tell
  if (centred) t.headings.push_back("centroid"), t.numeric.push_back(true);
  for (std::size_t i = 0; i < w.scan.points.size(); ++i) {
    const Coordinate& c = coordinate_of(machine, w.scan.points[i]);
    const auto bracket = [&](const program::Bounds& b) {
      if (!b.bounded()) return std::string("-");
      const Apart ends = show_apart(b.low, b.high, c.unit);
      return ends.value == ends.beside ? ends.value : ends.value + " to " + ends.beside;
    };
    std::vector<std::string> row{symbol(c.name)};
    if (w.proof && i < w.proof->low.size() && !w.proof->empty)
      row.insert(row.end(), {bracket(w.proof->low[i]), bracket(w.proof->high[i])});
    else if (const auto least = w.grid ? analysis::end_of_points(w, need, i, false) : std::nullopt)
      row.insert(row.end(), {show(*least, c.unit), show(*analysis::end_of_points(w, need, i, true), c.unit)});
    else
      continue;
    // A sum of numbers that cancel leaves rounding.
    const scan::Axis& a = w.scan.points[i];
    const auto clean = [&](double x) { return std::abs(x) < 1e-12 * std::max(std::abs(a.from), std::abs(a.to)) ? 0.0 : x; };
    if (centred) row.push_back(show(clean(w.grid->centroid[i]), c.unit));
    t.rows.push_back(std::move(row));
  }
  return t;
}

Table workspace_reasons(const Workspace& w) {
  const scan::Tally* tally = w.grid ? &w.grid->tally : w.estimate ? &w.estimate->tally : nullptr;
  // What is left after each limit: of a grid of one orientation the volume, as papers tabulate it.
  const bool volume = w.grid && w.scan.orientations.empty();
  Table t{
      "Why poses are refused: by the first limit that they break, in this order; by each limit, whatever else they break; and what is "
      "left, "
      "limit after limit",
      {"limit", "first", "first [%]", "any", "any [%]", volume ? fmt::format("left [{}]", typographic(w.unit)) : "left"},
      {false, true, true, true, true, true},
      {}};
  if (tally == nullptr || tally->first.empty()) return t;
  // Random poses are told by points, what refuses them by poses of all orientations.
  const std::uint64_t all = w.grid ? tally->poses : tally->poses * w.scan.orientation_count();
  std::uint64_t left = all;
  for (std::size_t m = 0; m < tally->first.size(); ++m) {
    left -= tally->first[m];
    if (tally->any[m] == 0) continue;
    t.rows.push_back({w.margins.margins[m].name, count(tally->first[m]), share(tally->first[m], all), count(tally->any[m]),
                      share(tally->any[m], all),
                      volume ? typeset(format_number(w.scan.cell() * static_cast<double>(left), 5)) : count(left)});
  }
  return t;
}

Table safe_limits(const Workspace& w, const mechanics::Machine& machine) {
  Table t{"", {"coordinate", "least", "bound there by", "most", "bound there by"}, {false, true, false, true, false}, {}};
  if (!w.safe_box || !w.safe_box->found) return t;
  std::string ball;
  if (w.safe_ball && w.safe_ball->found) {
    const bool lengths =
        std::ranges::all_of(w.safe_axes, [&](const scan::Axis& a) { return coordinate_of(machine, a).sense() == Sense::linear; });
    const bool even = std::ranges::all_of(w.safe_proportions, [&](double p) { return p == w.safe_proportions.front(); });
    ball = lengths && even ? fmt::format(" The largest ball around home has a radius of {}",
                                         show(w.safe_ball->radius * w.safe_proportions.front(), "m"))
                           : fmt::format(" The largest ellipsoid around home of the same proportions has {} of the ranges' half widths",
                                         typeset(format_number(w.safe_ball->radius, 4)));
    ball += fmt::format("; it is bound by {}.", margin_words(w, w.safe_ball->margin));
  }
  const std::string held = held_words(w, machine);
  t.caption = fmt::format("Safe limits: every pose of this box around home keeps all limits, all coordinates at once{}. That is proved.{}",
                          held.empty() ? "" : ", with " + held, ball);
  for (std::size_t i = 0; i < w.safe_axes.size(); ++i) {
    const Coordinate& c = coordinate_of(machine, w.safe_axes[i]);
    const auto told = [&](double si, bool upper) {
      const SafeEnd end = safe_end_of(si, c, upper);
      return fmt::format("{} {}", typeset(fmt::format("{:.3f}", end.value)), end.unit == "deg" ? "°" : end.unit);
    };
    const auto why = [&](int margin, bool sharp) { return margin_words(w, margin) + (sharp || margin < 0 ? "" : " (not proved farther)"); };
    t.rows.push_back({symbol(c.name), told(w.safe_box->sides[i].low, false), why(w.safe_box->low_margin[i], w.safe_box->low_sharp[i]),
                      told(w.safe_box->sides[i].high, true), why(w.safe_box->high_margin[i], w.safe_box->high_sharp[i])});
  }
  return t;
}

document::Data workspace_counts(const Workspace& w, const std::string& name) {
  const scan::Tally* tally = w.grid ? &w.grid->tally : w.estimate ? &w.estimate->tally : nullptr;
  document::Data d{name, {"limit", "refused_first", "refused_any"}, {{}, {}}, {{}}};
  if (tally == nullptr) return d;
  for (std::size_t m = 0; m < tally->first.size(); ++m) {
    d.words[0].push_back(w.margins.margins[m].name);
    d.columns[0].push_back(static_cast<double>(tally->first[m]));
    d.columns[1].push_back(static_cast<double>(tally->any[m]));
  }
  return d;
}

}  // namespace pmreport::section
