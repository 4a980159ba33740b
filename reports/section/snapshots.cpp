// Section `snapshots`, and the cameras that all pictures of a report share.
#include <reports/section/section.hpp>
#include <reports/section/words.hpp>

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

Stage::Stage(const Analysis& a) {
  scene::include(bounds_, a.machine(), a.machine().home_pose());
  const int step = std::max(1, a.samples() / framed_poses);
  for (int k = 0; k < a.samples(); k += k + step < a.samples() || k == a.samples() - 1 ? step : a.samples() - 1 - k) {
    if (a.condition(k) == Condition::unreachable) continue;
    const mechanics::Pose pose = a.pose(k);
    scene::include(bounds_, a.machine(), pose);
    path_.push_back(a.machine().origin(pose, a.machine().topology().platform));
  }
}

document::Picture Stage::picture(const Analysis& a, int sample, const scenario::View& view, const scenario::SectionRequest& r,
                                 const std::string& id) const {
  scene::Extras extras;
  if (r.path) extras.path = path_;
  if (r.load) {
    extras.force = a.scenario().load.force[static_cast<std::size_t>(sample)];
    extras.moment = a.scenario().load.moment[static_cast<std::size_t>(sample)];
  }
  extras.labels = r.labels;
  extras.frames = r.frames;
  const scene::Camera camera = scene::frame(bounds_, view.azimuth, view.elevation, static_cast<double>(r.width) / r.height);
  const scene::Quality quality{r.width, r.height, r.transparent, 2};
  return {id, fmt::format("t = {}, {} view", show_time(a, sample), view.name),
          scene::to_png(scene::render(scene::build(a.machine(), a.pose(sample), extras), camera, quality)), r.width, r.height};
}

document::Picture Stage::portrait(const Analysis& a, const std::string& id) const {
  const scene::Quality quality{};
  scene::Bounds home;
  scene::include(home, a.machine(), a.machine().home_pose());
  const scene::Camera camera =
      scene::frame(home, isometric.azimuth, isometric.elevation, static_cast<double>(quality.width) / quality.height);
  return {id, "The mechanism at home, isometric view, joints and frames.",
          scene::to_png(scene::render(scene::build(a.machine(), a.machine().home_pose(), {}), camera, quality)), quality.width,
          quality.height};
}

document::Section snapshots_section(const Analysis& a, const scenario::SectionRequest& r, const Stage& stage, const Progress& progress,
                                    int number) {
  const std::string suffix = number > 1 ? std::to_string(number) : "";
  document::Section s{"snapshots" + suffix, "snapshots", "Snapshots", {}};
  document::Gallery gallery{{}, "All pictures of one view share one camera, framed over the whole motion."};
  int index = 0;
  for (const double t : r.times)
    for (const scenario::View& view : r.views) {
      progress.stop_if_asked();
      const int k = a.sample_at(t);
      ++index;
      if (a.condition(k) == Condition::unreachable) {
        s.blocks.push_back(Paragraph{Paragraph::Tone::warning,
                                     fmt::format("t = {}: no picture, the mechanism cannot be assembled: {}.", show_time(a, k), a.why(k))});
        continue;
      }
      progress.say(fmt::format("picture {} of {}", index, r.times.size() * r.views.size()));
      gallery.pictures.push_back(stage.picture(a, k, view, r, fmt::format("snapshot{}-{}", suffix, index)));
    }
  if (!gallery.pictures.empty()) s.blocks.push_back(gallery);
  return s;
}

}  // namespace pmreport::section
