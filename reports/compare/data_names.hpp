// What results.json says of the files in data/.
#pragma once

#include <string>
#include <vector>

namespace pmreport::compare {

constexpr const char* time_heading = "t [s]";  // the first column of what is a curve

struct DataName {
  std::string name, csv;  // "displacement", "data/displacement.csv", as anybody may have written them
};

// Throws InputError, as read_results.
std::vector<DataName> data_names(const std::string& text, const std::string& label);

}  // namespace pmreport::compare
