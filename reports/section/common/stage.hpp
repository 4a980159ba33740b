// The cameras that all pictures of a report share.
#pragma once

#include <reports/document/report.hpp>
#include <reports/scene/showing/overlay.hpp>
#include <reports/scene/studio.hpp>
#include <reports/section/common/analysis.hpp>

#include <future>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace pmreport::section {

struct View {
  std::string name;           // "isometric", "front", "side", "top", or "azimuth 30°, elevation 20°"; "auto": chosen by the stage
  double azimuth, elevation;  // of the camera as seen from the platform [rad]; front looks along +Y; of "auto" without meaning
};
View view_at(double azimuth, double elevation);  // [rad], with the name that tells them
std::string words(const View& view);             // "isometric view", "view from azimuth 30°, elevation 20°"

// What a picture of the motion shows besides the mechanism, and its size.
struct Look {
  int width = 1600, height = 1200;  // [px]
  bool transparent = false;         // else white ground
  bool path = true, labels = true, frames = true, load = true;
  double printed = 85;      // [mm] width on paper: half a page
  std::vector<View> views;  // the first of them that is oblique is also that of cover and portrait
};

// Cameras shared by all pictures of a report: framed over the whole motion, so that pictures of one view compare.
class Stage {
 public:
  static constexpr double page_width = 140;  // [mm] of a picture alone, printed

  Stage(const Analysis& a, scene::Studio& studio);

  // The isometric view where limbs, platform and joints are seen well in it, else the one that shows most of them over the motion.
  const View& chosen() const;

  // A picture whose PNG and vectors are still being made.
  struct Ordered {
    document::Picture picture;
    std::future<scene::Prints> prints;
    document::Picture wait();
  };
  Ordered picture(int sample, const View& view, const Look& look, const std::string& id) const;
  // The poses at these samples over one another, the path with the time at several of its points, and no load.
  Ordered overlay(const std::vector<int>& samples, const View& view, const Look& look, const std::string& id) const;
  // The home pose; without path and load, which are of a motion.
  Ordered picture_at_home(const View& view, const Look& look, const std::string& id) const;
  // The pose of a sample with its load and these forces at joints, all to one scale: `full` [N] is the longest arrow.
  Ordered forces(int sample, std::vector<scene::JointForce> forces, double full, const std::string& id, const std::string& caption) const;
  Ordered portrait(const std::string& id) const;  // the home pose, with labels and frames
  // The home pose as a line drawing, in the view of the portrait.
  document::Picture diagram(const std::string& id) const;
  Ordered cover() const;  // the home pose and the path, small and bare
  // To which scale loads are drawn, in a sentence; empty: there are none.
  std::string load_scale() const;
  // Any pose of a machine of this mechanism, framed by `bounds`: pictures that are to compare share them.
  Ordered picture(const mechanics::Machine& machine, const mechanics::Pose& pose, scene::Extras extras, const scene::Bounds& bounds,
                  const View& view, const std::string& id, const std::string& caption, const scene::Quality& quality) const;

 private:
  View resolved(const View& view) const;
  View main_view() const;  // of cover and portrait
  bool base_in_front(const View& view) const;
  bool at_one_place(int a, int b) const;
  std::vector<std::string> symbols() const;  // of the actuators
  scene::Extras extras_of(const Look& look) const;
  void complete(scene::Extras& extras, const View& view) const;

  const Analysis& analysis_;
  scene::Studio& studio_;
  scene::Bounds bounds_;
  std::vector<Eigen::Vector3d> path_;
  std::vector<mechanics::Pose> looked_at_;                           // by which views are chosen
  double most_force_ = 0, most_moment_ = 0;                          // [N], [N m] over the motion
  mutable std::optional<View> chosen_;                               // when first asked for
  mutable std::map<std::pair<double, double>, bool> base_in_front_;  // by azimuth and elevation, likewise
};

}  // namespace pmreport::section
