#include <reports/program/command_line.hpp>

#include <reports/program/cli/spoken.hpp>
#include <reports/program/memory_limit.hpp>
#include <reports/program/terminal.hpp>

#include <core/text/text.hpp>

#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include <charconv>
#include <cmath>
#include <sstream>
#include <string_view>

namespace pmreport::program {

namespace {

// CLI11 has it as well, and takes "nan".
std::string not_negative(const std::string& text) {
  double value = -1;
  const bool is_number = CLI::detail::lexical_cast(text, value);
  return is_number && value >= 0 && std::isfinite(value) ? "" : "expected a number of 0 or above; seen " + in_quotes(text);
}

// "3/64".
std::optional<chunks::Shard> shard_of(std::string_view text) {
  std::size_t numbers[2] = {};
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return std::nullopt;
  const std::string_view words[2] = {text.substr(0, slash), text.substr(slash + 1)};
  for (int i = 0; i < 2; ++i) {
    const char* end = words[i].data() + words[i].size();
    if (const auto [to, error] = std::from_chars(words[i].data(), end, numbers[i]); error != std::errc() || to != end) return std::nullopt;
  }
  constexpr std::size_t most = 1'000'000;
  if (numbers[0] < 1 || numbers[0] > numbers[1] || numbers[1] > most) return std::nullopt;
  return chunks::Shard(numbers[0] - 1, numbers[1]);
}

std::string a_name(const std::string& text) { return text.empty() ? "expected a name, seen nothing" : ""; }

}  // namespace

std::variant<Options, int> read_command_line(int argc, char** argv) {
  CLI::App app("pmreport: reports about parallel manipulators that an engineer can believe", "pmreport");
  app.set_version_flag("--version", std::string("pmreport ") + PMREPORT_VERSION);
  Options options;
  std::string name, folder, shell, shard, memory;
  app.add_option("scenario", options.scenarios, "scenario to report on, a TOML file; of several each gets its report, with an index");
  app.add_option("-o,--out", options.out,
                 "folder of the report (default: the scenario's name with -report, here), or of several (default: reports)")
      ->check(a_name);
  app.add_flag("--check", options.check_only, "validate the scenario only; write nothing");
  app.add_flag("-q,--quiet", options.quiet, "print errors only")->group(of_every_command);
  app.add_option("--plugin-path", options.plugin_path, "folder with plugins, searched first; may be repeated")
      ->allow_extra_args(false)
      ->group(of_every_command);
  app.add_option("--threads", options.threads, "threads to use (default: all cores); the report does not depend on it")
      ->check(CLI::PositiveNumber)
      ->group(of_every_command);
  app.add_flag("--resume", options.resume, "go on where an interrupted run of the same scenario stopped");
  app.add_option("--chunks", options.chunks, "folder where long work is kept in chunks (default: that of the report, with .chunks)")
      ->check(a_name);
  app.add_option("--shard", shard, "compute and keep a share of the work alone: 3/64 is the third of 64; pmreport merge makes the report")
      ->option_text("I/N")
      ->check([](const std::string& text) {
        return shard_of(text) ? "" : "expected I/N with I from 1 to N, as in 3/64; seen " + in_quotes(text);
      });
  app.add_option("--timeout", options.timeout, "give up after so many seconds (default: never)")
      ->check(CLI::PositiveNumber)
      ->group(of_every_command);
  app.add_option("--max-memory", memory, "refuse a report that would take more: 4 GB, 500 MB (default: nine tenths of what is available)")
      ->option_text("SIZE")
      ->check([](const std::string& text) {
        return size_of(text) ? "" : "expected a size with its unit, as in \"4 GB\" or \"500 MB\"; seen " + in_quotes(text);
      });
  app.add_flag("--sandbox", options.sandbox, "let plugins write beside the report alone, reach no network and run no program")
      ->group(of_every_command);
  app.add_option("--baseline", options.baseline, "results that the report must agree with: results.json, or the folder of a report")
      ->check(a_name);
  app.add_option("--relative", options.relative, "tolerance of a comparison, of the larger value (default 1e-6)")->check(not_negative);
  app.add_option("--absolute", options.absolute, "tolerance of a comparison, SI (default 1e-12)")->check(not_negative);

  CLI::App* list_command = app.add_subcommand("list", "list the mechanisms and their files");
  CLI::App* describe_command = app.add_subcommand("describe", "describe a mechanism: coordinates, actuators, parameters, joints");
  describe_command->add_option("name", name, "mechanism, or the path of a plugin library")->required()->type_name(mechanism_argument);
  describe_command->add_flag("--json", options.json, "for programs");
  CLI::App* check_command = app.add_subcommand("check", "run the property suite over mechanisms");
  check_command->add_option("name", options.names, "mechanisms, or the paths of plugin libraries")->type_name(mechanism_argument);
  check_command->add_flag("--all", options.check_all, "every mechanism found");
  check_command->add_option("--poses", options.poses, "random poses (default 1000)")->check(CLI::Range(0, 1000000));
  check_command->add_option("--parameters", options.parameters, "of the mechanism, as in a scenario: 'base_radius = \"400 mm\", ...'");
  check_command->add_option("--scenario", options.setting, "a scenario, whose mechanism, parameters and motion are checked");
  CLI::App* new_command = app.add_subcommand("new", "begin something of one's own")->require_subcommand(1);
  CLI::App* new_mechanism_command = new_command->add_subcommand("mechanism", "write a folder with a small mechanism that builds and runs");
  new_mechanism_command->add_option("name", name, "of the mechanism: lower-case letters, digits, dashes")->required();
  new_mechanism_command->add_option("--folder", options.folder, "where its folder is made (default: here)");
  CLI::App* new_scenario_command = new_command->add_subcommand("scenario", "print a scenario of a mechanism that passes as it stands");
  new_scenario_command->add_option("mechanism", name, "by its name")->required()->type_name(mechanism_argument);
  new_scenario_command->add_option("-o,--out", options.out, "new file to write it to (default: standard output)")->check(a_name);
  CLI::App* import_command = app.add_subcommand("import", "print a scenario of the machine that a controller's settings describe");
  import_command->add_option("files", options.names, "of LinuxCNC (.ini and .hal, both), Klipper (.cfg) or Marlin (.h)")
      ->required()
      ->expected(1, 16)
      ->option_text("FILE ...");
  import_command->add_option("-o,--out", options.out, "new file to write it to (default: standard output)")->check(a_name);
  CLI::App* classify_command = app.add_subcommand("classify", "list the class of parallel-cross mechanisms");
  classify_command->add_flag("--json", options.json, "for programs");
  CLI::App* merge_command = app.add_subcommand("merge", "make the report of a scenario from the chunks of all its shards");
  merge_command->add_option("scenario", options.scenario, "that all shards were run with")->required();
  CLI::App* limits_command = app.add_subcommand("limits", "print the safe box around home as settings of a controller");
  limits_command->add_option("scenario", options.scenario, "scenario with a section \"workspace\"")->required();
  limits_command->add_option("--format", options.format, "toml, linuxcnc (HAL) or klipper (default: toml)")
      ->check(CLI::IsMember({"toml", "linuxcnc", "klipper"}));
  limits_command->add_option("--axes", options.axes, "letters of the controller's axes for coordinates besides x, y and z: alpha=c,beta=a");
  CLI::App* schema_command = app.add_subcommand("schema", "print the JSON Schema of scenarios, for editors that complete and check them");
  schema_command->add_option("mechanism", name, "whose coordinates, parameters and joints it shall know (default: of any mechanism)")
      ->type_name(mechanism_argument);
  CLI::App* compare_command = app.add_subcommand("compare", "hold reports against each other: values, checks, evidence, curves");
  compare_command->add_option("reports", options.names, "folders of reports, results.json files or scenarios, two to 26")
      ->required()
      ->expected(2, 26)
      ->option_text("A B ...");
  compare_command->add_option("-o,--out", options.out, "folder for compare.html, a page with the curves as well")->check(a_name);
  compare_command->add_option("--relative", options.relative, "tolerance, of the larger value (default 1e-6)")->check(not_negative);
  compare_command->add_option("--absolute", options.absolute, "tolerance, SI (default 1e-12)")->check(not_negative);
  CLI::App* approve_command = app.add_subcommand("approve", "make the results of a report the baseline that later ones are held against");
  approve_command->add_option("report", folder, "folder of the report, or its results.json")->required();
  approve_command->add_option("baseline", name, "file of the baseline, new or an earlier one")->required();
  approve_command->add_option("--relative", options.relative, "tolerance of what is told to have changed (default 1e-6)")
      ->check(not_negative);
  approve_command->add_option("--absolute", options.absolute, "the same, SI (default 1e-12)")->check(not_negative);
  approve_command->add_flag("--failed", options.failed_too, "also when the report did not pass");
  CLI::App* completion_command = app.add_subcommand("completion", "print a script that completes pmreport in a shell");
  completion_command->add_option("shell", shell, "bash, zsh or fish")->required()->check(CLI::IsMember({"bash", "zsh", "fish"}));
  CLI::App* man_command = app.add_subcommand("man", "print the manual page: pmreport man | man -l -");
  for (CLI::App* c : {completion_command, man_command, new_scenario_command, merge_command, import_command, compare_command,
                      approve_command, schema_command, limits_command, list_command, describe_command, check_command, new_command,
                      new_mechanism_command, classify_command})
    c->fallthrough();

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    std::ostringstream asked, wrong;
    const int status = app.exit(e, asked, wrong);
    put("{}", asked.str());
    tell_text(wrong.str());
    return status == 0 ? all_well : bad_scenario;
  }
  if (*completion_command || *man_command) {
    put("{}", *man_command ? manual(spoken(app), PMREPORT_VERSION) : completion(spoken(app), shell));
    return all_well;
  }
  if (*describe_command || *new_mechanism_command || *schema_command || *new_scenario_command) options.names = {name};
  if (*approve_command) options.names = {folder, name};
  const std::pair<CLI::App*, Command> commands[] = {{compare_command, Command::compare},
                                                    {approve_command, Command::approve},
                                                    {list_command, Command::list},
                                                    {describe_command, Command::describe},
                                                    {check_command, Command::check},
                                                    {new_mechanism_command, Command::new_mechanism},
                                                    {classify_command, Command::classify},
                                                    {limits_command, Command::limits},
                                                    {schema_command, Command::schema},
                                                    {new_scenario_command, Command::new_scenario},
                                                    {import_command, Command::import_settings}};
  for (const auto& [asked, command] : commands)
    if (*asked) options.command = command;
  if (options.command == Command::report && !options.scenarios.empty()) options.scenario = options.scenarios.front();
  if (options.command == Command::report && options.scenarios.size() > 1) options.command = Command::many;
  if (*merge_command) options.merge = true;
  if (!shard.empty()) options.shard = shard_of(shard);
  if (!memory.empty()) options.max_memory = size_of(memory);
  if (options.shard && (options.command != Command::report || options.merge)) {
    tell("error: --shard: expected with one scenario alone: pmreport SCENARIO --shard {}\n", printable(shard));
    return bad_scenario;
  }
  if (options.command != Command::report && !options.baseline.empty()) {
    tell("error: --baseline: expected with one scenario: pmreport SCENARIO --baseline RESULTS\n");
    return bad_scenario;
  }
  if (options.command == Command::report && options.scenario.empty()) {
    tell("{}", app.help());
    return bad_scenario;
  }
  return options;
}

}  // namespace pmreport::program
