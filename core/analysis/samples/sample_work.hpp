// The work on one sample of a motion: every output number, and the residuals that prove them.
#pragma once

#include <core/analysis/asked.hpp>
#include <core/analysis/columns.hpp>
#include <core/analysis/conditioning.hpp>
#include <core/analysis/residuals.hpp>
#include <core/mechanics/displacement/displacement.hpp>
#include <core/mechanics/model/closed_form.hpp>
#include <core/mechanics/model/closure.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/model/outcome.hpp>
#include <core/mechanics/trajectory/trajectory.hpp>
#include <core/mechanics/transmission/transmission.hpp>
#include <core/scenario/load.hpp>

#include <functional>
#include <string>
#include <vector>

namespace pmreport::analysis {

// Each thread has its own, with the buffers it reuses.
class SampleWork {
 public:
  // `length`: characteristic length [m]; `transmission`: null where nobody asks for it.
  SampleWork(const mechanics::Trajectory& trajectory, const scenario::Load& load, const mechanics::Machine& m,
             const mechanics::Closure& closure, double length, const Asked& asked, const mechanics::Transmission* transmission = nullptr)
      : trajectory_(trajectory),
        load_(load),
        machine_(m),
        closure_(closure),
        forward_(m),
        length_(length),
        asked_(asked),
        transmission_(transmission) {
    if (transmission == nullptr) return;
    for (const Column& c : transmission_columns(m.topology())) transmission_columns_.emplace_back(c);
    transmission_numbers_.resize(transmission_columns_.size());
  }

  using Put = std::function<void(const ColumnId& column, double value)>;

  // Fills `row` and hands every output number to `put`. `previous`: a neighbour of the sample, towards which forward displacement starts.
  mechanics::Outcome run(int sample, int previous, Row& row, const Put& put);
  const std::string& why() const { return state_.why; }  // when the sample is not good
  const HoldingWrenches& wrenches() const { return wrenches_; }

 private:
  void kinematics(const Put& put, const mechanics::ClosedForm& c);
  void transmission(const Put& put);
  void prove_rates(Row& row, const mechanics::ClosedForm& c, const mechanics::GenericModel& model);
  void round_trip(int sample, int previous, double condition, Row& row);
  void statics(int sample, Row& row, const Put& put, const mechanics::ClosedForm& c, const mechanics::GenericModel& model);
  const mechanics::BodyState& platform() const { return state_.bodies[static_cast<std::size_t>(machine_.topology().platform)]; }

  const mechanics::Trajectory& trajectory_;
  const scenario::Load& load_;
  const mechanics::Machine& machine_;
  const mechanics::Closure& closure_;
  mechanics::ForwardSolver forward_;
  double length_;
  Asked asked_;
  const mechanics::Transmission* transmission_;
  mechanics::Transmission::Work transmission_work_;
  std::vector<ColumnId> transmission_columns_;
  std::vector<double> transmission_numbers_;
  mechanics::State state_;
  HoldingWrenches wrenches_;
};

}  // namespace pmreport::analysis
