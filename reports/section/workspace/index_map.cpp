#include <reports/section/workspace/index_map.hpp>

#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/singularity/singularity.hpp>

#include <tbb/parallel_for.h>

#include <cmath>

namespace pmreport::section {

std::vector<double> index_over(const mechanics::Machine& machine, const analysis::Workspace& w, const scan::Field& field,
                               const scan::Scan& scan, const std::string& index) {
  const double length = mechanics::characteristic_length(machine);
  std::vector<double> out = field.least();
  tbb::parallel_for(std::size_t{0}, out.size(), [&](std::size_t k) {
    const bool inside = out[k] >= 0;
    out[k] = std::nan("");
    if (!inside) return;
    std::vector<double> q = scan.at;
    std::size_t rest = k;
    for (std::size_t a = field.axes.size(); a-- > 0; rest /= field.axes[a].count)
      q[static_cast<std::size_t>(field.axes[a].input)] = field.axes[a].value(rest % field.axes[a].count);
    const mechanics::Pose pose = machine.pose(analysis::machine_pose(w, q));
    if (pose.status != PM_OK) return;
    const mechanics::Jacobian g = machine.jacobian(pose);
    if (!g.known()) return;
    const mechanics::Conditioning c = mechanics::conditioning(machine, g.matrix, length);
    out[k] = index == "determinant" ? c.determinant : c.condition();
  });
  return out;
}

}  // namespace pmreport::section
