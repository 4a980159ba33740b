// A motion that the mechanism does not like: the report is written, tells it, and the exit status is 1.
#include <catch2/catch.hpp>
#include <tests/program/workshop.hpp>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

using namespace program_test;
using Catch::Contains;

namespace {

const std::string alpha = "1 deg * (1 - cos(2*pi*t/2 s))";

// Words that a number which is not finite could leave in a file of text.
void check_no_nan(const Workshop& here) {
  const std::regex word("(^|[^A-Za-z])([Nn]a[Nn]|NAN|[Ii]nf|INF|Infinity)([^A-Za-z]|$)");
  for (const auto& [name, bytes] : contents(here.report_folder())) {
    if (name.ends_with(".pdf") || name.ends_with(".png")) continue;
    INFO(name);
    // The page's own program may speak of numbers that are none, and the letters of an embedded picture spell anything.
    const auto program = bytes.find("<script type=\"module\">"), end = bytes.find("</script>", program);
    std::string told = program == std::string::npos ? bytes : bytes.substr(0, program) + bytes.substr(end);
    for (std::size_t at; (at = told.find(";base64,")) != std::string::npos;)
      told.erase(at, told.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/=", at + 8) - at);
    std::smatch found;
    const bool seen = std::regex_search(told, found, word);
    INFO((seen ? told.substr(static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, found.position() - 40)), 80) : ""));
    CHECK_FALSE(seen);
  }
}

// The warnings of the summary, which stand in every form of the report.
std::string warnings(const Workshop& here) {
  const auto json = nlohmann::json::parse(bytes_of(here.report_folder() / "results.json"));
  std::string out;
  for (const auto& w : json["warnings"]) out += w["text"].get<std::string>() + "\n";
  return out;
}

}  // namespace

TEST_CASE("a motion out of reach is told, leaves a gap in the data and nowhere a NaN") {
  const Workshop here;
  // At home the revolute axis points 53.1 degrees from X, across limb 5 from A5 at azimuth 315 to B5 at 288 degrees: turned back by
  // that angle it is perpendicular to y, which it no longer determines.
  const Result result = here.report(with(small, {{alpha, "-80 deg * t/2 s"}}));
  CHECK(result.status == 1);
  CHECK_THAT(result.out, Contains("FAILED  the mechanism can be assembled: ") && Contains("the mechanism cannot be assembled") &&
                             Contains("the revolute axis is almost perpendicular to the dependent coordinate"));
  CHECK_THAT(warnings(here), Contains("the mechanism cannot be assembled"));
  CHECK_THAT(bytes_of(here.report_folder() / "report.html"), Contains("the mechanism cannot be assembled"));

  int gaps = 0, numbers = 0;
  const auto data = columns(here.report_folder() / "data/displacement.csv");
  for (std::size_t k = 0; k < 21; ++k) {
    CHECK(std::isfinite(data.at("t")[k]));
    (std::isnan(data.at("l1")[k]) ? gaps : numbers) += 1;
    CHECK(std::isnan(data.at("l1")[k]) == std::isnan(data.at("y")[k]));
  }
  CHECK(gaps > 0);
  CHECK(numbers > 0);
  CHECK_THAT(result.out, Contains("(" + std::to_string(gaps) + " sample"));
  check_no_nan(here);
}

TEST_CASE("a motion that is never in reach makes a report all the same") {
  const Workshop here;
  const Result result =
      here.report(with(small, {{alpha, "-53.1 deg"}, {"[[check]]", "[[section]]\nkind = \"snapshots\"\nsize = [400, 300]\n\n[[check]]"}}));
  CHECK(result.status == 1);
  CHECK_THAT(result.out, Contains("max(abs(actuator_force)) has no value: l1_force has none at any sample: no sample can be assembled"));
  CHECK_THAT(warnings(here), Contains("no picture, the mechanism cannot be assembled"));
  check_no_nan(here);
}

TEST_CASE("a singular surface that is crossed again and again is told once, with how often") {
  const Workshop here;
  const Result result = here.report(with(small, {{"samples = 21", "samples = 201"}, {alpha, "25 deg * sin(2*pi*t/0.5 s + 0.1)"}}));
  CHECK(result.status == 1);
  const std::vector<double> det = columns(here.report_folder() / "data/velocity.csv").at("det_G");
  int changes = 0;
  for (std::size_t k = 0; k + 1 < det.size(); ++k) changes += det[k] * det[k + 1] < 0;
  REQUIRE(changes > 3);
  const std::string sentence =
      "The motion crosses a singular surface " + std::to_string(changes) + " times: det G changes its sign, first at";
  CHECK_THAT(result.out, Contains("FAILED  no singular surface is met: " + sentence));
  CHECK_THAT(warnings(here), Contains(sentence) && !Contains("Between t = "));
}

TEST_CASE("a singular surface on the way is told") {
  const Workshop here;
  const Result result = here.report(with(small, {{alpha, "25 deg * sin(2*pi*t/2 s)"}}));
  CHECK(result.status == 1);
  CHECK_THAT(result.out, Contains("FAILED  no singular surface is met: Between t = ") && Contains("det G changes its sign"));
  const std::vector<double> det = columns(here.report_folder() / "data/velocity.csv").at("det_G");
  const auto [low, high] = std::minmax_element(det.begin(), det.end());
  CHECK(*low < 0);
  CHECK(*high > 0);
  check_no_nan(here);
}

TEST_CASE("limbs beyond the ends of their strokes are told in one sentence, with the worst, its time, its length and the limit") {
  const Workshop here;
  const Result result = here.report(with(small, {{"\"550 mm\"", "\"550 mm + 500 mm * step5(t, 0 s, 2 s)\""}}));
  CHECK(result.status == 1);
  const auto data = columns(here.report_folder() / "data/displacement.csv");
  std::set<std::size_t> samples;
  std::string longest;
  const std::string page = bytes_of(here.report_folder() / "report.html");
  for (const std::string limb : {"l1", "l2", "l3", "l4", "l5"}) {
    const std::vector<double>& l = data.at(limb);
    CAPTURE(limb);
    for (std::size_t k = 0; k < l.size(); ++k)
      if (l[k] > 0.850) samples.insert(k);
    REQUIRE(*std::max_element(l.begin(), l.end()) > 0.850);
    if (longest.empty() || *std::max_element(l.begin(), l.end()) > *std::max_element(data.at(longest).begin(), data.at(longest).end()))
      longest = limb;
    CHECK_THAT(page, Contains(limb + " (length of limb " + limb.back() + ")"));  // each has its row in the table
  }
  const std::vector<double>& l = data.at(longest);
  const auto worst = std::max_element(l.begin(), l.end());
  std::smatch found;
  const std::string told = warnings(here);
  REQUIRE(std::regex_search(told, found,
                            std::regex(R"(l1 to l5 leave their strokes, ([0-9]+) times in all, between t = ([0-9.]+) s and 2 s, at most )"
                                       R"((l.) by ([0-9.]+) mm \(([0-9.]+) mm at t = ([0-9.]+) s, its stroke ends at 850 mm\)\.)")));
  CHECK(found[1] == "5");
  // The first sample beyond a stroke comes after the motion left it, and within a step.
  CHECK(std::stod(found[2]) <= 0.1 * static_cast<double>(*samples.begin()));
  CHECK(std::stod(found[2]) >= 0.1 * static_cast<double>(*samples.begin()) - 0.1);
  CHECK(found[3] == longest);
  CHECK(std::stod(found[4]) == Approx(*worst * 1e3 - 850).epsilon(5e-3));                            // told with three digits
  CHECK(std::stod(found[5]) == Approx(*worst * 1e3).epsilon(5e-4));                                  // with four
  CHECK(std::stod(found[6]) == Approx(0.1 * static_cast<double>(worst - l.begin())).margin(0.1));    // beside it, within a step
  CHECK_THAT(result.out, Contains("FAILED  strokes and joint limits are kept: " + found[0].str()));  // the console names it too
  // The values stand in the data: a limit is no gap.
  for (const auto& [name, column] : data) {
    CAPTURE(name);
    CHECK(std::none_of(column.begin(), column.end(), [](double x) { return std::isnan(x); }));
  }
}
