// Klipper's printer.cfg: the linear Delta of `kinematics: delta`.
#include <reports/program/import/imported.hpp>

#include <core/text/text.hpp>
#include <core/text/units.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace pmreport::program {

namespace {

using settings::Place, settings::Setting, settings::Settings;

// What else Klipper drives, and why no mechanism here is it.
std::string why_not(const std::string& kinematics) {
  static const std::map<std::string, const char*> machines{
      {"cartesian", "slides at right angles, one on the other, which is no parallel mechanism"},
      {"corexy", "slides at right angles, one on the other, which is no parallel mechanism"},
      {"corexz", "slides at right angles, one on the other, which is no parallel mechanism"},
      {"hybrid_corexy", "slides at right angles, one on the other, which is no parallel mechanism"},
      {"hybrid_corexz", "slides at right angles, one on the other, which is no parallel mechanism"},
      {"generic_cartesian", "slides at right angles, one on the other, which is no parallel mechanism"},
      {"polar", "a turntable with slides, which is no parallel mechanism"},
      {"deltesian", "two towers with rods and a slide across, which no mechanism here has"},
      {"rotary_delta", "a Delta robot with turning arms: write a scenario of mechanism \"delta\" by hand (pmreport new scenario delta)"},
      {"winch", "a platform on cables, which no mechanism here has"},
      {"none", "no machine at all"}};
  const auto known = machines.find(kinematics);
  return known != machines.end() ? known->second : "which is not known here";
}

class KlipperReading {
 public:
  explicit KlipperReading(const std::filesystem::path& file)
      : all_(settings::read_klipper(settings::lines_of(file))), whole_{file.string()} {}

  const Setting* find(const std::string& section, const std::string& key) {
    const Setting* s = settings::last_of(all_, section, key);
    for (const Setting& other : all_)
      if (other.section == section && other.key == key) taken_.insert(other.place.line);
    return s;
  }
  double length(const Setting& s, bool above_zero) const {
    const double out = settings::number_of(s.value, s.place, s.key + " in mm");
    check_length(out, 1e-3, s.place, s.key, above_zero);
    return out;
  }
  double length_or(const std::string& section, const std::string& key, double otherwise, bool above_zero) {
    const Setting* s = find(section, key);
    return s != nullptr ? length(*s, above_zero) : otherwise;
  }
  const Setting& need(const std::string& section, const std::string& key) {
    const Setting* s = find(section, key);
    if (s == nullptr)
      settings::refuse(whole_, fmt::format("expected {} in [{}], which is not there", key, section),
                       std::ranges::any_of(all_, includes) ? "files that it includes are not read: put their lines in its place" : "");
    return *s;
  }
  void tell_rest(std::vector<std::string>& out) {
    for (const Setting& s : all_)
      if (includes(s)) {
        taken_.insert(s.place.line);
        out.push_back(fmt::format("{}: [{}], which was not read; where it sets the geometry, put its lines in its place", where(s.place),
                                  settings::shown(s.section)));
      }
    program::tell_rest(all_, taken_, out);
  }

 private:
  static bool includes(const Setting& s) { return s.key.empty() && s.section.starts_with(settings::include); }

  Settings all_;
  Place whole_;
  std::set<int> taken_;  // lines
};

}  // namespace

Imported import_klipper(const std::filesystem::path& file) {
  KlipperReading config(file);
  const Setting& kinematics = config.need("printer", "kinematics");
  if (const std::string word = settings::lower(kinematics.value); word != "delta")
    settings::refuse(kinematics.place,
                     fmt::format("expected kinematics: delta, seen {}: {}", in_quotes(settings::shown(kinematics.value)), why_not(word)));

  Imported out;
  out.place = kinematics.place;
  out.title = fmt::format("Linear Delta of {}", where({file.string()}));
  const Setting& radius = config.need("printer", "delta_radius");
  Towers t;
  std::fill(std::begin(t.radius), std::end(t.radius), config.length(radius, true));
  const Setting *first_rod = nullptr, *first_end = nullptr;
  double height = most_metres * 1e3;  // of the nozzle with all carriages at their ends
  t.highest = height;
  for (int i = 0; i < 3; ++i) {
    const std::string section = std::string("stepper_") + "abc"[i];
    const Setting* rod = config.find(section, "arm_length");
    if (i == 0) first_rod = rod != nullptr ? rod : &config.need(section, "arm_length");
    const Setting& arm = rod != nullptr ? *rod : *first_rod;  // b and c are as a where they say nothing
    t.rod[i] = config.length(arm, true);
    if (!(t.rod[i] > t.radius[i]))
      settings::refuse(arm.place, fmt::format("expected an arm_length above delta_radius, {} mm; seen {} mm", format_number(t.radius[i], 6),
                                              format_number(t.rod[i], 6)));
    if (const Setting* angle = config.find(section, "angle")) {
      t.angle[i] = settings::number_of(angle->value, angle->place, "the angle of a tower in degrees");
      if (std::abs(t.angle[i]) > 400) settings::refuse(angle->place, "expected the angle of a tower within 400 degrees either way");
    }
    const Setting* end = config.find(section, "position_endstop");
    if (i == 0) first_end = end != nullptr ? end : &config.need(section, "position_endstop");
    const double at = config.length(end != nullptr ? *end : *first_end, false);
    height = std::min(height, at);
    t.highest = std::min(t.highest, at + std::sqrt(t.rod[i] * t.rod[i] - t.radius[i] * t.radius[i]));
  }
  const double floor = config.length_or("printer", "minimum_z_position", 0, false),
               print = config.length_or("printer", "print_radius", t.radius[0], true);
  if (!(floor < height)) settings::refuse(first_end->place, "expected ends of the carriages above minimum_z_position");
  put_lowest(
      t, floor, print, t.radius[0], *std::min_element(std::begin(t.rod), std::end(t.rod)),
      {config.find("printer", "print_radius") != nullptr ? "print_radius" : "delta_radius, as the print_radius,", "minimum_z_position"});
  t.highest_from = "where the lowest of position_endstop stops its carriage";
  t.home = std::stod(format_number(floor + 0.3 * (height - floor), 3));
  out.told.emplace_back("Imported from Klipper's kinematics: delta; its towers a, b, c are 1, 2, 3.");
  put_towers(t, out);
  config.tell_rest(out.not_taken);
  return out;
}

}  // namespace pmreport::program
