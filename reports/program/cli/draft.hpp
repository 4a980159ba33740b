// Scenarios that pass as they stand, for their reader to change: a gentle motion about home of a mechanism.
#pragma once

#include <core/host/catalog.hpp>
#include <core/mechanics/machine/machine.hpp>
#include <reports/program/terminal.hpp>

#include <optional>
#include <string>
#include <vector>

namespace pmreport::program {

struct Draft {
  const mechanics::Machine& machine;
  std::string title = {};
  std::string comments = {};            // before all else, lines of "# ..."
  std::string parameters = {};          // lines of [mechanism.parameters]; empty: no such table
  std::string length_unit = {};         // of lengths in the motion; empty: that in which the program shows them
  std::string push = "-50 N";           // along Z on the platform
  std::string tables = {};              // that stand before the sections
  std::vector<std::string> kinds = {};  // of the sections
};

// Whether there is anything to be moved by forces.
bool has_mass(const Topology& t);

// The text of the widest motion that passes, over a half, a quarter, ... of the coordinates' boxes, with a check on the actuators' forces;
// nothing, with the reason in `why`, where none does. Each is run in memory.
std::optional<std::string> passing(const Draft& draft, const host::Catalog& catalog, Terminal& terminal, std::string& why);

// To a new file, or to standard output where `path` is empty. Throws ScaffoldError of a file that is there already: best before work is
// done.
void refuse_existing(const std::string& path);
void hand_out(const std::string& text, const std::string& path);

}  // namespace pmreport::program
