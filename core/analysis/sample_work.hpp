// The work on one sample of a motion: every output number, and the residuals that prove them.
#pragma once

#include <core/analysis/analysis.hpp>
#include <core/mechanics/displacement/displacement.hpp>
#include <core/mechanics/model/closed_form.hpp>
#include <core/mechanics/model/closure.hpp>
#include <core/mechanics/model/generic_model.hpp>

#include <array>
#include <functional>
#include <string>

namespace pmreport::analysis {

using Row = std::array<double, static_cast<std::size_t>(Measure::count)>;

// Each thread has its own, with the buffers it reuses.
class SampleWork {
 public:
  // `length`: characteristic length [m]; `statics`: whether forces are asked for.
  SampleWork(const scenario::Scenario& s, const mechanics::Machine& m, const mechanics::Closure& closure, double length, bool statics)
      : scenario_(s), machine_(m), closure_(closure), forward_(m), length_(length), statics_(statics) {}

  using Put = std::function<void(const std::string& column, double value)>;

  // Fills `row` and hands every output number to `put`. `previous`: a neighbour of the sample, towards which forward displacement starts.
  Outcome run(int sample, int previous, Row& row, const Put& put);
  const std::string& why() const { return state_.why; }  // when the sample has no pose

 private:
  void kinematics(const Put& put, const mechanics::ClosedForm& c);
  void residuals(Row& row, const mechanics::ClosedForm& c, const mechanics::GenericModel& model);
  double round_trip(int sample, int previous, double condition);
  void statics(int sample, Row& row, const Put& put, const mechanics::ClosedForm& c, const mechanics::GenericModel& model);
  const mechanics::BodyState& platform() const { return state_.bodies[static_cast<std::size_t>(machine_.topology().platform)]; }

  const scenario::Scenario& scenario_;
  const mechanics::Machine& machine_;
  const mechanics::Closure& closure_;
  mechanics::ForwardSolver forward_;
  double length_;
  bool statics_;
  mechanics::State state_;
};

}  // namespace pmreport::analysis
