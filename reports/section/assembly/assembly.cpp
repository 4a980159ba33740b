// Section `assembly`: every pose that the actuator values of one moment allow, and how near the motion comes to another of them.
#include <reports/section/assembly/assembly.hpp>
#include <reports/section/common/plots.hpp>
#include <reports/section/common/words.hpp>

#include <core/mechanics/assembly/follow.hpp>
#include <core/text/text.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace pmreport::section {

using document::Paragraph;
using mechanics::AssemblyMode;
using mechanics::AssemblyModes;

namespace {

constexpr std::size_t most_pictures = 8, most_curves = 6;
constexpr scene::Quality small_and_many{800, 600, false, 1};  // a quarter of the work of a snapshot's pixel
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double present = 1e-6;  // of the characteristic length: the mode that the mechanism is in

std::string working_mode(const AssemblyModes& found, std::size_t word) {
  return found.words[word].name.empty() ? "as set" : found.words[word].name;
}

// Coordinates of a mode in the units that read best for all modes.
document::Table table_of(const Analysis& a, const AssemblyModes& found, bool has_words) {
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
  if (has_words) add("working mode", false);
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
    if (has_words) row.push_back(working_mode(found, m.word));
    row.push_back(m.determinant > 0 ? "+" : "−");
    row.push_back(fmt::format("{:.2f}", m.distance * away.per_si));
    row.push_back(m.within_limits ? "kept" : "broken");
    table.rows.push_back(std::move(row));
  }
  return table;
}

document::Gallery pictures(const Analysis& a, const AssemblyModes& found, const Stage& stage, const Progress& progress) {
  const std::size_t n = std::min(most_pictures, found.modes.size());
  document::Gallery g{{}, "All pictures of modes share one camera."};
  if (n < found.modes.size()) g.caption += fmt::format(" The {} nearest of {} modes are shown.", n, found.modes.size());
  scene::Bounds bounds;
  for (std::size_t k = 0; k < n; ++k) scene::include(bounds, *found.words[found.modes[k].word].machine, found.modes[k].pose);
  const View view{"isometric", 45 * std::numbers::pi / 180, std::atan(1 / std::numbers::sqrt2)};
  scene::Extras extras;
  extras.labels = false;
  std::vector<Stage::Ordered> ordered;
  for (std::size_t k = 0; k < n; ++k) {
    const AssemblyMode& m = found.modes[k];
    std::string caption = fmt::format("Mode {}", k + 1);
    if (m.distance < present * a.length())
      caption += ", the present one";
    else
      caption += fmt::format(", {} away", show(m.distance, "m"));
    caption += m.determinant > 0 ? ", det G > 0" : ", det G < 0";
    if (!found.words[m.word].name.empty()) caption += "; " + found.words[m.word].name;
    ordered.push_back(stage.picture(*found.words[m.word].machine, m.pose, extras, bounds, view, fmt::format("assembly-{}", k + 1), caption,
                                    small_and_many));
  }
  for (Stage::Ordered& o : ordered) {
    progress.stop_if_asked();
    g.pictures.push_back(o.wait());
  }
  return g;
}

std::string counted(const AssemblyModes& found, bool has_words) {
  const auto own = std::count_if(found.modes.begin(), found.modes.end(), [](const AssemblyMode& m) { return m.word == 0; });
  const auto kept = std::count_if(found.modes.begin(), found.modes.end(), [](const AssemblyMode& m) { return m.within_limits; });
  std::string s = plural(static_cast<int>(found.modes.size()), "real assembly mode");
  if (has_words) s += fmt::format(", {} of them in the working mode of the scenario", own);
  return s + fmt::format("; {} of them {} within all strokes and joint limits.", kept, kept == 1 ? "is" : "are");
}

// How the search went, and what follows from it.
std::string searched(const AssemblyModes& found) {
  int rarest = std::numeric_limits<int>::max();
  for (const AssemblyMode& m : found.modes) rarest = std::min(rarest, m.reached_by_starts);
  std::string s = fmt::format(
      "How they were found: Newton's method from {} random poses, of which {} arrived at a mode, and {} curves on which the actuators move "
      "with one degree of freedom, followed from mode to mode. ",
      found.starts, found.arrivals, found.curves);
  s += found.last_new > 1 ? fmt::format("The last start to find a mode that was not known was number {}; ", found.last_new)
                          : "The curves from the present pose found all; ";
  s += rarest > 0 ? fmt::format("every mode was reached by {} or more. ", plural(rarest, "start"))
                  : "some modes were reached by no start, only along curves. ";
  s += "There is no proof that there are no more.";
  if (!found.complete_search)
    s += " The search ended at the most modes that are kept: the actuators may leave the platform a continuum of poses.";
  return s;
}

class Along {  // the motion, and the modes that accompany it
 public:
  Along(const Analysis& a, const AssemblyModes& found, int start, const mechanics::AssemblyOptions& options)
      : a_(a), listed_(found.modes.size()) {
    const mechanics::Trajectory& motion = a.trajectory();
    const int n = a.samples();
    std::vector<int> later;
    for (const int k : {n - 1, 0, n / 2})
      if (later.size() < 2 && std::abs(k - start) > n / 4) later.push_back(k);
    const mechanics::PoseAt pose = [&](double t) {
      Eigen::VectorXd q(a.machine().dof()), rate(q.size()), acceleration(q.size());
      if (!motion.at(t, q.data(), rate.data(), acceleration.data())) return mechanics::Pose{};
      return a.machine().pose({q.data(), static_cast<std::size_t>(q.size())});
    };
    mechanics::AssemblyOptions quick = options;
    quick.quiet_arrivals = 60;
    quick.most_starts = 300;
    tracks_ = mechanics::follow_assembly_modes(found, a.time(), pose, start, later, a.length(), quick);
    // Numbers of the modes as the table has them; those that are born later go on from there.
    std::size_t later_born = listed_, next = 0;
    for (std::size_t k = 0; k < found.modes.size(); ++k) {
      const bool own = found.modes[k].word == 0 && found.modes[k].distance < 1e-5 * a.length();
      if (!own && next < tracks_.tracks.size()) numbers_.push_back(k + 1), ++next;
    }
    while (numbers_.size() < tracks_.tracks.size()) numbers_.push_back(++later_born);
  }

  double least() const { return tracks_.least; }
  bool any() const { return std::isfinite(tracks_.least); }

  std::vector<std::string> sentences() const {
    std::vector<std::string> out;
    const std::size_t nearest = numbers_[tracks_.least_track];
    out.push_back(fmt::format("Along the motion mode {}{} comes nearest to the pose of the mechanism: {} away at t = {}.", nearest,
                              nearest > listed_ ? ", which comes into being on the way," : "", show(tracks_.least, "m"),
                              show_time(a_, tracks_.least_sample)));
    for (const Event& e : events()) {
      const std::string when = fmt::format("t = {}", show(e.time, "s", 4));
      std::string s = fmt::format("At {} ", when);
      if (!e.ending.empty()) s += modes_words(e.ending) + (e.ending.size() == 1 ? " vanishes" : " vanish");
      if (!e.beginning.empty()) {
        if (!e.ending.empty()) s += " and ";
        s += modes_words(e.beginning) + (e.beginning.size() == 1 ? " comes into being" : " come into being");
      }
      out.push_back(s + (e.ending.size() + e.beginning.size() > 1 ? ": assembly modes meet there on a singular surface."
                                                                  : ": it meets another there, or leaves what can be assembled."));
    }
    return out;
  }

  figure::Figure figure() const {
    std::vector<std::size_t> order(tracks_.tracks.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto least = [&](std::size_t i) {
      double d = std::numeric_limits<double>::infinity();
      for (const double x : tracks_.tracks[i].distance)
        if (x < d) d = x;
      return d;
    };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t x, std::size_t y) { return least(x) < least(y); });
    if (order.size() > most_curves) order.resize(most_curves);
    double largest = 0;
    for (const std::size_t i : order)
      for (const double x : tracks_.tracks[i].distance)
        if (std::isfinite(x)) largest = std::max(largest, x);
    figure::Figure f{"assembly",
                     "Distance of the other assembly modes from the pose of the mechanism along the motion.",
                     "data/assembly.csv",
                     figure::Width::full,
                     1,
                     {}};
    if (order.size() < tracks_.tracks.size())
      f.caption += fmt::format(" The {} that come nearest, of {}.", order.size(), tracks_.tracks.size());
    const DisplayUnit d = display_unit("m", largest);
    figure::Panel p = panel(a_, "distance of other modes", "distance", "m", {});
    p.y = {"distance", d.label};
    for (const std::size_t i : order) {
      figure::Series s{fmt::format("mode {}", numbers_[i]), a_.time(), tracks_.tracks[i].distance, -1};
      for (double& y : s.y) y *= d.per_si;
      p.series.push_back(std::move(s));
    }
    f.panels.push_back(std::move(p));
    return f;
  }

  // Modes that begin or end at one time.
  struct Event {
    double time;
    std::vector<std::size_t> ending, beginning;
  };
  std::vector<Event> events() const {
    std::vector<Event> out;
    const std::vector<double>& t = a_.time();
    const double together = t.size() > 1 ? 1.5 * (t.back() - t.front()) / static_cast<double>(t.size() - 1) : 0;
    const auto enter = [&](double time, std::size_t number, bool ends) {
      auto at = std::find_if(out.begin(), out.end(), [&](const Event& e) { return std::abs(e.time - time) <= together; });
      if (at == out.end()) at = out.insert(out.end(), {time, {}, {}});
      (ends ? at->ending : at->beginning).push_back(number);
    };
    for (std::size_t i = 0; i < tracks_.tracks.size(); ++i) {
      if (tracks_.tracks[i].vanishes) enter(tracks_.tracks[i].ends, numbers_[i], true);
      if (tracks_.tracks[i].born) enter(tracks_.tracks[i].begins, numbers_[i], false);
    }
    std::stable_sort(out.begin(), out.end(), [](const Event& x, const Event& y) { return x.time < y.time; });
    return out;
  }
  static std::string modes_words(const std::vector<std::size_t>& numbers) {
    std::vector<std::string> names;
    for (const std::size_t n : numbers) names.push_back(std::to_string(n));
    return (numbers.size() == 1 ? "mode " : "modes ") + listed(names);
  }

  document::Data data() const {
    document::Data out{"assembly", {"t [s]", "nearest [m]"}, {a_.time(), tracks_.nearest}};
    for (std::size_t i = 0; i < tracks_.tracks.size(); ++i) {
      out.headings.push_back(fmt::format("mode_{}_distance [m]", numbers_[i]));
      out.columns.push_back(tracks_.tracks[i].distance);
    }
    return out;
  }

 private:
  const Analysis& a_;
  mechanics::ModeTracks tracks_;
  std::size_t listed_;  // modes in the table
  std::vector<std::size_t> numbers_;
};

}  // namespace

Result assembly_section(const Analysis& a, const AssemblyOptions& r, const Stage& stage, const Progress& progress) {
  Result result{{"assembly", "assembly", "Assembly modes", {}}, {}, {}, {}};
  auto& blocks = result.section.blocks;
  const mechanics::Machine& m = a.machine();
  const bool moves = a.samples() > 0;
  const int sample = moves ? a.sample_at(r.time) : -1;
  if (moves && a.outcome(sample) == Outcome::unreachable) {
    blocks.push_back(Paragraph{Paragraph::Tone::warning,
                               fmt::format("t = {}: the mechanism cannot be assembled: {}.", show_time(a, sample), a.why(sample))});
    return result;
  }
  const mechanics::Pose pose = moves ? a.pose(sample) : m.home_pose();
  const Eigen::VectorXd reference = moves ? Eigen::VectorXd(a.trajectory().value.row(sample)) : m.home();
  const bool given = r.actuators.size() > 0;
  const Eigen::VectorXd here = Eigen::Map<const Eigen::VectorXd>(pose.numbers.data() + m.layout().actuator(0), m.dof());
  mechanics::AssemblyOptions options;
  options.working_modes = r.working_modes;
  const AssemblyModes found = find_assembly_modes(m, given ? r.actuators : here, reference, options);
  progress.stop_if_asked();
  const bool has_words = found.words.size() > 1;

  std::string values;
  for (int i = 0; i < m.dof(); ++i) {
    const Actuator& actuator = m.topology().actuators[static_cast<std::size_t>(i)];
    values += fmt::format("{}{} = {}", i > 0 ? ", " : "", symbol(actuator.name), show(given ? r.actuators(i) : here(i), actuator.unit, 6));
  }
  const auto tell = [&](const std::string& text) { blocks.push_back(Paragraph{Paragraph::Tone::plain, text}); };
  tell(fmt::format("The actuator values {} do not determine the pose alone: the mechanism can be assembled with them in several ways. {}{}",
                   given   ? "given"
                   : moves ? "at t = " + show_time(a, sample)
                           : "at home",
                   values + ". ", counted(found, has_words)));
  tell(fmt::format(
      "The distance between two poses is √(|Δp|² + (L·θ)²), with Δp the way of the reference point, θ the angle between the two "
      "orientations and L = {} the characteristic length.",
      show(a.length(), "m")));
  blocks.push_back(table_of(a, found, has_words));
  if (!found.modes.empty()) blocks.push_back(pictures(a, found, stage, progress));

  document::Proof proof;
  double residual = 0, gap = 0, misalignment = 0, nearest = nan;
  int own = 0;
  for (const AssemblyMode& mode : found.modes) {
    residual = std::max(residual, mode.residual), gap = std::max(gap, mode.gap), misalignment = std::max(misalignment, mode.misalignment);
    own += mode.word == 0;
    if (!(nearest <= mode.distance)) nearest = mode.distance;
  }
  result.values = {{"assembly", "modes", "", double(found.modes.size())}, {"assembly", "own_working_mode", "", double(own)}};
  proof.lines.push_back(
      {"Every mode has the actuator values", "by substitution into inverse displacement, of the mechanism's size", residual, 1e-10, ""});
  proof.lines.push_back({"Joints meet in every mode", "joint centres as both bodies carry them, of the mechanism's size", gap, 1e-9, ""});
  proof.lines.push_back({"Joint axes agree in every mode", "axes as both bodies carry them", misalignment, 1e-9, "rad"});
  if (!given) {
    proof.lines.push_back({moves ? "The pose of the motion is among the modes" : "The home pose is among the modes",
                           "its distance from the nearest, by the characteristic length", nearest / a.length(), 1e-7, ""});
  }
  if (!given && moves) {
    const Along along(a, found, sample, options);
    progress.stop_if_asked();
    if (along.any()) {
      for (const std::string& s : along.sentences()) tell(s);
      blocks.push_back(along.figure());
      result.data.push_back(along.data());
      result.values.push_back({"assembly", "nearest", "m", along.least()});
    }
  }
  tell(searched(found));
  blocks.push_back(proof);
  return result;
}

}  // namespace pmreport::section
