// What the program prints on standard output.
#pragma once

#include <core/mechanics/model/machine.hpp>
#include <reports/document/report.hpp>

#include <string>

namespace pmreport::program {

std::string describe_text(const mechanics::Machine& machine);
std::string describe_json(const mechanics::Machine& machine);

// Verdict, failures, and where the report is.
void print_verdict(const document::Report& report, const std::string& folder);

}  // namespace pmreport::program
