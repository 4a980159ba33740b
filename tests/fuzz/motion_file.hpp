// What holds for every file of a motion: it is one, of numbers throughout and through all of its rows, or refused with a reason.
#pragma once

#include <core/scenario/loaded.hpp>
#include <core/scenario/read/csv.hpp>
#include <reports/section/kinds.hpp>
#include <tests/fuzz/scratch.hpp>
#include <tests/given/stage.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace fuzz {

inline std::string broken_by_table(const pmreport::scenario::NumberTable& table) {
  if (table.columns.empty() || table.lines.size() < 2) return "a table of fewer rows than two";
  for (const auto& column : table.columns) {
    if (column.values.size() != table.lines.size()) return "a column of another length";
    if (!std::ranges::all_of(column.values, [](double x) { return std::isfinite(x); })) return "a number that is not finite";
  }
  if (!std::ranges::is_sorted(table.lines, std::ranges::less_equal())) return "rows out of their order";
  return {};
}

inline std::string broken_by_motion_file(const std::string& bytes) {
  using namespace pmreport::scenario;
  static const Scratch folder;
  const std::filesystem::path file = folder.put("motion.csv", bytes);
  Diagnostics mistakes("motion.csv", bytes);
  const auto table = read_number_table(file, "motion.csv", 1000, mistakes);
  if (!table) return mistakes.empty() ? "a refusal without a reason" : "";
  if (const std::string broken = broken_by_table(*table); !broken.empty()) return broken;
  for (const char* more : {"", "samples = 7\nprofile = \"quintic\"\n"}) {
    const std::string text = std::string("title = \"a\"\n[mechanism]\nuse = \"stage\"\n[motion]\nfile = \"motion.csv\"\n") + more +
                             "[[section]]\nkind = \"displacement\"\n";
    try {
      const Loaded loaded = load_text(text, folder.path() / "a.toml", stage::source(), pmreport::section::kinds());
      const auto& m = loaded.trajectory;
      for (const Eigen::MatrixXd* part : {&m.value, &m.rate, &m.acceleration})
        if (part->rows() != static_cast<Eigen::Index>(m.time.size()) || !part->allFinite()) return "a motion that is not finite";
      // Every row of the file is a sample of its own; a coordinate that the file has is that of the row.
      if (*more != '\0') continue;
      if (m.time.size() != table->lines.size()) return "a motion of other samples than the file's rows";
      for (const auto& column : table->columns) {
        double size = 0;  // all rows have a share in each number of a spline, and in its rounding
        for (const double x : column.values) size = std::max(size, std::abs(x));
        for (std::size_t k = 0; column.name == "x" && k < m.time.size(); ++k)
          if (std::abs(m.value(static_cast<Eigen::Index>(k), 0) - column.values[k]) > 1e-12 * size)
            return "a motion that does not pass through a row of its file";
      }
    } catch (const ScenarioError& e) {
      if (e.diagnostics.empty()) return "a refusal without a reason";
      for (const Diagnostic& d : e.diagnostics)
        if (has_control(to_string(d), "\n\t")) return "a control character in a sentence to the user";
    }
  }
  return {};
}

}  // namespace fuzz
