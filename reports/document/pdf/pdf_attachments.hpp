// The data behind the report, attached to it: one file to send, archive and compute with.
#pragma once

#include <reports/document/names.hpp>
#include <reports/document/pdf/pdf_finish.hpp>

namespace pmreport::document::pdf {

struct Attachments {
  std::vector<Attachment> files;
  // Those that are too large: the scenario's name, and where the others lie beside the report.
  std::string scenario_left_out = {};
  std::vector<std::string> left_out = {};
};

// The scenario, results.json, and every data/*.csv, as long as they take a few megabytes together.
Attachments attachments_of(const Report& r, const Names& names);

}  // namespace pmreport::document::pdf
