// pmreport new scenario MECHANISM: a scenario that passes as it stands, for its reader to change.
#include <core/mechanics/machine/machine.hpp>
#include <core/text/text.hpp>
#include <reports/program/cli/draft.hpp>
#include <reports/program/cli/parameter_words.hpp>
#include <reports/program/commands.hpp>
#include <reports/program/scaffold.hpp>
#include <reports/program/terminal.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace pmreport::program {

using mechanics::Machine, mechanics::ParameterInfo;

namespace {

std::string parameters_of(const Machine& machine) {
  std::size_t width = 0;
  std::vector<std::string> lines;
  for (const ParameterInfo& p : machine.info().parameters) {
    lines.push_back(fmt::format("# {} = {}", p.name, default_in_toml(p)));
    width = std::max(width, std::min<std::size_t>(lines.back().size(), 40));
  }
  std::string out;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const ParameterInfo& p = machine.info().parameters[i];
    out += fmt::format("{:<{}}  # {}; {}{}\n", lines[i], width, printable(p.title), range_in_words(p),
                       p.unless.empty() ? "" : "; not beside " + p.unless);
  }
  return out;
}

std::vector<std::string> kinds_for(const Topology& t) {
  std::vector<std::string> out{"mechanism", "snapshots", "displacement", "velocity", "acceleration", "statics"};
  if (has_mass(t)) out.emplace_back("dynamics");
  if (!t.elements.empty()) out.emplace_back("stiffness");
  out.emplace_back("mobility");
  return out;
}

}  // namespace

int new_scenario(const Options& options) {
  const host::Catalog catalog(host::search_folders(options.plugin_path));
  tell_refused(catalog);
  const std::string& name = options.names.front();
  refuse_existing(options.out);
  // A scenario names its mechanism, so a library file by its path does not do.
  if (catalog.find(name) == nullptr && (name.find('/') != std::string::npos || name.ends_with(".so")))
    throw ScaffoldError(fmt::format("expected the name of a mechanism, seen {}; give its folder by --plugin-path", in_quotes(name)));
  const pm_mechanism& mechanism = *mechanisms_named(catalog, name).front();
  const Machine machine(mechanism, mechanics::default_values(mechanics::describe(mechanism)));

  Draft draft{machine};
  draft.title = machine.info().name + ": a gentle motion about home";
  if (!machine.info().parameters.empty()) draft.parameters = "# Each with what counts where it is left out.\n" + parameters_of(machine);
  draft.kinds = kinds_for(machine.topology());
  Terminal terminal(options.quiet);
  std::string why;
  if (const std::optional<std::string> text = passing(draft, catalog, terminal, why)) {
    hand_out(*text, options.out);
    return all_well;
  }
  tell("error: no motion about home of {} passes, however small: {}\n       `pmreport check {}` tells more\n", name, why, name);
  return gate_failed;
}

}  // namespace pmreport::program
