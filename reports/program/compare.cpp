// pmreport compare: reports held against each other.
#include <reports/program/commands.hpp>
#include <reports/program/terminal.hpp>

#include <reports/compare/page.hpp>
#include <reports/compare/replaced_file.hpp>
#include <reports/compare/words.hpp>
#include <reports/document/folder/staged_folder.hpp>
#include <reports/section/kinds.hpp>
#include <reports/section/make_report.hpp>

#include <core/scenario/loaded.hpp>

#include <fmt/core.h>

#include <filesystem>
#include <fstream>

namespace pmreport::program {

namespace {

namespace fs = std::filesystem;

bool is_scenario(const std::string& given) {
  std::error_code ignored;
  return fs::path(given).extension() == ".toml" && !fs::is_directory(given, ignored);
}

// The report of a scenario, which is compared and written nowhere.
compare::Results made(const std::string& scenario, const host::Catalog& catalog, Terminal& terminal, bool (*stop)()) {
  const scenario::Loaded loaded = scenario::load(scenario, source_of(catalog), section::kinds());
  const section::Progress progress{[&](const std::string& what) { terminal.say(scenario + ": " + what); },
                                   [&] {
                                     if (stop()) throw document::Interrupted("interrupted");
                                   }};
  return compare::results_of(section::make_report(loaded, PMREPORT_VERSION, catalog.find(loaded.scenario.mechanism)->build, progress),
                             scenario);
}

// Whether a page says in its head that it was made by this program.
bool is_ours(const fs::path& page) {
  std::ifstream file(page, std::ios::binary);
  std::string head(4096, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  return head.find("<meta name=\"generator\" content=\"pmreport ") != std::string::npos;
}

// A report replaces its folder only when nothing else is in it: a page beside it would be in the way of the next one.
void write_page(const std::string& folder, const std::string& page) {
  std::error_code error;
  const fs::path place = fs::absolute(folder, error).lexically_normal();
  if (error) document::fail("reach", folder, error.value());
  if (fs::exists(place / "results.json", error))
    throw document::OutputError("cannot write the comparison into " + folder + ": it holds a report. Choose another folder.");
  if (fs::exists(place / "compare.html", error) && !is_ours(place / "compare.html"))
    throw document::OutputError("cannot write the comparison into " + folder +
                                ": compare.html in it is no comparison of pmreport. Choose another folder.");
  document::MadeParents made(place / "compare.html");
  compare::replace_file(place / "compare.html", page);
  made.keep();
}

}  // namespace

int compare(const Options& options, bool (*stop)()) {
  std::vector<compare::Results> reports(options.names.size());
  bool any_scenario = false;
  for (std::size_t i = 0; i < reports.size(); ++i) {  // first what takes no time, and may be told to be wrong
    if (is_scenario(options.names[i]))
      any_scenario = true;
    else
      reports[i] = compare::read_report(options.names[i]);
  }
  if (any_scenario) {
    const host::Catalog catalog(host::search_folders(options.plugin_path));
    tell_refused(catalog);
    Terminal terminal(options.quiet);
    for (std::size_t i = 0; i < reports.size(); ++i)
      if (is_scenario(options.names[i])) reports[i] = made(options.names[i], catalog, terminal, stop);
  }
  const compare::Comparison comparison = compare::compare(reports, {options.relative, options.absolute});
  if (!options.out.empty()) write_page(options.out, compare::to_html(comparison, PMREPORT_VERSION));
  if (!options.quiet) put("{}", compare::to_text(comparison));
  return comparison.agree ? all_well : gate_failed;
}

}  // namespace pmreport::program
