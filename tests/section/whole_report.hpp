// Whole reports of scenarios of mechanisms made for the tests, and where to look in one.
#pragma once

#include <reports/document/report.hpp>

#include <string>
#include <vector>

namespace pmreport::scenario {
struct MechanismSource;
}

namespace whole_report {

using namespace pmreport;

document::Report report_of(const std::string& text, const scenario::MechanismSource& source);

// Of the gantry (tests/given/gantry.hpp), x = 50 mm sin(pi t / s) over 2 s in steps of 0.1 s; `more` follows the motion.
document::Report of_gantry(const std::string& more);
// Of the stage (tests/given/stage.hpp), feeler 200 mm long, over 2 s in steps of 0.1 s: `parameters` and `motion` as in TOML.
document::Report of_stage(const std::string& parameters, const std::string& motion, const std::string& more);

// "[[section]]\nkind = ..." of each.
std::string asking_for(const std::vector<std::string>& kinds);

// Ids of the sections, in order.
std::vector<std::string> ids(const document::Report& r);
const document::Section& section_of(const document::Report& r, const std::string& id);

// A column of a data file by its heading, "x [m]".
const std::vector<double>& column_of(const document::Report& r, const std::string& data, const std::string& heading);

// Titles of the panels of the section's first figure, and one of its curves, in the units that are drawn.
std::vector<std::string> panels_of(const document::Section& s);
const figure::Panel& panel_of(const document::Section& s, const std::string& title);
const figure::Series& series_of(const document::Section& s, const std::string& panel, const std::string& label);

}  // namespace whole_report
