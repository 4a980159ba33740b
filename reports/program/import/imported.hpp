// What an import makes of settings: a mechanism with its parameters, and what its reader must know of where they come from.
#pragma once

#include <reports/program/import/settings.hpp>

#include <array>
#include <core/mechanics/machine/machine.hpp>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace pmreport::program {

struct Imported {
  std::string mechanism, title;
  settings::Place place;               // where the settings say what machine it is
  settings::Place home = {};           // where they say its home; line 0: they do not, and home is made up
  std::string unit = "mm";             // of lengths, as the settings have them
  std::vector<std::string> told;       // sentences on what was taken, and what is not the file's
  std::string parameters;              // lines of [mechanism.parameters]
  std::string tables;                  // of the scenario, before its sections
  std::vector<std::string> kinds;      // of sections that what is imported asks for
  std::vector<std::string> not_taken;  // a line each: where, what, why
};

// Of LinuxCNC: INI and HAL files of one machine. Of Klipper: printer.cfg. Of Marlin: Configuration.h and the like.
Imported import_linuxcnc(const std::vector<std::filesystem::path>& files);
Imported import_klipper(const std::filesystem::path& file);
Imported import_marlin(const std::vector<std::filesystem::path>& files);

// "printer.cfg:12"
std::string where(const settings::Place& place);

// A number and its unit as a TOML string: "\"12.5 mm\"".
std::string quoted(double value, const std::string& unit);

// To so many digits: an estimate that nobody shall take for a measure.
double roughly(double x, int to_digits);

// Refuses a length that no machine has, of so many metres a unit: beyond `most_metres`, or not above 0 where it must be. Or a speed, where
// `unit` is "m/s".
inline constexpr double most_metres = 100;
void check_length(double value, double metres, const settings::Place& place, const std::string& what, bool above_zero,
                  const char* unit = "m");

// Lines "printer.cfg, [fan]: pin, ..." of all settings whose place is not in `taken`, one a section.
void tell_rest(const settings::Settings& all, const std::set<int>& taken, std::vector<std::string>& out);

// Refuses a home where the machine is none, by the line that sets it: out of an actuator's stroke, or on a singular surface.
void check_home(const Imported& made, const mechanics::Machine& machine);

// Three upright towers with their rods, as printers have them.
struct Towers {
  std::string unit = "mm";
  double metres = 1e-3;                                  // of the unit
  double radius[3]{}, rod[3]{}, angle[3]{210, 330, 90};  // from ball to ball in plan, from ball to ball, [deg]
  double lowest = 0, highest = 0;                        // of the carriages' balls, where the platform's balls are at the nozzle's height
  double home = 0;                                       // height of the nozzle
  std::string lowest_from, highest_from;                 // what of the file they follow from
};
// The lower end of the carriages, from what a nozzle at height `floor` asks for that is to get `print` out: as far as rods that long, on
// towers of that radius, reach. `names` of the settings that ask for it, the one of `print` first.
void put_lowest(Towers& towers, double floor, double print, double radius, double rod, const std::array<std::string, 2>& names);
// The mechanism, its parameters, and what of them the settings do not say.
void put_towers(const Towers& towers, Imported& out);

}  // namespace pmreport::program
