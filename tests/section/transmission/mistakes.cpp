// What a section `transmission` refuses. The stage's turntable is turned by a couple, and so has neither pressure angle nor index.
#include <tests/scenario/trial.hpp>

using namespace pmreport;
using Catch::Contains;
using trial::told, trial::with_more;

namespace {

std::string with_section(const std::string& keys, const std::string& more = "") {
  return with_more("[[section]]\nkind = \"transmission\"\n" + keys + more);
}
std::string with_check(const std::string& that) { return with_section("", "[[check]]\nthat = \"" + that + "\"\nabove = \"0.5\"\n"); }

}  // namespace

TEST_CASE("a map refuses indices that there are not, and those that the mechanism has not, with the reason") {
  CHECK_THAT(told(with_section("map = { x = [\"0 mm\", \"1 mm\"], phi = [\"0 deg\", \"1 deg\"], show = [\"q_outptu\"] }\n")),
             Contains("did you mean \"q_output\"?"));
  CHECK_THAT(told(with_section("map = { x = [\"0 mm\", \"1 mm\"], phi = [\"0 deg\", \"1 deg\"], show = [\"psi_output\"] }\n")),
             Contains("psi_output cannot be shown on a map: it turns the platform by a couple"));
  CHECK_THAT(told(with_section("map = { x = [\"0 mm\", \"1 mm\"], phi = [\"0 deg\", \"1 deg\"], show = [\"q_output\", \"q_output\"] }\n")),
             Contains("\"q_output\" is given twice"));
  CHECK_THAT(told(with_section("map = { x = [\"0 mm\", \"1 mm\"], phi = [\"1 deg\", \"0 deg\"] }\n")), Contains("that rises"));
}

TEST_CASE("checks on numbers that the mechanism never has are refused, alone and in a group") {
  CHECK_THAT(told(with_check("min(psi_output)")),
             Contains("psi_output has no number for this mechanism: it turns the platform by a couple"));
  CHECK_THAT(told(with_check("min(output_transmission)")),
             Contains("psi_output has no number for this mechanism") && Contains("name those that have: q_output"));
  CHECK_THAT(told(with_check("min(local_transmission)")), Contains("local_transmission has no number for this mechanism: psi has none"));
  CHECK_THAT(told(with_check("transmission.least_local")), Contains("transmission.least_local has no number"));
  CHECK(told(with_check("min(q_output)")).empty());
  CHECK(told(with_check("transmission.least_conditioning")).empty());
}

TEST_CASE("columns of transmission need the section") {
  CHECK_THAT(told(with_more("[[check]]\nthat = \"min(local_conditioning)\"\nabove = \"0.1\"\n")),
             Contains("belongs to the section \"transmission\"") && Contains("kind = \"transmission\""));
}

TEST_CASE("a grid needs how many values there are, limits need a grid, and a length is above zero") {
  CHECK_THAT(told(with_section("grid = { x = [\"0 mm\", \"1 mm\"] }\n")), Contains("expected how many values x takes"));
  CHECK_THAT(told(with_section("limits = [\"strokes\"]\n")), Contains("limits count for a grid, and there is none"));
  CHECK_THAT(told(with_section("grid = { x = [\"0 mm\", \"1 mm\", 10000], phi = [\"0 deg\", \"1 deg\", 10000] }\n")),
             Contains("expected a grid of at most 5000000 poses, seen 100000000"));
  CHECK_THAT(told(with_section("length = \"0 mm\"\n")), Contains("expected a length above 0 mm"));
  CHECK_THAT(told(with_section("grid = { z = [\"0 mm\", \"1 mm\", 3] }\n")), Contains("z"));
}

TEST_CASE("without motion, pose, map and grid there is nothing to look at") {
  const std::string text =
      "title = \"Stage\"\n[mechanism]\nuse = \"stage\"\nparameters = { arm = \"200 mm\" }\n[[section]]\nkind = \"transmission\"\n";
  CHECK_THAT(told(text), Contains("has nothing to look at: there is no motion, no pose, no map and no grid"));
  CHECK(told(text + "grid = { x = [\"0 mm\", \"1 mm\", 3] }\n").empty());
}

TEST_CASE("a workspace refuses a limit on an index that the mechanism has not, or that no pose could keep") {
  const auto limited = [](const std::string& limit) {
    return told(with_more(
        "[[section]]\nkind = \"workspace\"\nmethod = \"grid\"\nscan = { x = [\"-10 mm\", \"10 mm\", 3] }\n[[section.limit]]\n" + limit));
  };
  CHECK_THAT(limited("index = \"transmission\"\nmin = \"0.7\"\n"),
             Contains("the local transmission index is not known, for psi has none: it turns the platform by a couple"));
  CHECK_THAT(limited("index = \"pressure\"\nmax = \"45 deg\"\n"), Contains("the pressure angle of psi is not known"));
}
