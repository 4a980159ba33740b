// A finished report in every form that it is written in.
#pragma once

#include <reports/document/report.hpp>

#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace pmreport::document {

std::string to_html(const Report& r);  // one file, no network, no script needed; readable at phone width
std::string to_pdf(const Report& r);   // A4: title, contents, sections, vector figures, page numbers, outline, links
std::string to_csv(const Data& d);     // fields as in RFC 4180, lines end in LF; '.' decimal, shortest digits that read back the same
// The same in pieces of about a megabyte, whole lines each: of a long motion it would be as large as all else together.
void to_csv(const Data& d, const std::function<void(std::string_view piece)>& put);
std::string to_json(const Report& r);  // results.json
std::string to_junit(const Report& r);
std::string to_markdown(const Report& r);  // summary.md: the first page for a job's summary
// What fails, as workflow commands of GitHub Actions about this scenario: ten lines at most.
std::string to_annotations(const Report& r, const std::string& file);

// Writes everything below `folder`: made whole beside it, then renamed, so that a report is the old one or the new one, never half.
// Replaces an empty folder or an earlier report; a folder that holds anything else is refused. Throws OutputError, or Interrupted once
// `interrupted`, asked between files by the calling thread, says so; the old report is untouched then and nothing temporary is left.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};
class Interrupted : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};
void write(const Report& r, const std::string& folder, bool (*interrupted)() = nullptr);
// The same into a folder that was begun before the report was made: where it cannot be written, that is told before the work.
class StagedFolder;
void write(const Report& r, StagedFolder& staged, bool (*interrupted)());

}  // namespace pmreport::document
