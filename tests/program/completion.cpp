// What the program tells of itself to shells and to man, held by what --help says.
#include <tests/program/workshop.hpp>

#include <catch2/catch.hpp>

#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

using namespace program_test;
using Catch::Matchers::Contains;

namespace {

// The commands that a help lists: lines of two blanks and a word after "Subcommands:".
std::vector<std::string> commands_in(const std::string& help) {
  std::vector<std::string> out;
  const std::size_t begin = help.find("Subcommands:\n");
  if (begin == std::string::npos) return out;
  static const std::regex line("\n  ([a-z]+) ");
  const std::string list = help.substr(begin);
  for (std::sregex_iterator i(list.begin(), list.end(), line), end; i != end; ++i) out.push_back((*i)[1]);
  return out;
}

void options_below(const std::vector<std::string>& command, std::set<std::string>& options, std::set<std::string>& commands) {
  std::vector<std::string> asked = command;
  asked.push_back("--help");
  const std::string help = run_pmreport(asked).out;
  static const std::regex option("\n  (?:-([a-z]),)?--([a-z-]+)");
  for (std::sregex_iterator i(help.begin(), help.end(), option), end; i != end; ++i) {
    options.insert((*i)[2]);
    if ((*i)[1].matched) options.insert((*i)[1]);
  }
  for (const std::string& below : commands_in(help)) {
    commands.insert(below);
    std::vector<std::string> longer = command;
    longer.push_back(below);
    options_below(longer, options, commands);
  }
}

struct Said {
  Said() { options_below({}, options, commands); }
  std::set<std::string> options, commands;
};
const Said& said() {
  static const Said all;
  return all;
}

// What bash offers where `words` are typed and the last one is at hand.
std::string offered(const Workshop& here, const std::string& words) {
  here.write("complete.bash", run_pmreport({"completion", "bash"}).out);
  here.write("ask.bash", "source complete.bash\nCOMP_WORDS=(" + words +
                             ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_pmreport " PROGRAM "\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n");
  return run({"bash", "ask.bash"}, {.folder = here.path()}).out;
}

}  // namespace

TEST_CASE("every option and command of --help is in the completions and in the manual") {
  REQUIRE(said().options.size() > 15);
  REQUIRE(said().commands.contains("schema"));
  REQUIRE(said().commands.contains("mechanism"));
  for (const char* shell : {"bash", "zsh", "fish"}) {
    const Result script = run_pmreport({"completion", shell});
    CAPTURE(shell);
    REQUIRE(script.status == 0);
    for (const std::string& option : said().options) {
      const std::string dashed = (option.size() == 1 ? "-" : "--") + option, fish = (option.size() == 1 ? " -s " : " -l ") + option;
      CHECK_THAT(script.out, Contains(std::string(shell) == "fish" ? fish : dashed));
    }
    for (const std::string& command : said().commands) CHECK_THAT(script.out, Contains(command));
  }
  const std::string page = run_pmreport({"man"}).out;
  for (const std::string& option : said().options)
    CHECK_THAT(page, Contains("\\fB" + std::regex_replace((option.size() == 1 ? "-" : "--") + option, std::regex("-"), "\\-")));
  for (const std::string& command : said().commands) CHECK_THAT(page, Contains("\\fB" + command));
}

TEST_CASE("the completions are sound scripts of their shells") {
  const Workshop here;
  for (const char* shell : {"bash", "zsh", "fish"}) {
    if (run({"sh", "-c", std::string("command -v ") + shell}).status != 0) {
      WARN(shell << " is not installed: its completion is not parsed");
      continue;
    }
    CAPTURE(shell);
    const Result sound = run({shell, "-n", here.write(std::string("completion.") + shell, run_pmreport({"completion", shell}).out)});
    CHECK(sound.status == 0);
    CHECK(sound.err == "");
  }
}

TEST_CASE("bash is offered commands, options, values and the mechanisms that are found") {
  const Workshop here;
  here.write("mine.toml", small);
  CHECK_THAT(offered(here, "pmreport de"), Contains("describe\n") && !Contains("delta"));
  CHECK_THAT(offered(here, "pmreport mi"), Contains("mine.toml\n"));
  CHECK_THAT(offered(here, "pmreport describe de"), Contains("delta\n") && !Contains("describe"));
  CHECK_THAT(offered(here, "pmreport describe delta --js"), Contains("--json\n"));
  CHECK_THAT(offered(here, "pmreport new s"), Contains("scenario\n") && !Contains("mine"));
  CHECK_THAT(offered(here, "pmreport new scenario g"), Contains("gough\n"));
  CHECK_THAT(offered(here, "pmreport limits mine.toml --format l"), Contains("linuxcnc\n"));
  CHECK_THAT(offered(here, "pmreport completion z"), Contains("zsh\n"));
  CHECK_THAT(offered(here, "pmreport --plugin-path mi"), Contains("mine.toml\n"));
}

TEST_CASE("behind a command stand its own options and those of every command, not those of reports") {
  const Workshop here;
  CHECK_THAT(offered(here, "pmreport --"), Contains("--baseline\n") && Contains("--resume\n") && Contains("--threads\n"));
  for (const char* command : {"describe", "check", "list", "classify", "schema", "import"}) {
    CAPTURE(command);
    CHECK_THAT(offered(here, std::string("pmreport ") + command + " --"),
               Contains("--threads\n") && Contains("--plugin-path\n") && !Contains("--baseline") && !Contains("--resume"));
  }
  CHECK_THAT(offered(here, "pmreport approve --"), Contains("--relative\n") && Contains("--failed\n") && !Contains("--out"));
  const std::string fish = run_pmreport({"completion", "fish"}).out;
  CHECK_THAT(fish, Contains("complete -c pmreport -n '__pmreport_at \\'\\'' -l baseline") && Contains("complete -c pmreport -l threads"));
}

TEST_CASE("an output without a name is refused, not taken for one by default") {
  const Workshop here;
  here.write("mine.toml", small);
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"mine.toml", "-o", ""}, {"new", "scenario", "gough", "--out", ""}, {"mine.toml", "--baseline", ""}}) {
    const Result result = run_pmreport(words, {.folder = here.path()});
    CHECK(result.status == 2);
    CHECK_THAT(result.err, Contains("expected a name, seen nothing"));
  }
  CHECK_FALSE(std::filesystem::exists(here / "mine-report"));
}

TEST_CASE("a shell that is none is told those that are") {
  const Result result = run_pmreport({"completion", "tcsh"});
  CHECK(result.status == 2);
  CHECK_THAT(result.err, Contains("bash") && Contains("zsh") && Contains("fish"));
}

TEST_CASE("the manual tells every exit status and every variable of the environment that README.md tells") {
  const std::string readme = bytes_of(SOURCE "/README.md"), page = run_pmreport({"man"}).out;
  const std::size_t statuses = readme.find("| exit status |"), variables = readme.find("| environment |");
  REQUIRE(statuses < variables);
  static const std::regex status("\n\\| (\\d+)(?:, (\\d+))? \\|"), variable("\n\\| `([A-Z_]+)`");
  const std::string of_statuses = readme.substr(statuses, variables - statuses),
                    of_variables = readme.substr(variables, readme.find("\n\n", variables) - variables);
  for (std::sregex_iterator i(of_statuses.begin(), of_statuses.end(), status), end; i != end; ++i)
    for (const int k : {1, 2})
      if ((*i)[k].matched) CHECK_THAT(page, Contains("\n\\fB" + (*i)[k].str() + "\\fR\n"));
  for (std::sregex_iterator i(of_variables.begin(), of_variables.end(), variable), end; i != end; ++i)
    CHECK_THAT(page, Contains("\\fB" + (*i)[1].str()));
}
