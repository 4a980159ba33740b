// Limits on what no program gives at a pose, or none that is fast: readings of the source, pressure angles, condition numbers,
// transmission indices.
//
// With J the columns of G^-1 that belong to actuators, t = J r', a wrench W on the platform meets the drives with J^T W, which yield by it
// over their stiffness k, and the platform with them: the compliance is J J^T / k, and the largest displacement by a force is the largest
// singular value of its first three rows and the columns of that force.
#pragma once

#include <core/mechanics/machine/machine.hpp>
#include <core/program/guided.hpp>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pmreport::mechanics {

class LateLimits {
 public:
  explicit LateLimits(const Machine& machine);
  ~LateLimits();
  // Ends that are infinite make no margin; a lower end comes first.
  void add_reading(int reading, double min, double max);
  void add_pressure(double min, double max);
  void add_condition(double min, double max);
  void add_transmission(double min, double max);
  void add_compliance(double drive_stiffness, bool horizontal, double min, double max);
  // Of `count` poses, input i of pose k at [i * count + k]: margin m to [m * count + k], in the order in which they were added. NaN where a
  // number does not exist. May be called by several threads; the machine must live as long.
  std::function<void(std::size_t count, const double* poses, double* out)> judge() const;
  // The same margins, of any scale, for boxes of poses; nothing where there are none, or where a reading, a condition number or a
  // compliance is among them, which only poses have. Throws program::ProgramError.
  std::optional<program::Guided> over_boxes() const;

 private:
  struct Work;
  std::shared_ptr<Work> work_;
};

}  // namespace pmreport::mechanics
