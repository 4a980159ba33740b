#include <core/numbers.hpp>
#include <reports/program/import/linuxcnc_files.hpp>

#include <core/text/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pmreport::program::linuxcnc {

using settings::Setting;

Files::Files(const std::vector<std::filesystem::path>& files) : whole_{files.front().string()} {
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

const Setting* Files::pin(const std::string& name) {
  const std::string whole_name = kins_ + "." + name;
  const Setting* out = nullptr;
  for (const Setting& s : hal_.set)
    if (s.key == whole_name) out = &s, taken_pins_.insert(s.key);
  return out;
}

double Files::number(const Setting& s, const std::string& what) {
  const std::optional<std::string> value = resolved(s.value, ini_, taken_lines_);
  if (!value)
    settings::refuse(s.place, fmt::format("expected {}, seen {}, which no INI file given says", what, in_quotes(settings::shown(s.value))),
                     "give the INI file too: pmreport import MACHINE.ini FILE.hal");
  return settings::number_of(*value, s.place, what);
}

double Files::length(const Setting& s, const std::string& what, bool above_zero) {
  const double out = number(s, what);
  check_length(out, unit_.metres, s.place, what, above_zero);
  return out;
}

double Files::speed(const Setting& s, const std::string& what) {
  const double out = number(s, what);
  check_length(out, unit_.metres, s.place, what, true, "m/s");
  return out;
}

const Setting* Files::ini(const std::string& section, const std::string& key) {
  const Setting* s = settings::first_of(ini_, section, key);
  for (const Setting& other : ini_)
    if (other.section == section && other.key == key) taken_lines_.insert(other.place.line);
  return s;
}

const Setting* Files::joint(int i, const std::string& key) {
  const Setting* s = ini(fmt::format("JOINT_{}", i), key);
  return s != nullptr ? s : ini(fmt::format("AXIS_{}", i), key);
}

const Setting* Files::net(const std::string& name) const {
  for (const Setting& s : hal_.nets)
    if (s.key == kins_ + "." + name) return &s;
  return nullptr;
}

void Files::tell_rest(std::vector<std::string>& out) {
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

// By the INI, by what the HAL loads, by what it sets.
void Files::find_kins() {
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

void Files::read_units() {
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

void tell_unit(const Files& m, Imported& out) {
  if (!m.unit().given)
    out.told.emplace_back("No [TRAJ]LINEAR_UNITS was given: lengths are taken as mm. Give the INI file too where they are inches.");
}

Stroke strokes_of(Files& m, int joints) {
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

void put_speeds(Files& m, int joints, const char* actuator, Imported& out) {
  std::string speeds;
  for (int i = 0; i < joints; ++i)
    if (const Setting* s = m.joint(i, "MAX_VELOCITY")) {
      const double value = m.speed(*s, "the MAX_VELOCITY of a joint");
      speeds += fmt::format("{}{}{} = {}", speeds.empty() ? "" : ", ", actuator, i + 1, quoted(value, m.unit().name + "/s"));
    }
  if (!speeds.empty()) out.tables += fmt::format("[limits]\nactuator_speed = {{ {} }}  # MAX_VELOCITY of the joints\n", speeds);
}

std::optional<std::array<double, 6>> home_of(Files& m) {
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

settings::Place place_of_home(Files& m) {
  const Setting* s = m.ini("TRAJ", "HOME");
  return s != nullptr ? s->place : settings::Place{};
}

}  // namespace pmreport::program::linuxcnc
