// The reckoning itself, for as many poses at once as the processor has lanes for.
#pragma once

#include <core/mechanics/reactions/by_limb/plan.hpp>
#include <core/mechanics/reactions/reactions.hpp>

#include <vector>

namespace pmreport::mechanics {

// A run of poses. Number i of pose k: of inputs at [i * stride + k], of outputs at [i * count + k].
struct DynamicsBatch {
  const double* placement = nullptr;  // of order PM_JET
  const double* loads = nullptr;
  const double* wrenches = nullptr;  // null: none beside the loads
  double gravity[3] = {0, 0, 0};
  std::size_t stride = 1;              // a multiple of the kernel's width: whoever calls fills it up
  std::size_t count = 1, written = 1;  // results are written of the first so many poses
  double* actuator_forces = nullptr;
  double* regularity = nullptr;
  double* joints = nullptr;  // null: actuator forces alone, and none of the following
  Indeterminate* indeterminate = nullptr;
  double* stresses = nullptr;
};

class DynamicsKernel {
 public:
  static DynamicsKernel single();  // one pose at a time
  static DynamicsKernel widest();  // that this processor runs
  static std::vector<DynamicsKernel> all();

  std::size_t width() const { return width_; }
  std::size_t memory(const DynamicsPlan& plan) const;  // numbers that `solve` works in, aligned to 64 bytes
  void solve(const DynamicsPlan& plan, const DynamicsBatch& batch, double* memory) const { solve_(plan, batch, memory); }

 private:
  using Solve = void (*)(const DynamicsPlan&, const DynamicsBatch&, double*);
  DynamicsKernel(std::size_t width, Solve solve) : width_(width), solve_(solve) {}
  std::size_t width_;
  Solve solve_;
};

// Largest coefficient in each equation of each group at one pose, group after group: zero where a freedom moves nothing that is held.
// `placement`: one pose, order PM_JET.
std::vector<double> equation_sizes(const DynamicsPlan& plan, const double* placement);

}  // namespace pmreport::mechanics
