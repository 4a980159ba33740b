// Units, titles and groups of the columns that an analysis fills, one list a subject: checks, CSV files, plots and tables share them.
#pragma once

#include <core/analysis/column_names.hpp>
#include <pmreport/topology.hpp>

#include <vector>

namespace pmreport::analysis {

using ColumnList = std::vector<Column>(const Topology&);

std::vector<Column> displacement_columns(const Topology& t);  // the platform's coordinates, actuators, readings, joints
std::vector<Column> velocity_columns(const Topology& t);      // their rates, the platform's twist, how well G is conditioned
std::vector<Column> acceleration_columns(const Topology& t);  // their accelerations, the rate of the twist
std::vector<Column> statics_columns(const Topology& t);       // actuator forces and constraint wrenches at rest
std::vector<Column> dynamics_columns(const Topology& t);      // actuator forces, powers and energies in motion
std::vector<Column> drive_columns(const Topology& t);         // what drives and motors must give
std::vector<Column> reaction_columns(const Topology& t);      // the wrench in every joint, and of every limb on the platform
std::vector<Column> transmission_columns(const Topology& t);  // how well actuators move the platform, and constraints hold it

// Deflection of the tool, indices, frequencies; of every element its share, of every beam its internal forces. Those of a motion's loads
// come first.
std::vector<Column> stiffness_columns(const Topology& t);
bool of_compliance(const Column& column);  // of these: one that asks for no load

// Whether a joint of a kind transmits component c of a wrench in joint axes (joint_frame.hpp): 0-2 force, 3-5 moment about its centre.
bool transmits(JointKind kind, int c);

}  // namespace pmreport::analysis
