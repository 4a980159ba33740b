// The first page: what matters most of a report whose sections are made, drawn from what was computed.
#pragma once

#include <core/analysis/study/between_samples.hpp>
#include <reports/document/report.hpp>
#include <reports/section/common/analysis.hpp>
#include <reports/section/common/words/proof_words.hpp>

#include <vector>

namespace pmreport::section {

// Fills findings, key numbers, summary, assumptions and what was not asked. `of_sections`: what the sections found.
void put_front(document::Report& r, const Analysis& a, const Proved& p, const std::vector<analysis::Unseen>& unseen,
               std::vector<document::Finding> of_sections);

}  // namespace pmreport::section
