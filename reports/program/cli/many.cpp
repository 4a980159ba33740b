// pmreport SCENARIO SCENARIO ...: a report of each, in one folder with an index. Each is made by a process of its own, one after the other,
// so that none takes the others along.
#include <core/text/text.hpp>
#include <reports/compare/replaced_file.hpp>
#include <reports/document/data/results.hpp>
#include <reports/document/folder/file.hpp>
#include <reports/document/narrowed.hpp>
#include <reports/document/text.hpp>
#include <reports/program/cli/child.hpp>
#include <reports/program/cli/index_of_reports.hpp>
#include <reports/program/commands.hpp>
#include <reports/program/terminal.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

namespace pmreport::program {

namespace fs = std::filesystem;

namespace {

constexpr int thumbnail_width = 420;         // [px]: wider than a card on most screens
constexpr std::size_t longest_error = 4000;  // [bytes], of what a card shows

std::string bytes_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Names of the reports' folders: the stems of their scenarios, of equal ones the second with -2.
std::vector<std::string> folders_of(const std::vector<std::string>& scenarios) {
  std::set<std::string> taken{"index.html", "index.json"};
  std::vector<std::string> out;
  for (const std::string& s : scenarios) {
    std::string stem = fs::path(s).stem().string();
    if (stem.empty() || stem == "." || stem == "..") stem = "report";
    std::string name = stem;
    for (int n = 2; !taken.insert(name).second; ++n) name = fmt::format("{}-{}", stem, n);
    out.push_back(std::move(name));
  }
  return out;
}

// An index is written over an earlier one alone, and not into a report.
void refuse_foreign(const fs::path& folder) {
  if (document::files_listed_in(bytes_of(folder / "results.json")))
    throw document::OutputError(fmt::format("{} is a report; choose another folder for several", folder.string()));
  std::error_code error;
  if (fs::exists(folder / "index.html", error) && !is_index(bytes_of(folder / "index.html")))
    throw document::OutputError(
        fmt::format("{} is no index of reports; choose another folder, or move it away", (folder / "index.html").string()));
}

std::string without_line_end(std::string text) {
  while (text.ends_with('\n')) text.pop_back();
  return text;
}

// What the report says of itself.
void read_results(const fs::path& folder, Outcome& out) {
  const auto results = nlohmann::json::parse(bytes_of(folder / "results.json"));
  out.title = results.at("title");
  out.mechanism = results.at("mechanism").at("name");
  out.mechanism_title = results.at("mechanism").at("title");
  for (auto [tally, name] : {std::pair{&out.checks, "checks"}, {&out.evidence, "evidence"}})
    for (const auto& [verdict, count] : results.at("verdict").at(name).items()) (*tally)[verdict] = count;
  if (results.at("snapshots").empty()) return;
  const auto& first = results.at("snapshots").front();
  out.thumbnail = document::narrowed(bytes_of(folder / first.at("png").get<std::string>()), thumbnail_width);
  out.thumbnail_words = first.at("caption");
}

// What every scenario is run with.
std::vector<std::string> shared_arguments(const Options& options) {
  std::vector<std::string> out;
  for (const fs::path& p : options.plugin_path) out.insert(out.end(), {"--plugin-path", p.string()});
  if (options.threads > 0) out.insert(out.end(), {"--threads", std::to_string(options.threads)});
  if (options.timeout > 0) out.insert(out.end(), {"--timeout", fmt::format("{}", options.timeout)});
  if (options.check_only) out.push_back("--check");
  if (options.quiet) out.push_back("--quiet");
  if (options.resume) out.push_back("--resume");
  if (!options.chunks.empty()) out.insert(out.end(), {"--chunks", options.chunks});
  if (options.max_memory) out.insert(out.end(), {"--max-memory", fmt::format("{} kB", *options.max_memory / 1e3)});
  if (options.sandbox) out.push_back("--sandbox");
  return out;
}

Outcome outcome_of(const ChildResult& run, const std::string& scenario, const fs::path& folder, bool check_only) {
  Outcome out;
  out.scenario = fs::path(scenario).filename().string();
  out.folder = folder.filename().string();
  out.status = run.status;
  if (!out.made()) out.error = without_line_end(run.told.substr(0, longest_error));
  if (!out.made() || check_only) return out;
  try {
    read_results(folder, out);
  } catch (const nlohmann::json::exception& e) {  // somebody else was at it
    out.status = output_failed;
    out.error = fmt::format("{} cannot be read: {}", (folder / "results.json").string(), e.what());
  }
  return out;
}

}  // namespace

int many(const Options& options, bool (*stop)()) {
  const auto is_there = [](const std::string& s) {
    std::error_code error;
    return fs::exists(s, error);
  };
  // Two words that are no files are more likely a command that is misspelt.
  if (std::ranges::none_of(options.scenarios, is_there)) {
    tell("error: expected scenarios, and there is no file {}; `pmreport --help` lists the commands\n",
         listed(options.scenarios, "and", true));
    return bad_scenario;
  }
  if (!options.baseline.empty()) {
    tell("error: a baseline is of one report, and {} scenarios are given; run each with its own --baseline\n", options.scenarios.size());
    return bad_scenario;
  }
  const fs::path folder = options.out.empty() ? "reports" : options.out;
  std::error_code error;
  if (!options.check_only) {
    fs::create_directories(folder, error);
    if (error) throw document::OutputError(fmt::format("cannot make {}: {}. Choose another folder.", folder.string(), error.message()));
    refuse_foreign(folder);
  }

  Terminal terminal(options.quiet);
  const std::vector<std::string> folders = folders_of(options.scenarios);
  std::vector<Outcome> outcomes;
  for (std::size_t i = 0; i < folders.size(); ++i) {
    terminal.say(fmt::format("{} of {}: {}", i + 1, folders.size(), printable(options.scenarios[i])));
    std::vector<std::string> arguments = shared_arguments(options);
    if (!options.check_only) arguments.insert(arguments.end(), {"--out", (folder / folders[i]).string()});
    arguments.insert(arguments.end(), {"--", options.scenarios[i]});
    const ChildResult run = run_again(arguments, stop, [&] { terminal.clear(); });
    terminal.clear();
    outcomes.push_back(outcome_of(run, options.scenarios[i], folder / folders[i], options.check_only));
  }
  int worst = all_well;
  for (const Outcome& o : outcomes) worst = std::max(worst, o.status);
  if (options.check_only) return worst;
  compare::replace_file(folder / "index.json", index_json(outcomes));
  compare::replace_file(folder / "index.html", index_html(outcomes));
  if (!options.quiet) put("{}; {}\n", tally_of(outcomes), (folder / "index.html").string());
  return worst;
}

}  // namespace pmreport::program
