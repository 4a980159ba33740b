// The direction from which a machine shows most of itself, and what stands before it there.
#pragma once

#include <reports/scene/scene.hpp>
#include <vector>

namespace pmreport::scene {

struct Direction {
  double azimuth, elevation;  // [rad], as of a camera
};
Direction isometric();  // azimuth 45°, the three axes equally long

// How well the machine is seen at these poses, framed by `bounds`: of every body of the limbs, of the platform and of the joints the share
// of its largest picture among `directions` that is neither hidden nor foreshortened; and how much of the middle, the platform and the
// frames, nothing stands before. 0: nothing is seen; 1: all of it.
std::vector<double> visibility(const mechanics::Machine& machine, const std::vector<mechanics::Pose>& poses, const Bounds& bounds,
                               const std::vector<Direction>& directions);

// Azimuths every 15°, but for those in which one axis of the base hides behind another; elevations 15°, 25°, the isometric one and 45°. The
// isometric view where it is nearly as good as the best; else the best, and of views that are alike the one nearest to it.
Direction choose_direction(const mechanics::Machine& machine, const std::vector<mechanics::Pose>& poses, const Bounds& bounds);

// The base hides so much of the rest that it is better seen through.
bool base_is_in_front(const mechanics::Machine& machine, const std::vector<mechanics::Pose>& poses, const Bounds& bounds,
                      const Direction& direction);

}  // namespace pmreport::scene
