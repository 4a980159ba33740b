// Section `snapshots`, and the cameras that all pictures of a report share.
#include <reports/section/common/words.hpp>
#include <reports/section/section.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pmreport::section {

using document::Paragraph;

namespace {

constexpr double deg = std::numbers::pi / 180;
const scenario::View isometric{"isometric", 45 * deg, std::atan(1 / std::numbers::sqrt2)};
constexpr int framed_poses = 64;  // enough to bound a smooth motion; every pose would cost more than the picture

}  // namespace

Stage::Stage(const Analysis& a, scene::Studio& studio) : analysis_(a), studio_(studio) {
  scene::include(bounds_, a.machine(), a.machine().home_pose());
  const int n = std::min(framed_poses, a.samples());
  for (int i = 0; i < n; ++i) {
    const int k = n > 1 ? i * (a.samples() - 1) / (n - 1) : 0;
    if (a.outcome(k) == Outcome::unreachable) continue;
    const mechanics::Pose pose = a.pose(k);
    scene::include(bounds_, a.machine(), pose);
    path_.push_back(a.machine().origin(pose, a.machine().topology().platform));
  }
}

document::Picture Stage::Ordered::wait() {
  picture.png = png.get();
  return std::move(picture);
}

Stage::Ordered Stage::picture(int sample, const scenario::View& view, const scenario::SectionRequest& r, const std::string& id) const {
  scene::Extras extras;
  if (r.path) extras.path = path_;
  if (r.load) {
    extras.force = analysis_.scenario().load.force[static_cast<std::size_t>(sample)];
    extras.moment = analysis_.scenario().load.moment[static_cast<std::size_t>(sample)];
  }
  extras.labels = r.labels;
  extras.frames = r.frames;
  const scene::Camera camera = scene::frame(bounds_, view.azimuth, view.elevation, static_cast<double>(r.width) / r.height);
  return {{id, fmt::format("t = {}, {} view", show_time(analysis_, sample), view.name), "", r.width, r.height},
          studio_.take(scene::build(analysis_.machine(), analysis_.pose(sample), extras), camera, {r.width, r.height, r.transparent, 2})};
}

Stage::Ordered Stage::picture_at_home(const scenario::View& view, const scenario::SectionRequest& r, const std::string& id) const {
  scene::Extras extras;
  extras.labels = r.labels;
  extras.frames = r.frames;
  const mechanics::Machine& machine = analysis_.machine();
  return picture(machine, machine.home_pose(), extras, bounds_, view, id, fmt::format("At home, {} view", view.name),
                 {r.width, r.height, r.transparent, 2});
}

Stage::Ordered Stage::portrait(const std::string& id) const {
  const scene::Quality quality{1200, 900, false, 2};
  const mechanics::Machine& machine = analysis_.machine();
  scene::Bounds home;
  scene::include(home, machine, machine.home_pose());
  const scene::Camera camera =
      scene::frame(home, isometric.azimuth, isometric.elevation, static_cast<double>(quality.width) / quality.height);
  return {{id, "The mechanism at home, isometric view, joints and frames.", "", quality.width, quality.height},
          studio_.take(scene::build(machine, machine.home_pose(), {}), camera, quality)};
}

Stage::Ordered Stage::picture(const mechanics::Machine& machine, const mechanics::Pose& pose, const scene::Extras& extras,
                              const scene::Bounds& bounds, const scenario::View& view, const std::string& id, const std::string& caption,
                              const scene::Quality& quality) const {
  const scene::Camera camera = scene::frame(bounds, view.azimuth, view.elevation, static_cast<double>(quality.width) / quality.height);
  return {{id, caption, "", quality.width, quality.height}, studio_.take(scene::build(machine, pose, extras), camera, quality)};
}

document::Section snapshots_section(const Analysis& a, const scenario::SectionRequest& r, const Stage& stage, const Progress& progress,
                                    int number) {
  const std::string suffix = number > 1 ? std::to_string(number) : "";
  document::Section s{"snapshots" + suffix, "snapshots", "Snapshots", {}};
  document::Gallery gallery{{}, r.times.empty() ? "" : "All pictures of one view share one camera, framed over the whole motion."};
  std::vector<Stage::Ordered> ordered;
  if (r.times.empty())  // there is no motion
    for (const scenario::View& view : r.views)
      ordered.push_back(stage.picture_at_home(view, r, fmt::format("snapshot{}-{}", suffix, ordered.size() + 1)));
  for (const double t : r.times)
    for (const scenario::View& view : r.views) {
      const int k = a.sample_at(t);
      if (a.outcome(k) == Outcome::unreachable)
        s.blocks.push_back(Paragraph{Paragraph::Tone::warning,
                                     fmt::format("t = {}: no picture, the mechanism cannot be assembled: {}.", show_time(a, k), a.why(k))});
      else
        ordered.push_back(stage.picture(k, view, r, fmt::format("snapshot{}-{}", suffix, ordered.size() + 1)));
    }
  for (Stage::Ordered& o : ordered) {
    progress.stop_if_asked();
    progress.say(fmt::format("picture {} of {}", gallery.pictures.size() + 1, ordered.size()));
    gallery.pictures.push_back(o.wait());
  }
  if (!gallery.pictures.empty()) s.blocks.push_back(gallery);
  return s;
}

}  // namespace pmreport::section
