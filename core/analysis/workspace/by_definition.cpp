#include <core/analysis/workspace/by_definition.hpp>

#include <core/analysis/spread.hpp>
#include <core/analysis/workspace/scan_of.hpp>
#include <core/mechanics/machine/joint_words.hpp>
#include <core/mechanics/model/closure.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/transmission/transmission_paths.hpp>
#include <core/mechanics/workspace/segments.hpp>
#include <core/program/evaluate.hpp>

#include <fmt/format.h>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace pmreport::analysis {

namespace {

using mechanics::PoseLimit;

// Values this near an end are left out: the two ways differ by rounding there, and pressure angles by what differences are good for.
constexpr double near_an_end = 1e-9, near_a_pressure = 1e-6;
// Of the poses around home, how far of the range they reach.
constexpr double around_home = 0.15;

// Least distance of two segments: of their ends from the other, or of the lines where both feet lie within.
double segment_distance(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d) {
  const auto from_segment = [](const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& r) {
    const double s = std::clamp((p - q).dot(r - q) / (r - q).squaredNorm(), 0.0, 1.0);
    return (q + s * (r - q) - p).norm();
  };
  double out = std::min({from_segment(a, c, d), from_segment(b, c, d), from_segment(c, a, b), from_segment(d, a, b)});
  const Eigen::Vector3d u = b - a, v = d - c, n = u.cross(v);
  if (!(n.norm() > 1e-12 * u.norm() * v.norm())) return out;
  Eigen::Matrix3d m;
  m << u, -v, n;
  const Eigen::Vector3d x = m.inverse() * (c - a);
  if (x(0) >= 0 && x(0) <= 1 && x(1) >= 0 && x(1) <= 1) out = std::min(out, std::abs(x(2)) * n.norm());
  return out;
}

// What no other way is known for.
bool judged_in_one_way(const PoseLimit& limit) {
  return limit.group == PoseLimit::Group::condition || limit.group == PoseLimit::Group::transmission ||
         limit.group == PoseLimit::Group::compliance;
}

// The values of limits at a pose that can be assembled, in the order of `limits`: all but the reach and what is judged in one way only.
class Values {
 public:
  Values(const Workspace& w, const mechanics::Machine& machine)
      : w_(w),
        machine_(machine),
        closure_(machine),
        drives_(mechanics::transmission_paths(machine, characteristic_length(machine)).drives) {}

  std::vector<double> at(std::span<const double> q, const mechanics::Pose& pose) const {
    std::vector<double> out;
    const Topology& t = machine_.topology();
    const std::vector<double> readings = t.readings.empty() ? std::vector<double>() : machine_.readings(q, pose);
    const std::vector<mechanics::BodyState> bodies = mechanics::bodies_at_rest(machine_, pose);
    for (const PoseLimit& limit : w_.margins.limits)
      if (limit.group == PoseLimit::Group::strokes || limit.group == PoseLimit::Group::joints || limit.group == PoseLimit::Group::values)
        out.push_back(named(limit.value.empty() ? limit.name : limit.value, pose, bodies, readings));
    for (const mechanics::AskedLimit& asked : w_.request.limits.asked) {
      if (const auto* angle = std::get_if<mechanics::AskedAngle>(&asked.what)) angles(*angle, pose, bodies, out);
      if (const auto* distance = std::get_if<mechanics::AskedDistance>(&asked.what))
        for (const auto& [a, b] : mechanics::pairs_of(machine_, *distance))
          out.push_back(segment_distance(centre(pose, a.low), centre(pose, a.high), centre(pose, b.low), centre(pose, b.high)));
    }
    for (const bool every : {false, true})
      for (const mechanics::AskedLimit& asked : w_.request.limits.asked)
        if (std::holds_alternative<mechanics::AskedPressure>(asked.what) && asked.every == every)
          std::ranges::copy(pressure_angles(q, pose), std::back_inserter(out));
    return out;
  }
  // The limits in the same order; those that are judged in one way only are in none.
  std::vector<const PoseLimit*> limits() const {
    std::vector<const PoseLimit*> out;
    using Group = PoseLimit::Group;
    for (const auto& groups :
         {std::array{Group::strokes, Group::joints, Group::values}, std::array{Group::angles, Group::distances, Group::pressure}})
      for (const PoseLimit& l : w_.margins.limits)
        if (std::ranges::find(groups, l.group) != groups.end()) out.push_back(&l);
    return out;
  }

 private:
  Eigen::Vector3d centre(const mechanics::Pose& pose, int joint) const { return machine_.centre(pose, joint); }

  double named(const std::string& name, const mechanics::Pose& pose, const std::vector<mechanics::BodyState>& bodies,
               const std::vector<double>& readings) const {
    const Topology& t = machine_.topology();
    for (std::size_t i = 0; i < t.actuators.size(); ++i)
      if (t.actuators[i].name == name) return pose.numbers[machine_.layout().actuator(static_cast<int>(i))];
    for (std::size_t i = 0; i < t.derived.size(); ++i)
      if (t.derived[i].name == name) return pose.numbers[machine_.layout().derived(static_cast<int>(i))];
    for (std::size_t i = 0; i < t.readings.size(); ++i)
      if (t.readings[i].name == name) return readings[i];
    for (std::size_t j = 0; j < t.joints.size(); ++j)
      for (std::size_t k = 0; k < t.joints[j].limits.size(); ++k)
        if (mechanics::motion_name(t.joints[j], k) == name) return closure_.motion(bodies, static_cast<int>(j))[k];
    return std::nan("");
  }
  void angles(const mechanics::AskedAngle& asked, const mechanics::Pose& pose, const std::vector<mechanics::BodyState>& bodies,
              std::vector<double>& out) const {
    const Eigen::Vector3d direction = bodies[static_cast<std::size_t>(asked.against.body)].rotation * asked.against.axis;
    for (const int n : asked.limbs)
      if (const auto line = mechanics::limb_line(machine_, n)) {
        const Eigen::Vector3d along = centre(pose, line->to) - centre(pose, line->from);
        out.push_back(std::atan2(along.cross(direction).norm(), along.dot(direction)));
      }
  }

  // By differences: the points that the drives push and the actuators' values a little to either side of the pose, one coordinate after the
  // other.
  std::vector<double> pressure_angles(std::span<const double> q, const mechanics::Pose& pose) const {
    constexpr double step = 1e-5;  // [m], [rad]: of differences its square remains, and rounding over it
    const auto n = static_cast<Eigen::Index>(drives_.size());
    const auto pushed = [&](const mechanics::Pose& at, const mechanics::DrivePath& d) -> Eigen::Vector3d {
      if (d.telescope) return centre(at, d.telescope->far) - centre(at, d.telescope->near);
      if (d.entry.joints.empty()) return machine_.origin(at, d.entry.body);
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (const int j : d.entry.joints) sum += centre(at, j);
      return sum / static_cast<double>(d.entry.joints.size());
    };
    const auto numbers = [&](const mechanics::Pose& at) {
      Eigen::VectorXd x(4 * n);
      for (Eigen::Index i = 0; i < n; ++i) {
        x(i) = at.numbers[machine_.layout().actuator(static_cast<int>(i))];
        x.segment<3>(n + 3 * i) = pushed(at, drives_[static_cast<std::size_t>(i)]);
      }
      return x;
    };
    Eigen::MatrixXd partials(4 * n, n);
    for (Eigen::Index c = 0; c < n; ++c) {
      std::array<Eigen::VectorXd, 2> sides;
      for (const bool above : {false, true}) {
        std::vector<double> there(q.begin(), q.end());
        there[static_cast<std::size_t>(c)] += above ? step : -step;
        const mechanics::Pose beside = machine_.pose(there);
        if (beside.status != PM_OK) return std::vector<double>(static_cast<std::size_t>(n), std::nan(""));
        sides[above ? 1 : 0] = numbers(beside);
      }
      partials.col(c) = (sides[1] - sides[0]) / (2 * step);
    }
    const Eigen::MatrixXd moved = partials.bottomRows(3 * n) * partials.topRows(n).inverse();
    const linear::Matrix6d g = machine_.jacobian(pose).matrix;
    std::vector<double> out;
    for (Eigen::Index i = 0; i < n; ++i) {
      const mechanics::DrivePath& d = drives_[static_cast<std::size_t>(i)];
      const Eigen::Vector3d force = d.telescope ? pushed(pose, d) : Eigen::Vector3d(g.row(i).head<3>()), v = moved.col(i).segment<3>(3 * i);
      out.push_back(std::atan2(force.cross(v).norm(), std::abs(force.dot(v))));
    }
    return out;
  }

  const Workspace& w_;
  const mechanics::Machine& machine_;
  mechanics::Closure closure_;
  std::vector<mechanics::DrivePath> drives_;
};

}  // namespace

DefinitionCheck check_by_definition(const Workspace& w, const mechanics::Machine& machine, int poses) {
  DefinitionCheck out;
  const Values values(w, machine);
  const std::vector<const PoseLimit*> limits = values.limits();
  for (const PoseLimit& l : w.margins.limits)
    if (judged_in_one_way(l)) out.not_looked_at.push_back(l.name);
  const std::vector<double> home = home_of(w, machine);
  const std::size_t recorded = w.set.margins.outputs().size();
  std::vector<double> margins(w.set.size());
  program::Evaluator<double> evaluator(w.set.margins);
  const std::vector<std::vector<double>> spread_evenly =
      spread(static_cast<std::size_t>(std::max(poses, 0)), std::min(w.scan.points.size(), most_variables));
  for (int k = 0; k < poses; ++k) {
    std::vector<double> q = w.scan.at;
    const bool local = w.home_inside && k % 2 == 1;
    std::size_t dimension = 0;
    for (const scan::Axis& a : w.scan.points) {
      const auto i = static_cast<std::size_t>(a.input);
      const std::vector<double>& point = spread_evenly[static_cast<std::size_t>(k)];
      const double u = point[dimension++ % point.size()];
      q[i] = local ? home[i] + around_home * (2 * u - 1) * (a.to - a.from) : a.from + u * (a.to - a.from);
    }
    if (!w.scan.orientations.empty()) {
      const auto& o = w.scan.orientations[static_cast<std::size_t>(k) * 7919 % w.scan.orientations.size()];
      for (std::size_t i = 0; i < o.size(); ++i) q[static_cast<std::size_t>(w.scan.turned[i])] = o[i];
    }
    const std::vector<double> of_machine = machine_pose(w, q);
    const mechanics::Pose pose = machine.pose(of_machine);
    bool accepted = pose.status == PM_OK, near = pose.status != PM_OK && pose.status != PM_UNREACHABLE;
    if (accepted) {
      near = pose.numbers[0] < near_an_end;
      const std::vector<double> at = values.at(of_machine, pose);
      for (std::size_t l = 0; l < limits.size(); ++l) {
        const double min = limits[l]->min, max = limits[l]->max;
        const double least = limits[l]->group == PoseLimit::Group::pressure ? near_a_pressure : near_an_end;
        near = near || std::abs(at[l] - min) < least || std::abs(at[l] - max) < least || std::isnan(at[l]);
        accepted = accepted && at[l] >= min && at[l] <= max;
      }
    }
    if (near) {
      ++out.near;
      continue;
    }
    evaluator.run(q, {margins.data(), recorded});
    bool by_margins = true;
    for (std::size_t m = 0; m < recorded; ++m) by_margins = by_margins && margins[m] >= -w.set.rounding[m];
    if (by_margins && w.set.late.size > 0) {
      w.set.late.judge(1, q.data(), margins.data() + recorded);
      for (std::size_t m = recorded; m < margins.size(); ++m)
        if (!judged_in_one_way(w.margins.limits[static_cast<std::size_t>(w.margins.margins[m].limit)]))
          by_margins = by_margins && margins[m] >= -w.set.rounding[m];
    }
    ++out.poses;
    out.accepted += accepted ? 1 : 0;
    if (by_margins == accepted) continue;
    ++out.differing;
    if (!out.first.empty()) continue;
    for (std::size_t i = 0; i < q.size(); ++i)
      out.first += fmt::format("{}{} = {:.9g}", i == 0 ? "" : ", ", machine.topology().coordinates[i].name, q[i]);
  }
  return out;
}

}  // namespace pmreport::analysis
