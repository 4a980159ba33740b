// What [motion] says with from = "forces": where the motion begins, what the actuators exert, and what may end it.
#pragma once

#include <Eigen/Core>
#include <core/scenario/mechanism_part.hpp>
#include <core/scenario/motion/request.hpp>
#include <optional>
#include <string>
#include <vector>

namespace pmreport::scenario {

struct Forces {
  Place place;  // of the motion's beginning
  Eigen::VectorXd start, start_rate;
  struct Force {  // of an actuator
    Place place;
    Expression expression;
    double home = 0;             // value of the actuator there [m], [rad]
    std::vector<int> variables;  // of the expression, beside its own three: 2 i the value of actuator i, 2 i + 1 its rate
  };
  std::vector<std::optional<Force>> forces;  // one an actuator; nothing: it exerts none
  bool until_singularity = false, until_limit = false;
  std::string description;
};
// Nothing, told, when something is wrong.
std::optional<Forces> read_forces(const Value& motion, Place place, const MechanismPart& mechanism, const Movables& movables,
                                  const Reader& reader);
// All forces as one function of time, values and rates of the actuators.
ActuatorForces all_of(const Forces& forces);
// Forces without a finite value where the motion begins, at time `t`, are told where they stand; false then.
bool finite_at_start(const Forces& forces, const mechanics::Machine& machine, double t, Diagnostics& diagnostics);

}  // namespace pmreport::scenario
