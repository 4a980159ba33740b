// Names and titles of a plugin, and of a scenario, that would do something in a spreadsheet, a page, XML, Markdown, a workflow or a
// terminal: in everything that the program writes they are words.
#include <catch2/catch.hpp>
#include <tests/program/workshop.hpp>

#include <toml++/toml.h>

#include <algorithm>
#include <charconv>
#include <sstream>

namespace fs = std::filesystem;
using namespace program_test;
using Catch::Contains;

namespace {

// What stands in the fixture, after the host has made one line of it.
constexpr std::string_view formula = "=cmd|", tag = "<script>alert", end_of_data = "]]>", turned = "\u202E";

constexpr std::string_view scenario = R"toml(title = "=cmd|' /C calc'!A0 <script>alert(1)</script> ]]> | `x`\n::error::hello \u202E"
author = "=cmd|' <script>alert(1)</script> \n::error::hello"
description = "=cmd|' <script>alert(1)</script> ]]> | `x` \n::error::hello \u202E"
[mechanism]
use = "plain-slider"
[motion]
duration = "1 s"
samples = 21
[load]
force = ["10 N", "0 N", "0 N"]
[limits]
actuator_force = "1 N"
[[section]]
kind = "mechanism"
title = "=cmd|' <script>alert(1)</script> ]]> | `x`\n::error::hello \u202E"
[[section]]
kind = "snapshots"
size = [160, 120]
[[section]]
kind = "displacement"
[[section]]
kind = "velocity"
[[section]]
kind = "acceleration"
[[section]]
kind = "statics"
[[section]]
kind = "dynamics"
[[section]]
kind = "reactions"
[[section]]
kind = "stiffness"
[[section]]
kind = "mobility"
[[section]]
kind = "singularity"
[[section]]
kind = "transmission"
[[section]]
kind = "assembly"
[[check]]
that = "max(abs(actuator_force))"
below = "1 N"
)toml";

// Rows of cells, as RFC 4180 has them.
std::vector<std::vector<std::string>> cells_of(const std::string& csv) {
  std::vector<std::vector<std::string>> rows(1, {""});
  bool quoted = false;
  for (std::size_t i = 0; i < csv.size(); ++i) {
    std::string& cell = rows.back().back();
    if (quoted && csv[i] == '"' && i + 1 < csv.size() && csv[i + 1] == '"')
      cell += csv[i++];
    else if (csv[i] == '"')
      quoted = !quoted;
    else if (!quoted && csv[i] == ',')
      rows.back().emplace_back();
    else if (!quoted && csv[i] == '\n')
      rows.push_back({""});
    else
      cell += csv[i];
  }
  if (rows.back() == std::vector<std::string>{""}) rows.pop_back();
  return rows;
}

bool is_number(const std::string& cell) {
  double x = 0;
  return !cell.empty() && std::from_chars(cell.data(), cell.data() + cell.size(), x).ptr == cell.data() + cell.size();
}

void check_csv(const std::string& csv) {
  const auto rows = cells_of(csv);
  REQUIRE(rows.size() > 1);
  for (const auto& row : rows) {
    CHECK(row.size() == rows.front().size());
    for (const std::string& cell : row) {
      INFO(cell);
      CHECK((cell.empty() || is_number(cell) || std::string_view("=+-@\t\r").find(cell.front()) == std::string_view::npos));
    }
  }
}

// Elements that open and close in their order, and & only where an entity begins: what any reader of XML asks first.
void check_xml(const std::string& xml) {
  std::vector<std::string> open;
  bool text = false;
  for (std::size_t i = 0; i < xml.size(); ++i) {
    if (xml[i] == '&') REQUIRE(xml.find(';', i) < i + 8);
    if (xml[i] != '<') continue;
    std::size_t end = i + 1;
    for (char quote = '\0'; end < xml.size() && (quote != '\0' || xml[end] != '>'); ++end)
      if (quote != '\0' ? xml[end] == quote : xml[end] == '"' || xml[end] == '\'') quote = quote != '\0' ? '\0' : xml[end];
    const std::string inside = xml.substr(i + 1, end - i - 1), name = inside.substr(0, inside.find_first_of(" \n/", 1));
    text = true;
    if (inside.front() == '/') {
      REQUIRE(!open.empty());
      REQUIRE(open.back() == inside.substr(1));
      open.pop_back();
    } else if (inside.front() != '?' && inside.front() != '!' && inside.back() != '/') {
      open.push_back(name);
    }
    i = end;
  }
  CHECK(text);
  CHECK(open.empty());
}

// Lines that a workflow would obey, those that the program means left out.
int commands_of_workflows(const std::string& text) {
  int n = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const auto begin = line.find_first_not_of(" \t\r");
    if (begin != std::string::npos && line.compare(begin, 2, "::") == 0 && line.compare(begin, 13, "::error file=") != 0) ++n;
  }
  return n;
}

// Neither controls nor a turned direction, and valid UTF-8 enough that no stray byte is left.
void check_printable(const std::string& text) {
  for (const char c : text) REQUIRE(((static_cast<unsigned char>(c) >= 0x20 && c != 0x7F) || c == '\n' || c == '\t'));
  CHECK(count_of(text, turned) == 0);
  CHECK(count_of(text, "\xFF") == 0);
}

struct Hostile {
  explicit Hostile(const char* plugin = "hostile") {
    fs::create_directory(workshop / "plugins");
    fs::copy_file(fs::path(FIXTURES) / (std::string(plugin) + ".so"), workshop / "plugins" / "one.so");
  }
  Result run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), {"--plugin-path", (workshop / "plugins").string()});
    return run_pmreport(std::move(arguments), {.environment = {{"GITHUB_ACTIONS", "true"}}, .folder = workshop.path()});
  }
  Workshop workshop;
};

}  // namespace

TEST_CASE("hostile words of a plugin and a scenario are words in every file of a report") {
  const Hostile here, plain("plain");
  here.workshop.write("scenario.toml", scenario);
  const Result r = here.run({"scenario.toml"});
  INFO(r.out << r.err);
  REQUIRE(r.status == 1);  // a limit is broken, so that there is something to annotate
  CHECK(commands_of_workflows(r.out + r.err) == 0);
  CHECK_THAT(r.out, Contains("::error file="));
  check_printable(r.out);
  check_printable(r.err);

  plain.workshop.write("scenario.toml", scenario);
  REQUIRE(plain.run({"scenario.toml"}).status == 1);
  const auto harmless = contents(plain.workshop.report_folder());
  int tables = 0, told = 0;
  for (const auto& [name, bytes] : contents(here.workshop.report_folder())) {
    CAPTURE(name);
    const std::string kind = fs::path(name).extension();
    if (kind == ".csv") check_csv(bytes), ++tables;
    if (kind == ".svg" || kind == ".xml") check_xml(bytes);
    if (kind == ".csv" || kind == ".svg" || kind == ".xml" || kind == ".html" || kind == ".md" || kind == ".json") {
      check_printable(bytes);
      told += count_of(bytes, "calc");
    }
    if (kind == ".svg" || kind == ".xml" || kind == ".html" || kind == ".md") CHECK(count_of(bytes, tag) == 0);
    if (kind == ".svg" || kind == ".xml") CHECK(count_of(bytes, end_of_data) == 0);
    // Scripts and styles of the page are its own.
    if (kind == ".html")
      for (const char* element : {"<script", "</script", "<style", "<iframe", "<img"})
        CHECK(count_of(bytes, element) == count_of(harmless.at(name), element));
    if (kind == ".glb" || kind == ".pdf") CHECK(count_of(bytes, "\x1b[31m") == 0);
  }
  CHECK(tables >= 5);
  CHECK(told > 50);

  // Of a table in Markdown every line has as many bars that are not escaped as its head.
  std::istringstream lines(bytes_of(here.workshop.report_folder() / "summary.md"));
  std::size_t bars = 0;
  for (std::string line; std::getline(lines, line);) {
    CHECK(line.find("`") == line.find("\\`") + (line.find("`") == std::string::npos ? 0 : 1));
    const std::size_t here_ = count_of(line, "|") - count_of(line, "\\|");
    if (line.starts_with("|")) CHECK((bars == 0 || here_ == bars));
    bars = line.starts_with("|") ? here_ : 0;
  }
}

TEST_CASE("hostile words of a plugin are words in what the commands print") {
  const Hostile here;
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"list"},
                                                    {"describe", "plain-slider"},
                                                    {"describe", "plain-slider", "--json"},
                                                    {"check", "plain-slider", "--poses", "10"},
                                                    {"schema", "plain-slider"},
                                                    {"new", "scenario", "plain-slider"}}) {
    CAPTURE(arguments.at(0), arguments.size());
    const Result r = here.run(arguments);
    check_printable(r.out);
    check_printable(r.err);
    CHECK(commands_of_workflows(r.out + r.err) == 0);
    CHECK(r.out.find("\n[[section]] ") == std::string::npos);
  }
}

TEST_CASE("limits that are printed as settings keep hostile names within their lines") {
  const Hostile here;
  const std::string name = R"(=cmd|' /C calc'!A0 <script>alert(1)</script> ]]> | `x` \"q\" \\ # ${x} ::error::hello  [[section]] ?[31m?)"
                           "\uFFFD x";
  here.workshop.write("scenario.toml",
                      "title = \"t\"\n[mechanism]\nuse = \"plain-slider\"\n[[section]]\nkind = \"workspace\"\nscan = { \"" + name +
                          "\" = [\"-50 mm\", \"50 mm\"] }\n");
  for (const char* format : {"toml", "linuxcnc", "klipper"}) {
    CAPTURE(format);
    const Result r = here.run({"limits", "scenario.toml", "--format", format});
    INFO(r.out << r.err);
    REQUIRE(r.status == 0);
    check_printable(r.out);
    CHECK(commands_of_workflows(r.out) == 0);
    if (std::string_view(format) == "toml") {
      const toml::table limits = toml::parse(r.out);
      REQUIRE(limits["safe_limits"].is_table());
      CHECK(limits["safe_limits"].as_table()->size() == 1);
      continue;
    }
    std::istringstream lines(r.out);  // there is no axis of this name: all that is said is a comment
    for (std::string line; std::getline(lines, line);) CHECK(line.starts_with("#"));
  }
}
