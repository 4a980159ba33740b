// Section `snapshots`.
#include <reports/scene/showing/overlay.hpp>
#include <reports/section/common/words/words.hpp>
#include <reports/section/snapshots/snapshots.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace pmreport::section {

using document::Paragraph;

namespace {

constexpr int usual_overlay = 5;             // poses
constexpr std::size_t most_looked_at = 240;  // samples among which they are chosen

// Samples whose poses show the motion best: the first, the last, and those farthest from one another.
std::vector<int> samples_of_overlay(const Analysis& a, int count) {
  std::vector<int> reached;
  for (int k = 0; k < a.samples(); ++k)
    if (a.outcome(k) != Outcome::unreachable) reached.push_back(k);
  std::vector<int> samples;
  std::vector<mechanics::Pose> poses;
  const std::size_t n = std::min(most_looked_at, reached.size());
  for (std::size_t i = 0; i < n; ++i) {
    samples.push_back(reached[n > 1 ? i * (reached.size() - 1) / (n - 1) : 0]);
    poses.push_back(a.pose(samples.back()));
  }
  std::vector<int> out;
  for (const std::size_t i : scene::spread(a.machine(), poses, static_cast<std::size_t>(count))) out.push_back(samples[i]);
  return out;
}

// Of a motion that is seen to move: two poses that look alike need no picture of both.
std::vector<int> overlaid(const Analysis& a, const SnapshotsOptions& r, int number) {
  const bool by_itself = !r.overlay && number == 1 && a.samples() > 2;
  const int count = by_itself ? usual_overlay : r.overlay.value_or(0);
  if (count == 0) return {};
  std::vector<int> samples = samples_of_overlay(a, count);
  if (samples.size() < 2) samples.clear();
  return samples;
}

}  // namespace

Result snapshots_section(const Analysis& a, const SnapshotsOptions& r, const Stage& stage, const Progress& progress, int number) {
  const std::string suffix = number > 1 ? std::to_string(number) : "";
  document::Section s{"snapshots" + suffix, "snapshots", "Snapshots", {}};
  document::Gallery gallery{{}, ""};
  Look look = r;
  if (std::max<std::size_t>(1, r.times.size()) * r.views.size() == 1) look.printed = Stage::page_width;
  std::vector<Stage::Ordered> ordered;
  if (r.times.empty())  // there is no motion
    for (const View& view : r.views)
      ordered.push_back(stage.picture_at_home(view, look, fmt::format("snapshot{}-{}", suffix, ordered.size() + 1)));
  for (const double t : r.times)
    for (const View& view : r.views) {
      const int k = a.sample_at(t);
      if (a.outcome(k) == Outcome::unreachable)
        s.blocks.push_back(Paragraph{Paragraph::Tone::warning,
                                     fmt::format("t = {}: no picture, the mechanism cannot be assembled: {}.", show_time(a, k), a.why(k))});
      else
        ordered.push_back(stage.picture(k, view, look, fmt::format("snapshot{}-{}", suffix, ordered.size() + 1)));
    }
  std::optional<Stage::Ordered> motion;
  if (const std::vector<int> samples = overlaid(a, r, number); !samples.empty())
    motion = stage.overlay(samples, r.views.front(), r, fmt::format("motion{}", suffix));
  for (Stage::Ordered& o : ordered) {
    progress.stop_if_asked();
    progress.say(fmt::format("picture {} of {}", gallery.pictures.size() + 1, ordered.size()));
    document::Picture p = o.wait();
    p.caption = fmt::format("Snapshot {}{}: {}", number > 1 ? fmt::format("{}.", number) : "", gallery.pictures.size() + 1, p.caption);
    gallery.pictures.push_back(std::move(p));
  }
  if (gallery.pictures.size() > 1) gallery.caption = "All pictures of one view share one camera, framed over the whole motion.";
  if (const std::string scale = stage.load_scale(); r.load && !r.times.empty() && !scale.empty())
    gallery.caption += (gallery.caption.empty() ? "" : " ") + scale;
  if (!gallery.pictures.empty()) s.blocks.push_back(gallery);
  if (motion) s.blocks.push_back(document::Gallery{{motion->wait()}, ""});
  return {s};
}

}  // namespace pmreport::section
