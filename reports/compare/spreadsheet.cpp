#include <reports/compare/data_names.hpp>
#include <reports/compare/spreadsheet.hpp>

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>

namespace pmreport::compare {

namespace {

// Takes one cell off the front of `rest`; true while the line goes on behind it. Fields as in RFC 4180, lines end in LF or CRLF.
bool take_cell(std::string_view& rest, std::string& cell, int line) {
  cell.clear();
  if (rest.starts_with('"')) {
    std::size_t at = 1;
    while (true) {
      const std::size_t quote = rest.find('"', at);
      if (quote == std::string_view::npos) throw SpreadsheetError(fmt::format("line {}: a quoted cell has no end", line));
      cell.append(rest, at, quote - at);
      at = quote + 1;
      if (at >= rest.size() || rest[at] != '"') break;
      cell += '"';
      ++at;
    }
    rest.remove_prefix(at);
  } else {
    const std::size_t end = std::min(rest.find_first_of(",\n"), rest.size());
    cell.assign(rest, 0, end);
    rest.remove_prefix(end);
    if (!cell.empty() && cell.back() == '\r') cell.pop_back();
  }
  if (rest.starts_with('\r')) rest.remove_prefix(1);
  if (rest.empty()) return false;
  const char next = rest.front();
  if (next != ',' && next != '\n') throw SpreadsheetError(fmt::format("line {}: expected a comma behind a quoted cell", line));
  rest.remove_prefix(1);
  return next == ',';
}

double number_in(const std::string& cell, int line) {
  if (cell.empty()) return std::numeric_limits<double>::quiet_NaN();
  double out = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), out);
  if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(out))
    throw SpreadsheetError(fmt::format("line {}: expected a number or nothing in each cell", line));
  return out;
}

}  // namespace

bool is_a_course(const std::vector<double>& time) {
  for (std::size_t i = 0; i < time.size(); ++i)
    if (!std::isfinite(time[i]) || (i > 0 && time[i] < time[i - 1])) return false;
  return true;
}

std::optional<Curves> read_curves(std::string_view csv, const std::string& section) {
  std::string cell;
  std::vector<std::string> headings;
  if (csv.empty()) throw SpreadsheetError("expected a heading; the file is empty");
  while (true) {
    const bool more = take_cell(csv, cell, 1);
    headings.push_back(cell);
    if (!more) break;
  }
  if (headings.front() != time_heading) return std::nullopt;
  std::vector<std::vector<double>> columns(headings.size());
  for (int line = 2; !csv.empty(); ++line) {
    std::size_t count = 0;
    bool more = true;
    while (more) {
      more = take_cell(csv, cell, line);
      if (count < columns.size()) columns[count].push_back(number_in(cell, line));
      ++count;
    }
    if (count != columns.size()) throw SpreadsheetError(fmt::format("line {}: expected {} cells; seen {}", line, columns.size(), count));
  }
  if (!is_a_course(columns.front())) return std::nullopt;
  Curves out{section, {headings.begin() + 1, headings.end()}, std::move(columns.front()), {}};
  out.columns.assign(std::make_move_iterator(columns.begin() + 1), std::make_move_iterator(columns.end()));
  return out;
}

}  // namespace pmreport::compare
