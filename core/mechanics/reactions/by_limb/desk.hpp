// Where the numbers of a pack of poses stand while its forces are reckoned: one piece of memory, nothing of it allocated at a pose.
#pragma once

#include <core/mechanics/reactions/by_limb/pack.hpp>
#include <core/mechanics/reactions/by_limb/plan.hpp>

#include <algorithm>

namespace pmreport::mechanics {

template <class T>
struct Wrench {
  Triple<T> force, moment;
};
template <class T>
PMREPORT_INLINE void operator+=(Wrench<T>& a, const Wrench<T>& b) {
  a.force += b.force;
  a.moment += b.moment;
}
template <class T>
PMREPORT_INLINE Wrench<T> operator*(const Wrench<T>& a, double s) {
  return {a.force * s, a.moment * s};
}

// Where the numbers of one pack stand in the memory given. Made without memory, it tells how much is needed.
template <class T>
struct Desk {
  Triple<T>*cut_centre, *cut_axes, *tree_centre;  // p_OC of joints, from the platform's reference point; two axes a cut
  Wrench<T>*beyond, *cut_wrench;                  // about O: sum of D_b by body, X_c by cut (inverse_dynamics.hpp)
  T *matrix, *diagonal, *factor, *right;          // of the group at hand
  T *x, *shift, *vectors;                         // unknowns of all groups; what a stress adds; what each group's equations leave open
  T *platform, *platform_diagonal, *platform_factor, *platform_right, *share, *stress_shares;
  T *wrenches, *bits;  // by joint, force and moment per length, the reactions first, then every stress
  std::size_t numbers = 0;

  Desk(const DynamicsPlan& p, double* memory) {
    std::size_t trees = 0;
    for (const DynamicsPlan::Group& g : p.groups) trees += g.trees.size();
    const auto size = [](int n) { return static_cast<std::size_t>(std::max(0, n)); };  // of an unfinished plan, below zero
    const auto take = [&]<class E>(E*& out, std::size_t count) {
      out = memory == nullptr ? nullptr : reinterpret_cast<E*>(memory + numbers);
      numbers += count * sizeof(E) / sizeof(double);
    };
    take(cut_centre, p.cuts.size());
    take(cut_axes, 2 * p.cuts.size());
    take(tree_centre, trees);
    take(beyond, size(p.bodies));
    take(cut_wrench, p.cuts.size());
    take(matrix, size(p.most_equations * p.most_unknowns));
    for (T** list : {&diagonal, &factor, &right}) take(*list, size(p.most_equations));
    for (T** list : {&x, &shift}) take(*list, size(p.unknowns));
    take(vectors, p.vector_numbers);
    take(platform, size(6 * p.open));
    for (T** list : {&platform_diagonal, &platform_factor, &platform_right}) take(*list, 6);
    take(share, size(p.open));
    take(stress_shares, size(p.open * std::max(0, p.stresses())));
    take(wrenches, size(6 * p.joints * (1 + std::max(0, p.stresses()))));
    take(bits, size(p.joints));
  }
};

}  // namespace pmreport::mechanics
