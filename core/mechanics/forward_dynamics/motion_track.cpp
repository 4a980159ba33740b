#include <core/mechanics/forward_dynamics/motion_track.hpp>

#include <algorithm>

namespace pmreport::mechanics {

namespace {

// Steps so short that the difference of two values, rounded, no longer tells a rate: there the rates are interpolated by themselves.
constexpr double rounded_away = 1e-6;  // [s]

}  // namespace

// With s = (t - t_a) / h and what the Taylor polynomial at a leaves of value, rate and acceleration at b, D, E = h D', F = h^2 D'':
//   q = q_a + s h q_a' + s^2 h^2 q_a'' / 2 + (10 D - 4 E + F/2) s^3 + (-15 D + 7 E - F) s^4 + (6 D - 3 E + F/2) s^5.
TrackPoint between(const TrackPoint& a, const TrackPoint& b, double t) {
  const double h = b.time - a.time, s = (t - a.time) / h;
  const SmallVector slope = h * a.rate, bend = h * h * a.acceleration;
  const SmallVector d = b.value - a.value - slope - 0.5 * bend, e = h * b.rate - slope - bend, f = h * h * b.acceleration - bend;
  const SmallVector c3 = 10 * d - 4 * e + 0.5 * f, c4 = -15 * d + 7 * e - f, c5 = 6 * d - 3 * e + 0.5 * f;
  TrackPoint out;
  out.time = t;
  out.value = a.value + s * (slope + s * (0.5 * bend + s * (c3 + s * (c4 + s * c5))));
  out.rate = (slope + s * (bend + s * (3 * c3 + s * (4 * c4 + s * 5 * c5)))) / h;
  if (h < rounded_away) {
    const SmallVector rest = b.rate - a.rate - h * a.acceleration, turn = h * (b.acceleration - a.acceleration);
    out.rate = a.rate + s * (h * a.acceleration + s * (3 * rest - turn + s * (turn - 2 * rest)));
  }
  return out;
}

TrackPoint MotionTrack::at(double t) const {
  if (points_.size() == 1) return points_.front();
  const auto after = std::upper_bound(points_.begin() + 1, points_.end() - 1, t, [](double x, const TrackPoint& p) { return x < p.time; });
  return between(*(after - 1), *after, t);
}

}  // namespace pmreport::mechanics
