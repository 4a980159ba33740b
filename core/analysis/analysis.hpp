// One run of a scenario through the mechanics: every sample's output columns, what broke a limit or could not be reached, and the residuals
// that prove the numbers. Sections draw on it; they compute no mechanics of their own.
#pragma once

#include <core/analysis/asked.hpp>
#include <core/analysis/breaches.hpp>
#include <core/analysis/column_store.hpp>
#include <core/analysis/columns.hpp>
#include <core/analysis/conditioning.hpp>
#include <core/analysis/crossings.hpp>
#include <core/analysis/margins.hpp>
#include <core/analysis/progress.hpp>
#include <core/analysis/proof/proof.hpp>
#include <core/analysis/samples/motion_answers.hpp>
#include <core/mechanics/mobility/mobility_count.hpp>
#include <core/mechanics/transmission/transmission.hpp>
#include <core/scenario/scenario.hpp>

#include <memory>
#include <string>
#include <vector>

namespace pmreport::analysis {

using mechanics::Indeterminate;
using mechanics::Outcome;

class Analysis {
 public:
  // All three must live as long. A trajectory of no samples: there is no motion, and the machine is known at home alone. Throws
  // mechanics::MechanismError when the plugin breaks down on the way, and what chunks::run throws: Elsewhere where the samples of the
  // motion are left to others.
  Analysis(const scenario::Scenario& scenario, const mechanics::Trajectory& trajectory, const mechanics::Machine& machine,
           const Asked& asked, const Progress& progress);

  const scenario::Scenario& scenario() const { return scenario_; }
  const mechanics::Trajectory& trajectory() const { return trajectory_; }
  const mechanics::Machine& machine() const { return machine_; }
  const std::vector<double>& time() const { return trajectory_.time; }
  int samples() const { return trajectory_.samples(); }

  // Those columns of a list that this run has, in its order: forces in motion when something asks for them, motor columns where a motor is
  // given.
  std::vector<Column> columns_of(ColumnList* list) const;
  bool has(const ColumnId& id) const { return answers_.columns.has(id); }
  // NaN where a sample has no value.
  const std::vector<double>& column(const ColumnId& id) const { return answers_.columns[id]; }
  // To who has the last use of it: of a long motion there is no room for two.
  std::vector<double> release(const ColumnId& id) { return answers_.columns.release(id); }
  double largest(const std::vector<ColumnId>& columns) const { return answers_.columns.largest(columns); }  // magnitude over the samples

  Outcome outcome(int sample) const { return answers_.outcomes[static_cast<std::size_t>(sample)]; }
  int count(Outcome c) const;
  const std::string& why(int sample) const { return answers_.reason(sample); }  // of a sample that is not good
  Worst worst(Measure m, double tolerance = std::numeric_limits<double>::infinity()) const {
    return answers_.residuals.worst(m, tolerance);
  }

  // What the section transmission asks of; null where nobody does.
  const mechanics::Transmission* transmission() const { return transmission_.get(); }

  bool has_dynamics() const { return asked_.forces; }  // a section or a limit asks for forces in motion
  const std::vector<Indeterminate>& indeterminate() const { return answers_.reactions.indeterminate; }  // of each joint, in any sample
  int self_stresses() const { return answers_.reactions.self_stresses; }                                // most in any sample
  const ElasticReactions& elastic_reactions() const { return answers_.reactions.elastic; }              // of joint reactions

  // At every sample, at the tool, in the axes of section `stiffness`; NaN where there is none. Empty: nobody asked.
  const std::vector<mechanics::Matrix6d>& compliances() const { return answers_.compliances; }

  const HoldingWrenches& wrenches(int sample) const { return answers_.wrenches[static_cast<std::size_t>(sample)]; }
  bool singular_everywhere() const { return singular_everywhere_; }  // the architecture: the actuators hold the platform at no pose
  const std::vector<LimitBreach>& breaches() const { return breaches_; }
  const std::vector<Crossing>& crossings() const { return crossings_; }
  const Margins& margins() const { return margins_; }
  const MotionProof& proof() const { return proof_; }  // what holds at every instant; of a single instant, and without a motion, nothing
  std::vector<SampleRun> broken() const { return broken_runs(breaches_, samples()); }
  std::vector<SampleRun> unreachable() const;  // runs of samples without a pose

  mechanics::Pose pose(int sample) const;
  int sample_at(double time) const;  // nearest; there must be a motion

  const mechanics::Mobility& mobility() const { return mobility_; }
  double length() const { return length_; }  // characteristic length [m]

 private:
  void run(const Progress& progress);
  void find_singularities(const Progress& progress);

  const scenario::Scenario& scenario_;
  const mechanics::Trajectory& trajectory_;
  const mechanics::Machine& machine_;
  Asked asked_;
  double length_;
  std::unique_ptr<const mechanics::Transmission> transmission_;
  mechanics::Mobility mobility_;
  MotionAnswers answers_;
  bool singular_everywhere_ = false;
  std::vector<LimitBreach> breaches_;
  std::vector<Crossing> crossings_;
  Margins margins_;
  MotionProof proof_;
};

}  // namespace pmreport::analysis
