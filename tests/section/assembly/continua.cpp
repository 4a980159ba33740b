// Section `assembly` where modes are not isolated, or meet: two legs in a plane, whose modes are where two circles meet.
#include <catch2/catch.hpp>

#include <reports/section/assembly/assembly.hpp>
#include <tests/given/two_legs.hpp>
#include <tests/section/gantry.hpp>

using namespace pmreport;
using Catch::Matchers::Contains;
using report_words::table_of;

namespace {

struct LegsRun {
  LegsRun(const std::string& apart, const std::string& motion)
      : loaded(scenario::load_text("title = \"Two legs\"\n[mechanism]\nuse = \"two-legs\"\nparameters = { apart = \"" + apart +
                                       "\" }\n[motion]\nduration = \"2 s\"\nsamples = 21\n" + motion + "[[section]]\nkind = \"assembly\"\n",
                                   "a.toml", test::only(test::two_legs()), section::kinds())),
        analysis(loaded.scenario, loaded.trajectory, *loaded.machine, analysis::asked_by(loaded.scenario), {}) {}
  section::Result assembly(double time = 0) {
    scene::Studio studio;
    section::AssemblyOptions request;
    request.time = time;
    return section::assembly_section(analysis, request, section::Stage(analysis, studio), {});
  }
  scenario::Loaded loaded;
  section::Analysis analysis;
};

}  // namespace

TEST_CASE("a continuum of poses is told apart from isolated modes, with its extent and two pictures") {
  LegsRun run("0 mm", "x = \"60 mm + 10 mm * t/1 s\"\ny = \"80 mm\"\n");
  const section::Result r = run.assembly();
  CHECK(gantry::value(r, "modes") == 0);
  CHECK(gantry::value(r, "continua") == 1);
  const std::string text = gantry::text_of(r.section);
  CHECK_THAT(text, Contains("0 isolated real assembly modes and 1 continuum (a curve of poses with the same actuator values)"));
  CHECK_THAT(text, Contains("The pose of the motion lies on a continuum: its actuators do not hold the platform there"));
  const auto row = report_words::row_of(r.section, "Continua", "1");
  CHECK(row.at(1) == "a curve, closed");
  // A circle of 100 mm about O: both coordinates go from -100 to 100 mm, but for the steps between poses.
  for (const std::string& range : {row.at(2), row.at(3)}) {
    CAPTURE(range);
    CHECK(range.starts_with("−"));
    CHECK(std::abs(std::stod(range.substr(range.rfind(' ') + 1)) - 100) < 3);
  }
  const auto galleries = report_words::blocks<document::Gallery>(r.section);
  REQUIRE(galleries.size() == 1);
  REQUIRE(galleries[0].pictures.size() == 2);
  CHECK_THAT(galleries[0].pictures[0].caption, Contains("the present pose on it"));
  CHECK_THAT(galleries[0].pictures[1].caption, Contains("a pose with the same actuator values"));
  CHECK(galleries[0].pictures[0].png != galleries[0].pictures[1].png);
  gantry::check_proofs(r.section, 4);
}

TEST_CASE("a mode in which two have met is told as double") {
  LegsRun run("300 mm", "x = \"120 mm\"\ny = \"100 mm * t/1 s\"\n");
  const section::Result r = run.assembly();
  CHECK(gantry::value(r, "modes") == 1);
  CHECK(gantry::value(r, "continua") == 0);
  CHECK_THAT(gantry::text_of(r.section), Contains("1 real assembly mode; 1 of them is double: two modes have met there"));
  CHECK(table_of(r.section, "Assembly modes,").rows.at(0).at(4) == "0, double");
}

TEST_CASE("modes that meet along the motion are told with their time") {
  // Through the line between the feet at 0.8 s: there the mirrored mode meets that of the mechanism, and parts from it again.
  LegsRun run("300 mm", "x = \"120 mm\"\ny = \"100 mm * (0.8 - t/1 s)\"\n");
  const section::Result r = run.assembly();
  CHECK(gantry::value(r, "modes") == 2);
  const document::Table& events = table_of(r.section, "Assembly modes that come into being or vanish");
  REQUIRE(events.rows.size() == 2);
  for (const auto& row : events.rows) {
    CHECK(std::stod(row.at(0)) == Approx(0.8).margin(1e-3));  // modes 1e-5 of the length apart count as one
    CHECK_THAT(row.at(1), Contains("it meets the mode of the mechanism on a singular surface"));
  }
  CHECK_THAT(events.rows[0].at(1) + events.rows[1].at(1), Contains("vanishes") && Contains("comes into being"));
  CHECK_THAT(gantry::text_of(r.section), Contains("The motion has 2 assembly modes at its beginning, 2 at its end"));
}
