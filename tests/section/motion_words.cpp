// What a report_of says of a motion that jumps, or that its samples do not show.
#include <catch2/catch.hpp>
#include <tests/section/whole_report.hpp>

#include <algorithm>

using namespace pmreport;
using namespace whole_report;
using Catch::Contains;

namespace {

document::Report report_of(const std::string& motion, const std::vector<std::string>& kinds) {
  return of_stage("", motion, asking_for(kinds));
}

const document::Check* demand(const document::Report& r, const std::string& name) {
  const auto found = std::find_if(r.checks.begin(), r.checks.end(), [&](const document::Check& c) { return c.name == name; });
  return found != r.checks.end() ? &*found : nullptr;
}
const document::Check* smoothness(const document::Report& r) { return demand(r, "values and rates of the motion do not jump"); }
const document::Check* visibility(const document::Report& r) { return demand(r, "the samples show the motion"); }

// Of one tone, a line each.
std::string summary(const document::Report& r, document::Paragraph::Tone tone) {
  std::string out;
  for (const document::Paragraph& p : r.summary)
    if (p.tone == tone) out += p.text + "\n";
  return out;
}
constexpr auto note = document::Paragraph::Tone::note;
std::string faults(const document::Report& r) {
  std::string out;
  for (const document::Finding& f : r.findings)
    if (f.kind == document::Finding::Kind::fault) out += f.text + "\n";
  return out;
}

}  // namespace

TEST_CASE("a corner fails the report where rates or forces are asked for, and is a warning where places alone are") {
  const std::string corner = "x = \"50 mm - 100 mm * abs(t/1 s - 0.5)\"\n";
  const std::string sentence = "The rate of x jumps by 200 mm/s at t = 0.5 s: no finite force follows it.";
  for (const char* kind : {"velocity", "acceleration", "dynamics"}) {
    CAPTURE(kind);
    const document::Report r = report_of(corner, {kind});
    REQUIRE(smoothness(r));
    CHECK_FALSE(smoothness(r)->passed);
    CHECK(smoothness(r)->message == sentence);
    CHECK(smoothness(r)->measured == "1 jump");
    CHECK_FALSE(r.passed());
    CHECK_THAT(faults(r), Contains(sentence));
  }
  const document::Report places = report_of(corner, {"displacement"});
  CHECK_FALSE(smoothness(places));
  CHECK(places.passed());
  CHECK_THAT(faults(places), Contains(sentence));
}

TEST_CASE("many jumps are one sentence with the first times and the largest jump") {
  const document::Report r = report_of("x = \"1 mm * abs(sin(pi*5*t/1 s))\"\n", {"velocity"});
  REQUIRE(smoothness(r));
  CHECK(smoothness(r)->message ==
        "The rate of x jumps 9 times, by up to 31.42 mm/s, at t = 0.2 s, 0.4 s, 0.6 s and later: no finite force follows it.");
}

TEST_CASE("a jump of acceleration alone is legal, and noted") {
  const document::Report r = report_of("x = \"1 mm/s^2 * max(t - 1.1 s, 0 s)^2\"\nphi = \"1 deg * sin(t/1 s)\"\n", {"dynamics"});
  REQUIRE(smoothness(r));
  CHECK(smoothness(r)->passed);
  CHECK(r.passed());
  CHECK(summary(r, note).starts_with("The acceleration of x jumps by 2 mm/s² at t = 1.1 s: the forces jump with it."));
}

TEST_CASE("what moves between the samples fails the report, with its size and the number of samples that would do") {
  const document::Report r = report_of("x = \"1 mm * sin(2*pi*10 Hz*t)\"\n", {"displacement"});
  REQUIRE(visibility(r));
  CHECK_FALSE(visibility(r)->passed);
  CHECK(visibility(r)->measured == "1 hidden");
  CHECK_THAT(visibility(r)->message, Contains("Between samples x goes up to ") && Contains("it moves by 2 mm in all") &&
                                         Contains("21 samples cannot show it, 501 do."));
  CHECK_FALSE(r.passed());
  CHECK_THAT(faults(r), Contains(visibility(r)->message));
}

TEST_CASE("a sound motion meets both demands") {
  const document::Report r = report_of("x = \"20 mm * sin(2*pi*t/2 s)\"\n", {"dynamics"});
  REQUIRE((smoothness(r) && visibility(r)));
  CHECK(smoothness(r)->passed);
  CHECK(visibility(r)->passed);
  CHECK(visibility(r)->measured == "nothing hidden");
}
