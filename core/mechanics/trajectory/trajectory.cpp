#include <core/mechanics/trajectory/trajectory.hpp>

namespace pmreport::mechanics {

void cut_off(Trajectory& trajectory, std::size_t samples) {
  trajectory.time.resize(samples);
  for (Eigen::MatrixXd* part : {&trajectory.value, &trajectory.rate, &trajectory.acceleration})
    part->conservativeResize(static_cast<Eigen::Index>(samples), Eigen::NoChange);
  const double end = trajectory.time.empty() ? 0 : trajectory.time.back();
  std::erase_if(trajectory.knots, [&](double t) { return t >= end; });
  std::erase_if(trajectory.breaks, [&](const Break& b) { return b.time >= end; });
}

Trajectory sampled(Path path, std::vector<double> times, int dof) {
  Trajectory out;
  const auto rows = static_cast<Eigen::Index>(times.size());
  for (Eigen::MatrixXd* part : {&out.value, &out.rate, &out.acceleration}) part->resize(rows, dof);
  Eigen::VectorXd value(dof), rate(dof), acceleration(dof);
  for (Eigen::Index k = 0; k < rows; ++k) {
    path(times[static_cast<std::size_t>(k)], value.data(), rate.data(), acceleration.data());
    out.value.row(k) = value, out.rate.row(k) = rate, out.acceleration.row(k) = acceleration;
  }
  out.time = std::move(times);
  out.at = std::move(path);
  return out;
}

}  // namespace pmreport::mechanics
