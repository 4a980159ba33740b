// pmreport approve: the results of a report become the baseline that later ones are held against. Nothing else ever writes one.
#include <reports/program/commands.hpp>
#include <reports/program/terminal.hpp>

#include <reports/compare/replaced_file.hpp>
#include <reports/compare/words.hpp>

#include <core/text/text.hpp>

#include <fmt/core.h>

#include <filesystem>

namespace pmreport::program {

namespace {

namespace fs = std::filesystem;

// What stands in the place of the new baseline must be an earlier one, if anything.
compare::Results earlier(const fs::path& baseline, const std::string& bytes) {
  try {
    return compare::read_results(bytes, baseline.string());
  } catch (const compare::InputError& e) {
    throw compare::InputError(fmt::format("{}. Only an earlier baseline is replaced: choose another name, or remove this file", e.what()));
  }
}

}  // namespace

int approve(const Options& options) {
  const fs::path source = compare::results_file(options.names.at(0)), baseline = options.names.at(1);
  const std::string name = printable(baseline.string()), bytes = compare::bytes_of_results(source);
  const compare::Results fresh = compare::read_results(bytes, source.string());
  if (!fresh.passed && !options.failed_too) {
    tell("error: {}: the report did not pass, and is no baseline; --failed approves it all the same\n", printable(source.string()));
    return gate_failed;
  }
  std::error_code ignored;
  if (fs::is_directory(baseline, ignored))
    throw compare::InputError(fmt::format("{}: expected the name of a file for the baseline; seen a folder", name));
  if (fs::equivalent(source, baseline, ignored))
    throw compare::InputError(fmt::format("{}: the report itself cannot be its baseline; choose another name", name));
  if (!fs::exists(fs::status(baseline, ignored))) {
    compare::replace_file(baseline, bytes);
    if (!options.quiet) put("{}: new baseline of {} values and {} verdicts\n", name, fresh.values.size(), fresh.judgements.size());
    return all_well;
  }
  const std::string old_bytes = compare::bytes_of_results(baseline);
  const std::vector<compare::Results> both{earlier(baseline, old_bytes), fresh};
  if (old_bytes != bytes) compare::replace_file(baseline, bytes);
  if (options.quiet) return all_well;
  if (old_bytes == bytes)
    put("{}: is this very baseline; nothing changed\n", name);
  else
    put("{}{}: replaced; above, A is the baseline until now, B the new one\n",
        compare::to_text(compare::compare(both, {options.relative, options.absolute})), name);
  return all_well;
}

}  // namespace pmreport::program
