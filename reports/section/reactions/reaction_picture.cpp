#include <reports/section/common/words/words.hpp>
#include <reports/section/reactions/reactions.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <utility>

namespace pmreport::section {

Stage::Ordered reaction_picture(const Analysis& a, const std::vector<JointLoad>& loads, const Stage& stage) {
  constexpr double drawn = 0.01;       // of the largest: a shorter arrow is hidden by its joint
  constexpr std::size_t labelled = 8;  // more words than these hide the machine
  const JointLoad& largest = *std::ranges::max_element(loads, {}, [](const JointLoad& l) { return l.force.peak; });
  const int sample = largest.force.sample;
  const auto& joints = a.machine().topology().joints;
  std::vector<scene::JointForce> forces;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    Eigen::Vector3d f;
    for (int c = 0; c < 3; ++c) f(c) = a.column(analysis::reaction_column(joints[j], c, true))[static_cast<std::size_t>(sample)];
    if (f.norm() > drawn * largest.force.peak) forces.push_back({static_cast<int>(j), f, ""});
  }
  std::ranges::stable_sort(forces, std::ranges::greater(), [](const scene::JointForce& f) { return f.force.norm(); });
  bool marked = false;
  for (std::size_t i = 0; i < std::min(labelled, forces.size()); ++i) {
    const auto j = static_cast<std::size_t>(forces[i].joint);
    const bool doubtful = loads[j].doubtful_force();
    marked |= doubtful;
    forces[i].label = fmt::format("{}{} {}", joints[j].name, doubtful ? least_norm_mark : "", show(forces[i].force.norm(), "N", 3));
  }
  const double load = a.scenario().load.force[static_cast<std::size_t>(sample)].norm(), full = std::max(largest.force.peak, load);
  const auto shown = forces.size();
  const std::string caption = fmt::format(
      "Forces in the joints at t = {}, where joint {} carries the largest of all: what body a exerts on body b, from the joint's centre, "
      "to one scale{}, the longest arrow {}.{}{}",
      show_time(a, sample), joints[static_cast<std::size_t>(&largest - loads.data())].name, load > 0 ? " with the load" : "",
      show(full, "N", 3), shown > labelled ? fmt::format(" The {} largest have their size beside them.", labelled) : "",
      marked ? fmt::format(" {}: least-norm values.", least_norm_mark) : "");
  return stage.forces(sample, std::move(forces), full, "reactions", caption);
}

}  // namespace pmreport::section
