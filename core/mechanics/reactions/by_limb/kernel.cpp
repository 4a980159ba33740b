#include <core/mechanics/reactions/by_limb/kernel.hpp>

#include <core/mechanics/reactions/by_limb/solver.hpp>
#include <core/vectors.hpp>

namespace pmreport::mechanics {

namespace {

template <class T>
PMREPORT_INLINE void solve_all(const DynamicsPlan& plan, const DynamicsBatch& batch, double* memory) {
  const Desk<T> desk(plan, memory);
  for (std::size_t k = 0; k < batch.written; k += T::width) LimbSolver<T>(plan, batch, desk, k).solve();
}

[[gnu::flatten]] void solve_single(const DynamicsPlan& plan, const DynamicsBatch& batch, double* memory) {
  solve_all<Pack<1>>(plan, batch, memory);
}

[[gnu::flatten]] void solve_plain(const DynamicsPlan& plan, const DynamicsBatch& batch, double* memory) {
  solve_all<Pack<2>>(plan, batch, memory);
}

#if defined(__x86_64__)
[[gnu::flatten, gnu::target("arch=x86-64-v3")]] void solve_v3(const DynamicsPlan& plan, const DynamicsBatch& batch, double* memory) {
  solve_all<Pack<4>>(plan, batch, memory);
}
[[gnu::flatten, gnu::target("arch=x86-64-v4")]] void solve_v4(const DynamicsPlan& plan, const DynamicsBatch& batch, double* memory) {
  solve_all<Pack<8>>(plan, batch, memory);
}
#endif

}  // namespace

DynamicsKernel DynamicsKernel::single() { return {1, solve_single}; }

std::vector<DynamicsKernel> DynamicsKernel::all() {
  std::vector<DynamicsKernel> out{single(), {2, solve_plain}};
#if defined(__x86_64__)
  if (vector_level() >= 3) out.push_back({4, solve_v3});
  if (vector_level() >= 4) out.push_back({8, solve_v4});
#endif
  return out;
}

DynamicsKernel DynamicsKernel::widest() { return all().back(); }

std::size_t DynamicsKernel::memory(const DynamicsPlan& plan) const { return Desk<Pack<1>>(plan, nullptr).numbers * width_; }

std::vector<double> equation_sizes(const DynamicsPlan& plan, const double* placement) {
  std::vector<double> memory(Desk<Pack<1>>(plan, nullptr).numbers), out;
  int equations = 0;
  for (const DynamicsPlan::Group& g : plan.groups) equations += g.equations;
  out.resize(static_cast<std::size_t>(equations));
  DynamicsBatch batch;
  batch.placement = placement;
  const Desk<Pack<1>> desk(plan, memory.data());
  LimbSolver<Pack<1>>(plan, batch, desk, 0).equations(out.data());
  return out;
}

}  // namespace pmreport::mechanics
