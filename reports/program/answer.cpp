#include <reports/program/answer.hpp>

#include <core/chunks/chunk_folder.hpp>
#include <core/host/processor.hpp>
#include <core/mechanics/machine/machine.hpp>
#include <core/scenario/diagnostic.hpp>
#include <reports/compare/results.hpp>
#include <reports/document/folder/left_behind.hpp>
#include <reports/document/write.hpp>
#include <reports/figure/warnings.hpp>
#include <reports/program/commands.hpp>
#include <reports/program/memory_limit.hpp>
#include <reports/program/scaffold.hpp>
#include <reports/program/terminal.hpp>
#include <reports/program/worker/environment.hpp>
#include <reports/program/worker/sandbox.hpp>
#include <reports/program/worker/worker.hpp>

#include <fcntl.h>
#include <tbb/global_control.h>
#include <unistd.h>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <optional>
#include <stop_token>
#include <system_error>
#include <thread>
#include <variant>

namespace pmreport::program {

namespace {

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

// Of one of several processes that somebody else starts and ends: mpiexec kills a rank that goes on for a second. One that does not come to
// the end of its step in half of that clears away and ends.
void end_soon_when_asked(const std::stop_token& over) {
  constexpr std::chrono::milliseconds between_looks{50};
  constexpr int patience = 8;
  for (int looks = 0; looks < patience; looks += stop_asked()) {
    std::this_thread::sleep_for(between_looks);
    if (over.stop_requested()) return;
  }
  document::clear_all_left_behind();
  _exit(128 + stop_signal);
}

// A stream that is closed from the start would lend its number to the first file opened, and words would end in that file. This one
// refuses them.
void fill_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0) open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

int run(const Options& options) {
  switch (options.command) {
    case Command::report:
      listen_to_signals();
      return report(options, stop_asked);
    case Command::many:
      listen_to_signals();
      return many(options, stop_asked);
    case Command::limits:
      listen_to_signals();
      return limits(options, stop_asked);
    case Command::compare:
      listen_to_signals();
      return compare(options, stop_asked);
    case Command::approve:
      return approve(options);
    case Command::list:
      return list(options);
    case Command::describe:
      return describe(options);
    case Command::check:
      return check(options);
    case Command::new_mechanism:
      return new_mechanism(options);
    case Command::classify:
      return classify(options);
    case Command::new_scenario:
      return new_scenario(options);
    case Command::import_settings:
      return import_settings(options);
    case Command::schema:
      return schema(options);
  }
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
  } catch (const compare::InputError& e) {
    tell("error: {}\n", e.what());
    return bad_scenario;
  } catch (const ScaffoldError& e) {
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
  } catch (const chunks::ChunkNotKept& e) {
    tell("error: {}\n", e.what());
    return output_failed;
  } catch (const chunks::ChunkError& e) {
    tell("error: {}\n", e.what());
    return bad_scenario;
  } catch (const std::system_error& e) {  // of a thread that is not to be had, of a print to stdout, or of a folder that went away
    if (e.code() == std::errc::resource_unavailable_try_again || e.code() == std::errc::not_enough_memory) {
      tell("error: neither another thread nor more memory is to be had ({}); look at `ulimit -a`, or ask for --threads 1\n", e.what());
      return resource_limit;
    }
    tell("error: the output failed: {}\n", e.what());
    return output_failed;
  } catch (const TooLarge& e) {
    tell("error: {}\n", e.what());
    return resource_limit;
  } catch (const SandboxError& e) {
    tell("error: {}\n", e.what());
    return resource_limit;
  } catch (const std::bad_alloc&) {
    tell("error: out of memory; ask for fewer samples or smaller pictures\n");
    return resource_limit;
  } catch (const std::exception& e) {
    tell("error: {}\n", e.what());
    return resource_limit;
  }
}

int work(const Options& options) {
  std::optional<tbb::global_control> threads;
  if (options.threads > 0) threads.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(options.threads));
  return run(options);
}

// What a command writes, and where it keeps its work; a report is made here by default.
std::vector<std::filesystem::path> folders_written(const Options& options) {
  std::vector<std::filesystem::path> paths;
  if (!options.out.empty()) paths.emplace_back(options.out);
  if (options.command == Command::report && options.out.empty()) paths.emplace_back("report");
  if (!options.chunks.empty()) paths.push_back(std::filesystem::path(options.chunks) / "chunk");
  if (options.command == Command::approve) paths.emplace_back(options.names.back());
  if (options.command == Command::new_mechanism) paths.push_back(std::filesystem::path(options.folder) / options.names.front());
  return folders_that_hold(paths);
}

// What is printed may stand in a buffer until here.
int flushed(int status) {
  if (std::fflush(results()) == 0 && std::ferror(results()) == 0) return status;
  tell("error: standard output could not be written\n");
  return status == all_well ? output_failed : status;
}

std::variant<Options, int> asked(int argc, char** argv) {
  std::variant<Options, int> out = read_command_line(argc, argv);
  if (const int* status = std::get_if<int>(&out)) return flushed(*status);
  if (const std::string wrong = host::fault_of_processor(); !wrong.empty()) {
    tell("error: {}\n", wrong);
    return bad_scenario;
  }
  return out;
}

void prepare_process() {
  fill_closed_streams();
  figure::keep_library_warnings();
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGCHLD, SIG_DFL);  // where it is ignored, nobody learns how a child ended
}

}  // namespace

int answer(int argc, char** argv) {
  prepare_process();
  const int status = guarded([&] {
    const bool worker = begin_as_worker();
    const std::variant<Options, int> what = asked(argc, argv);
    if (const int* known = std::get_if<int>(&what)) return *known;
    const Options& options = std::get<Options>(what);
    const bool confined = options.sandbox && options.command != Command::many;  // whose processes are confined each
    const std::vector<std::filesystem::path> written = confined ? folders_written(options) : std::vector<std::filesystem::path>();
    if (!worker && options.command != Command::many)
      if (const std::optional<int> status = run_in_worker(argv, options.timeout, confined ? &written : nullptr)) return *status;
    if (confined) confine(written);
    if (worker) watch_parent();
    return flushed(guarded([&] { return work(options); }));
  });
  worker_done(status);
  return status;
}

int answer_together(int argc, char** argv, chunks::Dealer& dealer, int threads) {
  prepare_process();
  forget_what_does_not_matter();
  keep_results_apart();
  leave_telling_to_others(!dealer.collects());
  return guarded([&] {
    std::variant<Options, int> what = asked(argc, argv);
    if (const int* known = std::get_if<int>(&what)) return *known;
    Options& options = std::get<Options>(what);
    if (options.sandbox) {
      tell("error: --sandbox: ranks speak with each other, which it refuses; leave it away, or share the work by --shard\n");
      return static_cast<int>(bad_scenario);
    }
    if (options.command != Command::report || options.shard || options.merge) {
      tell("error: expected a scenario alone, whose report all ranks make together; the other commands are those of pmreport\n");
      return static_cast<int>(bad_scenario);
    }
    options.dealer = &dealer;
    if (options.threads == 0) options.threads = threads;
    const std::jthread watch(end_soon_when_asked);
    return flushed(guarded([&] { return work(options); }));
  });
}

}  // namespace pmreport::program
