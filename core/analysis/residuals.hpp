// The residuals that prove the numbers of a run, one row a sample.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace pmreport::analysis {

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
  elastic_work,             // work of all loads on all bodies against the energy of all springs
  elastic_judge,            // compliance by the force method against the system over all bodies, joints and springs
  elastic_drives,           // compliance of the drives alone against the overall Jacobian
  count
};

// Of one sample; NaN: not computed. `error`: how far the two sides that were compared are known themselves, where that may be less than the
// claim asks for.
struct Row {
  std::array<double, static_cast<std::size_t>(Measure::count)> value, error;

  double& operator[](std::size_t measure) { return value[measure]; }
  double operator[](std::size_t measure) const { return value[measure]; }
};

// A residual that is not a number must not pass for a small one.
void set(Row& row, Measure m, double value, double error = 0);
// Deviation over scale; nothing over nothing agrees.
inline double relative(double deviation, double scale) { return scale > 0 ? deviation / scale : deviation; }

struct Worst {
  double value = 0;      // largest over the samples; of one whose sides are known to less than the tolerance, that share of the tolerance
                         // that the residual is of what is known
  int sample = -1;       // where; -1: nowhere computed
  int compared = 0;      // number of samples that it was computed of
  int poorly_known = 0;  // of these: samples whose sides are known to less than the tolerance
  double poorest = 0;    // the largest such error
  int undecided = 0;     // samples where too little is known to compare anything
};

class Residuals {
 public:
  explicit Residuals(std::size_t samples = 0);
  Row& operator[](std::size_t sample) { return rows_[sample]; }
  // `tolerance`: what the claim asks for; where it is left out, residuals are as they are.
  Worst worst(Measure m, double tolerance = std::numeric_limits<double>::infinity()) const;

 private:
  std::vector<Row> rows_;
};

}  // namespace pmreport::analysis
