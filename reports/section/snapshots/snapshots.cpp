// Section `snapshots`.
#include <reports/section/common/words/words.hpp>
#include <reports/section/snapshots/snapshots.hpp>

#include <fmt/core.h>

namespace pmreport::section {

using document::Paragraph;

Result snapshots_section(const Analysis& a, const SnapshotsOptions& r, const Stage& stage, const Progress& progress, int number) {
  const std::string suffix = number > 1 ? std::to_string(number) : "";
  document::Section s{"snapshots" + suffix, "snapshots", "Snapshots", {}};
  document::Gallery gallery{{}, r.times.empty() ? "" : "All pictures of one view share one camera, framed over the whole motion."};
  std::vector<Stage::Ordered> ordered;
  if (r.times.empty())  // there is no motion
    for (const View& view : r.views)
      ordered.push_back(stage.picture_at_home(view, r, fmt::format("snapshot{}-{}", suffix, ordered.size() + 1)));
  for (const double t : r.times)
    for (const View& view : r.views) {
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
  return {s};
}

}  // namespace pmreport::section
