#include <reports/section/assembly/along.hpp>
#include <reports/section/common/plots.hpp>
#include <reports/section/common/words/words.hpp>

#include <core/text/text.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pmreport::section {

using analysis::ModesAlong;
using mechanics::ModeEnd;
using mechanics::ModeEvent;

namespace {

constexpr std::size_t most_curves = 6;

// First and last sample with a pose; none: the motion has no pose at all, and there are no modes either.
std::pair<int, int> ends_of(const ModesAlong& along) {
  const std::vector<int>& count = along.tracks.count;
  const auto first = std::find_if(count.begin(), count.end(), [](int n) { return n > 0; });
  const auto last = std::find_if(count.rbegin(), count.rend(), [](int n) { return n > 0; });
  return {static_cast<int>(first - count.begin()), static_cast<int>(count.rend() - last) - 1};
}

// Whether the mode that is met ends there as well: where three meet, one may go on.
bool both_end(const ModesAlong& along, const ModeEvent& e) {
  const mechanics::ModeTrack& other = along.tracks.tracks[e.with];
  const ModeEnd& end = e.birth ? other.begins : other.ends;
  return end.how == ModeEnd::How::meets && end.with == e.track;
}

std::string what(const ModesAlong& along, const ModeEvent& e) {
  const std::string mode = fmt::format("mode {}", along.numbers[e.track]);
  const char *one = e.birth ? "comes into being" : "vanishes", *both = e.birth ? "come into being" : "vanish";
  switch (e.how) {
    case ModeEnd::How::meets:
      if (e.with == mechanics::own_mode) return fmt::format("{} {}: it meets the mode of the mechanism on a singular surface", mode, one);
      if (e.with == mechanics::no_track)
        return fmt::format("{} {}: it meets another on a singular surface, which exists for less than a sample", mode, one);
      if (!both_end(along, e))
        return fmt::format("{} {}: it meets mode {} on a singular surface, which goes on", mode, one, along.numbers[e.with]);
      return fmt::format(
          "modes {} {}: they meet on a singular surface",
          listed({std::to_string(along.numbers[std::min(e.track, e.with)]), std::to_string(along.numbers[std::max(e.track, e.with)])}),
          both);
    case ModeEnd::How::reach:
      return fmt::format("{} {}: it comes to the end of reach", mode, one);
    default:
      return fmt::format("{} cannot be followed any further {}", mode, e.birth ? "back" : "on");
  }
}

}  // namespace

std::vector<std::string> sentences(const Analysis& a, const ModesAlong& along, std::size_t listed_modes) {
  const mechanics::ModeTracks& tracks = along.tracks;
  std::vector<std::string> out;
  if (std::isfinite(tracks.least)) {
    const std::size_t nearest = along.numbers[tracks.least_track];
    out.push_back(fmt::format("Along the motion mode {}{} comes nearest to the pose of the mechanism: {} away at t = {}.", nearest,
                              nearest > listed_modes ? ", which is not there at the time of the table," : "", show(tracks.least, "m"),
                              show_time(a, tracks.least_sample)));
  }
  const auto [first, last] = ends_of(along);
  int fewest = std::numeric_limits<int>::max(), most = 0;
  for (int k = first; k <= last; ++k)
    if (const int n = tracks.count[static_cast<std::size_t>(k)]; n > 0) fewest = std::min(fewest, n), most = std::max(most, n);
  const int at_first = tracks.count[static_cast<std::size_t>(first)], at_last = tracks.count[static_cast<std::size_t>(last)];
  if (tracks.events.empty())
    out.push_back(fmt::format("The motion has {} at all of its samples: none comes into being on the way, and none vanishes.",
                              plural(at_first, "assembly mode")));
  else
    out.push_back(fmt::format("The motion has {} at its beginning, {} at its end, and between {} and {} on the way.",
                              plural(at_first, "assembly mode"), at_last, fewest, most));
  std::vector<std::string> times;
  std::vector<int> searched = tracks.searched;
  std::sort(searched.begin(), searched.end());
  for (const int k : searched) times.push_back(show_time(a, k));
  std::string s = fmt::format(
      "All modes were looked for at t = {}, at both ends as thoroughly as for the table and shortly on the way; from "
      "there they were followed from sample to sample, and round the folds at which two meet. ",
      listed(times));
  if (tracks.further > 0)
    s += fmt::format("{} found by no search there, but by following others or from those of another time. ",
                     plural(tracks.further, "mode was", "modes were"));
  out.push_back(s + "Modes that come into being and vanish again between these times, without meeting another, would not be seen.");
  if (!tracks.continua.empty()) {
    std::vector<std::string> where;
    for (const int k : tracks.continua) where.push_back(show_time(a, k));
    out.push_back(fmt::format("At t = {} there are continua besides; they are neither counted here nor followed.", listed(where)));
  }
  return out;
}

document::Table table_of_events(const ModesAlong& along) {
  document::Table table{"Assembly modes that come into being or vanish along the motion.", {"t [s]", "what happens"}, {true, false}, {}};
  for (const ModeEvent& e : along.tracks.events) table.rows.push_back({typeset(fmt::format("{:.6g}", e.time)), what(along, e)});
  return table;
}

figure::Figure figure_of_modes(const Analysis& a, const ModesAlong& along) {
  std::vector<std::size_t> order(along.tracks.tracks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto least = [&](std::size_t i) {
    double d = std::numeric_limits<double>::infinity();
    for (const double x : along.tracks.tracks[i].distance)
      if (x < d) d = x;
    return d;
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t x, std::size_t y) { return least(x) < least(y); });
  if (order.size() > most_curves) order.resize(most_curves);
  double largest = 0;
  for (const std::size_t i : order)
    for (const double x : along.tracks.tracks[i].distance)
      if (std::isfinite(x)) largest = std::max(largest, x);
  figure::Figure f{"assembly",
                   "Distance of the other assembly modes from the pose of the mechanism along the motion.",
                   "data/assembly.csv",
                   figure::Width::full,
                   1,
                   {}};
  if (order.size() < along.tracks.tracks.size())
    f.caption += fmt::format(" The {} that come nearest, of {}.", order.size(), along.tracks.tracks.size());
  const DisplayUnit d = display_unit("m", largest);
  figure::Panel p = panel(a, "distance of other modes", "distance", "m", {});
  p.y = {"distance", d.label};
  for (const std::size_t i : order) {
    figure::Series s{fmt::format("mode {}", along.numbers[i]), a.time(), along.tracks.tracks[i].distance, -1};
    for (double& y : s.y) y *= d.per_si;
    p.series.push_back(std::move(s));
  }
  f.panels.push_back(std::move(p));
  return f;
}

document::Data data_of_modes(const Analysis& a, const ModesAlong& along) {
  document::Data out{"assembly", {"t [s]", "nearest [m]"}, {a.time(), along.tracks.nearest}};
  for (std::size_t i = 0; i < along.tracks.tracks.size(); ++i) {
    out.headings.push_back(fmt::format("mode_{}_distance [m]", along.numbers[i]));
    out.columns.push_back(along.tracks.tracks[i].distance);
  }
  return out;
}

document::Evidence same_at_both_ends(const ModesAlong& along) {
  const auto [first, last] = ends_of(along);
  const std::vector<int>& count = along.tracks.count;
  return {"As many modes at both ends of the motion", "its first and its last pose are one",
          static_cast<double>(std::abs(count[static_cast<std::size_t>(first)] - count[static_cast<std::size_t>(last)])), 0, ""};
}

}  // namespace pmreport::section
