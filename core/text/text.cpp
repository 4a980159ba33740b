#include <algorithm>
#include <core/text/text.hpp>

namespace pmreport {
namespace {

constexpr std::size_t longest_word = 60;

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

// Bytes of the first character of what is not empty; 0: no UTF-8 begins there.
std::size_t length_of_first(std::string_view bytes) {
  const auto lead = static_cast<unsigned char>(bytes.front());
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || bytes.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if (!continues(bytes[i])) return 0;
  const auto second = static_cast<unsigned char>(bytes[1]);
  // Written longer than need be, halves of a pair, and what is beyond the last character.
  const bool none = (lead == 0xE0 && second < 0xA0) || (lead == 0xED && second > 0x9F) || (lead == 0xF0 && second < 0x90) ||
                    (lead == 0xF4 && second > 0x8F);
  return none ? 0 : length;
}

// Damerau-Levenshtein distance, restricted: neighbours that are swapped are not edited again.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0u : 1u)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before.swap(last);
    last.swap(row);
  }
  return last[b.size()];
}

}  // namespace

std::optional<std::string> nearest(std::string_view word, const std::vector<std::string>& candidates) {
  if (word.size() > longest_word) return std::nullopt;
  const std::string* best = nullptr;
  std::size_t least = 3;
  for (const std::string& candidate : candidates) {
    if (candidate.size() > longest_word) continue;
    const std::size_t d = distance(word, candidate);
    // "x" is two edits away from "mm", yet nobody who wrote the one meant the other.
    if (d < least && d < std::max(word.size(), candidate.size())) {
      best = &candidate;
      least = d;
    }
  }
  return best != nullptr ? std::optional(*best) : std::nullopt;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
  const auto best = nearest(word, candidates);
  return best ? "; did you mean " + in_quotes(*best) + "?" : std::string();
}

std::string listed(const std::vector<std::string>& words, const char* last, bool quotes) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i)
    out += (i == 0 ? "" : i + 1 == words.size() ? std::string(" ") + last + " " : ", ") + (quotes ? in_quotes(words[i]) : words[i]);
  return out;
}

std::string in_quotes(std::string_view text) {
  std::size_t end = std::min(text.size(), longest_word);
  while (end < text.size() && end > 0 && continues(text[end])) --end;
  return "\"" + printable(text.substr(0, end)) + (end < text.size() ? "…\"" : "\"");
}

std::string printable(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const bool c0 = (byte(i) < 0x20 && text[i] != '\t') || byte(i) == 0x7F;
    const bool c1 = byte(i) == 0xC2 && byte(i + 1) >= 0x80 && byte(i + 1) <= 0x9F;
    // U+202A to U+202E and U+2066 to U+2069 turn the direction of what is read.
    const bool turns = byte(i) == 0xE2 && ((byte(i + 1) == 0x80 && byte(i + 2) >= 0xAA && byte(i + 2) <= 0xAE) ||
                                           (byte(i + 1) == 0x81 && byte(i + 2) >= 0xA6 && byte(i + 2) <= 0xA9));
    out += c0 || c1 || turns ? '?' : text[i];
    i += turns ? 3 : c1 ? 2 : 1;
  }
  return out;
}

std::string without_noncharacters(std::string_view utf8) {
  const auto byte = [&](std::size_t i) { return i < utf8.size() ? static_cast<unsigned char>(utf8[i]) : 0u; };
  std::string out;
  out.reserve(utf8.size());
  for (std::size_t i = 0; i < utf8.size();) {
    // U+FDD0 to U+FDEF are EF B7 90 to EF B7 AF; the last two of each plane end in BF BE and BF BF, their first ten bits in ones.
    const bool of_block = byte(i) == 0xEF && byte(i + 1) == 0xB7 && byte(i + 2) >= 0x90 && byte(i + 2) <= 0xAF;
    const bool of_plane_0 = byte(i) == 0xEF && byte(i + 1) == 0xBF && byte(i + 2) >= 0xBE;
    const bool of_other_plane = byte(i) >= 0xF0 && (byte(i + 1) & 0x0F) == 0x0F && byte(i + 2) == 0xBF && byte(i + 3) >= 0xBE;
    const std::size_t length = of_other_plane ? 4 : of_block || of_plane_0 ? 3 : 0;
    if (length > 0)
      out += "\xEF\xBF\xBD";  // U+FFFD
    else
      out += utf8[i];
    i += std::max<std::size_t>(length, 1);
  }
  return out;
}

std::string one_line(std::string_view bytes) {
  std::string out;
  out.reserve(bytes.size());
  while (!bytes.empty()) {
    const std::size_t length = length_of_first(bytes);
    const char c = bytes.front();
    if (length == 0)
      out += "\xEF\xBF\xBD";  // U+FFFD
    else if (c == '\n' || c == '\r' || c == '\t')
      out += ' ';
    else
      out += bytes.substr(0, length);
    bytes.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return printable(without_noncharacters(out));
}

std::size_t characters(std::string_view utf8) {
  return static_cast<std::size_t>(std::count_if(utf8.begin(), utf8.end(), [](char c) { return !continues(c); }));
}

std::string_view trim(std::string_view text) {
  constexpr const char* blank = " \t\r";
  const auto first = text.find_first_not_of(blank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

}  // namespace pmreport
