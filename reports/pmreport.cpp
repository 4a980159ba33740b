// The program: what the user typed goes to its command, and what a command throws becomes a sentence and the exit status.
#include <core/host/processor.hpp>
#include <core/mechanics/machine/machine.hpp>
#include <core/scan/checkpoint.hpp>
#include <core/scenario/diagnostic.hpp>
#include <reports/compare/results.hpp>
#include <reports/document/write.hpp>
#include <reports/figure/warnings.hpp>
#include <reports/program/commands.hpp>
#include <reports/program/scaffold.hpp>
#include <reports/program/terminal.hpp>
#include <reports/program/worker/worker.hpp>

#include <fcntl.h>
#include <tbb/global_control.h>
#include <unistd.h>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <optional>
#include <system_error>
#include <variant>

namespace {

using namespace pmreport;
using program::Options, program::tell;

// The handler only raises a flag: work on a report stops between two samples, pictures or files, and takes its temporary files along.
// The other commands have nothing to clear away and end as the signal says.
std::atomic<int> stop_signal{0};
void on_signal(int number) { stop_signal = number; }
bool stop_asked() { return stop_signal != 0; }
void listen_to_signals() {
  struct sigaction action {};
  action.sa_handler = on_signal;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
    struct sigaction before {};
    if (sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_IGN) continue;  // as nohup wants it
    sigaction(signal, &action, nullptr);
  }
}

// A stream that is closed from the start would lend its number to the first file opened, and words would end in that file. This one
// refuses them.
void fill_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0) open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

int run(const Options& options) {
  switch (options.command) {
    case program::Command::report:
      listen_to_signals();
      return program::report(options, stop_asked);
    case program::Command::many:
      listen_to_signals();
      return program::many(options, stop_asked);
    case program::Command::limits:
      listen_to_signals();
      return program::limits(options, stop_asked);
    case program::Command::compare:
      listen_to_signals();
      return program::compare(options, stop_asked);
    case program::Command::approve:
      return program::approve(options);
    case program::Command::list:
      return program::list(options);
    case program::Command::describe:
      return program::describe(options);
    case program::Command::check:
      return program::check(options);
    case program::Command::new_mechanism:
      return program::new_mechanism(options);
    case program::Command::classify:
      return program::classify(options);
    case program::Command::new_scenario:
      return program::new_scenario(options);
    case program::Command::import_settings:
      return program::import_settings(options);
    case program::Command::schema:
      return program::schema(options);
  }
  return program::all_well;
}

// Runs `f` and turns every error into a sentence on stderr and the exit status that README.md promises.
template <class F>
int guarded(F&& f) {
  try {
    return f();
  } catch (const scenario::ScenarioError& e) {
    for (const scenario::Diagnostic& d : e.diagnostics) tell("{}\n", to_string(d));
    if (e.diagnostics.size() > 1) tell("{} errors\n", e.diagnostics.size());
    return program::bad_scenario;
  } catch (const compare::InputError& e) {
    tell("error: {}\n", e.what());
    return program::bad_scenario;
  } catch (const program::ScaffoldError& e) {
    tell("error: {}\n", e.what());
    return program::bad_scenario;
  } catch (const host::PluginError& e) {
    tell("error: {}\n", e.what());
    return program::plugin_failed;
  } catch (const mechanics::MechanismError& e) {
    tell("error: the mechanism's plugin failed: {}\n", e.what());
    return program::plugin_failed;
  } catch (const document::Interrupted&) {
    tell("interrupted; an earlier report is untouched\n");
    return 128 + stop_signal;
  } catch (const document::OutputError& e) {
    tell("error: {}\n", e.what());
    return program::output_failed;
  } catch (const scan::CheckpointNotKept& e) {
    tell("error: {}\n", e.what());
    return program::output_failed;
  } catch (const scan::CheckpointError& e) {
    tell("error: {}\n", e.what());
    return program::bad_scenario;
  } catch (const std::system_error& e) {  // of a thread that is not to be had, of a print to stdout, or of a folder that went away
    if (e.code() == std::errc::resource_unavailable_try_again || e.code() == std::errc::not_enough_memory) {
      tell("error: neither another thread nor more memory is to be had ({}); look at `ulimit -a`, or ask for --threads 1\n", e.what());
      return program::resource_limit;
    }
    tell("error: the output failed: {}\n", e.what());
    return program::output_failed;
  } catch (const std::bad_alloc&) {
    tell("error: out of memory; ask for fewer samples or smaller pictures\n");
    return program::resource_limit;
  } catch (const std::exception& e) {
    tell("error: {}\n", e.what());
    return program::resource_limit;
  }
}

int work(const Options& options) {
  std::optional<tbb::global_control> threads;
  if (options.threads > 0) threads.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(options.threads));
  return run(options);
}

// What is printed may stand in a buffer until here.
int flushed(int status) {
  if (std::fflush(program::results()) == 0 && std::ferror(program::results()) == 0) return status;
  tell("error: standard output could not be written\n");
  return status == program::all_well ? program::output_failed : status;
}

int answer(int argc, char** argv, bool worker) {
  const std::variant<Options, int> asked = program::read_command_line(argc, argv);
  if (const int* status = std::get_if<int>(&asked)) return flushed(*status);
  const Options& options = std::get<Options>(asked);
  if (const std::string wrong = host::fault_of_processor(); !wrong.empty()) {
    tell("error: {}\n", wrong);
    return program::bad_scenario;
  }
  if (!worker && options.command != program::Command::many)
    if (const std::optional<int> status = program::run_in_worker(argv, options.timeout)) return *status;
  return flushed(guarded([&] { return work(options); }));
}

}  // namespace

int main(int argc, char** argv) {
  fill_closed_streams();
  figure::keep_library_warnings();
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGCHLD, SIG_DFL);  // where it is ignored, nobody learns how a child ended
  const int status = guarded([&] { return answer(argc, argv, program::begin_as_worker()); });
  program::worker_done(status);
  return status;
}
