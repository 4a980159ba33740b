// What a report would take of memory is told, and refused where it is too much, before anything is begun; and what was told was enough.
#include <catch2/catch.hpp>
#include <tests/program/workshop.hpp>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <regex>

using namespace program_test;
using Catch::Contains;

namespace {

std::string with_samples(int n) { return with(small, {{"samples = 21", "samples = " + std::to_string(n)}}); }

double told_by_check(const Workshop& here, const std::string& scenario) {
  const Result r = here.report(scenario, {"--check"});
  std::smatch words;
  REQUIRE(std::regex_search(r.out, words, std::regex("at most about ([0-9.e+]+) (MB|GB) of memory")));
  return std::stod(words[1]) * (words[2] == "MB" ? 1e6 : 1e9);
}

// Of a run of the program and all that it starts [bytes]; in a process of its own, whose children are these alone. 0: it failed.
double peak_of(const Workshop& here, const std::string& scenario) {
  int ends[2];
  if (pipe(ends) != 0) return 0;
  const pid_t child = fork();
  if (child == 0) {
    const int status = here.report(scenario).status;
    rusage used{};
    getrusage(RUSAGE_CHILDREN, &used);
    const long kilobytes = status == 0 ? used.ru_maxrss : 0;
    _exit(write(ends[1], &kilobytes, sizeof kilobytes) == sizeof kilobytes ? 0 : 1);
  }
  close(ends[1]);
  long kilobytes = 0;
  const bool known = read(ends[0], &kilobytes, sizeof kilobytes) == sizeof kilobytes;
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return known ? 1024.0 * static_cast<double>(kilobytes) : 0;
}

}  // namespace

TEST_CASE("a report that would take more memory than is allowed is refused with its estimate before anything is begun") {
  const Workshop here;
  const Result r = here.report(with_samples(20001), {"--max-memory", "100 MB"});
  CHECK(r.status == 5);
  CHECK_THAT(r.err, Contains("the report would take about ") && Contains("--max-memory allows 100 MB; nothing was begun"));
  CHECK_THAT(r.err, Contains("for 20001 samples of ") && Contains("ask for fewer samples, or fewer sections"));
  CHECK(contents(here.path()).size() == 1);
  CHECK(here.report(small, {"--max-memory", "1 GB"}).status == 0);
}

TEST_CASE("pictures and grids are told by themselves") {
  const Workshop here;
  const std::string large = with(small, {{"kind = \"velocity\"", "kind = \"snapshots\"\nsize = [8000, 8000]\ntimes = [\"0 s\", \"1 s\"]"}});
  const Result pictures = here.report(large, {"--max-memory", "1 GB"});
  CHECK(pictures.status == 5);
  CHECK_THAT(pictures.err, Contains("pictures of 8000 x 8000 pixels") && Contains("ask for smaller or fewer pictures"));
  const Result grid = here.report(
      "title = \"t\"\n[mechanism]\nuse = \"gough\"\n[[section]]\nkind = \"workspace\"\nmethod = \"grid\"\nscan = { x = [\"-300 mm\", \"300 "
      "mm\", 1001], y = [\"-300 mm\", \"300 mm\", 1001], z = [\"700 mm\", \"1100 mm\", 1001] }\n",
      {"--max-memory", "4 GB"});
  CHECK(grid.status == 5);
  CHECK_THAT(grid.err, Contains("a workspace of 1.003e+09 points") && Contains("ask for fewer values on its axes"));
}

TEST_CASE("by default a report may take what the machine, its group of processes and its limits leave") {
  if (sanitized) return;  // takes memory of its own, several times that of the program
  const Workshop here;
  here.write("scenario.toml", with_samples(200001));
  // Enough to read the scenario, and not for its report.
  const Result r = run({"sh", "-c", "ulimit -v 700000; exec \"$0\" scenario.toml --threads 1", PROGRAM}, {.folder = here.path()});
  INFO(r.err);
  CHECK(r.status == 5);
  CHECK_THAT(r.err, Contains("the report would take about ") && Contains("`ulimit -v` leaves"));
}

TEST_CASE("what is no size is refused") {
  for (const char* size : {"4", "GB", "-1 GB", "0 GB", "nan GB", "4 apples", "inf GB"}) {
    CAPTURE(size);
    const Result r = run_pmreport({"scenario.toml", "--max-memory", size});
    CHECK(r.status == 2);
    CHECK_THAT(r.err, Contains("expected a size with its unit"));
  }
}

TEST_CASE("a report takes no more memory than was told, and no less than half of that") {
  if (sanitized) return;  // takes memory of its own, several times that of the program
  const Workshop here;
  const std::string scenario = with_samples(40001);
  const double told = told_by_check(here, scenario), taken = peak_of(here, scenario);
  CAPTURE(told, taken);
  REQUIRE(taken > 0);
  CHECK(taken < told);
  CHECK(taken > told / 2);
}

TEST_CASE("of tables of one name a scenario has a thousand at most") {
  const Workshop here;
  std::string many(small);
  for (int k = 0; k < 1000; ++k) many += "[[check]]\nthat = \"max(x)\"\nbelow = \"1 m\"\n";
  const Result r = here.report(many, {"--check"});
  CHECK(r.status == 2);
  CHECK_THAT(r.err, Contains("expected at most 1000 tables [[check]], seen 1001"));
}
