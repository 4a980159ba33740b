#include <core/chunks/sharing.hpp>
#include <core/host/surroundings.hpp>
#include <core/scenario/loaded.hpp>
#include <core/scenario/read/csv.hpp>
#include <core/text/text.hpp>
#include <reports/compare/words.hpp>
#include <reports/document/finding.hpp>
#include <reports/document/folder/staged_folder.hpp>
#include <reports/document/levels.hpp>
#include <reports/document/tally.hpp>
#include <reports/document/write.hpp>
#include <reports/program/commands.hpp>
#include <reports/program/memory_limit.hpp>
#include <reports/program/terminal.hpp>
#include <reports/section/common/words/words.hpp>
#include <reports/section/kinds.hpp>
#include <reports/section/make_report.hpp>

#include <fmt/core.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string_view>

namespace pmreport::program {

namespace {

// Verdict, failures, and where the report is.
void print_verdict(const document::Report& report, const std::string& folder) {
  using document::Verdict;
  for (const document::Check& c : report.checks)
    if (!c.passed) put("FAILED  {}: {}\n", c.name, c.message);
  for (const document::Section& s : report.sections)
    for (const document::Block& b : s.blocks)
      if (const auto* p = std::get_if<document::Proof>(&b))
        for (const document::Evidence& e : p->lines)
          if (e.failed() && !told_by_a_check(report, e))
            put("{}  {}: {}: {} ({})\n", e.verdict() == Verdict::error ? "ERROR " : "FAILED", s.title, e.claim, document::finding(e),
                e.how);
  const document::Tally checks = tally_checks(report), evidence = tally_evidence(report);
  document::Tally all = checks;
  all += evidence;
  const std::string others =
      counted(all, {Verdict::failed, Verdict::error, Verdict::not_decided, Verdict::not_examined, Verdict::not_applicable});
  put("{}: {} checks, {} lines of evidence{}; {}/report.html\n", report.passed() ? "passed" : "FAILED", checks.total(), evidence.total(),
      others.empty() ? "" : ", " + others, folder);
  if (report.every_instant) put("{}\n", report.every_instant->sentence);
}

document::Detail level_of(scenario::Detail detail) {
  switch (detail) {
    case scenario::Detail::brief:
      return document::Detail::brief;
    case scenario::Detail::engineering:
      return document::Detail::engineering;
    case scenario::Detail::full:
      break;
  }
  return document::Detail::full;
}

// GitHub shows what these lines say beside the lines of the scenario.
void print_annotations(const document::Report& report, const std::string& scenario) {
  const char* github = std::getenv("GITHUB_ACTIONS");
  if (github != nullptr && std::string_view(github) == "true") put("{}", document::to_annotations(report, scenario));
}

// Whether a report agrees with the baseline; what does not is told a line each.
bool agrees(const document::Report& report, const std::string& folder, const compare::Results& baseline, const Options& options) {
  const std::vector<compare::Results> both{baseline, compare::results_of(report, folder)};
  const compare::Comparison comparison = compare::compare(both, {options.relative, options.absolute});
  if (options.quiet) return comparison.agree;
  for (const std::string& line : compare::baseline_lines(comparison)) put("FAILED  baseline: {}\n", line);
  put("baseline {}: {}\n", printable(options.baseline), compare::verdict(comparison));
  if (!comparison.agree) put("What is meant to be so becomes the baseline by: pmreport approve {} BASELINE_FILE\n", printable(folder));
  return comparison.agree;
}

// A scenario, and all that it was read by.
struct Ready {
  explicit Ready(const Options& options)
      : catalog(host::search_folders(options.plugin_path)), loaded([&] {
          tell_refused(catalog);
          return scenario::load(options.scenario, source_of(catalog), section::kinds());
        }()) {
    put_back();
  }

  // What the mechanism's plugin may have changed.
  void put_back() const {
    for (const std::string& what : before.restore())
      tell("warning: the mechanism's plugin has changed {}, which belongs to the whole program; it is as before again\n", what);
  }

  host::Catalog catalog;
  host::Surroundings before;
  scenario::Loaded loaded;
};

// Beside the report, not in it: the report is written when all is known.
std::filesystem::path chunks_of(const Options& options, const std::string& folder) {
  return options.chunks.empty() ? folder + ".chunks" : options.chunks;
}

// Of what decides every answer: this program, the mechanism's library, the scenario. The library by its plain file, for a machine may load
// its build for another processor, which gives the same numbers.
std::uint64_t meaning_of(const Ready& ready) {
  constexpr std::size_t most_of_a_library = std::size_t{1} << 30;
  chunks::Meaning out;
  out << std::string_view(PMREPORT_VERSION)
      << scenario::read_file(ready.catalog.find(ready.loaded.scenario.mechanism)->file, most_of_a_library).value_or("")
      << ready.loaded.scenario.text;
  return out.value();
}

void tell_account(const chunks::Account& account, const std::filesystem::path& folder) {
  if (account.damaged > 0)
    tell("warning: {} in {} {} not as written, and done again\n", section::plural(static_cast<int>(account.damaged), "chunk"),
         printable(folder.string()), account.damaged == 1 ? "was" : "were");
}

}  // namespace

int report(const Options& options, bool (*stop)()) {
  // Before the report is made: a folder may be its own baseline, and a bad one is told at once.
  const std::optional<compare::Results> baseline =
      options.baseline.empty() ? std::nullopt : std::optional(compare::read_report(options.baseline));
  const Ready ready(options);
  leave_telling_to_others(false);  // what goes wrong from here on is this process's own
  const scenario::Loaded& loaded = ready.loaded;
  const section::MemoryNeed memory = section::memory_need(loaded);
  if (options.check_only) {
    if (!options.quiet)
      put("{}: valid, {}, {} sections, at most about {} of memory\n", options.scenario,
          loaded.scenario.motion ? fmt::format("{} samples", loaded.trajectory.samples()) : "no motion", loaded.scenario.sections.size(),
          section::memory_words(memory.bytes()));
    return all_well;
  }
  if (!options.shard) require_memory(memory, options.max_memory);  // a share of the work holds its own chunks alone
  const std::string folder = options.out.empty() ? std::filesystem::path(options.scenario).stem().string() + "-report" : options.out;
  const std::filesystem::path kept = chunks_of(options, folder);
  std::optional<chunks::Shard> shard = options.shard;
  chunks::Dealer* dealer = shard ? &*shard : options.dealer;
  chunks::Account account;
  Terminal terminal(options.quiet);
  const section::Progress progress{[&](const std::string& what) { terminal.say(what); },
                                   [&] {
                                     if (stop()) throw document::Interrupted("interrupted");
                                   },
                                   {.folder = kept,
                                    .of_run = meaning_of(ready),
                                    .known = options.resume || options.merge || dealer != nullptr,
                                    .computes = !options.merge || options.resume,
                                    .dealer = dealer,
                                    .account = &account},
                                   ""};
  if (dealer != nullptr && !dealer->collects()) {
    section::share_work(loaded, progress);
    ready.put_back();
    terminal.clear();
    tell_account(account, kept);
    if (!options.quiet && shard)
      put("{} computed, {} were there; in {}\n", section::plural(static_cast<int>(account.computed), "chunk"), account.found,
          kept.string());
    return all_well;
  }
  document::StagedFolder staged(folder);  // a folder that cannot be written is told before minutes are spent on what goes there
  const document::Report report =
      document::arranged(section::make_report(loaded, PMREPORT_VERSION, ready.catalog.find(loaded.scenario.mechanism)->build, progress),
                         level_of(loaded.scenario.detail));
  ready.put_back();
  terminal.say("writing " + folder);
  document::write(report, staged, stop);
  std::error_code none_there;
  if (options.chunks.empty()) std::filesystem::remove_all(kept, none_there);
  terminal.clear();
  tell_account(account, kept);
  if (!options.quiet) print_verdict(report, folder);
  print_annotations(report, options.scenario);
  const bool as_before = !baseline || agrees(report, folder, *baseline, options);
  return report.passed() && as_before ? all_well : gate_failed;
}

}  // namespace pmreport::program
