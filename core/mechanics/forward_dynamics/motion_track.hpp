// The steps of an integrated motion, and the motion between them.
#pragma once

#include <core/mechanics/model/state.hpp>

#include <vector>

namespace pmreport::mechanics {

struct TrackPoint {
  double time = 0;                        // [s]
  SmallVector value, rate, acceleration;  // dof long, SI
};

// From `a` to `b` by the quintic with their values, rates and accelerations. Its error is that of the sixth derivative, q6 h^6 / 46080 in
// value and about q6 h^5 / 13400 in rate: less than the step itself brings at h^5. The second derivative falls short of that; whoever wants
// the acceleration asks the equations of motion.
TrackPoint between(const TrackPoint& a, const TrackPoint& b, double t);

class MotionTrack {
 public:
  void add(TrackPoint point) { points_.push_back(std::move(point)); }
  TrackPoint at(double t) const;  // from the first point to the last; accelerations are left out

 private:
  std::vector<TrackPoint> points_;
};

}  // namespace pmreport::mechanics
