// What the program prints on standard output.
#pragma once

#include <core/mechanics/machine.hpp>
#include <reports/document/report.hpp>

#include <string>

namespace pmreport::program {

std::string describe_text(const mechanics::Machine& machine);
std::string describe_json(const mechanics::Machine& machine);

// The property suite as a table; true when everything passed.
bool print_properties(const mechanics::Machine& machine, int poses);

// Verdict, failures, and where the report is.
void print_verdict(const document::Report& report, const std::string& folder);

}  // namespace pmreport::program
