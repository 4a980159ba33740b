// pmreport completion SHELL. The scripts find the command among the words so far, then offer what may stand behind it.
#include <reports/program/cli/spoken.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace pmreport::program {

namespace {

std::string name_of(const SpokenCommand& command) { return fmt::format("{}", fmt::join(command.words, " ")); }

// In single quotes, as bash and zsh read them; fish reads '\'' within them.
std::string quoted(const std::string& text, const char* quote) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? quote : std::string(1, c);
  return out + "'";
}
std::string quoted(const std::string& text) { return quoted(text, "'\\''"); }
std::string fish_quoted(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '\\' ? "\\\\" : std::string(1, c);
  return quoted(out, "\\'");
}

// "'describe/new scenario'": the command so far and the next word, in a pattern of `case`.
std::string steps(const SpokenCommand& program, const char* indent) {
  std::string out;
  for (const SpokenCommand* c : all_of(program)) {
    if (c->words.empty()) continue;
    const std::string before = fmt::format("{}", fmt::join(c->words.begin(), c->words.end() - 1, " "));
    out += fmt::format("{}{}) command={} ;;\n", indent, quoted(before + "/" + c->words.back()), quoted(name_of(*c)));
  }
  return out;
}

bool wants_mechanism(const SpokenCommand& c) { return std::ranges::any_of(c.arguments, &SpokenArgument::mechanism); }
bool wants_file(const SpokenCommand& c) {
  return std::ranges::any_of(c.arguments, [](const SpokenArgument& a) { return !a.mechanism && a.choices.empty(); });
}

std::vector<std::string> choices_of(const SpokenCommand& c) {
  std::vector<std::string> out;
  for (const SpokenArgument& a : c.arguments) out.insert(out.end(), a.choices.begin(), a.choices.end());
  return out;
}

// The options that stand behind a command: its own, and those of every command.
std::vector<const SpokenOption*> options_of(const SpokenCommand& command, const SpokenCommand& program) {
  std::vector<const SpokenOption*> out;
  for (const SpokenCommand* c : {&command, &program})
    for (const SpokenOption& o : c->options)
      if ((c == &command || o.everywhere) &&
          std::ranges::none_of(out, [&](const SpokenOption* other) { return other->names.back() == o.names.back(); }))
        out.push_back(&o);
  return out;
}

// What a `case` of the word before offers: the choices of an option's value, or files. One option name means the same everywhere.
template <class Choices>
std::string values(const SpokenCommand& program, const std::string& files, Choices choices) {
  std::vector<std::string> of_files, lines, seen;
  for (const SpokenCommand* c : all_of(program))
    for (const SpokenOption& o : c->options) {
      if (!o.takes_value) continue;
      std::vector<std::string> names;
      for (const std::string& name : o.names)
        if (std::ranges::find(seen, name) == seen.end()) names.push_back(name);
      seen.insert(seen.end(), names.begin(), names.end());
      if (names.empty()) continue;
      if (o.choices.empty())
        of_files.insert(of_files.end(), names.begin(), names.end());
      else
        lines.push_back(fmt::format("    {}) {}; return ;;\n", fmt::join(names, "|"), choices(o.choices)));
    }
  return fmt::format("{}    {}) {}; return ;;\n", fmt::join(lines, ""), fmt::join(of_files, "|"), files);
}

std::string bash(const SpokenCommand& program) {
  std::string cases;
  for (const SpokenCommand* c : all_of(program)) {
    std::vector<std::string> words = choices_of(*c);
    for (const SpokenCommand& below : c->commands) words.push_back(below.words.back());
    for (const SpokenOption* o : options_of(*c, program)) words.insert(words.end(), o->names.begin(), o->names.end());
    cases += fmt::format("    {}) words={}", quoted(name_of(*c)), quoted(fmt::format("{}", fmt::join(words, " "))));
    if (wants_mechanism(*c)) cases += "; mechanisms=1";
    if (wants_file(*c)) cases += "; files=1";
    cases += " ;;\n";
  }
  const std::string of_values =
      values(program, "mapfile -t COMPREPLY < <(compgen -f -- \"$current\")", [](const std::vector<std::string>& choices) {
        return fmt::format("mapfile -t COMPREPLY < <(compgen -W {} -- \"$current\")", quoted(fmt::format("{}", fmt::join(choices, " "))));
      });
  return "# Completes pmreport in bash: source this, or put it where bash-completion looks, as pmreport.\n"
         "_pmreport() {\n"
         "  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]}\n"
         "  local command= word words= mechanisms= files=\n"
         "  for word in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n"
         "    case $command/$word in\n" +
         steps(program, "      ") +
         "    esac\n"
         "  done\n"
         "  case $previous in\n" +
         of_values +
         "  esac\n"
         "  case $command in\n" +
         cases +
         "  esac\n"
         "  if [[ $mechanisms ]]; then words+=\" $(\"$1\" list 2>/dev/null | sed -n 's/^\\([^ ][^ ]*\\) .*/\\1/p')\"; fi\n"
         "  mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\"; [[ $files ]] && compgen -f -- \"$current\")\n"
         "}\n"
         "complete -o filenames -F _pmreport pmreport\n";
}

// An entry of _describe: the word, a colon, what it means.
std::string zsh_entry(const std::string& word, const std::string& meaning) { return quoted(word + ":" + meaning); }

std::string zsh(const SpokenCommand& program) {
  std::string cases;
  for (const SpokenCommand* c : all_of(program)) {
    std::string commands, options;
    for (const SpokenCommand& below : c->commands) commands += " " + zsh_entry(below.words.back(), below.description);
    for (const SpokenOption* o : options_of(*c, program))
      for (const std::string& name : o->names) options += " " + zsh_entry(name, o->description);
    cases += fmt::format("    {})\n      commands=({} )\n      options=({} )\n", quoted(name_of(*c)), commands, options);
    if (const std::vector<std::string> choices = choices_of(*c); !choices.empty())
      cases += fmt::format("      words_of_choice=( {} )\n", fmt::join(choices, " "));
    if (wants_mechanism(*c)) cases += "      mechanisms=1\n";
    if (wants_file(*c)) cases += "      files=1\n";
    cases += "      ;;\n";
  }
  const std::string of_values = values(
      program, "_files", [](const std::vector<std::string>& choices) { return fmt::format("compadd -- {}", fmt::join(choices, " ")); });
  return "#compdef pmreport\n"
         "# Completes pmreport in zsh: put it in a folder of $fpath, as _pmreport.\n"
         "_pmreport() {\n"
         "  local command= word mechanisms= files=\n"
         "  local -a commands options words_of_choice\n"
         "  for word in \"${(@)words[2,CURRENT-1]}\"; do\n"
         "    case \"$command/$word\" in\n" +
         steps(program, "      ") +
         "    esac\n"
         "  done\n"
         "  case \"${words[CURRENT-1]}\" in\n" +
         of_values +
         "  esac\n"
         "  case \"$command\" in\n" +
         cases +
         "  esac\n"
         "  (( $#commands )) && _describe -t commands command commands\n"
         "  (( $#words_of_choice )) && compadd -- $words_of_choice\n"
         "  [[ -n $mechanisms ]] && compadd -- $(\"${words[1]}\" list 2>/dev/null | sed -n 's/^\\([^ ][^ ]*\\) .*/\\1/p')\n"
         "  [[ -n $files ]] && _files\n"
         "  _describe -o -t options option options\n"
         "}\n"
         "if [[ $funcstack[1] == _pmreport ]]; then _pmreport \"$@\"; else compdef _pmreport pmreport; fi\n";
}

std::string fish_options(const SpokenCommand& c, const std::string& condition) {
  std::string out;
  for (const SpokenOption& o : c.options) {
    std::string line = "complete -c pmreport" + (o.everywhere ? "" : condition);
    for (const std::string& name : o.names)
      line += name.starts_with("--") ? fmt::format(" -l {}", name.substr(2)) : fmt::format(" -s {}", name.substr(1));
    if (!o.choices.empty())
      line += fmt::format(" -x -a {}", fish_quoted(fmt::format("{}", fmt::join(o.choices, " "))));
    else if (o.takes_value)
      line += " -r -F";
    out += fmt::format("{} -d {}\n", line, fish_quoted(o.description));
  }
  return out;
}

std::string fish(const SpokenCommand& program) {
  std::string out =
      "# Completes pmreport in fish: put it in ~/.config/fish/completions, as pmreport.fish.\n"
      "function __pmreport_command\n"
      "  set -l command ''\n"
      "  for word in (commandline -opc)[2..-1]\n"
      "    switch \"$command/$word\"\n";
  for (const SpokenCommand* c : all_of(program)) {
    if (c->words.empty()) continue;
    const std::string before = fmt::format("{}", fmt::join(c->words.begin(), c->words.end() - 1, " "));
    out += fmt::format("      case {}\n        set command {}\n", fish_quoted(before + "/" + c->words.back()), fish_quoted(name_of(*c)));
  }
  out +=
      "    end\n"
      "  end\n"
      "  echo $command\n"
      "end\n"
      "function __pmreport_at\n"
      "  test (__pmreport_command) = \"$argv[1]\"\n"
      "end\n"
      "function __pmreport_mechanisms\n"
      "  pmreport list 2>/dev/null | string replace -rf '^(\\S+) +(.*)$' '$1\\t$2'\n"
      "end\n"
      "complete -c pmreport -f\n";
  for (const SpokenCommand* c : all_of(program)) {
    const std::string condition = " -n " + fish_quoted(fmt::format("__pmreport_at '{}'", name_of(*c)));
    for (const SpokenCommand& below : c->commands)
      out += fmt::format("complete -c pmreport{} -a {} -d {}\n", condition, below.words.back(), fish_quoted(below.description));
    out += fish_options(*c, condition);
    if (const std::vector<std::string> choices = choices_of(*c); !choices.empty())
      out += fmt::format("complete -c pmreport{} -a {}\n", condition, fish_quoted(fmt::format("{}", fmt::join(choices, " "))));
    if (wants_mechanism(*c)) out += fmt::format("complete -c pmreport{} -a '(__pmreport_mechanisms)'\n", condition);
    if (wants_file(*c)) out += fmt::format("complete -c pmreport{} -F\n", condition);
  }
  return out;
}

}  // namespace

std::string completion(const SpokenCommand& program, const std::string& shell) {
  return shell == "bash" ? bash(program) : shell == "zsh" ? zsh(program) : fish(program);
}

}  // namespace pmreport::program
