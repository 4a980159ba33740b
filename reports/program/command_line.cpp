#include <reports/program/command_line.hpp>

#include <reports/program/terminal.hpp>

#include <CLI/CLI.hpp>

namespace pmreport::program {

std::variant<Options, int> read_command_line(int argc, char** argv) {
  CLI::App app("pmreport: reports about parallel manipulators that an engineer can believe", "pmreport");
  app.set_version_flag("--version", std::string("pmreport ") + PMREPORT_VERSION);
  Options options;
  std::string name;
  app.add_option("scenario", options.scenario, "scenario to report on, a TOML file");
  app.add_option("-o,--out", options.out, "folder of the report (default: the scenario's name with -report, here)");
  app.add_flag("--check", options.check_only, "validate the scenario only; write nothing");
  app.add_flag("-q,--quiet", options.quiet, "print errors only");
  app.add_option("--plugin-path", options.plugin_path, "folder with plugins, searched first; may be repeated");
  app.add_option("--threads", options.threads, "threads to use (default: all cores); the report does not depend on it")
      ->check(CLI::PositiveNumber);
  app.add_flag("--resume", options.resume, "let long scans go on where an interrupted run of the same scenario stopped");
  app.add_option("--timeout", options.timeout, "give up after so many seconds (default: never)")->check(CLI::PositiveNumber);

  CLI::App* list_command = app.add_subcommand("list", "list the mechanisms and their files");
  CLI::App* describe_command = app.add_subcommand("describe", "describe a mechanism: coordinates, actuators, parameters, joints");
  describe_command->add_option("name", name, "mechanism, or the path of a plugin library")->required();
  describe_command->add_flag("--json", options.json, "for programs");
  CLI::App* check_command = app.add_subcommand("check", "run the property suite over mechanisms");
  check_command->add_option("name", options.names, "mechanisms, or the paths of plugin libraries");
  check_command->add_flag("--all", options.check_all, "every mechanism found");
  check_command->add_option("--poses", options.poses, "random poses (default 1000)")->check(CLI::Range(0, 1000000));
  check_command->add_option("--parameters", options.parameters, "of the mechanism, as in a scenario: 'base_radius = \"400 mm\", ...'");
  check_command->add_option("--scenario", options.setting, "a scenario, whose mechanism, parameters and motion are checked");
  CLI::App* new_command = app.add_subcommand("new", "begin something of one's own")->require_subcommand(1);
  CLI::App* new_mechanism_command = new_command->add_subcommand("mechanism", "write a folder with a small mechanism that builds and runs");
  new_mechanism_command->add_option("name", name, "of the mechanism: lower-case letters, digits, dashes")->required();
  new_mechanism_command->add_option("--folder", options.folder, "where its folder is made (default: here)");
  CLI::App* classify_command = app.add_subcommand("classify", "list the class of parallel-cross mechanisms");
  classify_command->add_flag("--json", options.json, "for programs");
  CLI::App* limits_command = app.add_subcommand("limits", "print the safe box around home as settings of a controller");
  limits_command->add_option("scenario", options.scenario, "scenario with a section \"workspace\"")->required();
  limits_command->add_option("--format", options.format, "toml, linuxcnc (HAL) or klipper (default: toml)")
      ->check(CLI::IsMember({"toml", "linuxcnc", "klipper"}));
  limits_command->add_option("--axes", options.axes, "letters of the controller's axes for coordinates besides x, y and z: alpha=c,beta=a");
  for (CLI::App* c : {limits_command, list_command, describe_command, check_command, new_command, new_mechanism_command, classify_command})
    c->fallthrough();

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    const int status = app.exit(e);
    return status == 0 ? all_well : bad_scenario;
  }
  if (*describe_command || *new_mechanism_command) options.names = {name};
  const std::pair<CLI::App*, Command> commands[] = {{list_command, Command::list},         {describe_command, Command::describe},
                                                    {check_command, Command::check},       {new_mechanism_command, Command::new_mechanism},
                                                    {classify_command, Command::classify}, {limits_command, Command::limits}};
  for (const auto& [asked, command] : commands)
    if (*asked) options.command = command;
  if (options.command == Command::report && options.scenario.empty()) {
    tell("{}", app.help());
    return bad_scenario;
  }
  return options;
}

}  // namespace pmreport::program
