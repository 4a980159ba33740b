// [[section]]
#pragma once

#include <core/mechanics/dynamics/drive.hpp>
#include <core/scenario/measured_part.hpp>
#include <core/scenario/mechanism_part.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace pmreport::scenario {

// A table that kinds of sections may need, and where it stands; nullptr: it does not.
struct GivenTable {
  std::string name;
  const Entry* entry;
  bool elastic = false;  // says how parts give way, which the sections with needs of stiffness or reactions use
};

// A section whose kind cannot be read keeps none. `drives`: what [drive] says.
std::vector<Section> read_sections(const Entry* entry, Kinds kinds, const std::optional<TimeSpan>& span, const MechanismPart& mechanism,
                                   std::span<const GivenTable> tables, const std::vector<mechanics::DriveTrain>& drives,
                                   const Origin& origin, const Reader& reader);

// Whether any of the sections as written needs a motion; a file without sections would.
bool need_motion(const Entry* sections, Kinds kinds);

}  // namespace pmreport::scenario
