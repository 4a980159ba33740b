// The samples of a motion in blocks, each of which stands alone: what it comes to depends on no other block, nor on who computes it.
#pragma once

#include <core/analysis/asked.hpp>
#include <core/analysis/samples/motion_answers.hpp>
#include <core/analysis/samples/sample_forces.hpp>
#include <core/analysis/samples/sample_stiffness.hpp>
#include <core/analysis/samples/sample_work.hpp>
#include <core/scenario/scenario.hpp>

#include <tbb/enumerable_thread_specific.h>

#include <functional>
#include <vector>

namespace pmreport::analysis {

class MotionBlocks {
 public:
  static constexpr std::size_t size = 4096;  // samples of each; of the last, what is left

  // All must live as long. `length`: characteristic length [m]; `transmission`: null where nobody asks for it.
  MotionBlocks(const scenario::Scenario& scenario, const mechanics::Trajectory& trajectory, const mechanics::Machine& machine,
               const Asked& asked, double length, const mechanics::Transmission* transmission);

  std::size_t count() const { return (samples_ + size - 1) / size; }
  std::size_t first(std::size_t block) const { return block * size; }  // sample
  std::size_t samples(std::size_t block) const { return std::min(size, samples_ - first(block)); }

  const MotionAnswers::Shape& shape() const { return shape_; }
  // Called by several threads at once; uses all threads itself, any of which asks whether to stop. A sample that failed is told as such,
  // and the forces of its block are left out.
  MotionAnswers compute(std::size_t block, const std::function<void()>& stop_if_asked);
  // A hash of all that decides the answers.
  std::uint64_t meaning() const;

 private:
  struct Part;  // one block at work
  void kinematics(Part& part);
  void forces(Part& part);
  void stiffness(Part& part);

  const scenario::Scenario& scenario_;
  const mechanics::Trajectory& trajectory_;
  const mechanics::Machine& machine_;
  Asked asked_;
  double length_;
  const mechanics::Transmission* transmission_;
  const StiffnessRequest* elasticity_;  // null: nobody asks, or nothing gives way
  std::size_t samples_;
  MotionAnswers::Shape shape_;
  mechanics::Closure closure_;
  mechanics::JointFrames frames_;
  tbb::enumerable_thread_specific<SampleWork> sample_work_;
  tbb::enumerable_thread_specific<SampleForces> sample_forces_;
  tbb::enumerable_thread_specific<SampleStiffness> sample_stiffness_;
};

}  // namespace pmreport::analysis
