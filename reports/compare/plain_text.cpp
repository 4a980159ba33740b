// A comparison on standard output.
#include <reports/compare/words.hpp>

#include <core/text/text.hpp>

#include <algorithm>

namespace pmreport::compare {

namespace {

// Columns as wide as their widest cell, two spaces between them, none behind the last word. Nobody's terminal shall obey a title.
std::string aligned(const document::Table& table) {
  std::vector<std::vector<std::string>> lines{table.headings};
  lines.insert(lines.end(), table.rows.begin(), table.rows.end());
  for (auto& line : lines)
    for (std::string& cell : line) {
      cell = printable(cell);
      std::ranges::replace(cell, '\t', ' ');
    }
  std::vector<std::size_t> widths(table.headings.size(), 0);
  for (const auto& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], characters(line[i]));
  std::string out = table.caption.empty() ? "" : printable(table.caption) + "\n";
  for (const auto& line : lines) {
    std::string text = table.caption.empty() ? "" : "  ";
    for (std::size_t i = 0; i < line.size(); ++i) {
      const std::string room(widths[i] - characters(line[i]), ' ');
      text += (i > 0 ? "  " : "") + (table.numeric[i] ? room + line[i] : line[i] + room);
    }
    text.erase(text.find_last_not_of(' ') + 1);
    out += text + "\n";
  }
  return out + "\n";
}

}  // namespace

std::string to_text(const Comparison& c) {
  std::string out = aligned(reports_table(c));
  const auto add = [&](const std::vector<document::Table>& tables) {
    for (const document::Table& table : tables) out += aligned(table);
  };
  const std::vector<std::string> all = remarks(c);
  for (const std::string& remark : all) out += printable(remark) + "\n";
  if (!all.empty()) out += "\n";
  add(value_tables(c));
  add(judgement_tables(c));
  add(curve_tables(c));
  add(lone_tables(c));
  return out + verdict(c) + "\n";
}

}  // namespace pmreport::compare
