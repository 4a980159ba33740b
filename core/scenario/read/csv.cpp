#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <core/scenario/read/csv.hpp>
#include <core/text/text.hpp>
#include <fstream>

namespace pmreport::scenario {
namespace {

constexpr std::size_t largest_table = 256u << 20;  // [bytes]: a million rows of twelve columns in full precision
constexpr std::size_t most_columns = 1000;

struct Cell {
  std::string_view text;
  int column;  // 1-based, in characters
};

std::vector<Cell> cells_of(std::string_view line) {
  std::vector<Cell> out;
  for (std::size_t start = 0;;) {
    const std::size_t end = std::min(line.find(',', start), line.size());
    const std::string_view whole = line.substr(start, end - start), cell = trim(whole);
    const std::size_t offset = cell.empty() ? start : static_cast<std::size_t>(cell.data() - line.data());
    out.push_back({cell, static_cast<int>(characters(line.substr(0, offset))) + 1});
    if (end == line.size() || out.size() > most_columns) return out;
    start = end + 1;
  }
}

class TableParser {
 public:
  TableParser(const std::string& name, Diagnostics& diagnostics) : diagnostics_(diagnostics) { table_.file = name; }

  std::optional<NumberTable> parse(std::string_view text, std::size_t most_rows) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    for (; !text.empty() && !stop_; ++line_) {
      const std::size_t end = text.find('\n');
      current_ = text.substr(0, end);
      text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
      if (trim(current_).empty()) continue;
      if (table_.columns.empty())
        header();
      else if (table_.lines.size() == most_rows) {
        refuse(1, fmt::format("expected at most {} rows", most_rows));
        stop_ = true;
      } else
        row();
    }
    if (!wrong_ && table_.lines.size() < 2) {
      diagnostics_.add(Diagnostic{table_.file,
                                  0,
                                  0,
                                  fmt::format("expected a header and at least two rows, seen {}", table_.lines.empty() ? "none" : "one"),
                                  {},
                                  {}});
      return std::nullopt;
    }
    return wrong_ ? std::nullopt : std::optional(std::move(table_));
  }

 private:
  void header() {
    stop_ = true;  // without a header no row means anything
    const auto cells = cells_of(current_);
    if (cells.size() > most_columns) return refuse(1, fmt::format("expected at most {} columns", most_columns));
    for (const Cell& cell : cells) {
      std::string_view text = cell.text;
      if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
      const std::size_t open = text.find('[');
      if (open == std::string_view::npos || text.back() != ']')
        return refuse(cell.column, "expected a name with its unit in brackets (e.g. \"t [s]\"), seen " + in_quotes(cell.text));
      const std::string_view written = text.substr(open + 1, text.size() - open - 2);
      const auto unit = parse_unit(written);
      if (!unit) return refuse_unit(cell, written);
      table_.columns.push_back({std::string(trim(text.substr(0, open))), *unit, {line_, cell.column}, {}});
    }
    stop_ = false;
  }

  void refuse_unit(const Cell& cell, std::string_view written) {
    const std::string unknown = unknown_unit_in(written);
    if (unknown.empty())
      refuse(cell.column, fmt::format("expected a unit in brackets (e.g. \"[mm/s^2]\"), seen {}", in_quotes(cell.text)));
    else
      refuse(cell.column,
             fmt::format("unknown unit {} in {}{}", in_quotes(unknown), in_quotes(cell.text), did_you_mean(unknown, unit_symbols())),
             "the units are " + listed(unit_symbols(), "and"));
  }

  void row() {
    const auto cells = cells_of(current_);
    if (cells.size() != table_.columns.size())
      return refuse(1, fmt::format("expected {} numbers as in the header, seen {}", table_.columns.size(), cells.size()));
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string_view text = cells[i].text;
      const char *last = text.data() + text.size(), *first = text.data() + (text.starts_with('+') ? 1 : 0);
      double value = 0;
      const auto [end, error] = std::from_chars(first, last, value);
      const Unit& unit = table_.columns[i].unit;
      if (error != std::errc{} || end != last || !std::isfinite(value) || !std::isfinite(value * unit.factor))
        return refuse(cells[i].column,
                      text.empty() ? "expected a number, seen an empty cell" : "expected a finite number, seen " + in_quotes(text));
      table_.columns[i].values.push_back(value * unit.factor);
    }
    table_.lines.push_back(line_);
  }

  void refuse(int column, std::string message, std::string hint = {}) {
    diagnostics_.add(Diagnostic{table_.file, line_, column, std::move(message), line_of(current_, 1), std::move(hint)});
    wrong_ = true;
    stop_ = stop_ || diagnostics_.full();
  }

  Diagnostics& diagnostics_;
  NumberTable table_;
  std::string_view current_;
  int line_ = 1;
  bool wrong_ = false, stop_ = false;
};

}  // namespace

std::optional<std::string> read_file(const std::filesystem::path& file, std::size_t most) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;  // a pipe would keep whoever opens it waiting
  std::ifstream in(file, std::ios::binary);
  const auto size = std::filesystem::file_size(file, error);
  if (!in || error || size > most) return std::nullopt;
  std::string text(size, '\0');
  in.read(text.data(), static_cast<std::streamsize>(size));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

std::optional<NumberTable> read_number_table(const std::filesystem::path& file, const std::string& name, std::size_t most_rows,
                                             Diagnostics& diagnostics) {
  const auto text = read_file(file, largest_table);
  if (!text) {
    diagnostics.add(Diagnostic{name, 0, 0, fmt::format("expected a readable file of at most {} MiB", largest_table >> 20), {}, {}});
    return std::nullopt;
  }
  return TableParser(name, diagnostics).parse(*text, most_rows);
}

}  // namespace pmreport::scenario
