// One run of a scenario through the mechanics: every sample's output columns, what broke a limit or could not be reached, and the residuals
// that prove the numbers. Sections draw on it; they compute no mechanics of their own.
#pragma once

#include <core/analysis/columns.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/reactions/reactions.hpp>
#include <core/scenario/scenario.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace pmreport::analysis {

using mechanics::Indeterminate;

// The residuals kept of each sample. Relative ones are dimensionless.
enum class Measure : std::size_t {
  gap,                      // joint centres as both bodies carry them [m]
  misalignment,             // joint axes as both bodies carry them [rad]
  round_trip,               // coordinates recovered from the actuators
  velocity,                 // twists by jets in the generic constraints
  jacobian,                 // G twist against actuator rates by jets
  forward_velocity,         // twist recovered from the actuator rates
  source,                   // relations that the source states by its matrices
  difference_rate,          // jets against differences in extended precision
  acceleration,             // twist rates by jets in the differentiated constraints
  jacobian_rate,            // G twist rate + G' twist against actuator accelerations by jets
  forward_acceleration,     // twist rate recovered from the actuator accelerations
  difference_acceleration,  // jets against second differences in extended precision
  statics,                  // actuator forces by G against the system over all bodies
  equilibrium,              // unbalanced force or moment of any body in that system
  power,                    // virtual power of actuators, load and weights
  newton_euler,             // actuator forces by virtual work against the free bodies
  free_body,                // unbalanced force or moment of any body, reactions and inertia included
  power_balance,            // power of actuators and load against the rate of kinetic and potential energy
  judge,                    // reactions limb by limb against the system over all bodies
  count
};

enum class Condition : std::uint8_t { good, singular, unreachable, failed };

struct Worst {
  double value = 0;  // largest over the samples
  int sample = -1;   // where; -1: nowhere computed
  int compared = 0;  // number of samples that it was computed of
};

struct LimitBreach {    // one limited quantity that leaves its range
  std::string subject;  // "l3 (length of limb 3)", "A2 (deflection of the ball joint)"
  std::string unit;     // SI
  std::vector<int> samples;
  int worst = 0;  // sample with the largest excess
  double value = 0, limit = 0;
  bool above = false;  // above the upper end, else below the lower
  bool stroke = false;
};

struct Interval {
  int first, last;  // samples, inclusive
};

// The motion meets a singular surface: det G changes its sign, or touches zero, at `time`.
struct Crossing {
  int before;                   // sample at or before it
  double time;                  // [s], to the last digits of a double
  Eigen::VectorXd coordinates;  // there
  bool touches = false;         // it comes back on the same side
  bool pole = false;            // det G passes through infinity, not zero: a limb is singular
};

// What the program does while it works: tell, and ask whether to stop (then throw).
struct Progress {
  std::function<void(const std::string&)> say = [](const std::string&) {};
  std::function<void()> stop_if_asked = [] {};
};

class Analysis {
 public:
  // Throws mechanics::MechanismError when the plugin breaks down on the way.
  Analysis(const scenario::Scenario& scenario, const mechanics::Machine& machine, const Progress& progress);

  const scenario::Scenario& scenario() const { return scenario_; }
  const mechanics::Machine& machine() const { return machine_; }
  const std::vector<double>& time() const { return scenario_.motion.time; }
  int samples() const { return static_cast<int>(time().size()); }

  // Those columns of a list that this run has, in its order: forces in motion when something asks for them, motor columns where a motor is
  // given.
  std::vector<Column> columns_of(ColumnList* list) const;
  bool has(const std::string& column) const { return columns_.contains(column); }
  // NaN where a sample has no value.
  const std::vector<double>& column(const std::string& name) const { return columns_.at(name); }
  double largest(const std::vector<std::string>& columns) const;  // magnitude over the samples

  Condition condition(int sample) const { return conditions_[static_cast<std::size_t>(sample)]; }
  int count(Condition c) const;
  const std::string& why(int sample) const;  // of a sample that is not good
  Worst worst(Measure m) const;

  bool has_dynamics() const { return dynamics_; }                                     // a section or a limit asks for forces in motion
  const std::vector<Indeterminate>& indeterminate() const { return indeterminate_; }  // of each joint, in any sample
  int self_stresses() const { return self_stresses_; }                                // most in any sample

  const std::vector<LimitBreach>& breaches() const { return breaches_; }
  const std::vector<Crossing>& crossings() const { return crossings_; }
  std::vector<Interval> broken() const;       // runs of samples that break some limit
  std::vector<Interval> unreachable() const;  // runs of samples without a pose

  mechanics::Pose pose(int sample) const;
  int sample_at(double time) const;  // nearest

  const mechanics::Mobility& mobility() const { return mobility_; }
  double length() const { return length_; }  // characteristic length [m]

  // Beyond this condition number of G an answer has lost too many digits to be compared with another; beyond `singular` it is none.
  static constexpr double comparable = 1e7, singular = 1e11;

 private:
  void run(const Progress& progress);
  void find_breaches();
  void find_crossings();  // in crossings.cpp
  // In analysis_dynamics.cpp.
  bool asks_for_dynamics() const;
  void run_dynamics(const Progress&);
  void balance_power();

  const scenario::Scenario& scenario_;
  const mechanics::Machine& machine_;
  double length_;
  mechanics::Mobility mobility_;
  std::map<std::string, std::vector<double>> columns_;
  std::vector<Condition> conditions_;
  std::map<int, std::string> why_;
  std::vector<std::array<double, static_cast<std::size_t>(Measure::count)>> measures_;  // NaN: not computed
  std::vector<LimitBreach> breaches_;
  std::vector<Crossing> crossings_;
  bool dynamics_ = false;
  std::vector<Indeterminate> indeterminate_;
  int self_stresses_ = 0;
};

}  // namespace pmreport::analysis
