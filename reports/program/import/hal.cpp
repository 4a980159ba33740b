#include <reports/program/import/hal.hpp>

#include <core/text/text.hpp>

#include <fmt/format.h>

namespace pmreport::program {

namespace {

using settings::Setting, settings::Settings;

// Lines that end in a backslash go on in the next.
settings::Lines joined(const settings::Lines& lines) {
  settings::Lines out;
  bool goes_on = false;
  for (const settings::Line& line : lines) {
    std::string text = line.text;
    const bool more = trim(text).ends_with('\\');
    if (more) text = std::string(trim(text)), text.back() = ' ';
    if (goes_on)
      out.back().text += " " + text;
    else
      out.push_back({line.place, std::move(text)});
    goes_on = more;
  }
  return out;
}

bool is_arrow(const std::string& word) { return word == "=>" || word == "<=" || word == "<=>"; }

}  // namespace

std::optional<std::string> resolved(const std::string& value, const Settings& ini, std::set<int>& used) {
  if (!value.starts_with('[')) return value;
  const std::size_t end = value.find(']');
  if (end == std::string::npos) return std::nullopt;
  std::string name = value.substr(end + 1);
  if (name.starts_with('(') && name.ends_with(')')) name = name.substr(1, name.size() - 2);  // as it is written too
  const Setting* s = settings::first_of(ini, value.substr(1, end - 1), name);
  if (s == nullptr) return std::nullopt;
  used.insert(s->place.line);
  return s->value;
}

Hal read_hal(const settings::Lines& lines) {
  Hal out;
  for (const settings::Line& line : joined(lines)) {
    const std::string_view text = std::string_view(line.text).substr(0, line.text.find('#'));
    std::vector<std::string> words = settings::words_of(text);
    if (words.empty()) continue;
    // name = value is another way to write setp.
    const bool assigned = words.size() == 3 && words[1] == "=";
    if (assigned) words = {"setp", words[0], words[2]};
    const std::string& command = words.front();
    if (command == "setp") {
      if (words.size() != 3)
        settings::refuse(line.place, fmt::format("expected setp NAME VALUE, seen {}", in_quotes(settings::shown(text))));
      out.set.push_back({"", words[1], words[2], line.place});
    } else if (command == "net" && words.size() > 2) {
      for (std::size_t i = 2; i < words.size(); ++i)
        if (!is_arrow(words[i])) out.nets.push_back({"", words[i], words[1], line.place});
      ++out.other_commands[command];
    } else if (command == "loadrt" && words.size() > 1) {
      out.modules.push_back({"", words[1], "", line.place});
      ++out.other_commands[command];
    } else {
      ++out.other_commands[settings::shown(command)];
    }
  }
  return out;
}

}  // namespace pmreport::program
