#include <reports/section/front/model_file.hpp>

#include <reports/scene/gltf/machine_model.hpp>

#include <algorithm>

namespace pmreport::section {

namespace {

constexpr std::size_t most_keys = 240;  // a smooth motion needs no more, and the file stays small

// The format counts time from zero: a motion that begins before is moved there.
double begin_of(const Analysis& a) { return a.samples() > 0 ? std::min(0.0, a.time().front()) : 0; }

// Samples that have a pose, spread evenly where there are too many; the first and the last of them always.
std::vector<scene::Moment> moments_of(const Analysis& a) {
  std::vector<int> reached;
  for (int k = 0; k < a.samples(); ++k)
    if (a.outcome(k) != Outcome::unreachable) reached.push_back(k);
  std::vector<scene::Moment> out;
  const double begin = begin_of(a);
  const std::size_t all = reached.size(), keys = std::min(all, most_keys);
  for (std::size_t i = 0; i < keys; ++i) {
    const int k = reached[keys > 1 ? i * (all - 1) / (keys - 1) : 0];
    const double t = a.time()[static_cast<std::size_t>(k)] - begin;
    // The format's times are single numbers: two that are one there have one pose.
    if (!out.empty() && static_cast<float>(t) <= static_cast<float>(out.back().time)) continue;
    if (mechanics::Pose pose = a.pose(k); pose.status == PM_OK) out.push_back({t, std::move(pose)});
  }
  return out;
}

}  // namespace

document::File model_file(const Analysis& a) {
  scene::Model model = scene::model_of(a.machine(), moments_of(a));
  model.begin = begin_of(a);
  const bool animated = !model.tracks.empty();
  return {"data/model.glb",
          animated ? "the machine as a 3D model, with the motion as animation (glTF 2.0)" : "the machine as a 3D model (glTF 2.0)",
          scene::to_glb(model)};
}

}  // namespace pmreport::section
