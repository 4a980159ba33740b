// Horton 1987, A polynomial-time algorithm to find the shortest cycle basis of a graph: the loops made of a joint and the shortest ways
// from some body to its two ends, where these ways part at that body, hold a basis of all loops with the fewest joints.
#include <core/mechanics/mobility/loops.hpp>

#include <algorithm>
#include <set>

namespace pmreport::mechanics {

namespace {

struct Ways {                      // from one body to all others
  std::vector<int> joint, before;  // the last joint of the way to a body, and the body before it; -1 at the start
};

Ways shortest_ways(const Topology& t, int from) {
  const std::size_t n = t.bodies.size();
  Ways w{std::vector<int>(n, -1), std::vector<int>(n, -1)};
  std::vector<bool> reached(n, false);
  std::vector<int> next{from};
  reached[static_cast<std::size_t>(from)] = true;
  for (std::size_t i = 0; i < next.size(); ++i)
    for (std::size_t j = 0; j < t.joints.size(); ++j) {
      const Joint& joint = t.joints[j];
      if (joint.a != next[i] && joint.b != next[i]) continue;
      const int to = joint.a == next[i] ? joint.b : joint.a;
      if (reached[static_cast<std::size_t>(to)]) continue;
      reached[static_cast<std::size_t>(to)] = true;
      w.joint[static_cast<std::size_t>(to)] = static_cast<int>(j), w.before[static_cast<std::size_t>(to)] = next[i];
      next.push_back(to);
    }
  return w;
}

// The way from the start to a body.
Loop way_to(const Ways& w, int body) {
  Loop out;
  for (; w.before[static_cast<std::size_t>(body)] >= 0; body = w.before[static_cast<std::size_t>(body)]) {
    out.bodies.push_back(body);
    out.joints.push_back(w.joint[static_cast<std::size_t>(body)]);
  }
  out.bodies.push_back(body);
  std::reverse(out.bodies.begin(), out.bodies.end());
  std::reverse(out.joints.begin(), out.joints.end());
  return out;
}

// The same loop, begun at its first body in the topology's order, towards the first of the two joints there.
Loop in_order(Loop l) {
  const auto start = std::min_element(l.bodies.begin(), l.bodies.end()) - l.bodies.begin();
  std::rotate(l.bodies.begin(), l.bodies.begin() + start, l.bodies.end());
  std::rotate(l.joints.begin(), l.joints.begin() + start, l.joints.end());
  if (l.joints.back() < l.joints.front()) {
    std::reverse(l.joints.begin(), l.joints.end());
    std::reverse(l.bodies.begin() + 1, l.bodies.end());
  }
  return l;
}

}  // namespace

std::vector<Loop> loops(const Topology& t) {
  std::vector<Loop> out;
  std::set<std::vector<int>> known;  // by their joints, sorted
  for (int from = 0; from < static_cast<int>(t.bodies.size()); ++from) {
    const Ways w = shortest_ways(t, from);
    for (int j = 0; j < static_cast<int>(t.joints.size()); ++j) {
      const Joint& joint = t.joints[static_cast<std::size_t>(j)];
      Loop one = way_to(w, joint.a), back = way_to(w, joint.b);
      if (one.bodies.front() != from || back.bodies.front() != from) continue;
      if (w.joint[static_cast<std::size_t>(joint.a)] == j || w.joint[static_cast<std::size_t>(joint.b)] == j) continue;
      const bool part = std::all_of(one.bodies.begin() + 1, one.bodies.end(),
                                    [&](int body) { return std::find(back.bodies.begin(), back.bodies.end(), body) == back.bodies.end(); });
      if (!part) continue;
      // There by one way, over the joint, and back by the other.
      one.joints.push_back(j);
      one.bodies.insert(one.bodies.end(), back.bodies.rbegin(), back.bodies.rend() - 1);
      one.joints.insert(one.joints.end(), back.joints.rbegin(), back.joints.rend());
      std::vector<int> sorted = one.joints;
      std::sort(sorted.begin(), sorted.end());
      if (known.insert(sorted).second) out.push_back(in_order(std::move(one)));
    }
  }
  std::stable_sort(out.begin(), out.end(), [](const Loop& a, const Loop& b) {
    return a.joints.size() != b.joints.size() ? a.joints.size() < b.joints.size() : a.joints < b.joints;
  });
  return out;
}

std::string in_words(const Topology& t, const Loop& loop) {
  std::string out;
  for (std::size_t k = 0; k < loop.joints.size(); ++k)
    out +=
        t.bodies[static_cast<std::size_t>(loop.bodies[k])].name + " – " + t.joints[static_cast<std::size_t>(loop.joints[k])].name + " – ";
  return out + t.bodies[static_cast<std::size_t>(loop.bodies.front())].name;
}

}  // namespace pmreport::mechanics
