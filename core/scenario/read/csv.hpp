// A table of numbers beside the scenario: comma-separated, a header of names with units in brackets, "t [s], x [mm]", then one row a line.
#pragma once

#include <core/scenario/read/diagnostics.hpp>
#include <core/text/units.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pmreport::scenario {

struct NumberColumn {
  std::string name;
  Unit unit;
  Place place;                 // of its header
  std::vector<double> values;  // SI
};

struct NumberTable {
  std::string file;
  std::vector<NumberColumn> columns;
  std::vector<int> lines;  // of each row
};

// Reads the file, shown to the user as `name`. What is wrong with it goes to `diagnostics`, and nothing is returned.
std::optional<NumberTable> read_number_table(const std::filesystem::path& file, const std::string& name, std::size_t most_rows,
                                             Diagnostics& diagnostics);

// The whole of a file, or nothing when it cannot be read. `most`: its largest size [bytes].
std::optional<std::string> read_file(const std::filesystem::path& file, std::size_t most);

}  // namespace pmreport::scenario
