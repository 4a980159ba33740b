// Everything of a mechanism that a motion is judged by, as one program of the coordinates: the plugin's recorded geometry, and on it the
// host's own, the motions of the joints from home.
#pragma once

#include <core/mechanics/machine/machine.hpp>
#include <core/program/program.hpp>

#include <optional>
#include <string>
#include <vector>

namespace pmreport::mechanics {

struct MotionProgram {
  // Inputs: the coordinates. Outputs: the numbers of a placement, as of Machine::layout(), its reach first; then the 36 of G; then the
  // motions of joints.
  program::Program program;
  std::size_t wrenches = 0;  // output of the first number of G
  struct JointMotion {       // one a limit that bounds anything (binds)
    int joint, limit;
    std::size_t output;
  };
  std::vector<JointMotion> joints;
  std::vector<std::string> left_out;  // joints with such a limit whose motion the geometry leaves open: a slender body has no spin to tell
};

// Nothing where the mechanism has no program; `why` then gets a sentence.
std::optional<MotionProgram> motion_program(const Machine& machine, std::string* why = nullptr);

}  // namespace pmreport::mechanics
