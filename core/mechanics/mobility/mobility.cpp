#include <core/mechanics/mobility/mobility.hpp>

#include <core/assertion.hpp>
#include <core/linear/subspace.hpp>
#include <core/mechanics/model/constraint_scale.hpp>

#include <algorithm>
#include <set>

namespace pmreport::mechanics {

using Eigen::MatrixXd;
using Eigen::Vector3d;

namespace {

Eigen::Index column_of(int body) { return 6 * (static_cast<Eigen::Index>(body) - 1); }

// What is left of the motion of the platform, `bodies[0]`, when the constraints `rows` of PHI hold between the bodies `bodies`, none of
// them the base.
MatrixXd platform_twists(const GenericModel& model, const std::vector<Eigen::Index>& rows, const std::vector<int>& bodies, double length) {
  MatrixXd phi(static_cast<Eigen::Index>(rows.size()), 6 * static_cast<Eigen::Index>(bodies.size()));
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      const auto cell = model.constraints.block<1, 6>(rows[r], column_of(bodies[b]));
      phi.block<1, 6>(static_cast<Eigen::Index>(r), 6 * static_cast<Eigen::Index>(b)) = cell;
    }
  phi = unit_rows(std::move(phi), length);
  MatrixXd twists = linear::column_space(linear::null_space(phi).topRows(6), 1);
  twists.bottomRows(3) /= length;
  return twists;
}

std::vector<int> in_front(int platform, const std::set<int>& bodies) {
  std::vector<int> out{platform};
  for (const int b : bodies)
    if (b != 0 && b != platform) out.push_back(b);
  return out;
}

// All bodies that joints between members of `set` connect to `from`, not looking beyond `until`.
std::set<int> connected(const Topology& t, const std::set<int>& set, int from, int until) {
  std::set<int> seen{from};
  for (bool grew = true; grew;) {
    grew = false;
    for (const Joint& j : t.joints)
      for (const auto& [a, b] : {std::pair{j.a, j.b}, std::pair{j.b, j.a}})
        if (set.contains(a) && set.contains(b) && seen.contains(a) && a != until && seen.insert(b).second) grew = true;
  }
  return seen;
}

}  // namespace

PlatformFreedoms platform_freedoms(const Machine& machine, const State& state, const GenericModel& model) {
  PMREPORT_ASSERT(state.status == PM_OK, "the state is that of an assembled pose");
  const int platform = machine.topology().platform;
  const double length = characteristic_length(machine);
  std::vector<Eigen::Index> rows(static_cast<std::size_t>(model.constraints.rows()));
  for (std::size_t r = 0; r < rows.size(); ++r) rows[r] = static_cast<Eigen::Index>(r);
  std::set<int> all;
  for (int b = 0; b < static_cast<int>(state.bodies.size()); ++b) all.insert(b);

  PlatformFreedoms f;
  f.twists = {state.bodies[static_cast<std::size_t>(platform)].origin, platform_twists(model, rows, in_front(platform, all), length)};
  f.constraints = reciprocal(f.twists, length);
  const MatrixXd turning = f.twists.basis.bottomRows(3) * length;  // orthonormal columns have this part
  f.translations = aligned((f.twists.basis * linear::null_space(turning, 1)).topRows(3));
  f.rotations = aligned(turning);
  return f;
}

std::vector<LimbSystem> limb_systems(const Machine& machine, const State& state, const GenericModel& model) {
  const Topology& t = machine.topology();
  const double length = characteristic_length(machine);
  int limbs = 0;
  for (const Body& b : t.bodies) limbs = std::max(limbs, b.limb);
  const auto limb_of = [&](int body) { return t.bodies[static_cast<std::size_t>(body)].limb; };

  std::vector<LimbSystem> out;
  for (int limb = 1; limb <= limbs; ++limb) {
    LimbSystem l;
    l.limb = limb;
    std::set<int> own, partners;
    for (int b = 0; b < static_cast<int>(t.bodies.size()); ++b)
      if (limb_of(b) == limb || limb_of(b) == 0) own.insert(b);
    for (std::size_t j = 0; j < t.joints.size(); ++j) {
      const Joint& joint = t.joints[j];
      if (limb_of(joint.a) != limb && limb_of(joint.b) != limb) continue;
      l.joints.push_back(static_cast<int>(j));
      for (const int body : {joint.a, joint.b})
        if (limb_of(body) != limb && limb_of(body) != 0) partners.insert(limb_of(body));
    }
    if (l.joints.empty()) continue;
    l.partners.assign(partners.begin(), partners.end());
    const std::set<int> chain = connected(t, own, 0, t.platform);
    l.alone = chain.contains(t.platform) && std::any_of(chain.begin(), chain.end(), [&](int b) { return limb_of(b) == limb; });
    if (l.alone) {
      std::vector<Eigen::Index> rows;
      for (std::size_t r = 0; r < model.joint_of_row.size(); ++r) {
        const Joint& joint = t.joints[static_cast<std::size_t>(model.joint_of_row[r])];
        if (chain.contains(joint.a) && chain.contains(joint.b)) rows.push_back(static_cast<Eigen::Index>(r));
      }
      l.twists = {state.bodies[static_cast<std::size_t>(t.platform)].origin,
                  platform_twists(model, rows, in_front(t.platform, chain), length)};
      l.constraints = reciprocal(l.twists, length);
    }
    out.push_back(std::move(l));
  }
  return out;
}

std::vector<Landmark> landmarks_of(const Topology& topology, const State& state, const std::vector<int>& joints) {
  std::vector<Landmark> out;
  for (const int j : joints)
    if (topology.joints[static_cast<std::size_t>(j)].kind != JointKind::prismatic)
      out.push_back({j, state.joints[static_cast<std::size_t>(j)].centre});
  return out;
}

}  // namespace pmreport::mechanics
