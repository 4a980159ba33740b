// What came of several scenarios, on one page and as JSON.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace pmreport::program {

struct Outcome {
  std::string scenario;  // its file's name
  std::string folder;    // of the report, beside the index
  int status = 0;        // the exit status of its run
  std::string error;     // what the run told, where it made no report
  // of the report, where there is one
  std::string title, mechanism, mechanism_title, thumbnail, thumbnail_words;  // thumbnail: a PNG; empty: there is none
  std::map<std::string, int> checks, evidence;                                // by verdict, as in results.json; "total"

  bool made() const { return status <= 1; }
  const char* verdict() const { return status == 0 ? "passed" : status == 1 ? "failed" : "error"; }
};

// One file, no script, nothing loaded; those that did not pass come first.
std::string index_html(const std::vector<Outcome>& outcomes);
// index.json: in the order in which they were given.
std::string index_json(const std::vector<Outcome>& outcomes);

// Whether a page is such an index.
bool is_index(const std::string& html);

// "3 reports: 1 passed, 1 failed, 1 without a report"
std::string tally_of(const std::vector<Outcome>& outcomes);

}  // namespace pmreport::program
