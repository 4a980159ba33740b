// The residuals that prove the numbers of a run: of every sample on the way, of all of them what the evidence asks.
#pragma once

#include <core/chunks/bytes.hpp>

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace pmreport::analysis {

// The residuals of each sample. Relative ones are dimensionless.
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
  Row();
  std::array<double, static_cast<std::size_t>(Measure::count)> value, error;
};

// A residual that is not a number must not pass for a small one.
void set(Row& row, Measure m, double value, double error = 0);
// Deviation over scale; nothing over nothing agrees.
inline double relative(double deviation, double scale) { return scale > 0 ? deviation / scale : deviation; }

struct Worst {
  double value = 0;      // largest over the samples; of one whose sides are known to less than the tolerance, that share of the tolerance
                         // that the residual is of what is known
  int sample = -1;       // where, the first; -1: nowhere computed
  int compared = 0;      // number of samples that it was computed of
  int poorly_known = 0;  // of these: samples whose sides are known to less than the tolerance
  double poorest = 0;    // the largest such error
  int undecided = 0;     // samples where too little is known to compare anything
};

class Residuals {
 public:
  // Samples in any order, each measure of a sample once.
  void add(int sample, const Row& row);
  void join(const Residuals& other);
  // `tolerance`: what the claim asks for; where it is left out, residuals are as they are.
  Worst worst(Measure m, double tolerance = std::numeric_limits<double>::infinity()) const;

  void put(chunks::Writer& to) const;
  void get(chunks::Reader& from);

 private:
  // Of one measure. Where both sides are known as they are, the worst sample speaks for all, whatever is asked for; the others have to be
  // kept one by one.
  struct All {
    Worst exact;
    struct Rounded {
      int sample;
      double value, error;
    };
    std::vector<Rounded> rounded;
  };
  std::array<All, static_cast<std::size_t>(Measure::count)> all_;
};

}  // namespace pmreport::analysis
