// The program: scenario in, report out.
#include <core/host/catalog.hpp>
#include <core/scenario/scenario.hpp>
#include <reports/document/report.hpp>
#include <reports/program/check.hpp>
#include <reports/program/classify.hpp>
#include <reports/program/describe.hpp>
#include <reports/program/scaffold.hpp>
#include <reports/program/worker.hpp>
#include <reports/section/kinds.hpp>
#include <reports/section/make_report.hpp>

#include <fmt/core.h>
#include <tbb/global_control.h>
#include <CLI/CLI.hpp>

#include <fcntl.h>
#include <unistd.h>
#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <system_error>

namespace {

using namespace pmreport;
namespace fs = std::filesystem;

// Part of the interface, in README.md.
enum ExitStatus { all_well = 0, gate_failed = 1, bad_scenario = 2, plugin_failed = 3, output_failed = 4, resource_limit = 5 };

// The handler only raises a flag: work on a report stops between two samples, pictures or files, and takes its temporary files along.
// The other commands have nothing to clear away and end as the signal says.
std::atomic<int> stop_signal{0};
void on_signal(int number) { stop_signal = number; }
bool stop_asked() { return stop_signal != 0; }
void listen_to_signals() {
  struct sigaction action {};
  action.sa_handler = on_signal;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

// A stream that is closed from the start would lend its number to the first file opened, and words would end in that file. This one
// refuses them.
void fill_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0) open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

// To stderr. Where nobody can be told the exit status still speaks.
template <class... T>
void tell(fmt::format_string<T...> format, T&&... values) {
  std::fputs(fmt::format(format, std::forward<T>(values)...).c_str(), stderr);
}

struct Options {
  std::string scenario, out;
  std::vector<fs::path> plugin_path;
  bool check_only = false, quiet = false;
  int threads = 0;
  double timeout = 0;  // [s]
};

// One line on a terminal, overwritten; nothing in a pipe or a log.
class Terminal {
 public:
  explicit Terminal(bool quiet) {
    const char* term = std::getenv("TERM");
    live_ = !quiet && isatty(STDERR_FILENO) != 0 && std::getenv("CI") == nullptr && (term == nullptr || std::string_view(term) != "dumb");
  }
  ~Terminal() { clear(); }
  void say(const std::string& what) {
    if (live_) tell("\r\x1b[K{}", what), std::fflush(stderr), used_ = true;
  }
  void clear() {
    if (used_) tell("\r\x1b[K"), std::fflush(stderr), used_ = false;
  }

 private:
  bool live_ = false, used_ = false;
};

scenario::MechanismSource source_of(const host::Catalog& catalog) {
  scenario::MechanismSource source;
  source.find = [&catalog](const std::string& name) {
    const host::Entry* entry = catalog.find(name);
    return entry != nullptr ? entry->mechanism : nullptr;
  };
  for (const host::Entry& e : catalog.entries()) source.names.push_back(e.name);
  return source;
}

void tell_refused(const host::Catalog& catalog) {
  for (const std::string& sentence : catalog.refused()) tell("warning: {}\n", sentence);
}

int run(const Options& options) {
  listen_to_signals();
  const host::Catalog catalog(host::search_folders(options.plugin_path));
  tell_refused(catalog);
  const scenario::Loaded loaded = scenario::load(options.scenario, source_of(catalog), section::kinds());
  if (options.check_only) {
    if (!options.quiet)
      fmt::print("{}: valid, {} samples, {} sections\n", options.scenario, loaded.scenario.motion.time.size(),
                 loaded.scenario.sections.size());
    return all_well;
  }
  Terminal terminal(options.quiet);
  const section::Progress progress{[&](const std::string& what) { terminal.say(what); },
                                   [] {
                                     if (stop_asked()) throw document::Interrupted("interrupted");
                                   }};
  const document::Report report =
      section::make_report(loaded.scenario, *loaded.machine, PMREPORT_VERSION, catalog.find(loaded.scenario.mechanism)->build, progress);
  const std::string folder = options.out.empty() ? fs::path(options.scenario).stem().string() + "-report" : options.out;
  terminal.say("writing " + folder);
  document::write(report, folder, stop_asked);
  terminal.clear();
  if (!options.quiet) program::print_verdict(report, folder);
  return report.passed() ? all_well : gate_failed;
}

int list(const Options& options) {
  const host::Catalog catalog(host::search_folders(options.plugin_path));
  tell_refused(catalog);
  for (const host::Entry& e : catalog.entries()) fmt::print("{:<16} {}\n{:<16} {}\n", e.name, e.mechanism->title, "", e.file.string());
  if (catalog.entries().empty()) {
    tell("no mechanism found; searched:\n");
    for (const fs::path& f : catalog.folders()) tell("  {}\n", f.string());
    return plugin_failed;
  }
  return all_well;
}

// A mechanism by name, or those of a library file given by its path.
std::vector<const pm_mechanism*> mechanisms_named(const host::Catalog& catalog, const std::string& name) {
  if (name.find('/') != std::string::npos || name.ends_with(".so")) return host::load_plugin(name).mechanisms;
  if (const host::Entry* e = catalog.find(name)) return {e->mechanism};
  std::string known;
  for (const host::Entry& e : catalog.entries()) known += (known.empty() ? "" : ", ") + e.name;
  throw host::PluginError(fmt::format("no mechanism is called '{}'; known: {}", name, known.empty() ? "none" : known));
}

int describe(const Options& options, const std::string& name, bool json) {
  const host::Catalog catalog(host::search_folders(options.plugin_path));
  for (const pm_mechanism* m : mechanisms_named(catalog, name)) {
    const mechanics::Machine machine(*m, default_values(mechanics::describe(*m)));
    fmt::print("{}", json ? program::describe_json(machine) : program::describe_text(machine));
  }
  return all_well;
}

// One mechanism that cannot be made is the answer where it is alone; among several it is told, and the others are checked.
int check(const Options& options, const std::vector<std::string>& names, bool all, int poses) {
  if (names.empty() && !all) {
    tell("error: check expects a mechanism, several, or --all\n");
    return bad_scenario;
  }
  const host::Catalog catalog(host::search_folders(options.plugin_path));
  std::vector<const pm_mechanism*> chosen;
  if (all) {
    tell_refused(catalog);
    for (const host::Entry& e : catalog.entries()) chosen.push_back(e.mechanism);
  }
  for (const std::string& name : names)
    for (const pm_mechanism* m : mechanisms_named(catalog, name)) chosen.push_back(m);
  if (chosen.empty()) throw host::PluginError("no mechanism was found to check; pmreport list tells where plugins are searched");
  std::vector<program::Checked> checked;
  bool broken = false;
  for (const pm_mechanism* m : chosen) try {
      const mechanics::Machine machine(*m, default_values(mechanics::describe(*m)));
      if (!checked.empty()) fmt::print("\n");
      checked.push_back(program::print_properties(machine, poses));
    } catch (const mechanics::MechanismError& e) {
      if (chosen.size() == 1) throw;
      tell("error: {}: {}\n", m->name, e.what());
      broken = true;
    }
  if (chosen.size() > 1) program::print_table(checked);
  if (broken) return plugin_failed;
  return std::ranges::all_of(checked, &program::Checked::all_passed) ? all_well : gate_failed;
}

int new_mechanism(const Options& options, const std::string& name, const std::string& folder) {
  if (const std::string fault = program::fault_of_name(name); !fault.empty()) throw program::ScaffoldError(fault);
  const host::Catalog catalog(host::search_folders(options.plugin_path));
  if (const host::Entry* e = catalog.find(name))
    throw program::ScaffoldError(fmt::format("there is a mechanism '{}' already, {}; choose another name", name, e->file.string()));
  const fs::path made = program::write_scaffold(name, folder);
  fmt::print("{}: mechanism.cpp, CMakeLists.txt, scenario.toml; README.md tells the three commands that build, check and report\n",
             made.string());
  return all_well;
}

// Runs `f` and turns every error into a sentence on stderr and the exit status that README.md promises.
template <class F>
int guarded(F&& f) {
  try {
    return f();
  } catch (const scenario::ScenarioError& e) {
    for (const scenario::Diagnostic& d : e.diagnostics) tell("{}\n", to_string(d));
    if (e.diagnostics.size() > 1) tell("{} errors\n", e.diagnostics.size());
    return bad_scenario;
  } catch (const program::ScaffoldError& e) {
    tell("error: {}\n", e.what());
    return bad_scenario;
  } catch (const host::PluginError& e) {
    tell("error: {}\n", e.what());
    return plugin_failed;
  } catch (const mechanics::MechanismError& e) {
    tell("error: the mechanism's plugin failed: {}\n", e.what());
    return plugin_failed;
  } catch (const document::Interrupted&) {
    tell("interrupted; an earlier report is untouched\n");
    return 128 + stop_signal;
  } catch (const document::OutputError& e) {
    tell("error: {}\n", e.what());
    return output_failed;
  } catch (const std::system_error& e) {  // of a print to stdout, or of a folder that went away
    tell("error: the output failed: {}\n", e.what());
    return output_failed;
  } catch (const std::bad_alloc&) {
    tell("error: out of memory; ask for fewer samples or smaller pictures\n");
    return resource_limit;
  } catch (const std::exception& e) {
    tell("error: {}\n", e.what());
    return resource_limit;
  }
}

}  // namespace

int main(int argc, char** argv) {
  fill_closed_streams();
  std::signal(SIGPIPE, SIG_IGN);

  CLI::App app("pmreport: reports about parallel manipulators that an engineer can believe", "pmreport");
  app.set_version_flag("--version", std::string("pmreport ") + PMREPORT_VERSION);
  Options options;
  std::string name, folder;
  std::vector<std::string> names;
  bool json = false, check_all = false;
  int poses = 1000;
  app.add_option("scenario", options.scenario, "scenario to report on, a TOML file");
  app.add_option("-o,--out", options.out, "folder of the report (default: the scenario's name with -report, here)");
  app.add_flag("--check", options.check_only, "validate the scenario only; write nothing");
  app.add_flag("-q,--quiet", options.quiet, "print errors only");
  app.add_option("--plugin-path", options.plugin_path, "folder with plugins, searched first; may be repeated");
  app.add_option("--threads", options.threads, "threads to use (default: all cores); the report does not depend on it")
      ->check(CLI::PositiveNumber);
  app.add_option("--timeout", options.timeout, "give up after so many seconds (default: never)")->check(CLI::PositiveNumber);

  CLI::App* list_command = app.add_subcommand("list", "list the mechanisms and their files");
  CLI::App* describe_command = app.add_subcommand("describe", "describe a mechanism: coordinates, actuators, parameters, joints");
  describe_command->add_option("name", name, "mechanism, or the path of a plugin library")->required();
  describe_command->add_flag("--json", json, "for programs");
  CLI::App* check_command = app.add_subcommand("check", "run the property suite over mechanisms");
  check_command->add_option("name", names, "mechanisms, or the paths of plugin libraries");
  check_command->add_flag("--all", check_all, "every mechanism found");
  check_command->add_option("--poses", poses, "random poses (default 1000)")->check(CLI::Range(0, 1000000));
  CLI::App* new_command = app.add_subcommand("new", "begin something of one's own")->require_subcommand(1);
  CLI::App* new_mechanism_command = new_command->add_subcommand("mechanism", "write a folder with a small mechanism that builds and runs");
  new_mechanism_command->add_option("name", name, "of the mechanism: lower-case letters, digits, dashes")->required();
  new_mechanism_command->add_option("--folder", folder, "where its folder is made (default: here)");
  CLI::App* classify_command = app.add_subcommand("classify", "list the class of parallel-cross mechanisms");
  classify_command->add_flag("--json", json, "for programs");
  for (CLI::App* c : {list_command, describe_command, check_command, new_command, new_mechanism_command, classify_command})
    c->fallthrough();

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    const int status = app.exit(e);
    return status == 0 ? all_well : bad_scenario;
  }
  if (const std::optional<int> status = program::run_in_worker(argv, options.timeout)) return *status;

  std::optional<tbb::global_control> threads;
  if (options.threads > 0) threads.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(options.threads));

  const int status = guarded([&] {
    if (*classify_command) {
      fmt::print("{}", json ? program::classify_json() : program::classify_text());
      return static_cast<int>(all_well);
    }
    if (*list_command) return list(options);
    if (*describe_command) return describe(options, name, json);
    if (*check_command) return check(options, names, check_all, poses);
    if (*new_mechanism_command) return new_mechanism(options, name, folder);
    if (options.scenario.empty()) {
      tell("{}", app.help());
      return static_cast<int>(bad_scenario);
    }
    return run(options);
  });
  if (std::fflush(stdout) != 0 && status == all_well) {
    tell("error: standard output could not be written\n");
    program::worker_done();
    return output_failed;
  }
  program::worker_done();
  return status;
}
