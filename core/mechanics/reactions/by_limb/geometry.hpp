// Where the joints of a pack of poses are, and in what directions they carry forces or let go.
#pragma once

#include <core/mechanics/reactions/by_limb/desk.hpp>

namespace pmreport::mechanics {

// Reads a placement of order PM_JET. Points count from the platform's reference point O, as p_OC of a joint's centre C, and moments are
// about it, unless said otherwise.
template <class T>
class PackGeometry {
 public:
  // `placement` points at the first pose of the pack, its numbers `stride` apart.
  PMREPORT_INLINE PackGeometry(const DynamicsPlan& plan, const Desk<T>& desk, const double* placement, std::size_t stride)
      : p_(plan), d_(desk), placement_(placement), stride_(stride) {
    origin_ = vector(p_.platform_at);
  }

  PMREPORT_INLINE T number(std::size_t at, std::size_t component = 0) const { return T::load(placement_ + (3 * at + component) * stride_); }
  PMREPORT_INLINE Triple<T> vector(std::size_t at, std::size_t component = 0, std::size_t step = 1) const {
    return {number(at, component), number(at + step, component), number(at + 2 * step, component)};
  }
  PMREPORT_INLINE Triple<T> column(std::size_t body_at, int k, std::size_t component = 0) const {
    return vector(body_at + 3 + static_cast<std::size_t>(k), component, 3);
  }

  // What settles axis 2 of a joint's frame.
  PMREPORT_INLINE Triple<T> second_of(const DynamicsPlan::Frame& f) const {
    if (!f.carried) return vector(f.second);
    if (f.second == 0) return {T(f.mark.x()), T(f.mark.y()), T(f.mark.z())};
    Triple<T> out = zero<T>();
    for (int k = 0; k < 3; ++k) out += vector(f.second + static_cast<std::size_t>(k), 0, 3) * f.mark(k);
    return out;
  }

  // The directions in which the unknowns of a cut joint act, other than base axes: across axis 1, or along axis 1 x axis 2.
  PMREPORT_INLINE void place_cut(int c) {
    const DynamicsPlan::Cut& cut = p_.cuts[static_cast<std::size_t>(c)];
    d_.cut_centre[c] = vector(cut.at) - origin_;
    Triple<T>* axes = d_.cut_axes + 2 * c;
    if (cut.kind == JointKind::universal)
      axes[0] = unit(cross(vector(cut.at + 3), vector(cut.at + 6)));
    else if (cut.kind != JointKind::spherical)
      complete(vector(cut.at + 3), axes[0], axes[1]);
  }
  // The wrench on body b of a cut joint, about its centre, from its unknowns: forces, and couples per length.
  PMREPORT_INLINE Wrench<T> of_unknowns(int c, const T* x) const {
    const DynamicsPlan::Cut& cut = p_.cuts[static_cast<std::size_t>(c)];
    const Triple<T>* axes = d_.cut_axes + 2 * c;
    const auto sum = [&](int count, const T* y) -> Triple<T> {
      if (count == 3) return {y[0], y[1], y[2]};
      if (count == 2) return axes[0] * y[0] + axes[1] * y[1];
      return count == 1 ? axes[0] * y[0] : zero<T>();
    };
    return {sum(cut.forces, x), sum(cut.couples, x + cut.forces) * p_.length};
  }
  PMREPORT_INLINE Wrench<T> about_reference(const Wrench<T>& w, const Triple<T>& p_OC) const {
    return {w.force, w.moment + cross(p_OC, w.force)};
  }
  // Coefficients of `count` forces or couples of a cut: the parts of v along them.
  PMREPORT_INLINE static void parts(int count, const Triple<T>* axes, const Triple<T>& v, double sign, T* out) {
    if (count == 3)
      out[0] = v.x * sign, out[1] = v.y * sign, out[2] = v.z * sign;
    else
      for (int k = 0; k < count; ++k) out[k] = dot(axes[k], v) * sign;
  }

  // Axis of a rotation that a tree joint transmits no moment about.
  PMREPORT_INLINE Triple<T> direction(const DynamicsPlan::Tree& t, DynamicsPlan::Freedom freedom) const {
    const T one(1.0), none(0.0);
    if (freedom == DynamicsPlan::Freedom::turn) return vector(t.at + 3);
    if (freedom == DynamicsPlan::Freedom::turn_second) {
      const Triple<T> a1 = vector(t.at + 3), a2 = vector(t.at + 6);
      return a2 - a1 * dot(a1, a2);
    }
    if (freedom == DynamicsPlan::Freedom::turn_x) return {one, none, none};
    if (freedom == DynamicsPlan::Freedom::turn_y) return {none, one, none};
    if (freedom == DynamicsPlan::Freedom::turn_z) return {none, none, one};
    const Triple<T> spine = vector(t.spine);
    if (freedom == DynamicsPlan::Freedom::turn_spine) return spine;
    Triple<T> e1, e2;
    complete(spine, e1, e2);
    return freedom == DynamicsPlan::Freedom::turn_across ? e1 : e2;
  }

 protected:
  const DynamicsPlan& p_;
  const Desk<T>& d_;
  Triple<T> origin_;  // p_O

 private:
  const double* placement_;
  std::size_t stride_;
};

}  // namespace pmreport::mechanics
