// Marlin's Configuration.h: the linear Delta of `#define DELTA`.
#include <reports/program/import/imported.hpp>

#include <core/text/text.hpp>
#include <core/text/units.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>

namespace pmreport::program {

namespace {

using settings::Place;

struct Definition {
  std::string value;
  Place place;
  bool again = false;  // defined a second time, as something else
  Place place_again = {};
};
using Definitions = std::map<std::string, Definition>;

bool of_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// #define NAME VALUE, outside of comments. Conditions are not followed: a name that stands twice with two values is told when it is needed.
void read_definitions(const settings::Lines& lines, Definitions& out, std::vector<std::string>& order) {
  bool in_comment = false;
  for (const settings::Line& line : lines) {
    std::string text;
    for (std::size_t i = 0; i < line.text.size(); ++i) {
      const std::string_view two = std::string_view(line.text).substr(i, 2);
      if (in_comment) {
        if (two == "*/") in_comment = false, ++i;
      } else if (two == "//") {
        break;
      } else if (two == "/*") {
        in_comment = true, ++i;
      } else {
        text += line.text[i];
      }
    }
    std::string_view rest = trim(text);
    if (!rest.starts_with('#')) continue;
    rest = trim(rest.substr(1));
    if (!rest.starts_with("define") || rest.size() < 8 || of_name(rest[6])) continue;
    rest = trim(rest.substr(6));
    const auto end = std::find_if_not(rest.begin(), rest.end(), of_name);
    const std::string name(rest.begin(), end), value(trim(std::string_view(end, rest.end())));
    if (name.empty()) settings::refuse(line.place, "expected a name behind #define");
    const auto [at, is_new] = out.try_emplace(name, Definition{value, line.place});
    if (is_new)
      order.push_back(name);
    else if (at->second.value != value)
      at->second.again = true, at->second.place_again = line.place;
  }
}

// Nothing where there is no such name. Refuses one of two meanings.
const Definition* look_up(const Definitions& all, const std::string& name) {
  const auto at = all.find(name);
  if (at == all.end()) return nullptr;
  if (at->second.again)
    settings::refuse(at->second.place_again,
                     fmt::format("{} is defined a second time, as something else than in {}; which counts is decided by conditions, "
                                 "which are not followed here",
                                 name, where(at->second.place)),
                     "take one of the two out");
  return &at->second;
}

// Sums, products and brackets of numbers and of other names, as C computes them: whole numbers divide whole. Bounded in depth and in steps:
// names may lead in circles.
//
// The preprocessor puts in the text of a name, not its value: with #define A 10+5, 200-A is 195. A name that stands in another's sum must
// therefore be one number, or in brackets.
class Arithmetic {
 public:
  // `used`: names that the number is put together from are added to it.
  Arithmetic(const Definitions& all, const Place& place, const std::string& what, std::set<std::string>& used)
      : all_(all), place_(place), what_(what), used_(used) {}
  double of(const std::string& text) {
    std::string_view rest = text;
    const Part out = sum(rest, 0);
    if (!trim(rest).empty() || !std::isfinite(out.value)) fail(text);
    return out.value;
  }

 private:
  struct Part {
    double value;
    bool whole;           // of the type int
    bool joined = false;  // by an operator that no brackets hold
  };

  [[noreturn]] void fail(std::string_view text) const {
    settings::refuse(place_, fmt::format("expected {}, a number or a sum of numbers; seen {}", what_, in_quotes(settings::shown(text))));
  }
  static Part both(double value, const Part& a, const Part& b) { return {value, a.whole && b.whole, true}; }
  Part sum(std::string_view& rest, int depth) {
    Part out = product(rest, depth);
    for (;;) {
      rest = trim(rest);
      if (!rest.starts_with('+') && !rest.starts_with('-')) return out;
      const double sign = rest.front() == '+' ? 1 : -1;
      rest.remove_prefix(1);
      const Part more = product(rest, depth);
      out = both(out.value + sign * more.value, out, more);
    }
  }
  Part product(std::string_view& rest, int depth) {
    Part out = one(rest, depth);
    for (;;) {
      rest = trim(rest);
      if (!rest.starts_with('*') && !rest.starts_with('/')) return out;
      const bool times = rest.front() == '*';
      rest.remove_prefix(1);
      const Part by = one(rest, depth);
      out = both(times ? out.value * by.value : out.value / by.value, out, by);
      if (!times && out.whole) out.value = std::trunc(out.value);
    }
  }
  Part one(std::string_view& rest, int depth) {
    constexpr int deepest = 50, most_steps = 10'000;
    if (depth > deepest || ++steps_ > most_steps)
      settings::refuse(place_, fmt::format("expected {}, a number; it is put together in too many steps", what_), "write it as a number");
    rest = trim(rest);
    if (rest.empty()) fail(rest);
    if (rest.front() == '-' || rest.front() == '+') {
      const double sign = rest.front() == '+' ? 1 : -1;
      rest.remove_prefix(1);
      const Part out = one(rest, depth + 1);
      return {sign * out.value, out.whole};
    }
    if (rest.front() == '(') {
      rest.remove_prefix(1);
      const Part out = sum(rest, depth + 1);
      rest = trim(rest);
      if (!rest.starts_with(')')) fail(rest);
      rest.remove_prefix(1);
      return {out.value, out.whole};
    }
    if (of_name(rest.front()) && std::isdigit(static_cast<unsigned char>(rest.front())) == 0) return named(rest, depth);
    double out = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), out);
    if (error != std::errc()) fail(rest);
    const auto digits = static_cast<std::size_t>(end - rest.data());
    const bool whole = rest.substr(0, digits).find_first_not_of("0123456789") == std::string_view::npos;
    rest.remove_prefix(digits);
    const bool is_float = rest.starts_with('f') || rest.starts_with('F');
    if (is_float) rest.remove_prefix(1);
    return {out, whole && !is_float};
  }
  Part named(std::string_view& rest, int depth) {
    const auto end = std::find_if_not(rest.begin(), rest.end(), of_name);
    const std::string name(rest.begin(), end);
    rest.remove_prefix(name.size());
    const Definition* d = look_up(all_, name);
    if (d == nullptr) fail(name);
    used_.insert(name);
    std::string_view value = d->value;
    const Part out = sum(value, depth + 1);
    if (!trim(value).empty()) fail(d->value);
    if (out.joined)
      settings::refuse(
          d->place,
          fmt::format("expected {}, which is part of {}, as a number or in brackets; seen {}, whose text and not its value the "
                      "preprocessor puts in",
                      name, what_, in_quotes(settings::shown(d->value))),
          fmt::format("write ({})", settings::shown(d->value)));
    return out;
  }

  const Definitions& all_;
  const Place& place_;
  const std::string& what_;
  std::set<std::string>& used_;
  int steps_ = 0;
};

class MarlinReading {
 public:
  explicit MarlinReading(const std::vector<std::filesystem::path>& files) : whole_{files.front().string()} {
    for (const auto& file : files) read_definitions(settings::lines_of(file), all_, order_);
  }
  const Place& whole() const { return whole_; }

  const Definition* find(const std::string& name) {
    const Definition* out = look_up(all_, name);
    if (out != nullptr) taken_.insert(name);
    return out;
  }
  const Definition* find_either(std::initializer_list<const char*> names) {
    for (const char* name : names)
      if (const Definition* d = find(name)) return d;
    return nullptr;
  }
  const Definition& need(std::initializer_list<const char*> names) {
    const Definition* d = find_either(names);
    if (d == nullptr) settings::refuse(whole_, fmt::format("expected #define {}, which is not there", *names.begin()));
    return *d;
  }
  double number(const Definition& d, const std::string& what, bool above_zero) {
    const double out = Arithmetic(all_, d.place, what, taken_).of(d.value);
    check_length(out, 1e-3, d.place, what, above_zero);
    return out;
  }
  // Three numbers in braces, or none: zeros.
  std::array<double, 3> trim_of(const char* name, double most) {
    std::array<double, 3> out{};
    const Definition* d = find(name);
    if (d == nullptr) return out;
    const std::vector<double> given = settings::numbers_of(d->value, d->place, name, 3);
    if (given.size() != 3) settings::refuse(d->place, fmt::format("expected three numbers in {}, seen {}", name, given.size()));
    for (std::size_t i = 0; i < 3; ++i) {
      if (std::abs(given[i]) > most) settings::refuse(d->place, fmt::format("expected {} within {} either way", name, most));
      out[i] = given[i];
    }
    return out;
  }
  void tell_rest(std::vector<std::string>& out) const {
    std::size_t others = 0;
    for (const std::string& name : order_) {
      if (taken_.contains(name)) continue;
      const Definition& d = all_.at(name);
      if (name.find("DELTA") == std::string::npos)
        ++others;
      else
        out.push_back(fmt::format("{}: {} {}", where(d.place), settings::shown(name), settings::shown(d.value)));
    }
    if (others > 0) out.push_back(fmt::format("{}, definitions that say nothing of the geometry: {}", where(whole_), others));
  }

 private:
  Definitions all_;
  std::vector<std::string> order_;
  std::set<std::string> taken_;
  Place whole_;
};

}  // namespace

Imported import_marlin(const std::vector<std::filesystem::path>& files) {
  MarlinReading config(files);
  const Definition* delta = config.find("DELTA");
  if (delta == nullptr) {
    for (const char* other : {"MORGAN_SCARA", "MP_SCARA", "AXEL_TPARA", "POLARGRAPH", "POLAR", "COREXY", "COREXZ"})
      if (const Definition* d = config.find(other))
        settings::refuse(d->place, fmt::format("expected #define DELTA, seen {}, a machine that no mechanism here is", other));
    settings::refuse(config.whole(),
                     "expected #define DELTA, which is not there; without it Marlin drives slides at right angles, which are no "
                     "parallel mechanism");
  }
  Imported out;
  out.place = delta->place;
  out.title = fmt::format("Linear Delta of {}", where(config.whole()));
  const Definition& rod = config.need({"DELTA_DIAGONAL_ROD"});
  const double length = config.number(rod, "DELTA_DIAGONAL_ROD in mm", true),
               radius = config.number(config.need({"DELTA_RADIUS"}), "DELTA_RADIUS in mm", true);
  const Definition& top = config.need({"DELTA_HEIGHT", "MANUAL_Z_HOME_POS"});
  const double height = config.number(top, "DELTA_HEIGHT in mm", true);
  const Definition* print = config.find_either({"PRINTABLE_RADIUS", "DELTA_PRINTABLE_RADIUS"});
  const auto radii = config.trim_of("DELTA_RADIUS_TRIM_TOWER", 1000), rods = config.trim_of("DELTA_DIAGONAL_ROD_TRIM_TOWER", 1000),
             angles = config.trim_of("DELTA_TOWER_ANGLE_TRIM", 90), ends = config.trim_of("DELTA_ENDSTOP_ADJ", 1000);

  Towers t;
  constexpr double azimuth[] = {210, 330, 90};
  t.highest = most_metres * 1e3;
  for (std::size_t i = 0; i < 3; ++i) {
    t.radius[i] = radius + radii[i];
    t.rod[i] = length + rods[i];
    t.angle[i] = azimuth[i] + angles[i];
    if (!(t.radius[i] > 0 && t.rod[i] > t.radius[i]))
      settings::refuse(rod.place, fmt::format("expected rods longer than the towers' distance, {} mm; seen {} mm",
                                              format_number(t.radius[i], 6), format_number(t.rod[i], 6)));
    t.highest = std::min(t.highest, height + ends[i] + std::sqrt(t.rod[i] * t.rod[i] - t.radius[i] * t.radius[i]));
  }
  put_lowest(t, 0, print != nullptr ? config.number(*print, "PRINTABLE_RADIUS in mm", true) : 0.8 * radius, radius, length,
             {print != nullptr ? "PRINTABLE_RADIUS" : "0.8 DELTA_RADIUS, as the PRINTABLE_RADIUS,", "the height of the bed"});
  t.highest_from = "where DELTA_HEIGHT and DELTA_ENDSTOP_ADJ stop the carriages";
  t.home = std::stod(format_number(0.3 * height, 3));
  out.told.emplace_back("Imported from Marlin's DELTA; its towers A, B, C are 1, 2, 3.");
  put_towers(t, out);
  config.tell_rest(out.not_taken);
  return out;
}

}  // namespace pmreport::program
