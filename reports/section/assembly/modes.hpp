// What is said and shown of the modes that a search has found.
#pragma once

#include <core/mechanics/assembly/assembly.hpp>
#include <reports/section/common/stage.hpp>

#include <optional>
#include <string>

namespace pmreport::section {

std::string counted(const mechanics::AssemblyModes& found);
std::string searched(const mechanics::AssemblyModes& found);  // how it went, and what follows from it
// What the joints allow beside the poses that the coordinates express.
std::string beyond_the_coordinates(const Analysis& a, const mechanics::FurtherModes& further);

document::Table table_of_modes(const Analysis& a, const mechanics::AssemblyModes& found);
document::Table table_of_continua(const Analysis& a, const mechanics::AssemblyModes& found);

// Of the nearest modes, and of two poses of the nearest continuum.
document::Gallery pictures_of_modes(const Analysis& a, const mechanics::AssemblyModes& found, const Stage& stage, const Progress& progress);

}  // namespace pmreport::section
