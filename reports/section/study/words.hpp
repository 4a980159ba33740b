// Numbers of variants as tables, sentences, values and data files have them.
#pragma once

#include <core/analysis/design/trials.hpp>
#include <core/text/units.hpp>
#include <reports/document/report.hpp>
#include <reports/section/study/options.hpp>

#include <string>
#include <vector>

namespace pmreport::section {

using analysis::Bracketed;
using analysis::Judged;

// Of several variants, the numbers of one of the measures: in the unit that reads best for all of them.
DisplayUnit unit_of(const StudyOptions& o, std::size_t number, const std::vector<const Judged*>& all);
DisplayUnit unit_of(const StudiedParameter& p);

// "0.0670", "0.06694 … 0.06702"; a dash where there is none.
std::string cell(const Bracketed& x, const DisplayUnit& unit);
std::string cell(const std::vector<Bracketed>& numbers, std::size_t number, const DisplayUnit& unit);
std::string with_unit(const Bracketed& x, const std::string& unit);
std::string heading(const std::string& name, const DisplayUnit& unit);  // "volume [m³]"
// A variant by its parameters: "base_radius = 250 mm, home_height = 300 mm".
std::string place_of(const StudyOptions& o, const std::vector<double>& values);
// Notes of a variant, or why it has no numbers.
std::string remark(const Judged& j);
// What is known of a difference: "12 % more", "not told apart".
std::string change(const Bracketed& now, const Bracketed& before);

// Variants that could not be judged, by reason: "5 of 7 variants could not be made or judged: the home pose cannot be assembled (4), ...".
// Nothing where all were.
std::string failures(const std::vector<const Judged*>& all);

// Variants whose workspace goes up to the end of the scanned range. Nothing where none does.
std::string cut_off(const std::vector<const Judged*>& all);

// Columns of the numbers, each with its two ends where any has a bracket.
void add_columns(const StudyOptions& o, const std::vector<const Judged*>& all, document::Data& data);

const std::string& title_of(const StudyOptions& o, std::size_t number);  // "volume of the workspace", for sentences
const std::string& label_of(const StudyOptions& o, std::size_t number);  // "volume", for axes and headings

}  // namespace pmreport::section
