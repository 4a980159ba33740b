#include <charconv>
#include <cmath>
#include <reports/document/text.hpp>
#include <reports/document/write.hpp>

namespace pmreport::document {

namespace {

// A spreadsheet runs a cell that starts like a formula; the apostrophe makes it text.
std::string text_cell(const std::string& raw) {
  std::string text = clean(raw);
  if (!text.empty() && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos) text.insert(0, "'");
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

void append(std::string& out, double number) {
  if (!std::isfinite(number)) return;
  char digits[32];
  const auto [end, error] = std::to_chars(digits, digits + sizeof digits, number);
  out.append(digits, end);
}

}  // namespace

std::string to_csv(const Data& d) {
  std::string out;
  to_csv(d, [&](std::string_view piece) { out += piece; });
  return out;
}

void to_csv(const Data& d, const std::function<void(std::string_view piece)>& put) {
  constexpr std::size_t enough = 1 << 20;
  const std::size_t words = d.words.size(), columns = words + d.columns.size();
  const std::size_t rows = words > 0 ? d.words.front().size() : columns > 0 ? d.columns.front().size() : 0;
  if (d.headings.size() != columns) throw std::logic_error("data " + d.name + ": one heading a column");
  const auto equally_long = [&](const auto& column) {
    if (column.size() != rows) throw std::logic_error("data " + d.name + ": columns are not equally long");
  };
  for (const auto& column : d.words) equally_long(column);
  for (const auto& column : d.columns) equally_long(column);
  std::string out;
  for (std::size_t c = 0; c < columns; ++c) out += (c ? "," : "") + text_cell(d.headings[c]);
  out += '\n';
  for (std::size_t row = 0; row < rows; ++row) {
    const std::size_t start = out.size();
    for (std::size_t c = 0; c < columns; ++c) {
      if (c) out += ',';
      if (c < words)
        out += text_cell(d.words[c][row]);
      else
        append(out, d.columns[c - words][row]);
    }
    if (out.size() == start) out += "\"\"";  // a lone empty cell would be an empty line, which readers skip
    out += '\n';
    if (out.size() < enough) continue;
    put(out);
    out.clear();
  }
  if (!out.empty()) put(out);
}

}  // namespace pmreport::document
