// The distance of two limbs, as segments of a line, for every scalar of the geometry.
#pragma once

#include <core/mechanics/machine/limb_line.hpp>
#include <core/mechanics/workspace/pose_limits.hpp>
#include <pmreport/scalar.hpp>

#include <utility>
#include <vector>

namespace pmreport::mechanics {

// Pairs that a distance is asked between.
std::vector<std::pair<LimbLine, LimbLine>> pairs_of(const Machine& machine, const AskedDistance& asked);

// Points p + s d, q + t e with s and t from 0 to 1, r = p - q. The distance is least, of a quadratic over a square, in three steps
// (Ericson 2005, Real-Time Collision Detection, 5.1.9):
//     s = clamp((b f - c e') / (a e' - b^2)),   t = clamp((b s + f) / e'),   s = clamp((b t - c) / a),
//     a = d.d, b = d.e, e' = e.e, c = d.r, f = e.r
// of which the last is right where t was clamped, and changes nothing where it was not. Of segments that are parallel every s will do for
// the first: the divisor is kept away from zero, relative to a e'. Quotients by a and e' are products with 1 / a and 1 / e', which all
// distances of a segment share.
template <class T>
T squared_distance(const Vector3<T>& p, const Vector3<T>& p_end, const Vector3<T>& q, const Vector3<T>& q_end) {
  const auto clamp = [](const T& x) { return smaller(larger(x, T(0.0)), T(1.0)); };
  const Vector3<T> d = p_end - p, e = q_end - q, r = p - q;
  const T a = d.dot(d), b = d.dot(e), ee = e.dot(e), c = d.dot(r), f = e.dot(r);
  const T s0 = clamp(T((b * f - c * ee) / larger(T(a * ee - b * b), T(1e-12 * a * ee))));
  const T t = clamp(T((b * s0 + f) * (1.0 / ee))), s = clamp(T((b * t - c) * (1.0 / a)));
  const Vector3<T> apart = r + d * s - e * t;
  return apart.dot(apart);
}

}  // namespace pmreport::mechanics
