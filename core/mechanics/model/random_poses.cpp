#include <core/mechanics/model/random_poses.hpp>

#include <random>

namespace pmreport::mechanics {

std::vector<Eigen::VectorXd> random_poses(const Machine& machine, int count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto& coordinates = machine.topology().coordinates;
  std::vector<double> placement(machine.layout().size());
  std::vector<Eigen::VectorXd> out;
  constexpr int tries = 1000;
  for (int k = 0; k < tries * count && static_cast<int>(out.size()) < count; ++k) {
    Eigen::VectorXd q(machine.dof());
    for (int i = 0; i < q.size(); ++i) {
      // 53 random bits; the standard library's distributions differ from one implementation to another.
      const double share = static_cast<double>(random() >> 11) * 0x1p-53;
      const Range& box = coordinates[static_cast<std::size_t>(i)].box;
      q(i) = box.min + share * (box.max - box.min);
    }
    if (machine.place(PM_VALUE, 1, q.data(), placement.data()) == PM_OK) out.push_back(q);
  }
  return out;
}

}  // namespace pmreport::mechanics
