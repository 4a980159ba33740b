// pmreport limits SCENARIO: the safe box around home as settings of controllers.
#include <reports/program/cli/parameter_words.hpp>
#include <reports/program/commands.hpp>
#include <reports/program/terminal.hpp>
#include <reports/section/kinds.hpp>
#include <reports/section/workspace/options.hpp>
#include <reports/section/workspace/workspace.hpp>

#include <core/analysis/workspace/workspace.hpp>
#include <core/text/text.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace pmreport::program {

namespace {

using analysis::Workspace;

struct Side {
  const Coordinate* coordinate;
  double low, high;  // in `unit`
  std::string unit;  // "mm", "deg"
};

std::vector<Side> sides_of(const Workspace& w, const mechanics::Machine& machine) {
  std::vector<Side> out;
  for (std::size_t i = 0; i < w.safe_axes.size(); ++i) {
    const Coordinate& c = machine.topology().coordinates[static_cast<std::size_t>(w.safe_axes[i].input)];
    const section::SafeEnd low = section::safe_end_of(w.safe_box->sides[i].low, c, false),
                           high = section::safe_end_of(w.safe_box->sides[i].high, c, true);
    out.push_back({&c, low.value, high.value, low.unit});
  }
  return out;
}

// Sections after the first have their names, so that all of them are one table.
void print_toml(const Workspace& w, const std::vector<Side>& sides, const std::string& name) {
  put("[safe_limits{}]  # every pose with all coordinates within these keeps all limits; proved\n", name.empty() ? "" : "." + name);
  for (std::size_t i = 0; i < sides.size(); ++i)
    put("{} = [\"{:.3f} {}\", \"{:.3f} {}\"]  # {}; {}\n", toml_key(sides[i].coordinate->name), sides[i].low, sides[i].unit, sides[i].high,
        sides[i].unit, section::margin_words(w, w.safe_box->low_margin[i]), section::margin_words(w, w.safe_box->high_margin[i]));
}

// Which letter of the controller a coordinate is: x, y and z are themselves, others what --axes says.
std::string letter_of(const Side& side, const std::map<std::string, std::string>& axes) {
  const std::string& name = side.coordinate->name;
  if (const auto found = axes.find(name); found != axes.end()) return found->second;
  return name == "x" || name == "y" || name == "z" ? name : std::string();
}

// The soft limits of LinuxCNC are pins that may be set while it runs.
void print_linuxcnc(const std::vector<Side>& sides, const std::map<std::string, std::string>& axes) {
  put("# Soft limits of the axes, machine units mm and degrees: every pose with all of them within these is proved to keep all limits.\n");
  for (const Side& s : sides) {
    const std::string letter = letter_of(s, axes);
    if (letter.empty())
      put("# {} from {:.3f} to {:.3f} {}: no axis is known for it; give --axes {}=c, or whichever it is\n", s.coordinate->name, s.low,
          s.high, s.unit, s.coordinate->name);
    else
      put("setp ini.{0}.min_limit {1:.3f}\nsetp ini.{0}.max_limit {2:.3f}\n", letter, s.low, s.high);
  }
}

void print_klipper(const std::vector<Side>& sides, const std::map<std::string, std::string>& axes) {
  put("# Positions in mm: every pose with all of them within these is proved to keep all limits.\n");
  for (const Side& s : sides) {
    const std::string letter = letter_of(s, axes);
    if (letter != "x" && letter != "y" && letter != "z")
      put("# {} from {:.3f} to {:.3f} {}: Klipper has no axis for it, and it must be kept by other means\n", s.coordinate->name, s.low,
          s.high, s.unit);
    else
      put("[stepper_{}]\nposition_min: {:.3f}\nposition_max: {:.3f}\n", letter, s.low, s.high);
  }
}

// "alpha=c,beta=a": letters by the names of coordinates. Nothing, told, where it is none of that.
std::optional<std::map<std::string, std::string>> axes_of(const std::string& text, const Topology& topology) {
  std::map<std::string, std::string> out;
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    const std::string part = text.substr(at, end - at);
    const std::size_t equals = part.find('=');
    const std::string name = part.substr(0, equals), letter = equals == std::string::npos ? "" : part.substr(equals + 1);
    const bool known = std::ranges::any_of(topology.coordinates, [&](const Coordinate& c) { return c.name == name; });
    if (!known || letter.size() != 1 || std::string("xyzabcuvw").find(letter) == std::string::npos) {
      tell("error: --axes: expected coordinates with letters of axes, such as alpha=c,beta=a; seen {}\n", in_quotes(part));
      return std::nullopt;
    }
    const bool taken = std::ranges::any_of(out, [&](const auto& other) { return other.second == letter; });
    const bool another = (letter == "x" || letter == "y" || letter == "z") && letter != name &&
                         std::ranges::any_of(topology.coordinates, [&](const Coordinate& c) { return c.name == letter; });
    if (taken || another) {
      tell("error: --axes: axis {} would stand for two coordinates; give each its own letter\n", letter);
      return std::nullopt;
    }
    out[name] = letter;
    at = end + 1;
  }
  return out;
}

}  // namespace

int limits(const Options& options, bool (*stop)()) {
  const host::Catalog catalog(host::search_folders(options.plugin_path));
  tell_refused(catalog);
  const scenario::Loaded loaded = scenario::load(options.scenario, source_of(catalog), section::kinds());
  const auto axes = axes_of(options.axes, loaded.machine->topology());
  if (!axes) return bad_scenario;
  Terminal terminal(options.quiet);
  const section::Progress progress{[&](const std::string& what) { terminal.say(what); },
                                   [&] {
                                     if (stop()) throw document::Interrupted("interrupted");
                                   }};
  bool asked = false;
  int status = all_well;
  for (const scenario::Section& s : loaded.scenario.sections) {
    const auto* own = dynamic_cast<const section::WorkspaceOptions*>(s.options.get());
    if (own == nullptr) continue;
    asked = true;
    analysis::WorkspaceRequest request = own->request;
    request.methods.clear();
    request.safe = true;
    Workspace w;
    try {
      w = analysis::workspace(*loaded.machine, request, progress);
    } catch (const analysis::NoProgram& e) {
      tell("{}:{}: there are no safe limits: {}\n", options.scenario, s.line, e.what());
      status = gate_failed;
      continue;
    }
    terminal.clear();
    if (!w.safe_box || !w.safe_box->found) {
      const std::string why = !w.home_inside      ? fmt::format("home lies outside: {} is broken there", w.home_refused_by)
                              : !w.set.provable() ? analysis::unprovable(w)
                              : w.safe_box        ? w.safe_box->why
                                                  : "no coordinate has a range";
      tell("{}:{}: there is no safe box around home: {}\n", options.scenario, s.line, why);
      status = gate_failed;
      continue;
    }
    const std::vector<Side> sides = sides_of(w, *loaded.machine);
    if (std::ranges::any_of(sides, [](const Side& side) { return !(side.low <= side.high); })) {
      tell("{}:{}: the safe box around home is narrower than a thousandth of a millimetre or of a degree\n", options.scenario, s.line);
      status = gate_failed;
      continue;
    }
    if (const std::string held = section::held_words(w, *loaded.machine); !held.empty()) put("# Held: {}.\n", held);
    if (!own->name.empty() && options.format != "toml") put("# Section {}\n", own->name);
    if (w.tool)
      put("# Of the tool point, in the platform's axes at ({:.3f}, {:.3f}, {:.3f}) mm.\n", 1e3 * w.tool->at()(0), 1e3 * w.tool->at()(1),
          1e3 * w.tool->at()(2));
    if (options.format == "linuxcnc")
      print_linuxcnc(sides, *axes);
    else if (options.format == "klipper")
      print_klipper(sides, *axes);
    else
      print_toml(w, sides, own->name);
  }
  if (asked) return status;
  tell(
      "error: {}: expected a section \"workspace\", whose scan and limits tell what is safe, and there is none\n"
      "       add [[section]], kind = \"workspace\" and scan = {{ {} = [\"...\", \"...\"] }}\n",
      options.scenario, loaded.machine->topology().coordinates.front().name);
  return bad_scenario;
}

}  // namespace pmreport::program
