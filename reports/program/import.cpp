// pmreport import FILE...: a scenario of the machine that a controller's settings describe. It passes as it stands.
#include <core/mechanics/machine/machine.hpp>
#include <core/scenario/diagnostic.hpp>
#include <core/scenario/loaded.hpp>
#include <core/text/text.hpp>
#include <reports/program/cli/draft.hpp>
#include <reports/program/cli/parameter_words.hpp>
#include <reports/program/commands.hpp>
#include <reports/program/import/imported.hpp>
#include <reports/program/terminal.hpp>
#include <reports/section/kinds.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace pmreport::program {

namespace {

using settings::Place;

Imported imported(const std::vector<std::filesystem::path>& files) {
  const auto ending = [](const std::filesystem::path& file) { return settings::lower(file.extension().string()); };
  const auto all_end_in = [&](std::initializer_list<const char*> endings) {
    return std::ranges::all_of(files, [&](const auto& f) { return std::ranges::find(endings, ending(f)) != endings.end(); });
  };
  if (all_end_in({".ini", ".hal"})) return import_linuxcnc(files);
  if (all_end_in({".h"})) return import_marlin(files);
  if (all_end_in({".cfg"})) {
    if (files.size() > 1) settings::refuse({files[1].string()}, "expected one printer.cfg, seen a second");
    return import_klipper(files.front());
  }
  for (const auto& file : files)
    if (const std::string e = ending(file); e != ".ini" && e != ".hal" && e != ".h" && e != ".cfg")
      settings::refuse({file.string()},
                       fmt::format("expected settings of a controller, a file in .hal or .ini of LinuxCNC, .cfg of Klipper or .h "
                                   "of Marlin; seen {}",
                                   e.empty() ? "a name without an ending" : in_quotes(settings::shown(e))));
  settings::refuse({files[1].string()}, "expected files of one controller, seen those of two");
}

std::string comments_of(const Imported& made) {
  constexpr std::size_t most = 40;
  std::string out;
  for (const std::string& sentence : made.told) out += fmt::format("# {}\n", sentence);
  out += "# The motion, the load and the bound of the check are made up: put your own.\n";
  if (!made.not_taken.empty()) out += "#\n";
  for (std::size_t i = 0; i < std::min(most, made.not_taken.size()); ++i) out += fmt::format("# not taken over: {}\n", made.not_taken[i]);
  if (made.not_taken.size() > most) out += fmt::format("# not taken over: {} lines more\n", made.not_taken.size() - most);
  return out + "\n";
}

// The machine as a scenario would have it. What its mechanism refuses is told of the file.
scenario::Loaded machine_of(const Imported& made, const host::Catalog& catalog) {
  const std::string text =
      fmt::format("title = \"import\"\n[mechanism]\nuse = {}\n[mechanism.parameters]\n{}\n[[section]]\nkind = \"mechanism\"\n",
                  toml_string(made.mechanism), made.parameters);
  try {
    return scenario::load_text(text, "imported.toml", source_of(catalog), section::kinds());
  } catch (const scenario::ScenarioError& e) {
    settings::refuse(made.place, fmt::format("what the settings say is no machine: {}", e.diagnostics.front().message));
  }
}

}  // namespace

int import_settings(const Options& options) {
  refuse_existing(options.out);
  const std::vector<std::filesystem::path> files(options.names.begin(), options.names.end());
  const Imported made = imported(files);
  const host::Catalog catalog(host::search_folders(options.plugin_path));
  tell_refused(catalog);
  const scenario::Loaded loaded = machine_of(made, catalog);
  check_home(made, *loaded.machine);

  Draft draft{*loaded.machine};
  draft.title = made.title;
  draft.comments = comments_of(made);
  draft.length_unit = made.unit;
  draft.parameters = made.parameters;
  draft.tables = made.tables;
  draft.kinds = {"mechanism", "snapshots", "displacement", "velocity", "statics"};
  draft.kinds.insert(draft.kinds.end(), made.kinds.begin(), made.kinds.end());
  draft.kinds.emplace_back("mobility");
  Terminal terminal(options.quiet);
  std::string why;
  if (const std::optional<std::string> text = passing(draft, catalog, terminal, why)) {
    hand_out(*text, options.out);
    return all_well;
  }
  tell("{}: error: no motion about home passes, however small: {}\n", where(made.place), why);
  return gate_failed;
}

}  // namespace pmreport::program
