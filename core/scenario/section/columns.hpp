// Names, units and groups of the output columns of each section: the one list that checks, CSV files, plots and tables share.
#pragma once

#include <pmreport/topology.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace pmreport::mechanics {

struct Column {
  std::string name;   // "l1_force"
  std::string unit;   // SI: "N"
  std::string group;  // "actuator_force": a check may name the whole group
  std::string title;  // "force of l1"
};

// Sections that have columns: "displacement", "velocity", "acceleration", "statics", "dynamics", "drives", "reactions". Others: empty. Time
// is not listed: it is always first.
std::vector<Column> columns_of(std::string_view section, const Topology& topology);
std::vector<std::string> sections_with_columns();

// Name of the column of limit number `limit` of a joint: "A1_deflection", "B5_angle", "U1_angle2".
std::string joint_column(const Joint& joint, std::size_t limit);

// Whether a joint of a kind transmits component c of a wrench in joint axes (joint_frame.hpp): 0-2 force, 3-5 moment about its centre.
bool transmits(JointKind kind, int c);
// Names of its columns: "B1_force_1", "B1_moment_3" in joint axes, "B1_force_x" in base axes.
std::string reaction_column(const Joint& joint, int c, bool base_axes);

}  // namespace pmreport::mechanics
