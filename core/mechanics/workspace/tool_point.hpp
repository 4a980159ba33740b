// A tool point as the point that is scanned, in place of the platform's reference point.
//
// With r in the platform's axes the tool point is at p + R r, where p is the reference point. Of a mechanism whose coordinates tell p, and
// R by the others alone, poses may so be told by the place of the tool point and the same orientation: p = t - R r.
#pragma once

#include <core/mechanics/machine/machine.hpp>
#include <core/program/guided.hpp>

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace pmreport::mechanics {

class ToolPoint {
 public:
  // `at`: r [m]. Nothing, with a sentence, where the coordinates do not tell the place of the reference point, or the mechanism records no
  // geometry.
  static std::optional<ToolPoint> of(const Machine& machine, const Eigen::Vector3d& at, std::string* why = nullptr);

  const Eigen::Vector3d& at() const { return at_; }
  // Coordinates of the mechanism, of those by the tool point; and the other way.
  std::vector<double> machine_pose(std::span<const double> by_tool) const;
  std::vector<double> by_tool(std::span<const double> machine_pose) const;
  // What a program of the mechanism's coordinates gives, of those by the tool point.
  program::Program of_tool(const program::Program& of_machine) const { return program::composed(of_machine, to_machine_); }
  // Likewise of what is judged pose by pose (PoseMargins::judge_late).
  using Judge = std::function<void(std::size_t count, const double* poses, double* out)>;
  Judge of_tool(Judge of_machine) const;
  program::Guided of_tool(const program::Guided& of_machine) const;

 private:
  Eigen::Vector3d at_ = Eigen::Vector3d::Zero();
  program::Program to_machine_, to_tool_;
};

}  // namespace pmreport::mechanics
