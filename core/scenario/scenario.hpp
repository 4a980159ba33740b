// A scenario: what a user asks of a mechanism, read from TOML and validated against the mechanism. All errors of a file are told in one
// run.
#pragma once

#include <Eigen/Core>
#include <core/mechanics/dynamics/drive.hpp>
#include <core/mechanics/model/machine.hpp>
#include <core/mechanics/model/state.hpp>
#include <core/scenario/section/kind.hpp>
#include <core/text/units.hpp>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace pmreport::scenario {

struct Diagnostic {
  std::string file;
  int line = 0, column = 0;  // 1-based; 0: the file as a whole
  std::string message;       // expected and seen, "did you mean"
  std::string source_line;   // the text of the line, for the caret
  std::string hint;          // what to do; may be empty
};
// "file:line:col: error: message", the source line, a caret, "hint: ...". Plain text, no colour.
std::string to_string(const Diagnostic& d);

class ScenarioError : public std::runtime_error {
 public:
  explicit ScenarioError(std::vector<Diagnostic> d);
  std::vector<Diagnostic> diagnostics;  // in the order of the file, at least one
};

// Independent coordinates at a time, with their rates and accelerations, each dof long, SI. False where there is no pose.
using Path = std::function<bool(double t, double* value, double* rate, double* acceleration)>;

// The motion: independent coordinates against time, with exact first and second derivatives. A scenario prescribes them, or it prescribes
// the actuators and they follow by forward displacement from home, or the forces of the actuators and they follow by forward dynamics.
struct Motion {
  std::vector<double> time;                   // [s]
  Eigen::MatrixXd value, rate, acceleration;  // one row a sample, one column an independent coordinate, SI; NaN: no pose
  Path at;                                    // the same at any time from the first sample to the last; safe in threads
  std::string description;                    // one line a prescribed quantity, for the report: "x = 20 mm * sin(2*pi*t/10 s)"
  bool by_actuators = false;
  Path actuators;                  // as prescribed, if they are: with their rates and accelerations, SI
  bool until_singularity = false;  // the motion may end at a singular surface
  bool by_forces = false;          // the samples come from forward dynamics; `at` goes through them
  // By forces: those given to the actuators at a time, with their values and rates as they are then, SI, dof long.
  std::function<void(double t, const std::vector<mechanics::Scalar>& actuators, double* forces)> forces;
  double work = 0;                // by forces: of actuators and load over the motion [J]
  double energy_drift = 0;        // by forces: energy that the integration lost or gained [J]
  double energy_drift_share = 0;  // the same, relative to the largest energy or work on the way
  double asked = 0;               // when it should have ended [s]
  // Why it ends before: "meets a singular surface at t = 3.314 s: ...". Empty: it does not. With `until_singularity` the samples end there,
  // else those beyond have no pose.
  std::string ending;
};

struct Load {                                               // wrench on the platform at its reference point, base axes, at every sample
  std::vector<Eigen::Vector3d> force, moment;               // [N], [N m]
  Eigen::Vector3d gravity{0, 0, 0};                         // [m/s^2]; none unless the scenario gives it: the bodies are weightless then
  std::function<Eigen::Matrix<double, 6, 1>(double t)> at;  // force and moment at any time of the motion
  std::string description;
};

// One number of the report: a column, or a group of columns, reduced; or a quantity that a section names.
struct Measured {
  std::string that;       // as written: "max(abs(actuator_force))", "mobility.redundant"
  std::string quantity;   // "mobility.redundant"; empty: reduced columns
  std::string reduction;  // "min", "max", "rms", "at"
  bool absolute = false;
  std::vector<std::string> columns;  // resolved column names: l1_force, ...
  double time = 0;                   // for "at": at(l1, 2.5 s)
  std::string unit;                  // SI
  bool count = false;                // a whole number
};

// Gate over a number of the report.
struct Check : Measured {
  std::optional<double> below, above;  // SI; passes when below and above hold strictly
  int line = 0;
};

struct Scenario {
  std::string title, author, description;
  std::filesystem::path file;  // as given
  std::string text;            // the file itself, for the report
  std::string mechanism;       // name
  mechanics::ParameterValues parameters;
  std::vector<std::size_t> parameters_set;  // indices of those that the scenario gives
  Motion motion;
  Load load;
  std::vector<mechanics::DriveTrain> drives;  // one an actuator; empty: the scenario has no [drive]
  mechanics::MotionLimits limits;             // from [limits]; all lists as long as the topology's
  std::vector<Section> sections;
  std::vector<Check> checks;
  bool asks_for(const SectionKind& kind) const;  // a section of that kind
  Needs needs() const;                           // of all sections together
};

// Finds a mechanism by its name. `names` are all there are, for "did you mean".
struct MechanismSource {
  std::function<const pm_mechanism*(const std::string&)> find;
  std::vector<std::string> names;
};

// A validated scenario and the machine that it describes. Throws ScenarioError (bad file, exit 2), or mechanics::MechanismError when the
// plugin breaks (exit 3); parameters that the mechanism refuses are a ScenarioError at the line of [mechanism]. A motion by actuators asks
// the machine for its poses: the scenario must not outlive it.
struct Loaded {
  Scenario scenario;
  std::unique_ptr<mechanics::Machine> machine;
};
// `kinds`: of the sections that it may ask for.
Loaded load(const std::filesystem::path& file, const MechanismSource& source, Kinds kinds);
Loaded load_text(const std::string& text, const std::filesystem::path& file, const MechanismSource& source, Kinds kinds);

// Largest number of samples; more is refused with the estimate of time and memory.
inline constexpr std::size_t max_samples = 1'000'000;

}  // namespace pmreport::scenario
