// `pmreport check`: the property suite of each mechanism, at the parameters that are given and at others, and a table of all when there are
// several.
#include <core/mechanics/conformance/properties.hpp>
#include <core/mechanics/conformance/settings.hpp>
#include <reports/program/commands.hpp>
#include <reports/program/remarks.hpp>
#include <reports/program/terminal.hpp>
#include <reports/section/kinds.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <limits>

namespace pmreport::program {

namespace {

using mechanics::Machine;
using mechanics::Property;
using mechanics::Verdict;

struct Checked {
  std::string mechanism;
  int passed = 0, failed = 0, unexamined = 0;
  int settings = 0, failed_settings = 0;  // other choices and sizes
  std::string closest;                    // the property that came closest to its tolerance, or exceeded it by most
  double share = -1;                      // its deviation in terms of its tolerance
  bool asked_for_poses = true;            // then all could have been examined
  bool examined = true;                   // all that a sound mechanism shows

  bool all_well() const { return failed == 0 && failed_settings == 0 && (examined || !asked_for_poses); }
  std::string counts() const {
    std::string out = fmt::format("{} passed", passed);
    if (failed > 0) out += fmt::format(", {} failed", failed);
    if (unexamined > 0) out += fmt::format(", {} not examined", unexamined);
    if (failed_settings > 0) out += fmt::format(", {} of {} other choices and sizes failed", failed_settings, settings);
    return out;
  }
};

double share_of_tolerance(const Property& p) {
  if (p.worst == 0) return 0;
  return p.tolerance > 0 ? p.worst / p.tolerance : std::numeric_limits<double>::infinity();
}

// A line of the table, with what to look at where it fails.
void print_property(const Property& p, const char* indent) {
  switch (p.verdict()) {
    case Verdict::not_applicable:
      return;
    case Verdict::not_examined:
      put("{}{:<50} {:>9} {:>9} {:<4} not examined: {}\n", indent, p.claim, "", "", "", p.unexamined);
      return;
    default:
      const bool passed = p.verdict() == Verdict::passed;
      put("{}{:<50} {:>9.1e} {:>9.0e} {:<4} {}\n", indent, p.claim, p.worst, p.tolerance, p.unit, passed ? "pass" : "FAIL");
      if (!passed) put("{}    compared: {}\n{}    worst: {}\n", indent, p.how, indent, p.where);
  }
}

constexpr int poses_elsewhere = 50, draws = 12, told = 3;

// The suite at other parameters: one line, and the first that fail. `strict`: what was not examined there fails as well. Another size may
// stand so badly that every pose is nearly singular; another choice may not.
void check_settings(const mechanics::Settings& settings, const char* what, bool strict, int poses, Checked& c) {
  int failed = 0;
  std::vector<std::pair<std::string, std::vector<Property>>> first;
  for (const mechanics::Setting& s : settings.taken) {
    std::vector<Property> broken;
    for (Property& p : check_properties(*s.machine, {.poses = poses, .seed = 1, .out_of_reach = 1}))
      if (p.verdict() == Verdict::failed || (strict && p.verdict() == Verdict::not_examined && !p.optional)) broken.push_back(std::move(p));
    if (broken.empty()) continue;
    if (failed++ < told) first.emplace_back(s.words, std::move(broken));
  }
  const int all = static_cast<int>(settings.taken.size());
  if (all == 0 && settings.refused == 0) return;
  if (all > 0) put("{} {}, home and {} random poses each: {}", all, what, poses, failed == 0 ? "pass" : fmt::format("{} FAIL", failed));
  if (settings.refused > 0)
    put("{}{} {} refused, such as: {}", all > 0 ? "; " : fmt::format("{}: ", what), settings.refused,
        settings.refused == 1 ? "was" : "were", settings.example);
  put("\n");
  for (const auto& [words, broken] : first) {
    put("  with {}\n", words);
    for (const Property& p : broken) print_property(p, "    ");
  }
  if (failed > told) put("  and with {} others\n", failed - told);
  c.settings += all;
  c.failed_settings += failed;
}

// Runs the suite and prints it. `way`: poses of a motion, to be looked at as well; `by`: what set the parameters.
Checked print_properties(const Machine& machine, int poses, const std::vector<Eigen::VectorXd>& way = {}, const std::string& by = {}) {
  put("{}{}: home{} and {} random poses\n\n{:<50} {:>9} {:>9}      \n", machine.info().name, by,
      way.empty() ? "" : fmt::format(", {} poses of its motion", way.size()), poses, "property", "worst", "allowed");
  Checked c;
  c.mechanism = machine.info().name;
  c.asked_for_poses = poses > 0;
  for (const Property& p : check_properties(machine, {.poses = poses, .seed = 1, .at_first = way})) {
    print_property(p, "");
    const Verdict v = p.verdict();
    (v == Verdict::failed ? c.failed : v == Verdict::not_examined ? c.unexamined : c.passed) += v != Verdict::not_applicable;
    if (v == Verdict::not_examined && !p.optional) c.examined = false;
    if (v != Verdict::passed && v != Verdict::failed) continue;
    if (const double share = share_of_tolerance(p); share > c.share) c.closest = p.claim, c.share = share;
  }
  put("\n");
  if (c.failed > 0) {
    put("other choices and sizes: not examined before these hold\n");
  } else {
    check_settings(other_choices(machine), "other choices", poses > 0, std::min(poses, poses_elsewhere), c);
    check_settings(other_numbers(machine, draws, 1), "other sizes", false, std::min(poses, poses_elsewhere), c);
  }
  print_remarks(machine);
  put("{}\n", c.counts());
  return c;
}

// "28 of 28 pass, 2 of 42 other settings FAIL"
std::string verdict_of(const Checked& c) {
  std::string out = fmt::format("{} of {} {}", c.passed, c.passed + c.failed, c.failed == 0 ? "pass" : "FAIL");
  if (c.unexamined > 0) out += fmt::format(", {} not examined", c.unexamined);
  if (c.failed_settings > 0) out += fmt::format(", {} of {} other settings FAIL", c.failed_settings, c.settings);
  return out;
}

void print_table(const std::vector<Checked>& all) {
  std::size_t width = 9, verdicts = 10;
  for (const Checked& c : all) width = std::max(width, c.mechanism.size()), verdicts = std::max(verdicts, verdict_of(c).size());
  put("\n{:<{}}  {:<{}}  {:>11}  {}\n", "mechanism", width, "properties", verdicts, "of allowed", "by");
  for (const Checked& c : all) put("{:<{}}  {:<{}}  {:>11.1e}  {}\n", c.mechanism, width, verdict_of(c), verdicts, c.share, c.closest);
}

// What a scenario or --parameters sets. The poses of a motion, at most so many, spread evenly over it.
constexpr int most_of_motion = 200;
Checked check_setting(const scenario::Loaded& loaded, int poses, const std::string& by) {
  std::vector<Eigen::VectorXd> way;
  const int samples = loaded.trajectory.samples(), count = std::min(samples, most_of_motion);
  for (int k = 0; k < count; ++k)
    if (const int sample = count > 1 ? k * (samples - 1) / (count - 1) : 0; loaded.trajectory.reaches(sample))
      way.emplace_back(loaded.trajectory.value.row(sample).transpose());
  return print_properties(*loaded.machine, poses, way, by);
}

// A scenario of nothing but the mechanism: parameters are read, and refused, as in any other.
Checked check_with_parameters(const Options& options, const pm_mechanism& mechanism) {
  scenario::MechanismSource source;
  source.find = [&](const std::string& name) { return name == mechanism.name ? &mechanism : nullptr; };
  source.names = {mechanism.name};
  const std::string text =
      fmt::format("title = \"check\"\n[mechanism]\nuse = \"{}\"\nparameters = {{ {} }}\n[[section]]\nkind = \"mechanism\"\n",
                  mechanism.name, options.parameters);
  return check_setting(scenario::load_text(text, "--parameters", source, section::kinds()), options.poses, " with " + options.parameters);
}

ExitStatus status_of(const std::vector<Checked>& checked) {
  return std::ranges::all_of(checked, &Checked::all_well) ? all_well : gate_failed;
}

}  // namespace

// One mechanism that cannot be made is the answer where it is alone; among several it is told, and the others are checked.
int check(const Options& options) {
  const std::vector<std::string>& names = options.names;
  const host::Catalog catalog(host::search_folders(options.plugin_path));
  if (!options.setting.empty()) {
    if (!names.empty() || options.check_all || !options.parameters.empty()) {
      tell("error: check --scenario expects nothing else: the scenario names the mechanism and its parameters\n");
      return bad_scenario;
    }
    return status_of({check_setting(scenario::load(options.setting, source_of(catalog), section::kinds()), options.poses,
                                    " as " + options.setting + " has it")});
  }
  if (names.empty() && !options.check_all) {
    tell("error: check expects a mechanism, several, --all, or --scenario FILE\n");
    return bad_scenario;
  }
  std::vector<const pm_mechanism*> chosen;
  if (options.check_all) {
    tell_refused(catalog);
    for (const host::Entry& e : catalog.entries()) chosen.push_back(e.mechanism);
  }
  for (const std::string& name : names)
    for (const pm_mechanism* m : mechanisms_named(catalog, name)) chosen.push_back(m);
  if (chosen.empty()) throw host::PluginError("no mechanism was found to check; pmreport list tells where plugins are searched");
  if (!options.parameters.empty()) {
    if (chosen.size() != 1) {
      tell("error: check --parameters expects one mechanism, seen {}\n", chosen.size());
      return bad_scenario;
    }
    return status_of({check_with_parameters(options, *chosen.front())});
  }
  std::vector<Checked> checked;
  bool broken = false;
  for (const pm_mechanism* m : chosen) try {
      const Machine machine(*m, default_values(mechanics::describe(*m)));
      if (!checked.empty()) put("\n");
      checked.push_back(print_properties(machine, options.poses));
    } catch (const mechanics::MechanismError& e) {
      if (chosen.size() == 1) throw;
      tell("error: {}: {}\n", m->name, e.what());
      broken = true;
    }
  if (chosen.size() > 1) print_table(checked);
  return broken ? plugin_failed : status_of(checked);
}

}  // namespace pmreport::program
