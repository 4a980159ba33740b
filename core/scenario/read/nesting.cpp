#include <algorithm>
#include <core/scenario/read/nesting.hpp>
#include <core/text/text.hpp>

namespace pmreport::scenario {
namespace {

Place place_at(std::string_view text, std::size_t at) {
  const std::string_view before = text.substr(0, at);
  const auto newline = before.rfind('\n');
  const std::size_t start = newline == std::string_view::npos ? 0 : newline + 1;
  int line = 1;
  for (const char c : before) line += c == '\n';
  return {line, static_cast<int>(characters(before.substr(start))) + 1};
}

// Past the string that begins at `at`. One on a single line that is not closed ends with the line: the parser will tell.
std::size_t end_of_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string_view fence = text.substr(at, 3);
  const bool long_one = fence == std::string_view("\"\"\"") || fence == std::string_view("'''");
  for (std::size_t i = at + (long_one ? 3 : 1); i < text.size(); ++i) {
    if (text[i] == '\\' && quote == '"')
      ++i;
    else if (text[i] == '\n' && !long_one)
      return i;
    else if (text[i] == quote && !long_one)
      return i + 1;
    else if (long_one && text.substr(i, 3) == fence)
      return i + 3;
  }
  return text.size();
}

}  // namespace

// Outside strings and comments, points that follow each other without = , [ ] { } or the end of a line between them belong to one key; a
// number has one at most.
std::optional<Place> too_deep(std::string_view text) {
  int brackets = 0, points = 0;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      i = end_of_string(text, i);
      continue;
    }
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    if (c == '.') {
      ++points;
    } else if (c == '[' || c == '{') {
      ++brackets;
      points = 0;
    } else if (c == ']' || c == '}') {
      brackets = std::max(0, brackets - 1);
      points = 0;
    } else if (c == '=' || c == ',' || c == '\n') {
      points = 0;
    }
    if (brackets > deepest_nesting || points >= deepest_nesting) return place_at(text, i);
    ++i;
  }
  return std::nullopt;
}

}  // namespace pmreport::scenario
