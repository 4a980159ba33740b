// LinuxCNC's HAL files: what they set, and what else they do.
#pragma once

#include <reports/program/import/settings.hpp>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace pmreport::program {

struct Hal {
  settings::Settings set;                     // key: the pin or parameter; value: as written
  settings::Settings nets;                    // key: a pin that a signal is led to; value: the signal
  settings::Settings modules;                 // key: of loadrt
  std::map<std::string, int> other_commands;  // how often each stands
};

Hal read_hal(const settings::Lines& lines);

// What a value stands for: [SECTION]NAME for what the INI file of the machine has there, anything else for itself; nothing where the INI
// does not have it. The line of the INI is added to `used`.
std::optional<std::string> resolved(const std::string& value, const settings::Settings& ini, std::set<int>& used);

}  // namespace pmreport::program
