#include <reports/figure/layout/label_groups.hpp>
#include <reports/figure/layout/layout.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <reports/figure/layout/occupancy.hpp>

namespace pmreport::figure {
namespace {

constexpr double along_curve = 2.5;  // [pt] between the places tried along a curve
constexpr double off_curve = 1.8;    // [pt] from a curve to a name beside it
constexpr double inset_name = 2;     // [pt] from a name to the frame
constexpr double moat = 3.4;         // [pt] no other curve comes nearer to a name than this
constexpr double own_reach = 2.2;    // [pt] of a leader that lie on its own curve's ink

void mark(Occupancy& ink, const Trace& trace, const Frame& frame) {
  for (const Stroke& stroke : trace.strokes)
    for (std::size_t i = 0; i + 1 < stroke.size(); ++i) ink.mark(stroke[i], stroke[i + 1]);
  for (const Point dot : trace.dots) ink.mark(Box{dot.x, dot.y, 0, 0}.grown(mark_radius));
  for (const Exit& exit : trace.exits)
    ink.mark(Box{exit.x - exit_mark / 2, exit.above ? 0 : frame.height - exit_mark, exit_mark, exit_mark});
}

struct Candidate {
  Box box;
  Stroke leader;
  double cost;
};

class Inside {
 public:
  Inside(const Panel& panel, const std::vector<Trace>& traces, const std::vector<double>& lines, const Frame& frame,
         const std::vector<LabelGroup>& groups)
      : traces_(traces), frame_(frame), groups_(groups), all_(frame.width, frame.height) {
    for (std::size_t i = 0; i < panel.series.size(); ++i) mark(all_, traces[i], frame);
    for (const double y : lines) all_.mark({0, y}, {frame.width, y});
    all_.seal();
    for (const LabelGroup& g : groups) {
      Occupancy others(frame.width, frame.height);
      for (std::size_t i = 0; i < panel.series.size(); ++i)
        if (std::find(g.series.begin(), g.series.end(), static_cast<int>(i)) == g.series.end()) mark(others, traces[i], frame);
      for (const double y : lines) others.mark({0, y}, {frame.width, y});
      others.seal();
      others_.push_back(std::move(others));
    }
  }

  // Places beside the curve, above, below, right and left of its points.
  std::vector<Candidate> beside_curve(std::size_t g) const {
    std::vector<Candidate> out;
    const double w = groups_[g].width, h = groups_[g].height - 1;
    for (const Point at : points(g))
      for (const auto& [right, down] : {std::pair{0, -1}, {0, 1}, {1, -1}, {-1, -1}, {1, 1}, {-1, 1}}) {
        const Box box{at.x + right * (w / 2 + off_curve) - w / 2, at.y + down * (h / 2 + off_curve) - h / 2, w, h};
        if (!fits(box) || !all_.free(box) || !others_[g].free(box.grown(moat))) continue;
        double room = moat;
        while (room < 12 && others_[g].free(box.grown(room + 2))) room += 2;
        out.push_back({box, {}, -room - 4 * at.x / frame_.width});
      }
    return out;
  }

  // Places a little off, with a leader that crosses no other curve.
  std::vector<Candidate> at_leader(std::size_t g) const {
    constexpr std::array<double, 3> lengths{7, 11, 16};
    constexpr std::array<Point, 8> ways{{{0, -1}, {0, 1}, {0.7, -0.7}, {-0.7, -0.7}, {0.7, 0.7}, {-0.7, 0.7}, {1, 0}, {-1, 0}}};
    std::vector<Candidate> out;
    const double w = groups_[g].width, h = groups_[g].height - 1;
    for (const Point at : points(g))
      for (const double length : lengths)
        for (const Point way : ways) {
          const Point end{at.x + length * way.x, at.y + length * way.y};
          const Box box{end.x + way.x * (w / 2 + leader_gap) - w / 2, end.y + way.y * (h / 2 + leader_gap) - h / 2, w, h};
          if (!fits(box) || !all_.free(box.grown(1.2)) || !crosses_nothing(g, at, end)) continue;
          out.push_back({box, {at, end}, length - 4 * at.x / frame_.width});
        }
    return out;
  }

 private:
  const std::vector<Trace>& traces_;
  const Frame& frame_;
  const std::vector<LabelGroup>& groups_;
  Occupancy all_;
  std::vector<Occupancy> others_;  // of each group, the ink of all curves but its own

  bool fits(const Box& box) const {
    return box.x >= inset_name && box.y >= inset_name && box.right() <= frame_.width - inset_name &&
           box.bottom() <= frame_.height - inset_name;
  }
  bool crosses_nothing(std::size_t g, Point from, Point to) const {
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    for (double s = 0; s <= length; s += 0.7) {
      const Box here{from.x + s / length * (to.x - from.x), from.y + s / length * (to.y - from.y), 0, 0};
      if (!others_[g].free(here) || (s > own_reach && !all_.free(here))) return false;
    }
    return true;
  }
  std::vector<Point> points(std::size_t g) const {
    std::vector<Point> out;
    const Trace& trace = traces_[static_cast<std::size_t>(groups_[g].series.front())];
    for (const Stroke& stroke : trace.strokes)
      for (std::size_t i = 0; i + 1 < stroke.size(); ++i) {
        const double length = std::hypot(stroke[i + 1].x - stroke[i].x, stroke[i + 1].y - stroke[i].y);
        const int steps = std::max(1, static_cast<int>(length / along_curve));
        for (int k = 0; k < steps; ++k) {
          const double s = static_cast<double>(k) / steps;
          out.push_back({stroke[i].x + s * (stroke[i + 1].x - stroke[i].x), stroke[i].y + s * (stroke[i + 1].y - stroke[i].y)});
        }
      }
    out.insert(out.end(), trace.dots.begin(), trace.dots.end());
    return out;
  }
};

}  // namespace

std::optional<DirectLabels> label_inside(cairo_t* cr, const Panel& panel, const std::vector<Trace>& traces,
                                         const std::vector<double>& lines, const Frame& frame) {
  const std::vector<LabelGroup> groups = label_groups(cr, panel, traces, frame);
  if (groups.empty()) return std::nullopt;
  const Inside inside(panel, traces, lines, frame, groups);
  struct Choice {
    std::size_t group;
    std::vector<Candidate> places;
  };
  std::vector<Choice> choices;
  for (std::size_t g = 0; g < groups.size(); ++g) choices.push_back({g, inside.beside_curve(g)});
  // Who has the fewest places chooses first.
  std::stable_sort(choices.begin(), choices.end(), [](const Choice& a, const Choice& b) { return a.places.size() < b.places.size(); });
  DirectLabels out;
  std::vector<Box> taken;
  std::vector<Stroke> leaders;
  const auto choose = [&](const std::vector<Candidate>& places) {
    const Candidate* best = nullptr;
    for (const Candidate& c : places) {
      const auto touches = [&](const Box& box) { return box.overlaps(c.box.grown(1.5)); };
      if (std::any_of(taken.begin(), taken.end(), touches)) continue;
      const auto crosses = [&](const Stroke& leader, const Box& box) { return !clip(leader, box).empty(); };
      if (std::any_of(leaders.begin(), leaders.end(), [&](const Stroke& s) { return crosses(s, c.box.grown(1)); })) continue;
      if (!c.leader.empty() && std::any_of(taken.begin(), taken.end(), [&](const Box& b) { return crosses(c.leader, b.grown(1)); }))
        continue;
      if (best == nullptr || c.cost < best->cost) best = &c;
    }
    return best;
  };
  for (const Choice& choice : choices) {
    std::vector<Candidate> farther;
    const Candidate* place = choose(choice.places);
    if (place == nullptr) {
      farther = inside.at_leader(choice.group);
      place = choose(farther);
    }
    if (place == nullptr) return std::nullopt;
    taken.push_back(place->box);
    if (!place->leader.empty()) leaders.push_back(place->leader);
    add_labels(panel, groups[choice.group], {place->box.x, place->box.y, place->box.height}, place->leader, true, out);
  }
  return out;
}

}  // namespace pmreport::figure
