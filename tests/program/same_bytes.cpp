// One scenario gives one report, byte for byte, wherever and however it is run.
#include <catch2/catch.hpp>
#include <tests/program/workshop.hpp>

using namespace program_test;

namespace {

// All kinds of sections and one small picture.
const std::string everything = with(
    small,
    {{"[[section]]",
      "[[section]]\nkind = \"mechanism\"\n\n[[section]]\nkind = \"snapshots\"\ntimes = [\"0.5 s\"]\nsize = [320, 240]\n\n[[section]]"}});

void check_same(const std::map<std::string, std::string>& a, const std::map<std::string, std::string>& b) {
  for (const auto& [name, bytes] : a) {
    INFO(name);
    REQUIRE(b.contains(name));
    CHECK(b.at(name) == bytes);
  }
  CHECK(a.size() == b.size());
}

}  // namespace

TEST_CASE("the report depends neither on the run nor on locale, time zone, threads, folder or terminal") {
  const Workshop here;
  REQUIRE(here.report(everything).status == 0);
  const auto first = contents(here.report_folder());
  REQUIRE(first.size() > 10);
  for (const char* file : {"report.html", "report.pdf", "results.json", "junit.xml", "data/displacement.csv", "figures/displacement.svg"})
    REQUIRE(first.contains(file));

  {
    INFO("another locale, in which the decimal sign is a comma");
    const std::string locales = (here / "locales").string();
    std::filesystem::create_directories(locales);
    const Result made = run({"localedef", "-i", "de_DE", "-f", "UTF-8", locales + "/de_DE.UTF-8"});
    INFO(made.err);
    REQUIRE(std::filesystem::exists(here / "locales/de_DE.UTF-8/LC_NUMERIC"));
    const Surroundings german{.environment = {{"LOCPATH", locales}, {"LC_ALL", "de_DE.UTF-8"}}};
    REQUIRE(run({"printf", "%.1f", "1,5"}, german).out == "1,5");  // the locale is in force for who asks for it
    REQUIRE(here.report(everything, {}, german).status == 0);
    check_same(first, contents(here.report_folder()));
  }
  {
    INFO("another time zone, on a terminal");
    REQUIRE(here.report(everything, {}, {.environment = {{"TZ", "Asia/Tokyo"}}, .terminal = true}).status == 0);
    check_same(first, contents(here.report_folder()));
  }
  {
    INFO("one thread and two");
    for (const char* threads : {"1", "2"}) {
      CAPTURE(threads);
      REQUIRE(here.report(everything, {"--threads", threads}).status == 0);
      check_same(first, contents(here.report_folder()));
    }
  }
  {
    INFO("another working directory and another place");
    const Workshop elsewhere;
    const std::string out = (elsewhere / "a/b/report").string();
    REQUIRE(pmreport({(here / "scenario.toml").string(), "--out", out}, {.folder = "/"}).status == 0);
    check_same(first, contents(out));
  }
}

TEST_CASE("the date of the PDF follows SOURCE_DATE_EPOCH") {
  const Workshop here;
  const Surroundings dated{.environment = {{"SOURCE_DATE_EPOCH", "1234567890"}, {"TZ", "Asia/Tokyo"}}};  // 2009-02-13 23:31:30 UTC
  REQUIRE(here.report(small, {}, dated).status == 0);
  CHECK(bytes_of(here.report_folder() / "report.pdf").find("D:20090213233130") != std::string::npos);
}
