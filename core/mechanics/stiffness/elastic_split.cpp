#include <core/mechanics/stiffness/elastic_split.hpp>

#include <algorithm>

namespace pmreport::mechanics {

using Eigen::Index;

ElasticSplit::Answer ElasticSplit::add(const double* placement, std::size_t stride, const MotionReactions& reactions, std::size_t k,
                                       std::size_t count, std::vector<Vector6d>& joints) {
  Answer out;
  if (reactions.stress_count == 0 || !any()) return out;
  placement_.resize(plan_.machine().layout().size());
  for (std::size_t i = 0; i < placement_.size(); ++i) placement_[i] = placement[i * stride];
  plan_.at(placement_.data(), 1, parts_);
  const std::size_t numbers = 6 * joints.size();
  const auto gathered = [&](const std::vector<double>& from, std::size_t first, std::size_t many) {
    std::vector<double> out_of(many);
    for (std::size_t i = 0; i < many; ++i) out_of[i] = from[(first + i) * count + k];
    return out_of;
  };
  std::vector<int> present;  // a pose with fewer self-stresses than others has zeros in their places
  std::vector<Eigen::VectorXd> columns;
  for (int s = 0; s < reactions.stress_count; ++s) {
    const std::vector<double> stress = gathered(reactions.stresses, static_cast<std::size_t>(s) * numbers, numbers);
    if (std::ranges::all_of(stress, [](double x) { return x == 0; })) continue;
    present.push_back(s);
    columns.push_back(stress_forces(plan_, parts_, placement_.data(), stress.data()));
  }
  const auto stress_count = static_cast<Index>(present.size());
  Eigen::MatrixXd stresses(static_cast<Index>(parts_.springs.size()), stress_count);
  for (Index s = 0; s < stress_count; ++s) stresses.col(s) = columns[static_cast<std::size_t>(s)];
  ForceRows forces;
  spring_forces(plan_, parts_, placement_.data(), 1, gathered(reactions.joints, 0, numbers).data(),
                gathered(reactions.actuator_forces, 0, static_cast<std::size_t>(plan_.machine().dof())).data(), forces);
  const Settled y = settled(parts_.springs, stresses, forces, true);
  const auto number = [&](Index s, std::size_t i) {
    return reactions.stresses[(static_cast<std::size_t>(present[static_cast<std::size_t>(s)]) * numbers + i) * count + k];
  };
  for (std::size_t i = 0; i < numbers; ++i)
    for (Index s = 0; s < stress_count; ++s) joints[i / 6](static_cast<Index>(i % 6)) += y.shares(s, 0) * number(s, i);
  for (Index o = 0; o < y.open.cols(); ++o) {
    std::vector<Vector6d> stress(joints.size(), Vector6d::Zero());
    for (std::size_t i = 0; i < numbers; ++i)
      for (Index s = 0; s < stress_count; ++s) stress[i / 6](static_cast<Index>(i % 6)) += y.open(s, o) * number(s, i);
    out.open.push_back(std::move(stress));
  }
  out.settled = static_cast<int>(stress_count - y.open.cols());
  return out;
}

}  // namespace pmreport::mechanics
