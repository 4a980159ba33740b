// Section `assembly`: every pose that the actuator values of one moment allow.
#pragma once

#include <reports/section/common/stage.hpp>
#include <reports/section/kind.hpp>

namespace pmreport::section {

// Actuator values at a time of the motion, unless they are given.
struct AssemblyOptions : scenario::Options {
  double time = 0;            // [s]
  Eigen::VectorXd actuators;  // SI; empty: those at `time`
  bool working_modes = true;  // with every word of the choices of working mode, else as the scenario sets them
};

Result assembly_section(const Analysis& a, const AssemblyOptions& r, const Stage& stage, const Progress& progress);

}  // namespace pmreport::section
