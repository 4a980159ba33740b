// Scenarios of a gentle motion about home, tried until one passes.
#include <reports/program/cli/draft.hpp>
#include <reports/program/terminal.hpp>

#include <core/mechanics/model/effort.hpp>
#include <core/scenario/diagnostic.hpp>
#include <core/text/text.hpp>
#include <core/text/units.hpp>
#include <reports/document/folder/file.hpp>
#include <reports/program/cli/parameter_words.hpp>
#include <reports/program/commands.hpp>
#include <reports/program/scaffold.hpp>
#include <reports/section/kinds.hpp>
#include <reports/section/make_report.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace pmreport::program {

using mechanics::Machine;

namespace {

constexpr double largest_share = 0.5, smallest_share = 0.004;  // of the way from home to the end of a coordinate's box
constexpr const char* period = "4 s";

// The largest number of one digit 1, 2 or 5 that is not above x; 0: x is nothing.
double round_below(double x) {
  if (!(x > 0)) return 0;
  const double ten = std::pow(10, std::floor(std::log10(x)));
  for (const double digit : {5.0, 2.0})
    if (digit * ten <= x * (1 + 1e-12)) return digit * ten;
  return ten;
}

// Of the coordinates in turn: to and fro, out and back, to and fro twice; so that what they make together is no line.
constexpr const char* ways[] = {"sin(2*pi*t/{0})", "(1 - cos(2*pi*t/{0})) / 2", "sin(4*pi*t/{0})"};

std::string motion_of(const Coordinate& c, const std::string& length_unit, std::size_t number, double share) {
  const std::string unit = c.unit == "m" && !length_unit.empty() ? length_unit : display_unit_of(c.unit);
  const double factor = parse_unit(unit).value_or(Unit{}).factor;
  const double up = c.box.max - c.home, down = c.home - c.box.min;
  // Where home lies at an end of the box there is one side to go to, and out and back goes there alone.
  const bool one_sided = std::min(up, down) < 0.1 * std::max(up, down);
  const double room = one_sided ? std::max(up, down) : std::min(up, down);
  const double amplitude = round_below(share * room / factor);
  const bool at_zero = std::abs(c.home) <= 1e-9 * std::max(up, down);  // but for rounding
  const std::string home = at_zero ? "" : quantity_in_words(c.home, unit);
  if (amplitude == 0) return fmt::format("{} = \"{}\"", toml_key(c.name), home.empty() ? "0 " + unit : home);
  const std::string way = fmt::format(fmt::runtime(ways[one_sided ? 1 : number % std::size(ways)]), period);
  const char* sign = one_sided && down > up ? "-" : home.empty() ? "" : "+";
  return fmt::format("{} = \"{}{}{}{} * {}\"", toml_key(c.name), home.empty() ? "" : home + " ", sign, home.empty() ? "" : " ",
                     fmt::format("{} {}", format_number(amplitude, 6), unit), way);
}

struct Attempt {
  const Draft& draft;
  double share;            // how far the motion goes
  std::string bound = {};  // of the check
  bool pictures = false;
};

std::string section_of(const std::string& kind, const char* more = "") {
  return fmt::format("\n[[section]]\nkind = \"{}\"\n{}", kind, more);
}

// Forces of linear and rotary actuators have no common bound: the check is then on those like the first.
std::string checked(const Topology& t) {
  const bool alike = std::ranges::all_of(t.actuators, [&](const Actuator& a) { return a.sense() == t.actuators.front().sense(); });
  return alike ? "max(abs(actuator_force))" : fmt::format("max(abs({}_force))", t.actuators.front().name);
}

std::string text_of(const Attempt& a) {
  const Topology& t = a.draft.machine.topology();
  std::string out = a.draft.comments;
  out += fmt::format("title = {}\n\n[mechanism]\nuse = {}\n", toml_string(a.draft.title), toml_string(a.draft.machine.info().name));
  if (!a.draft.parameters.empty()) out += "\n[mechanism.parameters]\n" + a.draft.parameters;
  out += fmt::format("\n[motion]\nduration = \"{}\"\nsamples = 161\n", period);
  for (std::size_t i = 0; i < t.coordinates.size(); ++i) out += motion_of(t.coordinates[i], a.draft.length_unit, i, a.share) + "\n";
  out += fmt::format(
      "\n[load]  # on the platform at its reference point, in base axes\n"
      "force = [\"0 N\", \"0 N\", {}]\nmoment = [\"0 N*m\", \"0 N*m\", \"0 N*m\"]\n",
      toml_string(a.draft.push));
  if (has_mass(t)) out += "gravity = [\"0 m/s^2\", \"0 m/s^2\", \"-9.81 m/s^2\"]\n";
  if (!a.draft.tables.empty()) out += "\n" + a.draft.tables;
  for (const std::string& kind : a.draft.kinds)
    if (kind != "snapshots")
      out += section_of(kind);
    else if (a.pictures)
      out += section_of(kind, "times = [\"0 s\", \"1 s\"]\n");
  const std::string effort = mechanics::unit_of_effort(t.actuators.front().sense());
  const std::string comment = a.bound.empty() ? "" : "  # twice what this motion asks for; put what yours can bear";
  return out + fmt::format("\n[[check]]\nthat = {}\nbelow = \"{}\"{}\n", toml_string(checked(t)),
                           a.bound.empty() ? "1e12 " + effort : a.bound, comment);
}

// The smallest number of one digit 1, 2 or 5 that is not below x, which is above 0.
double round_above(double x) {
  const double below = round_below(x);
  if (below >= x) return below;
  return std::round(below / std::pow(10, std::floor(std::log10(below)))) == 2 ? 2.5 * below : 2 * below;
}

// The report of an attempt, made without pictures and not written; nothing, with the reason in `why`, where it does not pass.
std::optional<document::Report> passed(const Attempt& attempt, const host::Catalog& catalog, std::string& why) {
  const std::string& name = attempt.draft.machine.info().name;
  const scenario::MechanismSource source = source_of(catalog);
  try {
    const scenario::Loaded loaded = scenario::load_text(text_of(attempt), name + ".toml", source, section::kinds());
    document::Report report = section::make_report(loaded, PMREPORT_VERSION, catalog.find(name)->build, {});
    if (report.passed()) return report;
    const auto failed = std::ranges::find(report.checks, false, &document::Check::passed);
    why = failed != report.checks.end() ? failed->name + ": " + failed->message : "a line of its evidence fails";
  } catch (const scenario::ScenarioError& e) {
    why = e.what();
  }
  return std::nullopt;
}

std::string bound_of(const document::Report& report, const Machine& machine) {
  const auto check = std::ranges::find_if(report.checks, [](const document::Check& c) { return c.line > 0; });
  const double most = check != report.checks.end() ? check->value : 0;
  return fmt::format("{} {}", format_number(most > 0 ? round_above(2 * most) : 1, 6),
                     mechanics::unit_of_effort(machine.topology().actuators.front().sense()));
}

}  // namespace

bool has_mass(const Topology& t) {
  return std::ranges::any_of(t.bodies, [](const Body& b) { return b.inertia.mass > 0; });
}

std::optional<std::string> passing(const Draft& draft, const host::Catalog& catalog, Terminal& terminal, std::string& why) {
  std::optional<std::string> out;
  for (Attempt attempt{draft, largest_share}; !out && attempt.share > smallest_share; attempt.share /= 2) {
    terminal.say(fmt::format("trying a motion over {} % of the box", format_number(100 * attempt.share, 2)));
    if (const std::optional<document::Report> report = passed(attempt, catalog, why))
      out = text_of({draft, attempt.share, bound_of(*report, draft.machine), true});
  }
  terminal.clear();
  return out;
}

void hand_out(const std::string& text, const std::string& path) {
  if (path.empty())
    put("{}", text);
  else
    document::write_new_file(path, text);
}

void refuse_existing(const std::string& path) {
  std::error_code error;
  if (!path.empty() && std::filesystem::exists(std::filesystem::symlink_status(path, error)))
    throw ScaffoldError(fmt::format("{} is there already; choose another name with --out", path));
}

}  // namespace pmreport::program
