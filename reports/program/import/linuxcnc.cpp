// LinuxCNC: hexapods of genhexkins, linear Deltas of lineardeltakins.
//
// genhexkins has strut i from b_i on the base, in the world's axes, to a_i on the platform, in the platform's, both shifted along Z by the
// offsets of spindle and tool, and
//     l_i = |P + R a_i - b_i|,     R = Rz(c) Ry(b) Rx(a)
// so that struts 0 to 5 are legs 1 to 6 of mechanism gough, in the same axes. What genhexkins corrects for screws that turn in their nuts
// as the joints tilt is no length between joints, and not taken over.
#include <reports/program/import/hal.hpp>
#include <reports/program/import/imported.hpp>

#include <core/text/text.hpp>
#include <core/text/units.hpp>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>

namespace pmreport::program {

namespace {

using Eigen::Vector3d;
using settings::Place, settings::Setting, settings::Settings;

constexpr double deg = std::numbers::pi / 180;

// Where LinuxCNC puts the joints of a hexapod that says nothing: a machine of 1.2 m in inches.
constexpr double default_base[6][3] = {{-22.950, 13.250, 0}, {22.950, 13.250, 0}, {22.950, 13.250, 0},
                                       {0, -26.500, 0},      {0, -26.500, 0},     {-22.950, 13.250, 0}};
constexpr double default_platform[6][3] = {{-1, 11.500, 0},    {1, 11.500, 0},      {10.459, -4.884, 0},
                                           {9.459, -6.616, 0}, {-9.459, -6.616, 0}, {-10.459, -4.884, 0}};

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

struct Unit {
  std::string name = "mm";
  double metres = 1e-3;
  bool given = false;
};

class Machine {
 public:
  explicit Machine(const std::vector<std::filesystem::path>& files) : whole_{files.front().string()} {
    for (const auto& file : files)
      if (settings::lower(file.extension().string()) == ".ini") {
        if (!ini_name_.empty()) settings::refuse({file.string()}, "expected one INI file, seen a second");
        ini_name_ = file.string();
        ini_ = settings::read_linuxcnc_ini(settings::lines_of(file));
      }
    for (const auto& file : files) {
      if (settings::lower(file.extension().string()) == ".ini") continue;
      Hal one = read_hal(settings::lines_of(file));
      // As halcmd does them one after the other, what is set last counts.
      for (auto [from, to] : {std::pair{&one.set, &hal_.set}, std::pair{&one.nets, &hal_.nets}, std::pair{&one.modules, &hal_.modules}})
        to->insert(to->end(), from->begin(), from->end());
      for (const auto& [command, count] : one.other_commands) hal_.other_commands[command] += count;
      hal_files_.push_back(file.filename().string());
    }
    find_kins();
    read_units();
  }

  const std::string& kins() const { return kins_; }
  const Place& kins_place() const { return kins_place_; }
  const Place& whole() const { return whole_; }
  const Unit& unit() const { return unit_; }
  double degrees() const { return degrees_; }

  // The last setp of genhexkins.NAME; nothing: the file leaves it as it is.
  const Setting* pin(const std::string& name) {
    const std::string whole_name = kins_ + "." + name;
    const Setting* out = nullptr;
    for (const Setting& s : hal_.set)
      if (s.key == whole_name) out = &s, taken_pins_.insert(s.key);
    return out;
  }
  double number(const Setting& s, const std::string& what) {
    const std::optional<std::string> value = resolved(s.value, ini_, taken_lines_);
    if (!value)
      settings::refuse(s.place,
                       fmt::format("expected {}, seen {}, which no INI file given says", what, in_quotes(settings::shown(s.value))),
                       "give the INI file too: pmreport import MACHINE.ini FILE.hal");
    return settings::number_of(*value, s.place, what);
  }
  double length(const Setting& s, const std::string& what, bool above_zero = false) {
    const double out = number(s, what);
    check_length(out, unit_.metres, s.place, what, above_zero);
    return out;
  }
  double speed(const Setting& s, const std::string& what) {
    const double out = number(s, what);
    check_length(out, unit_.metres, s.place, what, true, "m/s");
    return out;
  }
  const Setting* ini(const std::string& section, const std::string& key) {
    const Setting* s = settings::first_of(ini_, section, key);
    for (const Setting& other : ini_)
      if (other.section == section && other.key == key) taken_lines_.insert(other.place.line);
    return s;
  }
  // Of joint i, whose section older files call AXIS_i.
  const Setting* joint(int i, const std::string& key) {
    const Setting* s = ini(fmt::format("JOINT_{}", i), key);
    return s != nullptr ? s : ini(fmt::format("AXIS_{}", i), key);
  }
  const Setting* net(const std::string& name) const {
    for (const Setting& s : hal_.nets)
      if (s.key == kins_ + "." + name) return &s;
    return nullptr;
  }

  void tell_rest(std::vector<std::string>& out) {
    for (const Setting& s : hal_.set)
      if (s.key.starts_with(kins_ + ".") && !taken_pins_.contains(s.key))
        out.push_back(fmt::format("{}: {} {}", where(s.place), settings::shown(s.key), settings::shown(s.value)));
    const auto others = std::ranges::count_if(hal_.set, [&](const Setting& s) { return !s.key.starts_with(kins_ + "."); });
    std::vector<std::string> commands;
    if (others > 0) commands.push_back(fmt::format("{} setp of other components", others));
    for (const auto& [command, count] : hal_.other_commands) commands.push_back(fmt::format("{} {}", count, command));
    if (commands.size() > 12) commands.resize(12), commands.emplace_back("more");
    for (std::string& name : hal_files_) name = settings::shown(name);
    if (!commands.empty()) out.push_back(fmt::format("{}, other commands: {}", listed(hal_files_), listed(commands)));
    for (const Setting& s : ini_) {
      if (s.section != "HAL" || s.key != "HALFILE") continue;
      taken_lines_.insert(s.place.line);
      if (std::ranges::find(hal_files_, std::filesystem::path(s.value).filename().string()) == hal_files_.end())
        out.push_back(fmt::format("{}: HALFILE {} was not given; where it sets the geometry, name it behind the INI file", where(s.place),
                                  settings::shown(s.value)));
    }
    program::tell_rest(ini_, taken_lines_, out);
  }

 private:
  // By the INI, by what the HAL loads, by what it sets.
  void find_kins() {
    if (const Setting* s = ini("KINS", "KINEMATICS")) {
      const std::vector<std::string> words = settings::words_of(s->value);
      if (!words.empty()) kins_ = words.front(), kins_place_ = s->place;
    }
    for (const Setting& s : hal_.modules) {
      const std::vector<std::string> words = settings::words_of(resolved(s.key, ini_, taken_lines_).value_or(""));
      if (kins_.empty() && !words.empty() && (words.front().ends_with("kins") || words.front() == "scorbot-kins"))
        kins_ = words.front(), kins_place_ = s.place;
    }
    for (const Setting& s : hal_.set)
      if (const std::string name = s.key.substr(0, s.key.find('.')); kins_.empty() && name.ends_with("kins"))
        kins_ = name, kins_place_ = s.place;
    if (kins_.empty())
      settings::refuse(whole_,
                       "expected a machine: KINEMATICS in [KINS] of an INI file, or loadrt or setp of genhexkins or lineardeltakins in a "
                       "HAL file; seen none of them");
  }
  void read_units() {
    const Setting* s = ini("TRAJ", "LINEAR_UNITS");
    if (s != nullptr) {
      const std::string word = settings::lower(s->value);
      unit_.given = true;
      if (word == "inch" || word == "in" || word == "imperial")
        unit_.name = "in", unit_.metres = 0.0254;
      else if (word != "mm" && word != "metric")
        settings::refuse(s->place, fmt::format("expected LINEAR_UNITS mm or inch, seen {}", in_quotes(settings::shown(s->value))));
    }
    if (const Setting* a = ini("TRAJ", "ANGULAR_UNITS")) {
      const std::string word = settings::lower(a->value);
      if (word == "rad" || word == "radian")
        degrees_ = 1 / deg;
      else if (word == "grad" || word == "gon")
        degrees_ = 0.9;
      else if (word != "deg" && word != "degree" && word != "degrees")
        settings::refuse(a->place,
                         fmt::format("expected ANGULAR_UNITS degree, grad or radian; seen {}", in_quotes(settings::shown(a->value))));
    }
  }

  Place whole_, kins_place_;
  std::string kins_, ini_name_;
  Unit unit_;
  double degrees_ = 1;  // of the unit of angles
  Settings ini_;
  Hal hal_;
  std::vector<std::string> hal_files_;
  std::set<std::string> taken_pins_;
  std::set<int> taken_lines_;
};

void tell_unit(const Machine& m, Imported& out) {
  if (!m.unit().given)
    out.told.emplace_back("No [TRAJ]LINEAR_UNITS was given: lengths are taken as mm. Give the INI file too where they are inches.");
}

// What holds for all actuators of numbered joints: the strictest.
struct Stroke {
  std::optional<double> lowest, highest;
  std::string from = {};
};
Stroke strokes_of(Machine& m, int joints) {
  Stroke out;
  bool differ = false;
  for (const bool low : {true, false})
    for (int i = 0; i < joints; ++i) {
      const Setting* s = m.joint(i, low ? "MIN_LIMIT" : "MAX_LIMIT");
      if (s == nullptr) continue;
      const double value = m.number(*s, low ? "the MIN_LIMIT of a joint" : "the MAX_LIMIT of a joint");
      std::optional<double>& bound = low ? out.lowest : out.highest;
      differ = differ || (bound && *bound != value);
      bound = !bound ? value : low ? std::max(*bound, value) : std::min(*bound, value);
    }
  out.from = differ ? "of the joints' limits, which differ, the strictest" : "limits of the joints";
  return out;
}

// Speeds of joints as limits of actuators, by name.
void put_speeds(Machine& m, int joints, const char* actuator, Imported& out) {
  std::string speeds;
  for (int i = 0; i < joints; ++i)
    if (const Setting* s = m.joint(i, "MAX_VELOCITY")) {
      const double value = m.speed(*s, "the MAX_VELOCITY of a joint");
      speeds += fmt::format("{}{}{} = {}", speeds.empty() ? "" : ", ", actuator, i + 1, quoted(value, m.unit().name + "/s"));
    }
  if (!speeds.empty()) out.tables += fmt::format("[limits]\nactuator_speed = {{ {} }}  # MAX_VELOCITY of the joints\n", speeds);
}

// [TRAJ]HOME: x y z a b c, as far as it goes; nothing where it is not there, or all zeros, which stands for nothing.
std::optional<std::array<double, 6>> home_of(Machine& m) {
  const Setting* s = m.ini("TRAJ", "HOME");
  if (s == nullptr) return std::nullopt;
  std::array<double, 6> out{};
  const std::vector<double> given = settings::numbers_of(s->value, s->place, "the HOME of [TRAJ]", 9);
  std::copy_n(given.begin(), std::min(given.size(), out.size()), out.begin());
  for (std::size_t i = 0; i < 3; ++i) check_length(out[i], m.unit().metres, s->place, "HOME", false);
  for (std::size_t i = 3; i < 6; ++i)
    if (std::abs(out[i] * m.degrees()) > 360) settings::refuse(s->place, "expected angles of HOME within a turn");
  if (std::ranges::all_of(out, [](double x) { return x == 0; })) return std::nullopt;
  return out;
}

struct Hexapod {
  std::array<Vector3d, 6> base, platform;  // machine units, with the offsets
  std::string silent;                      // pins that the HAL leaves at LinuxCNC's own values
  std::size_t told = 0;                    // of 36 coordinates how many the HAL sets
};

Hexapod points_of(Machine& m) {
  Hexapod out;
  double shift = 0;
  for (const char* name : {"spindle-offset", "tool-offset"})
    if (const Setting* s = m.pin(name)) shift += m.length(*s, name);
  std::vector<std::string> left;
  for (const bool base : {true, false})
    for (std::size_t i = 0; i < 6; ++i) {
      Vector3d& point = (base ? out.base : out.platform)[i];
      for (int k = 0; k < 3; ++k) {
        const std::string name = fmt::format("{}.{}.{}", base ? "base" : "platform", i, "xyz"[k]);
        const Setting* s = m.pin(name);
        point(k) = s != nullptr ? m.length(*s, m.kins() + "." + name) : (base ? default_base : default_platform)[i][k];
        s != nullptr ? void(++out.told) : left.push_back(name);
      }
      point.z() += shift;
    }
  out.silent = listed(left);
  return out;
}

std::array<double, 6> lengths_at(const Hexapod& h, const Vector3d& p, const Eigen::Matrix3d& r) {
  std::array<double, 6> out{};
  for (std::size_t i = 0; i < 6; ++i) out[i] = (p + r * h.platform[i] - h.base[i]).norm();
  return out;
}

double mean(const std::array<double, 6>& all) { return std::accumulate(all.begin(), all.end(), 0.0) / 6; }

// Over the middle of the base, level, where the struts are as long on average as asked for.
Vector3d home_over_base(const Hexapod& h, double length) {
  Vector3d middle = Vector3d::Zero(), of_platform = Vector3d::Zero();
  for (std::size_t i = 0; i < 6; ++i) middle += h.base[i] / 6, of_platform += h.platform[i] / 6;
  Vector3d level = middle - of_platform;
  for (double& x : level)
    if (std::abs(x) < 1e-9 * length) x = 0;  // but for rounding
  double low = 0, high = length;
  for (int k = 0; k < 60; ++k) {
    const double z = (low + high) / 2;
    (mean(lengths_at(h, level + z * Vector3d::UnitZ(), Eigen::Matrix3d::Identity())) < length ? low : high) = z;
  }
  return level + high * Vector3d::UnitZ();
}

std::string points_in_toml(const std::array<Vector3d, 6>& points, const std::string& unit, const char* what) {
  std::string out = "[\n";
  for (std::size_t i = 0; i < 6; ++i)
    out += fmt::format("  {}, {}, {},  # {} of strut {}\n", quoted(points[i].x(), unit), quoted(points[i].y(), unit),
                       quoted(points[i].z(), unit), what, i);
  return out + "]\n";
}

constexpr int guessed = 2;  // digits

Imported hexapod(Machine& m) {
  Imported out;
  out.mechanism = "gough";
  const std::string& unit = m.unit().name;
  const Hexapod h = points_of(m);
  const Stroke stroke = strokes_of(m, 6);

  // Home: as the machine says, else where its struts are in the middle of what they can.
  Vector3d p;
  Eigen::Matrix3d r = Eigen::Matrix3d::Identity();
  const auto given = home_of(m);
  if (given) {
    p = {(*given)[0], (*given)[1], (*given)[2]};
    const double a = (*given)[3] * m.degrees() * deg, b = (*given)[4] * m.degrees() * deg, c = (*given)[5] * m.degrees() * deg;
    r = (Eigen::AngleAxisd(c, Vector3d::UnitZ()) * Eigen::AngleAxisd(b, Vector3d::UnitY()) * Eigen::AngleAxisd(a, Vector3d::UnitX()))
            .toRotationMatrix();
  } else {
    double spread = 0;
    for (std::size_t i = 0; i < 6; ++i) spread = std::max({spread, h.base[i].norm(), (h.base[i] - h.base[0]).norm()});
    const bool both = stroke.lowest && stroke.highest && *stroke.lowest > 0 && *stroke.highest * m.unit().metres < most_metres;
    p = home_over_base(h, both ? (*stroke.lowest + *stroke.highest) / 2 : 1.2 * spread);
    out.told.push_back(fmt::format("No [TRAJ]HOME was given: home is over the base, where the struts are {}.",
                                   both ? "in the middle of their limits" : "somewhat longer than the base is wide"));
  }
  const std::array<double, 6> lengths = lengths_at(h, p, r);
  const double length = mean(lengths), scale = length / 0.95;  // of the mechanism's own machine

  out.told.insert(out.told.begin(), "Imported from LinuxCNC's genhexkins; its struts 0 to 5 are legs 1 to 6, in the same axes.");
  out.told.emplace_back(
      "Orientations: alpha, beta, gamma are Rz(alpha) Rx(beta) Ry(gamma), where LinuxCNC's a, b, c are Rz(c) Ry(b) Rx(a).");
  tell_unit(m, out);
  if (h.told == 0)
    out.told.emplace_back("The files set no joint at all: the points are those that LinuxCNC has by itself.");
  else if (!h.silent.empty())
    out.told.push_back(fmt::format("Not set by the files, and as LinuxCNC has it by itself: {}.", h.silent));
  out.told.emplace_back("Masses, sizes and stiffness of the parts are the mechanism's own, or in its proportions: no such file has them.");

  std::string& q = out.parameters;
  q += "base_points = " + points_in_toml(h.base, unit, "base joint") +
       "platform_points = " + points_in_toml(h.platform, unit, "platform joint");
  double disc = 0;
  for (const Vector3d& b : h.platform) disc += std::hypot(b.x(), b.y()) / 6;
  q += fmt::format("platform_radius = {}  # of the disc that is drawn\n",
                   quoted(std::max(roughly(disc, guessed), 0.001 / m.unit().metres), unit));
  if (given)
    q += fmt::format("home_position = [{}, {}, {}]  # [TRAJ]HOME\n", quoted(p.x(), unit), quoted(p.y(), unit), quoted(p.z(), unit));
  else
    q += fmt::format("home_position = [{}, {}, {}]\n", quoted(std::stod(format_number(p.x(), 6)), unit),
                     quoted(std::stod(format_number(p.y(), 6)), unit), quoted(std::stod(format_number(p.z(), 4)), unit));
  if (const double beta = std::asin(std::clamp(r(2, 1), -1.0, 1.0)); !r.isIdentity(0))
    q += fmt::format("home_angles = [{}, {}, {}]\n", quoted(std::atan2(-r(0, 1), r(1, 1)) / deg, "deg"), quoted(beta / deg, "deg"),
                     quoted(std::atan2(-r(2, 0), r(2, 2)) / deg, "deg"));
  // Limits that stop nothing, as simulators have them, are no strokes.
  const double shortest = *std::ranges::min_element(lengths), longest = *std::ranges::max_element(lengths);
  const bool low = stroke.lowest && *stroke.lowest > 0, high = stroke.highest && *stroke.highest * m.unit().metres <= most_metres;
  q += fmt::format("stroke_min = {}  # {}\n", quoted(low ? *stroke.lowest : roughly(0.6 * shortest, guessed), unit),
                   low ? stroke.from : "a guess");
  q += fmt::format("stroke_max = {}  # {}\n", quoted(high ? *stroke.highest : roughly(1.5 * longest, guessed), unit),
                   high ? stroke.from : "a guess");
  if (stroke.lowest && !low) out.told.push_back(fmt::format("MIN_LIMIT {} stops no strut.", format_number(*stroke.lowest, 6)));
  if (stroke.highest && !high) out.told.push_back(fmt::format("MAX_LIMIT {} stops no strut.", format_number(*stroke.highest, 6)));
  if ((low && shortest < *stroke.lowest) || (high && longest > *stroke.highest))
    out.told.emplace_back("Home lies outside of the limits that the files give the struts.");
  for (const auto& [name, share] : {std::pair{"cylinder_length", 0.76}, std::pair{"rod_length", 0.7}, std::pair{"cylinder_radius", 0.03},
                                    std::pair{"rod_radius", 0.02}, std::pair{"platform_thickness", 0.03}})
    q += fmt::format("{} = {}\n", name, quoted(roughly(share * scale, guessed), unit));

  if (const Setting* s = m.pin("screw-lead"))
    if (const double lead = m.length(*s, "the screw-lead"); lead != 0) {
      out.tables += fmt::format("[drive]\nlead = {}  # {}\n\n", quoted(std::abs(lead), unit), where(s->place));
      out.kinds.emplace_back("drives");
      out.not_taken.push_back(fmt::format(
          "{}: what the lead corrects of the joints' positions as the joints tilt; actuators here are lengths", where(s->place)));
    }
  if (const Setting* s = m.net("tool-offset"))
    out.not_taken.push_back(fmt::format("{}: the tool's length from signal {}, taken as 0", where(s->place), settings::shown(s->value)));
  put_speeds(m, 6, "rho", out);
  return out;
}

Imported linear_delta(Machine& m) {
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
  t.home = home && (*home)[2] != 0                         ? (*home)[2]
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

Imported import_linuxcnc(const std::vector<std::filesystem::path>& files) {
  Machine m(files);
  Imported out;
  if (m.kins() == "genhexkins")
    out = hexapod(m);
  else if (m.kins() == "lineardeltakins")
    out = linear_delta(m);
  else
    settings::refuse(m.kins_place(), fmt::format("expected genhexkins or lineardeltakins, seen {}: {}",
                                                 in_quotes(settings::shown(m.kins())), why_not(m.kins())));
  out.place = m.kins_place();
  out.title = fmt::format("{} of {}", out.mechanism == "gough" ? "Hexapod" : "Linear Delta", where(m.whole()));
  m.tell_rest(out.not_taken);
  return out;
}

}  // namespace pmreport::program
