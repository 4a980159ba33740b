#include <core/analysis/workspace/scan_of.hpp>

#include <core/program/evaluate.hpp>

#include <algorithm>
#include <cmath>

namespace pmreport::analysis {

namespace {

std::size_t nearest(const scan::Axis& a, double x) {
  if (a.count < 2 || a.from == a.to) return 0;
  const double k = std::round((x - a.from) / a.step());
  return static_cast<std::size_t>(std::clamp(k, 0.0, static_cast<double>(a.count - 1)));
}

std::vector<double> as_vector(const Eigen::VectorXd& q) { return {q.data(), q.data() + q.size()}; }

std::string power(const std::string& unit, int n) { return n == 1 ? unit : unit + "^" + std::to_string(n); }

}  // namespace

std::string unit_of_volume(int metres, int radians) {
  std::string out = metres > 0 ? power("m", metres) : "";
  if (radians > 0) out += (out.empty() ? "" : "*") + power("rad", radians);
  return out;
}

WorkspaceRequest completed(WorkspaceRequest request, const std::vector<double>& home) {
  const auto n = static_cast<Eigen::Index>(home.size());
  if (request.at.size() == 0) request.at = Eigen::VectorXd::Constant(n, std::nan(""));
  for (Eigen::Index i = 0; i < n; ++i)
    if (std::isnan(request.at(i))) request.at(i) = home[static_cast<std::size_t>(i)];
  std::vector<ScanMethod> once;
  for (const ScanMethod m : request.methods)
    if (std::ranges::find(once, m) == once.end()) once.push_back(m);
  request.methods = once;
  std::uint64_t orientations = request.orientation_list.empty() ? 0 : request.orientation_list.size();
  if (!request.orientations.empty()) {
    orientations = 1;
    for (const ScanRange& r : request.orientations) orientations *= r.count;
  }
  if (orientations > 0 && request.at_least.empty()) {
    request.at_least = {1};
    if (orientations > 1) request.at_least.push_back(orientations);
  }
  if (orientations == 0) request.at_least.clear();
  return request;
}

scan::PoseSet set_of(const mechanics::PoseMargins& margins) {
  scan::PoseSet out;
  out.margins = margins.program;
  for (const mechanics::PoseMargin& m : margins.margins) out.rounding.push_back(m.rounding);
  out.late = {margins.late, margins.judge_late, margins.every, margins.late_over_boxes};
  return out;
}

scan::Scan scan_of(const WorkspaceRequest& request, const mechanics::Machine& machine) {
  scan::Scan out;
  const auto n = static_cast<std::size_t>(machine.dof());
  out.at.assign(request.at.data(), request.at.data() + n);
  for (const ScanRange& r : request.scan) out.points.push_back({r.coordinate, r.from, r.to, std::max<std::size_t>(r.count, 1)});
  out.turned = request.turned;
  for (const Eigen::VectorXd& q : request.orientation_list) {
    std::vector<double> values;
    for (const int i : request.turned) values.push_back(q(i));
    out.orientations.push_back(std::move(values));
  }
  if (request.orientations.empty()) return out;
  // The product of the ranges, the last fastest.
  out.turned.clear();
  std::vector<scan::Axis> axes;
  std::size_t count = 1;
  for (const ScanRange& r : request.orientations) {
    out.turned.push_back(r.coordinate);
    axes.push_back({r.coordinate, r.from, r.to, r.count});
    count *= r.count;
  }
  for (std::size_t k = 0; k < count; ++k) {
    std::vector<double> values(axes.size());
    std::size_t rest = k;
    for (std::size_t a = axes.size(); a-- > 0;) {
      values[a] = axes[a].value(rest % axes[a].count);
      rest /= axes[a].count;
    }
    out.orientations.push_back(std::move(values));
  }
  return out;
}

std::string unit_of(const scan::Scan& scan, const mechanics::Machine& machine) {
  int metres = 0, radians = 0;
  for (const scan::Axis& a : scan.points)
    (machine.topology().coordinates[static_cast<std::size_t>(a.input)].sense() == Sense::linear ? metres : radians) += 1;
  return unit_of_volume(metres, radians);
}

std::vector<double> machine_pose(const Workspace& w, std::span<const double> scanned) {
  return w.tool ? w.tool->machine_pose(scanned) : std::vector<double>(scanned.begin(), scanned.end());
}

std::vector<double> scanned_pose(const Workspace& w, std::span<const double> of_machine) {
  return w.tool ? w.tool->by_tool(of_machine) : std::vector<double>(of_machine.begin(), of_machine.end());
}

std::vector<double> home_of(const Workspace& w, const mechanics::Machine& machine) {
  const std::vector<double> home = scanned_pose(w, as_vector(machine.home()));
  std::vector<double> q = w.scan.at;
  for (const scan::Axis& a : w.scan.points) q[static_cast<std::size_t>(a.input)] = home[static_cast<std::size_t>(a.input)];
  for (const int i : w.scan.turned) q[static_cast<std::size_t>(i)] = home[static_cast<std::size_t>(i)];
  return q;
}

void judge_home(Workspace& w, const mechanics::Machine& machine) {
  const std::vector<double> q = home_of(w, machine);
  std::vector<double> margins(w.set.size());
  const std::size_t recorded = w.set.margins.outputs().size();
  program::Evaluator<double> evaluator(w.set.margins);
  evaluator.run(q, {margins.data(), recorded});
  if (w.set.late.size > 0) w.set.late.judge(1, q.data(), margins.data() + recorded);
  const auto refusing = std::ranges::find_if(margins, [&, m = std::size_t{0}](double x) mutable { return !(x >= -w.set.rounding[m++]); });
  w.home_inside = refusing == margins.end();
  if (!w.home_inside) w.home_refused_by = w.margins.margins[static_cast<std::size_t>(refusing - margins.begin())].name;
}

std::uint64_t nearest_to_home(const Workspace& w, const mechanics::Machine& machine) {
  const std::vector<double> home = scanned_pose(w, as_vector(machine.home()));
  std::uint64_t point = 0;
  for (const scan::Axis& a : w.scan.points) point = point * a.count + nearest(a, home[static_cast<std::size_t>(a.input)]);
  std::uint64_t orientation = 0;
  for (const ScanRange& r : w.request.orientations)
    orientation = orientation * r.count + nearest({r.coordinate, r.from, r.to, r.count}, home[static_cast<std::size_t>(r.coordinate)]);
  return point * w.scan.orientation_count() + orientation;
}

}  // namespace pmreport::analysis
