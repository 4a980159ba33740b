// What LinuxCNC's files say of a machine, whatever it is: its kind, units, settings, and what joints and [TRAJ] have in common.
#pragma once

#include <reports/program/import/hal.hpp>
#include <reports/program/import/imported.hpp>

#include <array>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace pmreport::program::linuxcnc {

constexpr int guessed = 2;  // digits of an estimate

struct Unit {
  std::string name = "mm";
  double metres = 1e-3;
  bool given = false;
};

// The INI and HAL files of one machine. What is asked for counts as taken; `tell_rest` tells the others.
class Files {
 public:
  // Throws settings' refusals: files that cannot be read, and files that name no machine.
  explicit Files(const std::vector<std::filesystem::path>& files);

  const std::string& kins() const { return kins_; }
  const settings::Place& kins_place() const { return kins_place_; }
  const settings::Place& whole() const { return whole_; }
  const Unit& unit() const { return unit_; }
  double degrees() const { return degrees_; }  // of the unit of angles

  // The last setp of KINS.NAME; nothing: the file leaves it as it is.
  const settings::Setting* pin(const std::string& name);
  const settings::Setting* net(const std::string& name) const;
  const settings::Setting* ini(const std::string& section, const std::string& key);
  // Of joint i, whose section older files call AXIS_i.
  const settings::Setting* joint(int i, const std::string& key);
  // What a setting says; `what` names it in refusals.
  double number(const settings::Setting& s, const std::string& what);
  double length(const settings::Setting& s, const std::string& what, bool above_zero = false);
  double speed(const settings::Setting& s, const std::string& what);

  void tell_rest(std::vector<std::string>& out);

 private:
  void find_kins();
  void read_units();

  settings::Place whole_, kins_place_;
  std::string kins_, ini_name_;
  Unit unit_;
  double degrees_ = 1;
  settings::Settings ini_;
  Hal hal_;
  std::vector<std::string> hal_files_;
  std::set<std::string> taken_pins_;
  std::set<int> taken_lines_;
};

void tell_unit(const Files& m, Imported& out);

// What holds for all actuators of numbered joints: the strictest.
struct Stroke {
  std::optional<double> lowest, highest;
  std::string from = {};
};
Stroke strokes_of(Files& m, int joints);

// Speeds of joints as limits of actuators, by name.
void put_speeds(Files& m, int joints, const char* actuator, Imported& out);

// [TRAJ]HOME: x y z a b c, as far as it goes; nothing where it is not there, or all zeros, which stands for nothing.
std::optional<std::array<double, 6>> home_of(Files& m);
settings::Place place_of_home(Files& m);  // of its line, where there is one

// Of files whose KINS it is.
Imported hexapod(Files& m);  // genhexkins

}  // namespace pmreport::program::linuxcnc
