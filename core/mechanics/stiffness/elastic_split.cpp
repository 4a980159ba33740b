#include <core/mechanics/stiffness/elastic_split.hpp>

namespace pmreport::mechanics {

using Eigen::Index;

ElasticSplit::Answer ElasticSplit::add(const double* placement, std::size_t stride, const MotionReactions& reactions, std::size_t k,
                                       std::size_t count, const Vector6d& load, std::vector<Vector6d>& joints) {
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
  Eigen::MatrixXd stresses(static_cast<Index>(parts_.springs.size()), reactions.stress_count);
  ForceRows forces;
  for (int s = 0; s < reactions.stress_count; ++s) {
    spring_forces(plan_, parts_, placement_.data(), 1, gathered(reactions.stresses, static_cast<std::size_t>(s) * numbers, numbers).data(),
                  nullptr, nullptr, forces);
    stresses.col(s) = forces;
  }
  spring_forces(plan_, parts_, placement_.data(), 1, gathered(reactions.joints, 0, numbers).data(),
                gathered(reactions.actuator_forces, 0, static_cast<std::size_t>(plan_.machine().dof())).data(), load.data(), forces);
  const Settled y = settled(parts_.springs, stresses, forces, true);
  const auto number = [&](int s, std::size_t i) { return reactions.stresses[(static_cast<std::size_t>(s) * numbers + i) * count + k]; };
  for (std::size_t i = 0; i < numbers; ++i)
    for (int s = 0; s < reactions.stress_count; ++s) joints[i / 6](static_cast<Index>(i % 6)) += y.shares(s, 0) * number(s, i);
  for (Index o = 0; o < y.open.cols(); ++o) {
    std::vector<Vector6d> stress(joints.size(), Vector6d::Zero());
    for (std::size_t i = 0; i < numbers; ++i)
      for (int s = 0; s < reactions.stress_count; ++s) stress[i / 6](static_cast<Index>(i % 6)) += y.open(s, o) * number(s, i);
    out.open.push_back(std::move(stress));
  }
  out.settled = reactions.stress_count - static_cast<int>(y.open.cols());
  return out;
}

}  // namespace pmreport::mechanics
