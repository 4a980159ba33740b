#include <reports/program/import/settings.hpp>

#include <core/scenario/diagnostic.hpp>
#include <core/text/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>

namespace pmreport::program::settings {

namespace {

constexpr std::size_t most_in_a_line = 4096, longest_shown = 80;

bool blank(char c) { return c == ' ' || c == '\t'; }

// Within a line that is no comment: from the mark to its end, where the mark stands at the beginning or behind a blank.
std::string_view without_comment(std::string_view line) {
  for (std::size_t i = 0; i < line.size(); ++i)
    if ((line[i] == '#' || line[i] == ';') && (i == 0 || blank(line[i - 1]))) return line.substr(0, i);
  return line;
}

std::optional<std::string> section_in(const Line& line) {
  const std::string_view text = trim(line.text);
  if (text.empty() || text.front() != '[') return std::nullopt;
  const std::size_t end = text.find(']');
  if (end == std::string_view::npos || end == 1)
    refuse(line.place, fmt::format("expected a section in brackets, seen {}", in_quotes(shown(text))), "write [NAME]");
  return std::string(trim(text.substr(1, end - 1)));
}

Setting setting_in(const Line& line, const std::string& section, const char* separators, const char* form) {
  const std::string_view text = trim(line.text);
  const std::size_t at = text.find_first_of(separators);
  if (at == std::string_view::npos || at == 0)
    refuse(line.place, fmt::format("expected {}, a [SECTION] or a comment; seen {}", form, in_quotes(shown(text))));
  return {section, std::string(trim(text.substr(0, at))), std::string(trim(text.substr(at + 1))), line.place};
}

template <class Iterator>
const Setting* found(Iterator first, Iterator end, std::string_view section, std::string_view key) {
  const auto at = std::find_if(first, end, [&](const Setting& s) { return s.section == section && s.key == key; });
  return at == end ? nullptr : &*at;
}

}  // namespace

void refuse(const Place& place, const std::string& message, const std::string& hint) {
  const std::size_t indent = place.text.find_first_not_of(" \t");
  const int column = place.line > 0 && indent < longest_shown ? static_cast<int>(indent) + 1 : place.line > 0 ? 1 : 0;
  throw scenario::ScenarioError({scenario::Diagnostic{place.file, place.line, column, message,
                                                      std::string(indent < longest_shown ? indent : 0, ' ') + shown(place.text), hint}});
}

Lines lines_of(const std::filesystem::path& file) {
  const Place whole{file.string()};
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) refuse(whole, "cannot be read: there is no such file");
  if (!std::filesystem::is_regular_file(status)) refuse(whole, "expected a text file, seen something else by that name");
  std::ifstream in(file, std::ios::binary);
  std::string bytes(most_bytes + 1, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (in.bad() || (!in && !in.eof())) refuse(whole, "cannot be read");
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  if (bytes.size() > most_bytes)
    refuse(whole, "is longer than 1 MiB, and no settings of a machine", "take out what is not about its geometry");
  if (bytes.find('\0') != std::string::npos) refuse(whole, "expected a text file, seen bytes of zero in it");
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.erase(0, 3);

  Lines out;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t end = std::min(bytes.find('\n', at), bytes.size());
    std::string text = bytes.substr(at, end - at);
    if (text.ends_with('\r')) text.pop_back();
    Place place{file.string(), static_cast<int>(out.size()) + 1, text};
    if (text.size() > most_in_a_line) refuse(place, fmt::format("expected lines of at most {} characters", most_in_a_line));
    if (out.size() == most_lines) refuse(place, fmt::format("expected at most {} lines", most_lines));
    out.push_back({std::move(place), std::move(text)});
    at = end + 1;
  }
  return out;
}

double number_of(std::string_view text, const Place& place, const std::string& what) {
  std::string_view digits = trim(text);
  if (digits.starts_with('+')) digits.remove_prefix(1);
  double out = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), out);
  if (error == std::errc::result_out_of_range)
    refuse(place, fmt::format("expected {}, seen {}, which is out of all proportion", what, in_quotes(shown(text))));
  if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(out))
    refuse(place, fmt::format("expected {}, a number; seen {}", what, in_quotes(shown(text))));
  return out;
}

std::vector<double> numbers_of(std::string_view text, const Place& place, const std::string& what, std::size_t most) {
  std::string plain(trim(text));
  if (plain.starts_with('{') && plain.ends_with('}')) plain = plain.substr(1, plain.size() - 2);
  std::ranges::replace(plain, ',', ' ');
  std::vector<double> out;
  for (const std::string& word : words_of(plain)) {
    if (out.size() == most) refuse(place, fmt::format("expected {}, {} numbers at most; seen more", what, most));
    out.push_back(number_of(word, place, what));
  }
  return out;
}

std::string shown(std::string_view text) {
  std::string out(trim(text.substr(0, longest_shown)));
  for (char& c : out)
    if (c == '\t')
      c = ' ';
    else if (const auto u = static_cast<unsigned char>(c); u < 0x20 || u > 0x7E)
      c = '?';
  return out + (text.size() > longest_shown ? "..." : "");
}

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of(" \t", at), text.size());
    if (end > at) out.emplace_back(text.substr(at, end - at));
    at = end + 1;
  }
  return out;
}

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

Settings read_linuxcnc_ini(const Lines& lines) {
  Settings out;
  std::string section;
  for (const Line& line : lines) {
    const std::string_view text = trim(line.text);
    if (text.empty() || text.front() == '#' || text.front() == ';') continue;
    if (const auto name = section_in(line))
      section = *name;
    else
      out.push_back(setting_in(line, section, "=", "NAME = VALUE"));
  }
  return out;
}

Settings read_klipper(const Lines& lines) {
  Settings out, saved;
  std::string section;
  bool in_saved = false, goes_on = false;  // goes_on: a value, in the next line
  for (const Line& line : lines) {
    constexpr std::string_view mark = "#*#";
    Line plain = line;
    if (line.text.starts_with(mark)) {
      if (!in_saved) section.clear(), in_saved = true, goes_on = false;
      plain.text.erase(0, mark.size());
      if (plain.text.starts_with(' ')) plain.text.erase(0, 1);
      if (plain.text.starts_with('<') || plain.text.starts_with("DO NOT EDIT")) continue;  // what Klipper writes above the block
    }
    plain.text = std::string(without_comment(plain.text));
    if (trim(plain.text).empty()) continue;
    Settings& here = in_saved ? saved : out;
    if (blank(plain.text.front())) {
      if (here.empty()) refuse(line.place, "expected [SECTION] first, seen a line that goes on with a value");
      if (!goes_on)
        refuse(line.place, fmt::format("expected a setting of [{}], seen a line that goes on with a value", shown(section)),
               "begin it without a blank");
      here.back().value += " " + std::string(trim(plain.text));
    } else if (const auto name = section_in(plain)) {
      section = *name;
      goes_on = false;
      if (section.starts_with(include)) here.push_back({section, "", "", line.place});
    } else {
      here.push_back(setting_in(plain, section, ":=", "NAME: VALUE"));
      goes_on = true;
    }
  }
  out.insert(out.end(), saved.begin(), saved.end());
  return out;
}

const Setting* first_of(const Settings& all, std::string_view section, std::string_view key) {
  return found(all.begin(), all.end(), section, key);
}
const Setting* last_of(const Settings& all, std::string_view section, std::string_view key) {
  return found(all.rbegin(), all.rend(), section, key);
}

}  // namespace pmreport::program::settings
