// The cameras that all pictures of a report share.
#pragma once

#include <reports/document/report.hpp>
#include <reports/scene/studio.hpp>
#include <reports/section/common/analysis.hpp>

#include <future>
#include <string>
#include <vector>

namespace pmreport::section {

struct View {
  std::string name;           // "isometric", "front", "side", "top", or "azimuth 30°, elevation 20°"
  double azimuth, elevation;  // of the camera as seen from the platform [rad]; front looks along +Y
};

// What a picture of the motion shows besides the mechanism, and its size.
struct Look {
  int width = 1600, height = 1200;  // [px]
  bool transparent = false;         // else white ground
  bool path = true, labels = true, frames = true, load = true;
};

// Cameras shared by all pictures of a report: framed over the whole motion, so that pictures of one view compare.
class Stage {
 public:
  Stage(const Analysis& a, scene::Studio& studio);

  // A picture whose PNG is still being made.
  struct Ordered {
    document::Picture picture;
    std::future<std::string> png;
    document::Picture wait();
  };
  Ordered picture(int sample, const View& view, const Look& look, const std::string& id) const;
  // The same of the home pose; without path and load, which are of a motion.
  Ordered picture_at_home(const View& view, const Look& look, const std::string& id) const;
  Ordered portrait(const std::string& id) const;  // the home pose, with labels and frames
  Ordered cover() const;                          // the home pose and the path, small and bare
  // Any pose of a machine of this mechanism, framed by `bounds`: pictures that are to compare share them.
  Ordered picture(const mechanics::Machine& machine, const mechanics::Pose& pose, const scene::Extras& extras, const scene::Bounds& bounds,
                  const View& view, const std::string& id, const std::string& caption, const scene::Quality& quality) const;

 private:
  const Analysis& analysis_;
  scene::Studio& studio_;
  scene::Bounds bounds_;
  std::vector<Eigen::Vector3d> path_;
};

}  // namespace pmreport::section
