// The inverse dynamics of one pack of poses, by the plan.
#pragma once

#include <core/linear/tolerance.hpp>
#include <core/mechanics/reactions/by_limb/factor.hpp>
#include <core/mechanics/reactions/by_limb/geometry.hpp>
#include <core/mechanics/reactions/by_limb/kernel.hpp>

#include <limits>

// A vector passed to a function that is inlined in any case has no calling convention to speak of.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace pmreport::mechanics {

// Keeps nothing: everything that it writes is on the desk, or in the batch.
template <class T>
class LimbSolver : PackGeometry<T> {
  using Geometry = PackGeometry<T>;
  using Plan = DynamicsPlan;
  using Freedom = Plan::Freedom;
  using Geometry::number, Geometry::vector, Geometry::column, Geometry::second_of, Geometry::direction;
  using Geometry::p_, Geometry::d_, Geometry::origin_;
  using Geometry::place_cut, Geometry::of_unknowns, Geometry::about_reference, Geometry::parts;

 public:
  PMREPORT_INLINE LimbSolver(const Plan& plan, const DynamicsBatch& batch, const Desk<T>& desk, std::size_t pose)
      : Geometry(plan, desk, batch.placement + pose, batch.stride),
        in_(batch),
        pose_(pose),
        lanes_(batch.written - pose < T::width ? batch.written - pose : T::width) {}

  PMREPORT_INLINE void solve() {
    demand();
    std::size_t tree = 0;
    for (const Plan::Group& g : p_.groups) {
      reduce(g, d_.tree_centre + tree);
      tree += g.trees.size();
    }
    balance_platform();
    judge();
    for (const Plan::Group& g : p_.groups) settle(g, d_.share, d_.x);
    wrenches_of_cuts(d_.x);
    through_trees(true, d_.wrenches);
    if (in_.joints != nullptr) {
      for (int s = 0; s < p_.stresses(); ++s) stress(s);
      write_reactions();
    }
  }

  PMREPORT_INLINE void equations(double* largest) {
    for (int b = 0; b < p_.bodies; ++b) d_.beyond[b] = {zero<T>(), zero<T>()};
    std::size_t tree = 0;
    for (const Plan::Group& g : p_.groups) {
      assemble(g, d_.tree_centre + tree);
      tree += g.trees.size();
      for (int i = 0; i < g.equations; ++i) {
        T most(0.0);
        for (int j = 0; j < g.unknowns; ++j) most = larger(most, magnitude(d_.matrix[i * g.unknowns + j]));
        *largest++ = most.lane(0);
      }
    }
  }

 private:
  // D_b, what must act on each body: the rate of its momentum, less its weight and the load. Equations (1) to (3) are those of
  // inverse_dynamics.hpp.
  //
  // With the centre of mass C at p_B + R_B p_BC_B, the force is m (o'' + R'' c - g). Of the moment about the centre of mass, the sum over
  // all points b of the body of (R b) x (R'' b) dm, nothing enters but the second moments S = sum of b b^T dm: with r_j the columns of R it
  // is the sum over j, k of S_jk r_j x r_k''. That equals I e + w x I w, and asks for no rates. A slender body does not spin, and its r_1,
  // r_2 drop out: (I_1 n) x n'', I_1 = S_11 + S_33.
  PMREPORT_INLINE void demand() {
    for (int b = 0; b < p_.bodies; ++b) d_.beyond[b] = {zero<T>(), zero<T>()};
    const Triple<T> gravity{T(in_.gravity[0]), T(in_.gravity[1]), T(in_.gravity[2])};
    for (const Plan::Mass& m : p_.masses) {
      Triple<T> p_OC = vector(m.at) - origin_, acceleration = vector(m.at, 2) - gravity, spin = zero<T>();
      if (m.slender) {
        const Triple<T> n = vector(m.at + 3), n_second = vector(m.at + 3, 2);
        p_OC += n * m.centre.z();
        acceleration += n_second * m.centre.z();
        spin = cross(n, n_second) * (m.moments(0, 0) + m.moments(2, 2));
      } else {
        Triple<T> second[3] = {zero<T>(), zero<T>(), zero<T>()};
        for (int k = 0; k < 3; ++k)
          if (m.column[static_cast<std::size_t>(k)]) second[k] = column(m.at, k, 2);
        for (int j = 0; j < 3; ++j) {
          if (!m.column[static_cast<std::size_t>(j)]) continue;
          const Triple<T> r = column(m.at, j);
          if (const double c = m.centre(j); c != 0) {
            p_OC += r * c;
            acceleration += second[j] * c;
          }
          Triple<T> weighted = zero<T>();
          bool any = false;
          for (int k = 0; k < 3; ++k)
            if (const double s = m.moments(j, k); s != 0) weighted += second[k] * s, any = true;
          if (any) spin += cross(r, weighted);
        }
      }
      const Triple<T> force = acceleration * m.mass;
      d_.beyond[m.body] = {force, cross(p_OC, force) + spin};
    }
    Wrench<T>& platform = d_.beyond[p_.platform];
    const double* load = in_.loads + pose_;
    const std::size_t s = in_.stride;
    platform.force -= {T::load(load), T::load(load + s), T::load(load + 2 * s)};
    platform.moment -= {T::load(load + 3 * s), T::load(load + 4 * s), T::load(load + 5 * s)};
    if (in_.wrenches == nullptr) return;
    const double* w = in_.wrenches + pose_;
    for (int b = 1; b < p_.bodies; ++b, w += 6 * s) {
      d_.beyond[b].force -= {T::load(w), T::load(w + s), T::load(w + 2 * s)};
      d_.beyond[b].moment -= {T::load(w + 3 * s), T::load(w + 4 * s), T::load(w + 5 * s)};
    }
  }

  // (2) of a group, C x = d. For each passive freedom of a tree joint at c: the wrenches of the cuts beyond do the same work on it as what
  // the bodies beyond demand. On a rotation about s a force f at r works by s x (r - c) . f, a couple m by s . m; both sides per length.
  PMREPORT_INLINE void assemble(const Plan::Group& g, Triple<T>* centres) {
    for (int c = g.first_cut; c < g.end_cut; ++c) place_cut(c);
    for (std::size_t i = g.trees.size(); i-- > 0;) {
      const Plan::Tree& t = g.trees[i];
      centres[i] = vector(t.at) - origin_;
      if (t.parent != 0) d_.beyond[t.parent] += d_.beyond[t.child];
    }
    const double per_length = 1 / p_.length;
    T* row = d_.matrix;
    T* right = d_.right;
    for (std::size_t i = 0; i < g.trees.size(); ++i) {
      const Plan::Tree& t = g.trees[i];
      if (t.passive.empty()) continue;
      const Triple<T> force = d_.beyond[t.child].force, moment = d_.beyond[t.child].moment - cross(centres[i], force);
      for (const Freedom freedom : t.passive) {
        for (int j = 0; j < g.unknowns; ++j) row[j] = T(0.0);
        const bool slides = freedom == Freedom::slide;
        const Triple<T> s = slides ? vector(t.at + 3) : direction(t, freedom);
        *right = slides ? dot(s, force) : dot(s, moment) * per_length;
        for (const Plan::Beyond& beyond : t.beyond) {
          const Plan::Cut& cut = p_.cuts[static_cast<std::size_t>(beyond.cut)];
          const Triple<T>* axes = d_.cut_axes + 2 * beyond.cut;
          T* at = row + cut.first - g.first;
          const Triple<T> moved = slides ? s : cross(s, d_.cut_centre[beyond.cut] - centres[i]) * per_length;
          parts(cut.forces, axes, moved, beyond.sign, at);
          if (!slides) parts(cut.couples, axes, s, beyond.sign, at + cut.forces);
        }
        row += g.unknowns;
        ++right;
      }
    }
  }

  PMREPORT_INLINE void reduce(const Plan::Group& g, Triple<T>* centres) {
    assemble(g, centres);
    WideSystem<T> system{d_.matrix, d_.diagonal, d_.factor, g.equations, g.unknowns};
    system.decompose();
    note_pivots(d_.diagonal, g.equations);
    system.solve(d_.right, d_.x + g.first);
    for (int k = 0; k < g.open(); ++k) system.open(k, d_.vectors + g.vectors + k * g.unknowns);
  }

  // The wrench on the platform of a group's joints there, from the group's unknowns.
  PMREPORT_INLINE Wrench<T> on_platform(const Plan::Group& g, const T* x) const {
    Wrench<T> sum{zero<T>(), zero<T>()};
    for (int c = g.first_cut; c < g.end_cut; ++c)
      if (const Plan::Cut& cut = p_.cuts[static_cast<std::size_t>(c)]; cut.platform != 0)
        sum += about_reference(of_unknowns(c, x + cut.first - g.first), d_.cut_centre[c]) * cut.platform;
    return sum;
  }

  // (3): what the groups left open meets at the platform, 6 equations. What these leave open is self-stress.
  PMREPORT_INLINE void balance_platform() {
    const double per_length = 1 / p_.length;
    const auto put = [&](const Wrench<T>& w, T* to, int step) {
      to[0] = w.force.x, to[step] = w.force.y, to[2 * step] = w.force.z;
      to[3 * step] = w.moment.x * per_length, to[4 * step] = w.moment.y * per_length, to[5 * step] = w.moment.z * per_length;
    };
    Wrench<T> rest = d_.beyond[p_.platform];
    for (const Plan::Group& g : p_.groups) {
      rest += on_platform(g, d_.x + g.first) * -1.0;
      for (int k = 0; k < g.open(); ++k)
        put(on_platform(g, d_.vectors + g.vectors + k * g.unknowns), d_.platform + g.first_open + k, p_.open);
    }
    put(rest, d_.platform_right, 1);
    WideSystem<T> system{d_.platform, d_.platform_diagonal, d_.platform_factor, 6, p_.open};
    system.decompose();
    note_pivots(d_.platform_diagonal, 6);
    system.solve(d_.platform_right, d_.share);
    if (in_.joints != nullptr)
      for (int s = 0; s < p_.stresses(); ++s) system.open(s, d_.stress_shares + s * p_.open);
  }

  PMREPORT_INLINE void note_pivots(const T* pivots, int count) {
    for (int i = 0; i < count; ++i) {
      const T size = magnitude(pivots[i]);
      least_ = where_less(size, least_, size, least_);
      largest_ = larger(largest_, size);
    }
  }

  // Poses out of reach, or so near a singularity that forces mean nothing, get no numbers: `given_` turns all that is written into NaN.
  PMREPORT_INLINE void judge() {
    using Limits = std::numeric_limits<double>;
    const T none(Limits::quiet_NaN()), nothing(0.0), ratio = least_ / largest_;
    const T below_zero(-Limits::denorm_min());  // in reach: at zero or above, and a number
    const T regularity = where_less(below_zero, number(0), where_less(nothing, ratio, ratio, nothing), none);
    given_ = where_less(regularity, T(linear::rank_tolerance), none, regularity * 0.0);
    regularity.store(in_.regularity + pose_, lanes_);
  }
  PMREPORT_INLINE void write(const T& x, double* to, std::size_t i) const { (x + given_).store(to + i * in_.count + pose_, lanes_); }

  // Adds what `share` of the open parameters means for a group's unknowns.
  PMREPORT_INLINE void settle(const Plan::Group& g, const T* share, T* x) const {
    for (int k = 0; k < g.open(); ++k) {
      const T* v = d_.vectors + g.vectors + k * g.unknowns;
      for (int j = 0; j < g.unknowns; ++j) x[g.first + j] += v[j] * share[g.first_open + k];
    }
  }
  PMREPORT_INLINE void wrenches_of_cuts(const T* x) {
    for (std::size_t c = 0; c < p_.cuts.size(); ++c) {
      const int i = static_cast<int>(c);
      d_.cut_wrench[c] = about_reference(of_unknowns(i, x + p_.cuts[c].first), d_.cut_centre[c]);
    }
  }

  PMREPORT_INLINE void keep(int joint, const Wrench<T>& about_centre, T* wrenches) const {
    const double per_length = 1 / p_.length;
    T* to = wrenches + 6 * joint;
    to[0] = about_centre.force.x, to[1] = about_centre.force.y, to[2] = about_centre.force.z;
    to[3] = about_centre.moment.x * per_length, to[4] = about_centre.moment.y * per_length, to[5] = about_centre.moment.z * per_length;
  }

  // (1): the wrench through each joint of the trees, what the bodies beyond demand, where `loaded`, less the wrenches of the cuts beyond.
  // Along its freedoms stands the actuator's force, or nothing but rounding.
  PMREPORT_INLINE void through_trees(bool loaded, T* wrenches) {
    const bool all = in_.joints != nullptr;
    const Triple<T>* centre = d_.tree_centre;
    for (const Plan::Group& g : p_.groups) {
      for (const Plan::Tree& t : g.trees) {
        const Triple<T> at = *centre++;
        if (!all && t.push < 0 && t.turn < 0) continue;
        Wrench<T> w{zero<T>(), zero<T>()};
        if (loaded) w = d_.beyond[t.child];
        for (const Plan::Beyond& b : t.beyond) w += d_.cut_wrench[b.cut] * -b.sign;
        w = about_reference(w, at * -1.0) * t.sign;
        if (t.push >= 0 && loaded) write(dot(vector(t.at + 3), w.force), in_.actuator_forces, static_cast<std::size_t>(t.push));
        if (t.turn >= 0 && loaded) write(dot(vector(t.at + 3), w.moment), in_.actuator_forces, static_cast<std::size_t>(t.turn));
        if (!all) continue;
        strip(t, w);
        keep(t.joint, w, wrenches);
      }
      if (!all) continue;
      for (int c = g.first_cut; c < g.end_cut; ++c)
        keep(p_.cuts[static_cast<std::size_t>(c)].joint, about_reference(d_.cut_wrench[c], d_.cut_centre[c] * -1.0), wrenches);
    }
  }
  // Leaves what the joint itself carries.
  PMREPORT_INLINE void strip(const Plan::Tree& t, Wrench<T>& w) const {
    if (t.kind == JointKind::spherical) {
      w.moment = zero<T>();
      return;
    }
    const Triple<T> axis = vector(t.at + 3);
    if (t.kind == JointKind::universal) {
      const Triple<T> c = cross(axis, vector(t.at + 6));
      w.moment = c * (dot(c, w.moment) / dot(c, c));
      return;
    }
    if (t.kind != JointKind::prismatic) w.moment -= axis * dot(axis, w.moment);
    if (t.kind != JointKind::revolute) w.force -= axis * dot(axis, w.force);
  }

  // Six sums side by side, for none to wait for another.
  PMREPORT_INLINE T product(const T* a, const T* b) const {
    Triple<T> force = zero<T>(), moment = zero<T>();
    for (const T* end = a + 6 * p_.joints; a != end; a += 6, b += 6) {
      force += {a[0] * b[0], a[1] * b[1], a[2] * b[2]};
      moment += {a[3] * b[3], a[4] * b[4], a[5] * b[5]};
    }
    const Triple<T> both = force + moment;
    return both.x + both.y + both.z;
  }
  // Self-stress s, made orthogonal to those before it and of length 1; and the reactions freed of it, which makes them least in norm.
  PMREPORT_INLINE void stress(int s) {
    const int n = 6 * p_.joints;
    T* mine = d_.wrenches + (1 + s) * n;
    for (int i = 0; i < p_.unknowns; ++i) d_.shift[i] = T(0.0);
    for (const Plan::Group& g : p_.groups) settle(g, d_.stress_shares + s * p_.open, d_.shift);
    wrenches_of_cuts(d_.shift);
    through_trees(false, mine);
    for (int other = 0; other < s; ++other) {
      const T* before = d_.wrenches + (1 + other) * n;
      const T along = product(before, mine);
      for (int i = 0; i < n; ++i) mine[i] -= along * before[i];
    }
    const T scale = T(1.0) / root(product(mine, mine));
    for (int i = 0; i < n; ++i) mine[i] = mine[i] * scale;
    const T along = product(mine, d_.wrenches);
    for (int i = 0; i < n; ++i) d_.wrenches[i] -= along * mine[i];
  }

  PMREPORT_INLINE void write_reactions() {
    const int n = 6 * p_.joints;
    for (int s = 0; s <= p_.stresses(); ++s)
      for (int i = 0; i < n; ++i) {
        double* to = s == 0 ? in_.joints : in_.stresses + static_cast<std::size_t>((s - 1) * n) * in_.count;
        write(d_.wrenches[s * n + i] * (i % 6 < 3 ? 1.0 : p_.length), to, static_cast<std::size_t>(i));
      }
    for (int j = 0; j < p_.joints; ++j) d_.bits[j] = T(0.0);
    if (p_.stresses() > 0) mark_indeterminate();
    for (int j = 0; j < p_.joints; ++j)
      for (std::size_t k = 0; k < lanes_; ++k) {
        const double bits = d_.bits[j].lane(k);
        in_.indeterminate[static_cast<std::size_t>(j) * in_.count + pose_ + k] = static_cast<Indeterminate>(bits);
      }
  }

  // The verdict of indeterminate_components, lane by lane: every bit is a power of two that is added once.
  PMREPORT_INLINE void mark_indeterminate() {
    const int n = 6 * p_.joints;
    for (int s = 0; s < p_.stresses(); ++s) {
      T* least = d_.shift + s;  // no longer needed
      *least = T(0.0);
      for (int i = 0; i < n; ++i) *least = larger(*least, magnitude(d_.wrenches[(1 + s) * n + i]));
      *least = *least * linear::carried_share;
    }
    for (int j = 0; j < p_.joints; ++j) {
      const Plan::Frame& f = p_.frames[static_cast<std::size_t>(j)];
      const Triple<T> e1 = vector(f.along, 0, f.along_step), across = unit(cross(e1, second_of(f))),
                      axes[3] = {e1, cross(across, e1), across};
      T beyond[12];
      for (T& b : beyond) b = T(0.0);
      for (int s = 0; s < p_.stresses(); ++s) {
        const T* w = d_.wrenches + (1 + s) * n + 6 * j;
        const T least = d_.shift[s];
        const Triple<T> both[2] = {{w[0], w[1], w[2]}, {w[3], w[4], w[5]}};
        for (int c = 0; c < 6; ++c) {
          beyond[c] = larger(beyond[c], less(least, magnitude(dot(axes[c % 3], both[c / 3]))));
          beyond[6 + c] = larger(beyond[6 + c], less(least, magnitude(w[c])));
        }
      }
      const T given = less(given_, T(1.0));
      for (int c = 0; c < 12; ++c) d_.bits[j] += given * beyond[c] * static_cast<double>(1 << c);
    }
  }
  const DynamicsBatch& in_;
  std::size_t pose_, lanes_;
  T least_ = T(std::numeric_limits<double>::infinity()), largest_ = T(0.0), given_ = T(0.0);
};

}  // namespace pmreport::mechanics
