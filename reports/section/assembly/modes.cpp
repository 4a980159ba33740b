#include <reports/section/assembly/modes.hpp>
#include <reports/section/common/words/words.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace pmreport::section {

using mechanics::AssemblyMode;
using mechanics::AssemblyModes;
using mechanics::ModeContinuum;

namespace {

constexpr std::size_t most_pictures = 8;
constexpr scene::Quality small_and_many{800, 600, false, 1};  // a quarter of the work of a snapshot's pixel
constexpr double present = 1e-6;                              // of the characteristic length: the mode that the mechanism is in

bool has_words(const AssemblyModes& found) { return found.words.size() > 1; }

std::string working_mode(const AssemblyModes& found, std::size_t word) {
  return found.words[word].name.empty() ? "as set" : found.words[word].name;
}

std::string family(const ModeContinuum& c) {
  return c.dimension == 1 ? "a curve" : c.dimension == 2 ? "a surface" : fmt::format("a family of {} dimensions", c.dimension);
}

std::string sign(const AssemblyMode& m) { return m.twofold ? "0, double" : m.determinant > 0 ? "+" : "−"; }

}  // namespace

// Coordinates of a mode in the units that read best for all modes.
document::Table table_of_modes(const Analysis& a, const AssemblyModes& found) {
  const Topology& t = a.machine().topology();
  const bool has_present =
      std::any_of(found.modes.begin(), found.modes.end(), [&](const AssemblyMode& m) { return m.distance < present * a.length(); });
  document::Table table{
      std::string(a.samples() > 0 ? "Assembly modes, nearest to the pose of the motion first" : "Assembly modes, nearest to home first") +
          (has_present ? "; a dot marks the mode that the mechanism is in." : "."),
      {"", "mode"},
      {false, true},
      {}};
  std::vector<DisplayUnit> units;
  for (std::size_t i = 0; i < t.coordinates.size(); ++i) {
    double largest = 0;
    for (const AssemblyMode& m : found.modes) largest = std::max(largest, std::abs(m.coordinates(static_cast<Eigen::Index>(i))));
    units.push_back(display_unit(t.coordinates[i].unit, largest));
    table.headings.push_back(fmt::format("{} [{}]", symbol(t.coordinates[i].name), units.back().label));
    table.numeric.push_back(true);
  }
  const auto add = [&](const std::string& heading, bool numeric) {
    table.headings.push_back(heading);
    table.numeric.push_back(numeric);
  };
  if (has_words(found)) add("working mode", false);
  double farthest = 0;
  for (const AssemblyMode& m : found.modes) farthest = std::max(farthest, m.distance);
  const DisplayUnit away = display_unit("m", farthest);
  add("det G", false);
  add("distance [" + away.label + "]", true);
  add("limits", false);
  for (std::size_t k = 0; k < found.modes.size(); ++k) {
    const AssemblyMode& m = found.modes[k];
    std::vector<std::string> row{m.distance < present * a.length() ? "•" : "", std::to_string(k + 1)};
    for (std::size_t i = 0; i < units.size(); ++i) {
      const double x = m.coordinates(static_cast<Eigen::Index>(i)) * units[i].per_si;
      row.push_back(typeset(fmt::format("{:.2f}", std::abs(x) < 0.005 ? 0.0 : x)));
    }
    if (has_words(found)) row.push_back(working_mode(found, m.word));
    row.push_back(sign(m));
    row.push_back(fmt::format("{:.2f}", m.distance * away.per_si));
    row.push_back(m.within_limits ? "kept" : "broken");
    table.rows.push_back(std::move(row));
  }
  return table;
}

// Of each continuum how far every coordinate goes on it.
document::Table table_of_continua(const Analysis& a, const AssemblyModes& found) {
  const auto& coordinates = a.machine().topology().coordinates;
  const auto n = static_cast<Eigen::Index>(coordinates.size());
  document::Table table{
      "Continua: poses that have the same actuator values and go over into one another, from the smallest to the largest "
      "value of each coordinate.",
      {"continuum", "poses"},
      {true, false},
      {}};
  std::vector<Eigen::VectorXd> low, high;
  Eigen::VectorXd largest = Eigen::VectorXd::Zero(n);
  for (const ModeContinuum& c : found.continua) {
    low.push_back(c.coordinates.front()), high.push_back(c.coordinates.front());
    for (const Eigen::VectorXd& q : c.coordinates) low.back() = low.back().cwiseMin(q), high.back() = high.back().cwiseMax(q);
    largest = largest.cwiseMax(low.back().cwiseAbs()).cwiseMax(high.back().cwiseAbs());
  }
  std::vector<DisplayUnit> units;
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto& of = coordinates[static_cast<std::size_t>(i)];
    units.push_back(display_unit(of.unit, largest(i)));
    table.headings.push_back(fmt::format("{} [{}]", symbol(of.name), units.back().label));
    table.numeric.push_back(false);
  }
  if (has_words(found)) table.headings.push_back("working mode"), table.numeric.push_back(false);
  table.headings.push_back("extent");
  table.numeric.push_back(false);
  for (std::size_t k = 0; k < found.continua.size(); ++k) {
    const ModeContinuum& c = found.continua[k];
    std::vector<std::string> row{std::to_string(k + 1), family(c) + (c.dimension > 1 ? "" : c.closed ? ", closed" : ", open")};
    for (Eigen::Index i = 0; i < n; ++i) {
      const double per_si = units[static_cast<std::size_t>(i)].per_si;
      const auto value = [&](double x) { return typeset(fmt::format("{:.2f}", std::abs(x * per_si) < 0.005 ? 0.0 : x * per_si)); };
      const bool around = c.closed && std::abs(c.coordinates.back()(i) - c.coordinates.front()(i)) > std::numbers::pi &&
                          coordinates[static_cast<std::size_t>(i)].sense() == Sense::rotary;
      row.push_back(around ? "all around" : value(low[k](i)) + " … " + value(high[k](i)));
    }
    if (has_words(found)) row.push_back(working_mode(found, c.word));
    row.push_back(show(c.extent, "m"));
    table.rows.push_back(std::move(row));
  }
  return table;
}

document::Gallery pictures_of_modes(const Analysis& a, const AssemblyModes& found, const Stage& stage, const Progress& progress) {
  struct Shown {
    std::size_t word;
    const mechanics::Pose& pose;
    std::string id, caption;
  };
  std::vector<Shown> shown;
  const std::size_t n = std::min(most_pictures, found.modes.size());
  for (std::size_t k = 0; k < n; ++k) {
    const AssemblyMode& m = found.modes[k];
    const std::string where = m.distance < present * a.length() ? ", the present one" : fmt::format(", {} away", show(m.distance, "m"));
    const std::string side = m.twofold ? ", det G = 0: a double root" : m.determinant > 0 ? ", det G > 0" : ", det G < 0";
    shown.push_back({m.word, m.pose, fmt::format("assembly-{}", k + 1), fmt::format("Mode {}{}{}", k + 1, where, side)});
  }
  if (!found.continua.empty()) {
    const ModeContinuum& c = found.continua.front();
    shown.push_back({c.word, c.poses[c.nearest], "assembly-continuum-1",
                     fmt::format("Continuum 1, {}", c.distance < present * a.length() ? "the present pose on it" : "its nearest pose")});
    shown.push_back({c.word, c.poses[c.farthest], "assembly-continuum-2",
                     fmt::format("Continuum 1, a pose with the same actuator values, {} away from the other", show(c.extent, "m"))});
  }
  document::Gallery g{{}, "All pictures of modes share one camera."};
  if (n < found.modes.size()) g.caption += fmt::format(" The {} nearest of {} modes are shown.", n, found.modes.size());
  scene::Bounds bounds;
  for (const Shown& s : shown) scene::include(bounds, *found.words[s.word].machine, s.pose);
  const View view{"auto", 0, 0};
  scene::Extras extras;
  extras.labels = false;
  std::vector<Stage::Ordered> ordered;
  for (Shown& s : shown) {
    if (!found.words[s.word].name.empty()) s.caption += "; " + found.words[s.word].name;
    ordered.push_back(stage.picture(*found.words[s.word].machine, s.pose, extras, bounds, view, s.id, s.caption, small_and_many));
  }
  for (Stage::Ordered& o : ordered) {
    progress.stop_if_asked();
    g.pictures.push_back(o.wait());
  }
  return g;
}

std::string counted(const AssemblyModes& found) {
  const auto count = [&](auto&& which) { return std::count_if(found.modes.begin(), found.modes.end(), which); };
  const auto own = count([](const AssemblyMode& m) { return m.word == 0; });
  const auto kept = count([](const AssemblyMode& m) { return m.within_limits; });
  const auto twofold = count([](const AssemblyMode& m) { return m.twofold; });
  const auto modes = static_cast<int>(found.modes.size()), continua = static_cast<int>(found.continua.size());
  std::string s = plural(modes, continua > 0 ? "isolated real assembly mode" : "real assembly mode");
  if (continua > 0) {
    const bool curves = std::all_of(found.continua.begin(), found.continua.end(), [](const ModeContinuum& c) { return c.dimension == 1; });
    s += fmt::format(" and {} ({} with the same actuator values)", plural(continua, "continuum", "continua"),
                     continua > 1 ? (curves ? "curves of poses" : "families of poses") : family(found.continua.front()) + " of poses");
  }
  if (modes == 0) return s + ".";
  if (has_words(found)) s += fmt::format(", {} of the modes in the working mode of the scenario", own);
  if (twofold > 0)
    s += fmt::format("; {} of them {} double: two modes have met there on a singular surface", twofold, twofold == 1 ? "is" : "are");
  return s + fmt::format("; {} of them {} within all strokes and joint limits.", kept, kept == 1 ? "is" : "are");
}

std::string searched(const AssemblyModes& found) {
  int rarest = std::numeric_limits<int>::max();
  for (const AssemblyMode& m : found.modes) rarest = std::min(rarest, m.reached_by_starts);
  for (const ModeContinuum& c : found.continua) rarest = std::min(rarest, c.reached_by_starts);
  std::string s = fmt::format(
      "How they were found: Newton's method from {} random poses, of which {} arrived at a mode, and {} curves on which the actuators move "
      "with one degree of freedom, followed from mode to mode. ",
      found.starts, found.arrivals, found.curves);
  if (found.modes.empty() && found.continua.empty()) return s + "None arrived. There is no proof that there is no mode.";
  s += found.last_new > 1 ? fmt::format("The last start to find a mode that was not known was number {}; ", found.last_new)
                          : "The curves from the present pose found all; ";
  s += rarest > 0 ? fmt::format("every mode was reached by {} or more. ", plural(rarest, "start"))
                  : "some modes were reached by no start, only along curves. ";
  if (found.edges > 0)
    s += fmt::format(
        "Curves were led across {} into another working mode, those counted as one that lie within 0.02 of the mechanism's size. ",
        plural(found.edges, "end of reach", "ends of reach"));
  if (found.curves_far > 0)
    s += fmt::format("{} left where {} went farther than 30 times the mechanism's size. ",
                     plural(found.curves_far, "curve was", "curves were"), found.curves_far == 1 ? "it" : "they");
  if (found.curves_cut > 0)
    s += fmt::format("{} given up before {} end, after 3000 steps or at a place too sharp for the shortest one. ",
                     plural(found.curves_cut, "curve was", "curves were"), found.curves_cut == 1 ? "its" : "their");
  switch (found.ended) {
    case AssemblyModes::Ended::quiet:
      s += "The search ended when a long run of starts brought nothing new. ";
      break;
    case AssemblyModes::Ended::most_starts:
      s += fmt::format("The search ended at its {} starts, before a run without anything new was long enough. ", found.starts);
      break;
    case AssemblyModes::Ended::most_modes:
      s += fmt::format("The search stopped at {} modes. ", found.modes.size() + found.continua.size());
      break;
    case AssemblyModes::Ended::no_start:
      s += "The search ended because random poses could no longer be assembled. ";
      break;
  }
  const auto cut = std::count_if(found.continua.begin(), found.continua.end(), [](const ModeContinuum& c) { return !c.whole; });
  if (cut > 0) s += fmt::format("{} not followed to the end. ", plural(static_cast<int>(cut), "continuum was", "continua were"));
  if (std::any_of(found.continua.begin(), found.continua.end(), [](const ModeContinuum& c) { return c.dimension > 1; }))
    s += "Continua of more than one dimension are known by some of their poses; two of them may be parts of one. ";
  return s + "There is no proof that there are no more.";
}

std::string beyond_the_coordinates(const Analysis& a, const mechanics::FurtherModes& further) {
  std::string s = fmt::format(
      "The table has the poses that the {} and the working modes of the mechanism express. Whether its joints allow others with these "
      "actuator values, the platform turned or moved otherwise, was tried on the bodies and joints alone: Newton's method from {} random "
      "starts closed all joints {}",
      plural(a.machine().dof(), "coordinate"), further.starts, further.arrivals == 1 ? "once" : fmt::format("{} times", further.arrivals));
  const auto all = static_cast<int>(further.poses.size());
  const auto isolated = static_cast<int>(
      std::count_if(further.poses.begin(), further.poses.end(), [](const mechanics::FurtherPose& p) { return p.isolated; }));
  if (all == 0) {
    s += further.arrivals > 0 ? ", always in a pose that those express." : ".";
  } else {
    s += fmt::format(", and found {} of the platform that those cannot express, the nearest {} away",
                     plural(isolated > 0 ? isolated : all, isolated > 0 ? "isolated pose" : "pose"),
                     show(further.poses.front().distance, "m"));
    if (isolated < all) s += isolated > 0 ? ", and besides some on continua" : ", all on continua";
    s += ".";
  }
  if (further.missed > 0)
    s += fmt::format(" {} in the table had been missed by the search above.",
                     plural(further.missed, "mode that is not", "modes that are not"));
  return s;
}

}  // namespace pmreport::section
