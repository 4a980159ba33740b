#include <core/analysis/workspace/along_motion.hpp>

#include <core/program/batch.hpp>
#include <core/program/derivative.hpp>

#include <cmath>
#include <numeric>

namespace pmreport::analysis {

BoundaryDistance distance_to_boundary(const Workspace& w, const mechanics::Machine& machine, const mechanics::Trajectory& trajectory,
                                      double length) {
  const auto samples = static_cast<std::size_t>(trajectory.samples()), dof = static_cast<std::size_t>(machine.dof());
  std::vector<int> by(dof);
  std::iota(by.begin(), by.end(), 0);
  program::Batch batch(program::partials(w.set.margins, by));
  const std::size_t margins = w.set.margins.outputs().size();
  std::vector<double> in(dof * samples), out((margins + margins * dof) * samples);
  for (std::size_t k = 0; k < samples; ++k) {
    std::vector<double> q(dof);
    for (std::size_t i = 0; i < dof; ++i) q[i] = trajectory.value(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(i));
    q = scanned_pose(w, q);
    for (std::size_t i = 0; i < dof; ++i) in[i * samples + k] = q[i];
  }
  batch.run(samples, in.data(), out.data());

  BoundaryDistance d{std::vector<double>(samples, std::nan("")), std::vector<int>(samples, -1)};
  for (std::size_t k = 0; k < samples; ++k) {
    if (!(out[k] >= 0)) continue;  // beyond reach there is no pose
    for (std::size_t m = 0; m < margins; ++m) {
      double squares = 0;
      for (std::size_t i = 0; i < dof; ++i) {
        const double scale = machine.topology().coordinates[i].sense() == Sense::linear ? 1 : length;
        squares += std::pow(out[(margins + m * dof + i) * samples + k] / scale, 2);
      }
      const double distance = out[m * samples + k] / std::sqrt(squares);
      if (!std::isfinite(distance) || distance >= d.distance[k]) continue;
      d.distance[k] = distance, d.margin[k] = static_cast<int>(m);
    }
    if (d.margin[k] >= 0 && (d.nearest < 0 || d.distance[k] < d.distance[static_cast<std::size_t>(d.nearest)]))
      d.nearest = static_cast<int>(k);
  }
  return d;
}

}  // namespace pmreport::analysis
