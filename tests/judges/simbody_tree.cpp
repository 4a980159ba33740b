#include <tests/judges/simbody_tree.hpp>

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace pmreport::judges {

// Actuated joints first, for only a mobilizer's motion can be prescribed. Then those of bodies without mass: no such body may end a branch,
// where nothing would resist its freedom and its acceleration would have no value. The rest as they are declared.
SpanningTree spanning_tree(const Topology& t) {
  std::vector<int> order(t.joints.size());
  std::iota(order.begin(), order.end(), 0);
  const auto rank = [&](int j) {
    for (const Actuator& actuator : t.actuators)
      if (actuator.joint == j) return 0;
    const Joint& joint = t.joints[static_cast<std::size_t>(j)];
    for (const int body : {joint.a, joint.b})
      if (body > 0 && t.bodies[static_cast<std::size_t>(body)].inertia.mass == 0) return 1;
    return 2;
  };
  std::ranges::stable_sort(order, {}, rank);

  std::vector<int> piece(t.bodies.size());  // bodies that the tree connects so far have the same number
  std::iota(piece.begin(), piece.end(), 0);
  std::vector<int> chosen;
  for (const int j : order) {
    const Joint& joint = t.joints[static_cast<std::size_t>(j)];
    const int from = piece[static_cast<std::size_t>(joint.b)], to = piece[static_cast<std::size_t>(joint.a)];
    if (from == to) {
      if (rank(j) == 0) throw std::invalid_argument("the actuated joint " + joint.name + " closes a loop of actuated joints");
      continue;
    }
    std::ranges::replace(piece, from, to);
    chosen.push_back(j);
  }

  SpanningTree tree{std::vector<int>(t.joints.size(), SpanningTree::left_out), {}};
  std::vector<int> reached{0};
  for (std::size_t next = 0; next < reached.size(); ++next)
    for (const int j : chosen) {
      const Joint& joint = t.joints[static_cast<std::size_t>(j)];
      int& parent = tree.parent[static_cast<std::size_t>(j)];
      if (parent != SpanningTree::left_out || (joint.a != reached[next] && joint.b != reached[next])) continue;
      parent = reached[next];
      tree.outward.push_back(j);
      reached.push_back(joint.a == parent ? joint.b : joint.a);
    }
  return tree;
}

}  // namespace pmreport::judges
