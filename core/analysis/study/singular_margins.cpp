#include <core/analysis/study/singular_margins.hpp>

#include <core/mechanics/singularity/singularity.hpp>
#include <core/numbers.hpp>

#include <tbb/parallel_for.h>

#include <cmath>

namespace pmreport::analysis {

AlongMotion along_motion(const Analysis& a, double length) {
  const auto n = static_cast<std::size_t>(a.samples());
  AlongMotion out{std::vector<double>(n, nan), std::vector<double>(n, nan), std::vector<double>(n, nan)};
  const mechanics::Machine& m = a.machine();
  tbb::parallel_for(std::size_t{0}, n, [&](std::size_t k) {
    if (a.outcome(static_cast<int>(k)) == Outcome::unreachable) return;
    const mechanics::Pose pose = a.pose(static_cast<int>(k));
    if (pose.status != PM_OK) return;
    const mechanics::Jacobian g = m.jacobian(pose);
    if (!g.known()) return;
    const mechanics::Conditioning c = mechanics::conditioning(m, g.matrix, length);
    out.determinant[k] = c.determinant, out.smallest[k] = c.smallest, out.condition[k] = c.condition();
  });
  for (std::size_t k = 0; k < n; ++k)
    if (std::isfinite(out.smallest[k]) && (out.worst < 0 || out.smallest[k] < out.smallest[static_cast<std::size_t>(out.worst)]))
      out.worst = static_cast<int>(k);
  return out;
}

// A row of the map is placed at once, so that the geometry runs on several poses at a time.
SingularityGrid singularity_grid(const mechanics::Machine& m, const PoseMap& r, double length) {
  const auto n = static_cast<std::size_t>(r.points);
  SingularityGrid grid{std::vector<double>(n * n, nan), std::vector<double>(n * n, nan)};
  std::vector<int> sides(n * n, 0);
  tbb::parallel_for(std::size_t{0}, n, [&](std::size_t row) {
    std::vector<double> q(static_cast<std::size_t>(m.dof()) * n), placement(m.layout().size() * n), g(36 * n);
    for (int i = 0; i < m.dof(); ++i)
      for (std::size_t k = 0; k < n; ++k)
        q[static_cast<std::size_t>(i) * n + k] = i == r.coordinate[0] ? r.value(0, k) : i == r.coordinate[1] ? r.value(1, row) : r.at(i);
    if (m.place(PM_VALUE, n, q.data(), placement.data()) != PM_OK || m.jacobian(PM_VALUE, n, placement.data(), g.data()) != PM_OK) return;
    for (std::size_t k = 0; k < n; ++k) {
      if (!(placement[k] >= 0)) continue;  // the reach
      mechanics::Matrix6d jacobian;
      for (std::size_t e = 0; e < 36; ++e) jacobian(static_cast<int>(e / 6), static_cast<int>(e % 6)) = g[e * n + k];
      if (!jacobian.allFinite()) continue;
      const mechanics::Conditioning c = mechanics::conditioning(m, jacobian, length);
      sides[row * n + k] = mechanics::side_of(jacobian, length);
      grid.determinant[row * n + k] = c.determinant;
      grid.smallest[row * n + k] = std::copysign(c.smallest, c.determinant);
    }
  });
  for (std::size_t k = 0; k < sides.size(); ++k) {
    if (!std::isfinite(grid.determinant[k])) continue;
    ++grid.reachable;
    grid.negative += sides[k] < 0 ? 1 : 0, grid.singular += sides[k] == 0 ? 1 : 0;
  }
  return grid;
}

}  // namespace pmreport::analysis
