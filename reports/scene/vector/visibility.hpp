// What is seen of each solid, and of lines, when nearer solids hide what is behind them.
#pragma once

#include <reports/scene/vector/regions.hpp>
#include <vector>

namespace pmreport::scene {

struct Seen {         // a solid in a picture
  std::size_t solid;  // index in the scene
  Facets facets;
  bool ghost = false;  // hides other ghosts alone
  Region visible;      // empty: hidden, or out of the picture
};

// The solids of a scene that a picture of this size can show, each with its visible region. Where two surfaces coincide, that of the later
// solid is seen.
std::vector<Seen> look_at(const Scene& scene, const View& view, int width, int height);

// The part of a convex polygon, at the depth `slope` · (x, y, 1), that a solid hides; it is convex.
Polygon hidden_part(const Polygon& p, const Eigen::Vector3d& slope, const Facets& by);

struct Interval {
  double from, to;  // of a segment: 0 to 1
};
// Where the segment from p to q runs behind solids, in order, without overlap. `by` chooses which solids count.
template <class By>
std::vector<Interval> hidden_intervals(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const std::vector<Seen>& solids, By by);
// Where it runs behind one solid; empty, from >= to, where nowhere.
Interval hidden_interval(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Facets& by);
std::vector<Interval> merged(std::vector<Interval> all);

template <class By>
std::vector<Interval> hidden_intervals(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const std::vector<Seen>& solids, By by) {
  std::vector<Interval> all;
  for (const Seen& s : solids)
    if (by(s))
      if (const Interval i = hidden_interval(p, q, s.facets); i.from < i.to) all.push_back(i);
  return merged(std::move(all));
}

}  // namespace pmreport::scene
