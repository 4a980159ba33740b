// Numbers of a report against published ones: verdicts worked out by hand, notes, gates.
#include <catch2/catch.hpp>

#include <reports/section/comparison/comparison.hpp>
#include <tests/scenario/trial.hpp>
#include <tests/section/report_words.hpp>

using namespace pmreport;
using Catch::Contains;
using report_words::table_of;

namespace {

// x runs from 0 to 20 mm; `values` stand for those of other sections.
section::Result compare(const std::string& rows, const std::string& options = "") {
  const std::string text = trial::with("20 mm * sin(2*pi*t/10 s)", "10 mm * t / 1 s") +
                           "[[section]]\nkind = \"classification\"\n[[section]]\nkind = \"comparison\"\n" + options + rows;
  INFO(trial::told(text));
  const scenario::Loaded loaded = scenario::load_text(text, "a.toml", stage::source(), section::kinds());
  const section::Analysis a(loaded.scenario, loaded.trajectory, *loaded.machine, analysis::asked_by(loaded.scenario), {});
  return section::comparison_section(a, options_of<section::ComparisonOptions>(loaded.scenario.sections.back()),
                                     {{"classification", "by_rule", "", 151}, {"classification", "base_schemes", "", 118}});
}

std::string row(const std::string& here, const std::string& paper, const std::string& more) {
  return "[[section.row]]\nwhat = \"a number\"\nhere = \"" + here + "\"\npaper = \"" + paper + "\"\n" + more + "\n";
}

std::string first_sentence(const section::Result& r) { return std::get<document::Paragraph>(r.section.blocks.at(0)).text; }

}  // namespace

TEST_CASE("a value reproduces within its tolerance, both ends included, and not beyond") {
  const section::Result r =
      compare(row("max(x)", "20.05 mm", "tolerance = \"0.05 mm\"") + row("max(x)", "20.06 mm", "tolerance = \"0.05 mm\"") +
              row("max(x)", "1.995 cm", "tolerance = \"0.05 mm\"") + row("max(x)", "19.9 mm", "tolerance = \"0.05 mm\""));
  const auto& rows = table_of(r.section).rows;
  REQUIRE(rows.size() == 4);
  CHECK(rows[0] == std::vector<std::string>{"a number", "20.05", "20", "−0.05", "0.05", "mm", "reproduces"});
  CHECK(rows[1].back() == "does not reproduce");
  CHECK(rows[2].back() == "reproduces");
  CHECK(rows[3] == std::vector<std::string>{"a number", "19.9", "20", "0.1", "0.05", "mm", "does not reproduce"});
  CHECK(first_sentence(r) == "2 of 4 published values reproduce within their tolerances; 2 do not.");
  CHECK(r.checks.empty());
  REQUIRE(r.values.size() == 2);
  CHECK(r.values[1].value == 2);
}

TEST_CASE("published values stand in the unit that they were published in") {
  const section::Result r = compare(row("max(x)", "1.995 cm", "tolerance = \"0.05 mm\"") + row("max(x)", "0.02 m", "tolerance = \"1 mm\""));
  const auto& rows = table_of(r.section).rows;
  CHECK(rows[0] == std::vector<std::string>{"a number", "1.995", "2", "0.005", "0.005", "cm", "reproduces"});
  CHECK(rows[1] == std::vector<std::string>{"a number", "0.02", "0.02", "0", "0.001", "m", "reproduces"});
}

TEST_CASE("counts are compared as whole numbers, exactly unless a tolerance is given") {
  const section::Result r = compare(row("classification.by_rule", "151", "") + row("classification.base_schemes", "117", "") +
                                        row("classification.base_schemes", "117", "tolerance = 1"),
                                    "source = \"Glazunov et al. 2008\"\n");
  const auto& rows = table_of(r.section).rows;
  CHECK(rows[0] == std::vector<std::string>{"a number", "151", "151", "0", "exact", "", "reproduces"});
  CHECK(rows[1] == std::vector<std::string>{"a number", "117", "118", "1", "exact", "", "does not reproduce"});
  CHECK(rows[2] == std::vector<std::string>{"a number", "117", "118", "1", "1", "", "reproduces"});
  CHECK(first_sentence(r) == "2 of 3 values published by Glazunov et al. 2008 reproduce within their tolerances; 1 does not.");
}

TEST_CASE("a value that this report could not compute is told, never a number") {
  const section::Result r = compare(row("classification.six_chains", "40", "verdict = \"reproduces\""));  // not among the values
  CHECK(table_of(r.section).rows[0] == std::vector<std::string>{"a number", "40", "–", "–", "exact", "", "no value here"});
  CHECK_THAT(first_sentence(r), Contains("1 has no value here"));
  REQUIRE(r.checks.size() == 1);
  CHECK_FALSE(r.checks[0].passed);
  CHECK(r.checks[0].message == "a number: classification.six_chains has no value to compare with the published 40");
}

TEST_CASE("a verdict in the scenario is a gate, whichever way it goes") {
  const auto gate = [](const std::string& paper, const std::string& verdict) {
    return compare(row("max(x)", paper, "tolerance = \"0.05 mm\"\nverdict = \"" + verdict + "\"")).checks.at(0);
  };
  CHECK(gate("20 mm", "reproduces").passed);
  CHECK(gate("21 mm", "differs").passed);
  const document::Check slipped = gate("20 mm", "differs"), lost = gate("21 mm", "reproduces");
  CHECK_FALSE(slipped.passed);
  CHECK(slipped.name == "a number: differs from 20 mm");
  CHECK(slipped.limit == "not 20 ± 0.05 mm");
  CHECK_FALSE(lost.passed);
  CHECK(lost.limit == "21 ± 0.05 mm");
  CHECK(lost.measured == "20 mm");
  CHECK(lost.message == "a number: max(x) is 20 mm, published is 21 mm; the scenario says that it reproduces");
  CHECK(lost.line == 16);
}

TEST_CASE("sources have a column where a row has one, and notes stand below the table") {
  const section::Result r = compare(row("max(x)", "20 mm", "tolerance = \"1 mm\"\nsource = \"Table 1\"\nnote = \"rounded\"") +
                                    row("min(x)", "0 mm", "tolerance = \"1 mm\"\nnote = \"at rest.\""));
  const document::Table& t = table_of(r.section);
  CHECK(t.headings.back() == "source");
  CHECK(t.rows[0].back() == "Table 1");
  CHECK(t.rows[0][6] == "reproduces ¹");
  CHECK(t.rows[1][6] == "reproduces ²");
  REQUIRE(r.section.blocks.size() == 4);
  CHECK(std::get<document::Paragraph>(r.section.blocks[2]).text == "¹ a number: rounded.");
  CHECK(std::get<document::Paragraph>(r.section.blocks[3]).text == "² a number: at rest.");
}
