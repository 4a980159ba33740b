#include <reports/program/import/imported.hpp>

#include <core/text/units.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace pmreport::program {

namespace {

constexpr int digits = 15;  // what a sum of two numbers of a file is good for

std::string list(const double (&all)[3], const std::string& unit, double more = 0) {
  return fmt::format("[{}, {}, {}]", quoted(all[0] + more, unit), quoted(all[1] + more, unit), quoted(all[2] + more, unit));
}
bool alike(const double (&all)[3]) { return all[0] == all[1] && all[1] == all[2]; }

}  // namespace

std::string where(const settings::Place& place) {
  const std::string name = settings::shown(std::filesystem::path(place.file).filename().string());
  return place.line > 0 ? fmt::format("{}:{}", name, place.line) : name;
}

std::string quoted(double value, const std::string& unit) { return fmt::format("\"{} {}\"", format_number(value, digits), unit); }

double roughly(double x, int to_digits) { return std::stod(format_number(x, to_digits)); }

void check_length(double value, double metres, const settings::Place& place, const std::string& what, bool above_zero, const char* unit) {
  if (above_zero && !(value > 0)) settings::refuse(place, fmt::format("expected {} above 0, seen {}", what, format_number(value, 6)));
  if (std::abs(value) * metres > most_metres)
    settings::refuse(place, fmt::format("expected {} of at most {} {}, seen {} {}", what, format_number(most_metres, 6), unit,
                                        format_number(value * metres, 6), unit));
}

void tell_rest(const settings::Settings& all, const std::set<int>& taken, std::vector<std::string>& out) {
  constexpr std::size_t most_keys = 12;
  std::vector<std::string> order;
  std::map<std::string, std::vector<std::string>> keys;
  std::set<std::pair<std::string, std::string>> seen;
  for (const settings::Setting& s : all) {
    if (taken.contains(s.place.line)) continue;
    if (!keys.contains(s.section)) order.push_back(s.section);
    if (seen.emplace(s.section, s.key).second) keys[s.section].push_back(s.key);
  }
  for (const std::string& section : order) {
    std::vector<std::string>& here = keys[section];
    const std::size_t more = here.size() > most_keys ? here.size() - most_keys : 0;
    here.resize(here.size() - more);
    for (std::string& key : here) key = settings::shown(key);
    out.push_back(fmt::format("{}, [{}]: {}{}", where({all.front().place.file}), settings::shown(section), fmt::join(here, ", "),
                              more > 0 ? fmt::format(" and {} more", more) : ""));
  }
}

void put_lowest(Towers& t, double floor, double print, double radius, double rod, const std::array<std::string, 2>& names) {
  constexpr double flattest = 0.97;  // of a rod's length in plan: one that lies flatter bears nothing
  const double farthest = std::max(0.0, flattest * rod - radius), away = radius + std::min(print, farthest);
  t.lowest = std::stod(format_number(floor + std::sqrt(rod * rod - away * away) - 1, 4));
  const std::string end = "and 1 mm; the file has no lower end";
  t.lowest_from = print > farthest ? fmt::format("what a radius of {} mm, as far as the rods reach, and {} ask for, {}; {} {} mm was cut",
                                                 format_number(farthest, 4), names[1], end, names[0], format_number(print, 6))
                                   : fmt::format("what {} and {} ask for, {}", names[0], names[1], end);
}

void put_towers(const Towers& t, Imported& out) {
  const double reach = *std::max_element(std::begin(t.radius), std::end(t.radius)),
               rod = *std::min_element(std::begin(t.rod), std::end(t.rod));
  // What enters is R - r alone; the firmware knows no more, so r is drawn as printers have it.
  const double r = roughly(0.17 * reach, 1), spacing = roughly(0.15 * rod, 1);
  const std::string& unit = t.unit;
  out.mechanism = "linear-delta";
  out.unit = unit;
  out.told.push_back(fmt::format("The firmware knows the distance in plan from ball to ball alone; of it r = {} {} is put on the platform.",
                                 format_number(r, digits), unit));
  out.told.emplace_back("Heights count as the firmware counts them: the platform's balls are taken at the height of the nozzle.");
  out.told.emplace_back(
      "Masses, the rods' spacing and section and the drives' stiffness are the mechanism's own or guessed: no such file has them.");

  std::string& p = out.parameters;
  p += alike(t.radius) ? fmt::format("tower_radius = {}\n", quoted(t.radius[0] + r, unit))
                       : fmt::format("tower_radii = {}\n", list(t.radius, unit, r));
  p += fmt::format("platform_radius = {}  # a guess\n", quoted(r, unit));
  p += alike(t.rod) ? fmt::format("rod_length = {}\n", quoted(t.rod[0], unit)) : fmt::format("rod_lengths = {}\n", list(t.rod, unit));
  p += fmt::format("tower_angles = {}\nrod_spacing = {}  # a guess\n", list(t.angle, "deg"), quoted(spacing, unit));
  p += fmt::format("home_height = {}\n", quoted(t.home, unit));
  p += fmt::format("stroke_min = {}  # {}\nstroke_max = {}  # {}\n", quoted(t.lowest, unit), t.lowest_from, quoted(t.highest, unit),
                   t.highest_from);
}

}  // namespace pmreport::program
