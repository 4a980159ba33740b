#include <reports/section/common/stage.hpp>

#include <reports/section/common/words/words.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pmreport::section {

namespace {

constexpr double deg = std::numbers::pi / 180;
const View isometric{"isometric", 45 * deg, std::atan(1 / std::numbers::sqrt2)};
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

Stage::Ordered Stage::picture(int sample, const View& view, const Look& look, const std::string& id) const {
  scene::Extras extras;
  if (look.path) extras.path = path_;
  if (look.load) {
    extras.force = analysis_.scenario().load.force[static_cast<std::size_t>(sample)];
    extras.moment = analysis_.scenario().load.moment[static_cast<std::size_t>(sample)];
  }
  extras.labels = look.labels;
  extras.frames = look.frames;
  const scene::Camera camera = scene::frame(bounds_, view.azimuth, view.elevation, static_cast<double>(look.width) / look.height);
  return {{id, fmt::format("t = {}, {} view", show_time(analysis_, sample), view.name), "", look.width, look.height},
          studio_.take(scene::build(analysis_.machine(), analysis_.pose(sample), extras), camera,
                       {look.width, look.height, look.transparent, 2})};
}

Stage::Ordered Stage::picture_at_home(const View& view, const Look& look, const std::string& id) const {
  scene::Extras extras;
  extras.labels = look.labels;
  extras.frames = look.frames;
  const mechanics::Machine& machine = analysis_.machine();
  return picture(machine, machine.home_pose(), extras, bounds_, view, id, fmt::format("At home, {} view", view.name),
                 {look.width, look.height, look.transparent, 2});
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

Stage::Ordered Stage::cover() const {
  const scene::Quality quality{880, 720, false, 2};
  scene::Extras extras;
  extras.labels = extras.frames = false;
  extras.path = path_;
  const bool moves =
      std::ranges::any_of(path_, [&](const Eigen::Vector3d& p) { return (p - path_.front()).norm() > 1e-9 * analysis_.length(); });
  return picture(analysis_.machine(), analysis_.machine().home_pose(), extras, bounds_, isometric, "cover",
                 moves ? "At home, with the path of the platform" : "At home", quality);
}

Stage::Ordered Stage::picture(const mechanics::Machine& machine, const mechanics::Pose& pose, const scene::Extras& extras,
                              const scene::Bounds& bounds, const View& view, const std::string& id, const std::string& caption,
                              const scene::Quality& quality) const {
  const scene::Camera camera = scene::frame(bounds, view.azimuth, view.elevation, static_cast<double>(quality.width) / quality.height);
  return {{id, caption, "", quality.width, quality.height}, studio_.take(scene::build(machine, pose, extras), camera, quality)};
}

}  // namespace pmreport::section
