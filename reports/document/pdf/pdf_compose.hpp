// The whole report put into a flow, part after part.
#pragma once

#include <reports/document/pdf/pdf_attachments.hpp>
#include <reports/document/pdf/pdf_blocks.hpp>
#include <reports/document/pdf/pdf_front.hpp>

#include <optional>
#include <string>
#include <vector>

namespace pmreport::document::pdf {

struct Plan {
  std::vector<Entry> sections;
  std::optional<Entry> checks, files;
  Entry scenario, provenance;
  std::vector<Entry> all() const;  // in their order
};
Plan plan_of(const Composer& c);

std::string title_of(const Entry& e);  // "3  Displacement"

// Front page, contents, sections, checks, scenario, files, colophon. The flow may be finished then.
void compose(Composer& c, const Plan& plan, const Attachments& attached);

}  // namespace pmreport::document::pdf
