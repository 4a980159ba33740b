// One scenario gives one report, byte for byte, wherever and however it is run.
#include <catch2/catch.hpp>
#include <tests/program/workshop.hpp>

#include <regex>

using namespace program_test;

namespace {

// Every kind of section that is registered: the table of README.md has them all, which a test of the sections holds it to.
std::vector<std::string> registered_kinds() {
  const std::string text = bytes_of(SOURCE "/README.md"), heading = "| kind | shows |";
  const std::size_t begin = text.find(heading), end = text.find("\n\n", begin);
  const std::string table = text.substr(begin, end - begin);
  const std::regex row("\n\\| `([a-z]+)` \\|");
  std::vector<std::string> out;
  for (auto at = std::sregex_iterator(table.begin(), table.end(), row); at != std::sregex_iterator(); ++at) out.push_back((*at)[1].str());
  return out;
}

// A section of each, with what it needs, or what makes it do more: pictures are small, searches short.
std::string section_of(const std::string& kind) {
  static const std::map<std::string, std::string> keys{
      {"snapshots", "times = [\"0.5 s\"]\nsize = [320, 240]\n"},
      {"dynamics", "equations = [\"0.5 s\"]\n"},
      {"singularity", "poses = [{x = \"10 mm\"}]\nmap = {x = [\"-100 mm\", \"100 mm\"], z = [\"500 mm\", \"600 mm\"], points = 11}\n"},
      {"transmission",
       "poses = [{x = \"10 mm\"}]\nmap = {x = [\"-100 mm\", \"100 mm\"], z = [\"500 mm\", \"600 mm\"], points = 11}\n"
       "grid = {x = [\"-100 mm\", \"100 mm\", 21], z = [\"500 mm\", \"600 mm\", 21]}\n"},
      {"stiffness", "poses = [{x = \"10 mm\"}]\nmap = {x = [\"-100 mm\", \"100 mm\"], z = [\"500 mm\", \"600 mm\"], points = 7}\n"},
      {"mobility", "poses = 10\n"},
      {"workspace",
       "method = [\"proof\", \"grid\", \"monte-carlo\"]\nscan = {x = [\"-200 mm\", \"200 mm\", 21], z = [\"450 mm\", \"650 mm\", 21]}\n"
       "poses = 20000\nmap = \"condition\"\n"},
      {"study", "sweep = {stroke_max = [\"0.8 m\", \"0.9 m\", 3]}\n"},
      {"comparison", "[[section.row]]\nwhat = \"freedoms\"\nhere = \"mobility.freedoms\"\npaper = \"5\"\n"},
  };
  const auto own = keys.find(kind);
  return "[[section]]\nkind = \"" + kind + "\"\n" + (own != keys.end() ? own->second : "") + "\n";
}

std::string every_section() {
  const std::string text(small);
  std::string out = text.substr(0, text.find("[[section]]")) + "[drive]\nlead = \"5 mm\"\n\n[limits]\nactuator_force = \"10 kN\"\n\n";
  for (const std::string& kind : registered_kinds()) out += section_of(kind);
  return out + text.substr(text.find("[[check]]"));
}

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
  REQUIRE(registered_kinds().size() >= 15);
  const std::string everything = every_section();
  const Result made = here.report(everything);
  INFO(made.err);
  REQUIRE(made.status == 0);
  const auto first = contents(here.report_folder());
  REQUIRE(first.size() > 10);
  for (const char* file : {"report.html", "report.pdf", "results.json", "junit.xml", "data/displacement.csv", "figures/displacement.svg"})
    REQUIRE(first.contains(file));

  {
    INFO("another locale, in which the decimal sign is a comma");
    const std::string locales = (here / "locales").string();
    std::filesystem::create_directories(locales);
    const Result compiled = run({"localedef", "-i", "de_DE", "-f", "UTF-8", locales + "/de_DE.UTF-8"});
    INFO(compiled.err);
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
    REQUIRE(run_pmreport({(here / "scenario.toml").string(), "--out", out}, {.folder = "/"}).status == 0);
    check_same(first, contents(out));
  }
}

TEST_CASE("the date of the PDF follows SOURCE_DATE_EPOCH") {
  const Workshop here;
  const Surroundings dated{.environment = {{"SOURCE_DATE_EPOCH", "1234567890"}, {"TZ", "Asia/Tokyo"}}};  // 2009-02-13 23:31:30 UTC
  REQUIRE(here.report(small, {}, dated).status == 0);
  CHECK(bytes_of(here.report_folder() / "report.pdf").find("<xmp:CreateDate>2009-02-13T23:31:30Z<") != std::string::npos);
}
