// pmreport man: the manual page.
#include <reports/program/cli/spoken.hpp>
#include <reports/program/command_line.hpp>

#include <fmt/format.h>

#include <utility>

namespace pmreport::program {

namespace {

// A text of one line in roff: a backslash, a dash and a first point or apostrophe would be orders.
std::string in_roff(const std::string& text) {
  std::string out = text.starts_with('.') || text.starts_with('\'') ? "\\&" : "";
  for (const char c : text) {
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else if (c == '\n')
      out += ' ';
    else
      out += c;
  }
  return out;
}

std::string bold(const std::string& text) { return "\\fB" + in_roff(text) + "\\fR"; }
std::string slanted(const std::string& text) { return "\\fI" + in_roff(text) + "\\fR"; }

std::string names_of(const SpokenOption& o) {
  std::vector<std::string> names;
  for (const std::string& name : o.names) names.push_back(bold(name));
  std::string out = fmt::format("{}", fmt::join(names, ", "));
  if (!o.choices.empty()) return out + " " + slanted(fmt::format("{}", fmt::join(o.choices, "|")));
  return o.takes_value ? out + " " + slanted("VALUE") : out;
}

std::string usage_of(const SpokenCommand& c) {
  std::string out = bold("pmreport");
  for (const std::string& word : c.words) out += " " + bold(word);
  if (!c.options.empty()) out += " [options]";
  for (const SpokenArgument& a : c.arguments) {
    const std::string name =
        (a.choices.empty() ? slanted(a.name) : slanted(fmt::format("{}", fmt::join(a.choices, "|")))) + (a.several ? " ..." : "");
    out += a.needed || c.words.empty() ? " " + name : " [" + name + "]";
  }
  return out;
}

std::string lines_of(const SpokenCommand& c) {
  std::string out;
  for (const SpokenArgument& a : c.arguments) out += fmt::format(".TP\n{}\n{}\n", slanted(a.name), in_roff(a.description));
  for (const SpokenOption& o : c.options) out += fmt::format(".TP\n{}\n{}\n", names_of(o), in_roff(o.description));
  return out;
}

const std::pair<int, const char*> statuses[] = {
    {all_well, "all well"},
    {gate_failed,
     "the report is written, and a check or a line of evidence failed or is an error, or it differs from its baseline; of check, a "
     "property failed; of compare, the reports differ; of approve, the report did not pass"},
    {bad_scenario, "the command line or the scenario is wrong, or what is compared is no report; nothing was written"},
    {plugin_failed, "a plugin failed or crashed, or there is none"},
    {output_failed,
     "the report, the page of a comparison, a baseline or standard output could not be written; an earlier report is untouched"},
    {resource_limit, "the time of --timeout is over, memory or another resource does not suffice, or a scan is too large to be done"},
    {129, "interrupted by SIGHUP; an earlier report is untouched"},
    {130, "interrupted by SIGINT; an earlier report is untouched"},
    {131, "interrupted by SIGQUIT; an earlier report is untouched"},
    {143, "interrupted by SIGTERM; an earlier report is untouched"}};

constexpr std::pair<const char*, const char*> environment[] = {
    {"PMREPORT_PLUGIN_PATH", "folders with plugins, colons between, searched after --plugin-path"},
    {"SOURCE_DATE_EPOCH", "the date that the PDF bears, in seconds since 1970; without it the PDF bears none"},
    {"PMREPORT_PROCESSOR", "x86-64 or x86-64-v3: takes no build of a plugin for newer processors than that"},
    {"XDG_DATA_HOME", "where plugins of the user are looked for, in pmreport/plugins; ~/.local/share without it"},
    {"CI, TERM=dumb", "no line of progress; there is none either where stderr is no terminal"},
    {"GITHUB_ACTIONS", "where it is true, what fails is printed as annotations of GitHub too"},
    {"NO_COLOR", "honoured: nothing that pmreport prints is coloured"}};

}  // namespace

std::string manual(const SpokenCommand& program, const std::string& version) {
  const std::size_t colon = program.description.find(": ");
  const std::string what = colon == std::string::npos ? program.description : program.description.substr(colon + 2);
  std::string out = fmt::format(".TH PMREPORT 1 \"\" \"pmreport {}\" \"User Commands\"\n.SH NAME\npmreport \\- {}\n.SH SYNOPSIS\n",
                                in_roff(version), in_roff(what));
  for (const SpokenCommand* c : all_of(program))
    if (c->commands.empty() || c->words.empty()) out += (c == &program ? "" : ".br\n") + usage_of(*c) + "\n";
  out +=
      ".SH DESCRIPTION\nTurns a script about a parallel manipulator, a TOML file, into a report. Of several scripts each gets its report "
      "in a folder of its own, with an index of all. The commands tell about mechanisms, scenarios and reports.\n";
  out += ".SH OPTIONS\nThose of the program itself may stand behind a command too.\n" + lines_of(program);
  out += ".SH COMMANDS\n";
  for (const SpokenCommand* c : all_of(program)) {
    if (c->words.empty() || !c->commands.empty()) continue;
    out += fmt::format(".SS {}\n{}\n{}", bold(fmt::format("{}", fmt::join(c->words, " "))), in_roff(c->description), lines_of(*c));
  }
  out += ".SH EXIT STATUS\nOf several scenarios the largest.\n";
  for (const auto& [status, meaning] : statuses) out += fmt::format(".TP\n{}\n{}\n", bold(std::to_string(status)), in_roff(meaning));
  out += ".SH ENVIRONMENT\n";
  for (const auto& [name, meaning] : environment) out += fmt::format(".TP\n{}\n{}\n", bold(name), in_roff(meaning));
  return out;
}

}  // namespace pmreport::program
