#include <core/mechanics/reactions/inverse_dynamics.hpp>

#include <core/assertion.hpp>
#include <core/mechanics/reactions/by_limb/kernel.hpp>
#include <core/mechanics/reactions/by_limb/planner.hpp>
#include <core/mechanics/reactions/dense_dynamics.hpp>
#include <core/numbers.hpp>

#include <algorithm>
#include <new>
#include <span>

namespace pmreport::mechanics {

class InverseDynamics::Work {
  static constexpr std::size_t alignment = 64;
  struct Free {
    void operator()(double* p) const { ::operator delete[](p, std::align_val_t(alignment)); }
  };
  using Memory = std::unique_ptr<double[], Free>;
  static Memory memory_of(std::size_t numbers) {
    return Memory(static_cast<double*>(::operator new[](numbers * sizeof(double), std::align_val_t(alignment))));
  }

 public:
  explicit Work(const Machine& machine)
      : machine_(machine),
        plan_(plan_of(machine)),
        single_(DynamicsKernel::single()),
        wide_(DynamicsKernel::widest()),
        dof_(static_cast<std::size_t>(machine.dof())),
        joints_(machine.topology().joints.size()),
        bodies_(machine.topology().bodies.size() - 1) {
    if (!plan_) {
      dense_.emplace(machine);
      return;
    }
    memory_ = memory_of(std::max(single_.memory(*plan_), wide_.memory(*plan_)));
    placement_ = memory_of(3 * plan_->size * chunk());
    jets_.resize(3 * dof_ * chunk());
    loads_.resize(6 * chunk());
  }

  bool limb_by_limb() const { return plan_.has_value(); }

  void solve(std::size_t count, const double* jets, const double* loads, const Eigen::Vector3d& gravity, MotionReactions& out,
             bool reactions, const double* wrenches) {
    if (dense_) return dense_->solve(count, jets, loads, gravity, out, reactions, wrenches);
    fit(out, count, reactions);
    if (count == 1) return run(single_, jets, loads, wrenches, 1, batch_of(out, 1, 0, 1, gravity));
    fit(block_, block(), reactions);
    for (std::size_t first = 0; first < count; first += block()) {
      const std::size_t poses = std::min(block(), count - first);
      for (std::size_t done = 0; done < poses; done += chunk()) {
        const std::size_t now = std::min(chunk(), poses - done), stride = (now + wide_.width() - 1) / wide_.width() * wide_.width();
        fill(jets, 3 * dof_, first + done, count, now, stride, jets_.data());
        fill(loads, 6, first + done, count, now, stride, loads_.data());
        if (wrenches != nullptr) {
          wrenches_.resize(6 * bodies_ * chunk());
          fill(wrenches, 6 * bodies_, first + done, count, now, stride, wrenches_.data());
        }
        run(wide_, jets_.data(), loads_.data(), wrenches != nullptr ? wrenches_.data() : nullptr, stride,
            batch_of(block_, block(), done, now, gravity));
      }
      each_list(block_, out, [&](const auto& from, auto& to) {
        for (std::size_t i = 0; i < to.size() / count; ++i) std::copy_n(from.data() + i * block(), poses, to.data() + i * count + first);
      });
    }
  }

 private:
  // Placements of a chunk stay in the nearest caches. Results are gathered over a block of chunks, then laid out: to write each number's
  // few poses at once, far from the next number's, would fetch every line of the memory several times. An odd number of lines parts the
  // numbers of a block, for them to fall on different lines of the cache.
  std::size_t chunk() const { return 3 * wide_.width(); }
  std::size_t block() const { return 3 * chunk(); }

  template <class F>
  static void each_list(const MotionReactions& a, MotionReactions& b, F&& f) {
    f(a.actuator_forces, b.actuator_forces);
    f(a.regularity, b.regularity);
    f(a.joints, b.joints);
    f(a.indeterminate, b.indeterminate);
    f(a.stresses, b.stresses);
  }
  void fit(MotionReactions& out, std::size_t count, bool reactions) const {
    out.stress_count = reactions ? plan_->stresses() : 0;
    out.actuator_forces.resize(dof_ * count);
    out.regularity.resize(count);
    out.joints.resize(reactions ? 6 * joints_ * count : 0);
    out.indeterminate.resize(reactions ? joints_ * count : 0);
    out.stresses.resize(static_cast<std::size_t>(out.stress_count) * out.joints.size());
  }
  // Writes poses first ... of `out`, which holds `count`.
  static DynamicsBatch batch_of(MotionReactions& out, std::size_t count, std::size_t first, std::size_t written,
                                const Eigen::Vector3d& gravity) {
    DynamicsBatch batch;
    Eigen::Vector3d::Map(batch.gravity) = gravity;
    batch.count = count;
    batch.written = written;
    batch.actuator_forces = out.actuator_forces.data() + first;
    batch.regularity = out.regularity.data() + first;
    if (out.joints.empty()) return batch;
    batch.joints = out.joints.data() + first;
    batch.indeterminate = out.indeterminate.data() + first;
    if (out.stress_count > 0) batch.stresses = out.stresses.data() + first;
    return batch;
  }

  // Poses first ... of a whole motion, the last one repeated until the lanes are full.
  static void fill(const double* from, std::size_t numbers, std::size_t first, std::size_t count, std::size_t poses, std::size_t stride,
                   double* to) {
    for (std::size_t i = 0; i < numbers; ++i)
      for (std::size_t k = 0; k < stride; ++k) to[i * stride + k] = from[i * count + first + std::min(k, poses - 1)];
  }

  void run(const DynamicsKernel& kernel, const double* jets, const double* loads, const double* wrenches, std::size_t stride,
           DynamicsBatch batch) {
    // Many loads at one pose ask for the same placements again.
    const std::span<const double> asked(jets, 3 * dof_ * stride);
    if (!std::ranges::equal(asked, placed_)) {
      placed_.clear();
      if (machine_.place(PM_JET, stride, jets, placement_.get()) != PM_OK) return no_numbers(batch);
      placed_.assign(asked.begin(), asked.end());
    }
    batch.placement = placement_.get();
    batch.loads = loads;
    batch.wrenches = wrenches;
    batch.stride = stride;
    kernel.solve(*plan_, batch, memory_.get());
  }

  void no_numbers(const DynamicsBatch& batch) const {
    const auto set = [&]<class T>(T* to, std::size_t numbers, T with) {
      for (std::size_t i = 0; i < numbers; ++i) std::fill_n(to + i * batch.count, batch.written, with);
    };
    set(batch.actuator_forces, dof_, nan);
    set(batch.regularity, 1, nan);
    if (batch.joints == nullptr) return;
    set(batch.joints, 6 * joints_, nan);
    set(batch.indeterminate, joints_, Indeterminate{0});
    set(batch.stresses, static_cast<std::size_t>(plan_->stresses()) * 6 * joints_, nan);
  }

  const Machine& machine_;
  std::optional<DynamicsPlan> plan_;
  std::optional<DenseDynamics> dense_;  // in the plan's place
  DynamicsKernel single_, wide_;
  std::size_t dof_, joints_, bodies_;  // those that move
  Memory memory_, placement_;
  std::vector<double> jets_, loads_, wrenches_;
  std::vector<double> placed_;  // the jets whose placements are there
  MotionReactions block_;
};

InverseDynamics::InverseDynamics(const Machine& machine) : work_(std::make_unique<Work>(machine)) {}
InverseDynamics::~InverseDynamics() = default;
InverseDynamics::InverseDynamics(InverseDynamics&&) noexcept = default;

void InverseDynamics::solve(std::size_t count, const double* jets, const double* loads, const Eigen::Vector3d& gravity,
                            MotionReactions& out, bool reactions, const double* wrenches) {
  PMREPORT_ASSERT(work_ != nullptr && jets != nullptr && loads != nullptr, "there is a motion and a load");
  work_->solve(count, jets, loads, gravity, out, reactions, wrenches);
}

bool InverseDynamics::limb_by_limb() const { return work_->limb_by_limb(); }

}  // namespace pmreport::mechanics
