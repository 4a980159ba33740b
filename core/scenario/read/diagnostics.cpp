#include <fmt/format.h>

#include <algorithm>
#include <core/scenario/read/diagnostics.hpp>
#include <core/text/text.hpp>

namespace pmreport::scenario {
namespace {

constexpr std::size_t longest_line = 400;  // [bytes]; a caret under more than that helps nobody

std::string_view raw_line(std::string_view text, int number) {
  for (int line = 1; line < number; ++line) {
    const auto end = text.find('\n');
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + 1);
  }
  return text.substr(0, text.find('\n'));
}

std::string all_of(const std::vector<Diagnostic>& diagnostics) {
  std::string out;
  for (const Diagnostic& d : diagnostics) out += (out.empty() ? "" : "\n") + to_string(d);
  return out;
}

}  // namespace

std::string line_of(std::string_view text, int number) {
  if (number < 1) return {};
  std::string_view line = raw_line(text, number);
  if (number == 1 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);  // a byte order mark has no column
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line.size() > longest_line ? std::string() : printable(line);
}

std::string to_string(const Diagnostic& d) {
  std::string out = d.file;
  if (d.line > 0) out += fmt::format(":{}:{}", d.line, d.column);
  out += ": error: " + d.message;
  if (!d.source_line.empty()) {
    out += "\n  " + d.source_line + "\n  ";
    int column = 1;
    for (std::size_t i = 0; i < d.source_line.size() && column < d.column; ++i) {
      const bool continuation = (static_cast<unsigned char>(d.source_line[i]) & 0xC0) == 0x80;
      if (continuation) continue;
      out += d.source_line[i] == '\t' ? '\t' : ' ';
      ++column;
    }
    out += '^';
  }
  if (!d.hint.empty()) out += "\n  hint: " + d.hint;
  return out;
}

ScenarioError::ScenarioError(std::vector<Diagnostic> d) : std::runtime_error(all_of(d)), diagnostics(std::move(d)) {}

void Diagnostics::add(Place place, std::string message, std::string hint) {
  if (full()) return;
  found_.push_back({file_, place.line, place.column, std::move(message), line_of(text_, place.line), std::move(hint)});
}

void Diagnostics::add(Diagnostic diagnostic) {
  if (!full()) elsewhere_.push_back(std::move(diagnostic));
}

void Diagnostics::throw_if_any() {
  if (empty()) return;
  std::stable_sort(found_.begin(), found_.end(),
                   [](const Diagnostic& a, const Diagnostic& b) { return std::pair(a.line, a.column) < std::pair(b.line, b.column); });
  found_.insert(found_.end(), elsewhere_.begin(), elsewhere_.end());
  throw ScenarioError(std::move(found_));
}

Place Diagnostics::inside(Place value, std::string_view parsed, std::size_t offset) const {
  if (value.line < 1 || offset > parsed.size()) return value;
  std::string_view line = raw_line(text_, value.line);
  if (value.line == 1 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
  std::size_t start = 0;
  for (int column = 1; column < value.column && start < line.size(); ++column) {
    ++start;
    while (start < line.size() && (static_cast<unsigned char>(line[start]) & 0xC0) == 0x80) ++start;
  }
  const bool literal = start < line.size() && (line[start] == '"' || line[start] == '\'') && line.substr(start + 1).starts_with(parsed);
  return literal ? Place{value.line, value.column + 1 + static_cast<int>(characters(parsed.substr(0, offset)))} : value;
}

}  // namespace pmreport::scenario
