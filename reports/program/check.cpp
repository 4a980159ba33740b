// `pmreport check`: the property suite of each mechanism, and a table of all when there are several.
#include <core/mechanics/conformance/properties.hpp>
#include <reports/program/commands.hpp>
#include <reports/program/remarks.hpp>
#include <reports/program/terminal.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <limits>

namespace pmreport::program {

namespace {

struct Checked {
  std::string mechanism;
  int passed = 0, properties = 0;
  std::string closest;  // the property that came closest to its tolerance, or exceeded it by most
  double share = 0;     // its deviation in terms of its tolerance
  bool all_passed() const { return passed == properties; }
};

double share_of_tolerance(const mechanics::Property& p) {
  if (p.worst == 0) return 0;
  return p.tolerance > 0 ? p.worst / p.tolerance : std::numeric_limits<double>::infinity();
}

// Runs the suite and prints it, with what to look at where it fails.
Checked print_properties(const mechanics::Machine& machine, int poses) {
  fmt::print("{}: home and {} random poses\n\n{:<50} {:>9} {:>9}      \n", machine.info().name, poses, "property", "worst", "allowed");
  Checked c{machine.info().name, 0, 0, "", -1};
  for (const mechanics::Property& p : check_properties(machine, {poses, 1})) {
    fmt::print("{:<50} {:>9.1e} {:>9.0e} {:<4} {}\n", p.claim, p.worst, p.tolerance, p.unit, p.passed() ? "pass" : "FAIL");
    if (!p.passed()) fmt::print("    compared: {}\n    worst: {}\n", p.how, p.where);
    ++c.properties;
    if (p.passed()) ++c.passed;
    if (const double share = share_of_tolerance(p); share > c.share) c.closest = p.claim, c.share = share;
  }
  print_remarks(machine);
  return c;
}

void print_table(const std::vector<Checked>& all) {
  std::size_t width = 9;
  for (const Checked& c : all) width = std::max(width, c.mechanism.size());
  fmt::print("\n{:<{}}  {:<16} {:>11}  {}\n", "mechanism", width, "properties", "of allowed", "by");
  for (const Checked& c : all)
    fmt::print("{:<{}}  {:<16} {:>11.1e}  {}\n", c.mechanism, width,
               fmt::format("{} of {} {}", c.passed, c.properties, c.all_passed() ? "pass" : "FAIL"), c.share, c.closest);
}

}  // namespace

// One mechanism that cannot be made is the answer where it is alone; among several it is told, and the others are checked.
int check(const Options& options) {
  const std::vector<std::string>& names = options.names;
  if (names.empty() && !options.check_all) {
    tell("error: check expects a mechanism, several, or --all\n");
    return bad_scenario;
  }
  const host::Catalog catalog(host::search_folders(options.plugin_path));
  std::vector<const pm_mechanism*> chosen;
  if (options.check_all) {
    tell_refused(catalog);
    for (const host::Entry& e : catalog.entries()) chosen.push_back(e.mechanism);
  }
  for (const std::string& name : names)
    for (const pm_mechanism* m : mechanisms_named(catalog, name)) chosen.push_back(m);
  if (chosen.empty()) throw host::PluginError("no mechanism was found to check; pmreport list tells where plugins are searched");
  std::vector<Checked> checked;
  bool broken = false;
  for (const pm_mechanism* m : chosen) try {
      const mechanics::Machine machine(*m, default_values(mechanics::describe(*m)));
      if (!checked.empty()) fmt::print("\n");
      checked.push_back(print_properties(machine, options.poses));
    } catch (const mechanics::MechanismError& e) {
      if (chosen.size() == 1) throw;
      tell("error: {}: {}\n", m->name, e.what());
      broken = true;
    }
  if (chosen.size() > 1) print_table(checked);
  if (broken) return plugin_failed;
  return std::ranges::all_of(checked, &Checked::all_passed) ? all_well : gate_failed;
}

}  // namespace pmreport::program
