// LinuxCNC: which of its machines it is, and linear Deltas of lineardeltakins. Hexapods are in a file of their own.
#include <reports/program/import/linuxcnc_files.hpp>

#include <core/text/text.hpp>
#include <core/text/units.hpp>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>
#include <optional>

namespace pmreport::program {

using settings::Place, settings::Setting;

namespace linuxcnc {

namespace {

// What else LinuxCNC drives, and why no mechanism here is it.
std::string why_not(const std::string& kins) {
  static const std::map<std::string, const char*> machines{
      {"pentakins", "a pentapod: five struts on rings that turn about its spindle, which no mechanism here has"},
      {"rotarydeltakins", "a Delta robot with turning arms: write a scenario of mechanism \"delta\" by hand (pmreport new scenario delta)"},
      {"tripodkins", "three struts to one point, which no mechanism here has"},
      {"trivkins", "slides one on the other, which is no parallel mechanism"},
      {"pumakins", "a serial arm, which is no parallel mechanism"},
      {"genserkins", "a serial arm, which is no parallel mechanism"},
      {"scarakins", "a serial arm, which is no parallel mechanism"},
      {"scorbot-kins", "a serial arm, which is no parallel mechanism"}};
  const auto known = machines.find(kins);
  return known != machines.end() ? known->second : "a machine that is not known here";
}

Imported linear_delta(Files& m) {
  Imported out;
  out.told.emplace_back("Imported from LinuxCNC's lineardeltakins; its joints 0, 1, 2 are towers 1, 2, 3.");
  tell_unit(m, out);
  Towers t;
  t.unit = m.unit().name, t.metres = m.unit().metres;
  // LinuxCNC's own: 198.25 - 33 - 35 and 269.
  double radius = 130.25, rod = 269;
  Place place = m.kins_place();
  for (const auto& [name, value] : {std::pair{"R", &radius}, std::pair{"L", &rod}})
    if (const Setting* s = m.pin(name))
      *value = m.length(*s, m.kins() + "." + name, true), place = s->place;
    else
      out.told.push_back(fmt::format("The files set no {}: {} is LinuxCNC's own.", name, format_number(*value, 6)));
  if (!(rod > radius))
    settings::refuse(place, fmt::format("expected rods L longer than R, {}; seen {}", format_number(radius, 6), format_number(rod, 6)));
  for (int i = 0; i < 3; ++i)
    t.radius[i] = radius, t.rod[i] = rod, t.angle[i] = std::array{90.0, 210.0, 330.0}[static_cast<std::size_t>(i)];
  const Stroke stroke = strokes_of(m, 3);
  const double rise = std::sqrt(rod * rod - radius * radius);
  const auto sound = [&](const std::optional<double>& x) { return x && std::abs(*x) * m.unit().metres < most_metres; };
  const auto home = home_of(m);
  const bool given = home && (*home)[2] != 0;
  if (given) out.home = place_of_home(m);
  t.home = given                                           ? (*home)[2]
           : sound(stroke.lowest) && sound(stroke.highest) ? roughly((*stroke.lowest + *stroke.highest) / 2 - rise, guessed)
                                                           : roughly(0.4 * rod, guessed);
  t.lowest = sound(stroke.lowest) ? *stroke.lowest : roughly(t.home, guessed);
  t.highest = sound(stroke.highest) ? *stroke.highest : roughly(t.home + 2 * rise, guessed);
  t.lowest_from = sound(stroke.lowest) ? stroke.from : "a guess";
  t.highest_from = sound(stroke.highest) ? stroke.from : "a guess";
  if (!(t.lowest < t.highest)) settings::refuse(m.kins_place(), "expected a MIN_LIMIT of the joints below their MAX_LIMIT");
  put_towers(t, out);
  put_speeds(m, 3, "s", out);
  return out;
}

}  // namespace

}  // namespace linuxcnc

Imported import_linuxcnc(const std::vector<std::filesystem::path>& files) {
  linuxcnc::Files m(files);
  Imported out;
  if (m.kins() == "genhexkins")
    out = linuxcnc::hexapod(m);
  else if (m.kins() == "lineardeltakins")
    out = linuxcnc::linear_delta(m);
  else
    settings::refuse(m.kins_place(), fmt::format("expected genhexkins or lineardeltakins, seen {}: {}",
                                                 in_quotes(settings::shown(m.kins())), linuxcnc::why_not(m.kins())));
  out.place = m.kins_place();
  out.title = fmt::format("{} of {}", out.mechanism == "gough" ? "Hexapod" : "Linear Delta", where(m.whole()));
  m.tell_rest(out.not_taken);
  return out;
}

}  // namespace pmreport::program
