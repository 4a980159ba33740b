// Where each thing of a report is found: the names of its files and the anchors of its sections. Ids may hold anything; names are plain
// ASCII, good at once as file name, address and anchor, and differ by more than case, so that a report unpacks on every system.
#pragma once

#include <reports/document/report.hpp>

namespace pmreport::document {

struct Names {                        // each list in the order in which the things occur
  std::vector<std::string> sections;  // anchors in report.html
  std::vector<std::string> figures;   // figures/<name>.svg and .pdf
  std::vector<std::string> pictures;  // snapshots/<name>.png
  std::vector<bool> drawn;            // which of them are there as .pdf and .svg too
  std::vector<std::string> data;      // data/<name>.csv
  std::vector<std::string> files;     // data/<name>, with their extensions
};
Names names_of(const Report& r);

// Every file of the report, "figures/displacement.svg", in the order in which they are written: results.json, which lists them, is the
// last.
std::vector<std::string> files_of(const Names& names);

// The CSV behind a figure as the file's name, "data/displacement.csv"; empty when the report has no such data.
std::string data_file(const Report& r, const Names& names, const figure::Figure& f);

std::vector<const figure::Figure*> figures_of(const Report& r);
std::vector<const Picture*> pictures_of(const Report& r);  // the cover first

}  // namespace pmreport::document
