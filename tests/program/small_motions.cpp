// What is small beside the machine, or no number at all, as the program tells it.
#include <catch2/catch.hpp>
#include <tests/program/workshop.hpp>

#include <algorithm>
#include <regex>

using namespace program_test;
using Catch::Contains;

namespace {

// A piezo hexapod: legs of 109 mm, a scan of 10 µm with 0.02 µm of wobble.
constexpr std::string_view scan = R"toml(title = "Scan"
[mechanism]
use = "gough"
[mechanism.parameters]
base_radius = "120 mm"
platform_radius = "110 mm"
base_half_angle = "8 deg"
platform_half_angle = "8 deg"
home_position = ["0 mm", "0 mm", "66 mm"]
stroke_min = "0 mm"
stroke_max = "200 mm"
platform_mass = "15 kg"
cylinder_mass = "0.5 kg"
cylinder_length = "50 mm"
cylinder_radius = "10 mm"
rod_mass = "0.2 kg"
rod_length = "50 mm"
rod_radius = "5 mm"
[motion]
duration = "0.1 s"
samples = 401
x = "10 um * sin(2*pi*t/50 ms)"
z = "66 mm + 0.02 um * sin(2*pi*t/10 ms)"
gamma = "5 urad * sin(2*pi*t/50 ms)"
[[section]]
kind = "displacement"
[[check]]
that = "max(z)"
equals = "66.00002 mm"
within = "1 nm"
)toml";

// The cells of a table's row, by its first cell.
std::vector<std::string> row_of(const std::string& page, const std::string& first) {
  const auto at = page.find(">" + first + "</th>");
  REQUIRE(at != std::string::npos);
  const std::string row = page.substr(at - 1, page.find("</tr>", at) - at + 1);
  const std::regex cell(">([^<>]+)<");
  std::vector<std::string> out;
  for (std::sregex_iterator i(row.begin(), row.end(), cell), end; i != end; ++i)
    if ((*i)[1].str().find_first_not_of(" \n") != std::string::npos) out.push_back((*i)[1]);
  return out;
}

}  // namespace

TEST_CASE("a scan of some µm is seen in the tables of a machine of some cm") {
  const Workshop here;
  const Result result = here.report(scan);
  INFO(result.out << result.err);
  REQUIRE(result.status == 0);
  const std::string page = bytes_of(here.report_folder() / "report.html");
  const std::vector<std::string> x = row_of(page, "x"), z = row_of(page, "z"), gamma = row_of(page, "gamma"), leg = row_of(page, "rho1");
  CHECK(x == std::vector<std::string>{"x", "X position", "−10", "0.0375 s", "10", "0.0125 s", "µm"});
  CHECK(z[2] == "65.99998");
  CHECK(z[4] == "66.00002");
  CHECK(gamma[4] == "5");
  CHECK(gamma[6] == "µrad");
  // A leg's shortest and longest, with three digits of what lies between, against the data.
  const auto data = columns(here.report_folder() / "data/displacement.csv").at("rho1");
  const auto [low, high] = std::minmax_element(data.begin(), data.end());
  const double span = (*high - *low) * 1e3;
  REQUIRE(span < 0.01);
  CHECK(std::stod(leg[4]) - std::stod(leg[2]) == Approx(span).epsilon(5e-3));
}

TEST_CASE("characters that are none are no reason not to write a report") {
  const Workshop here;
  const Result result = here.report(with(small, {{"\"Small\"", "\"Tiny \\uFDD0\\U0010FFFF\"\nauthor = \"\\uFDEF\""}}));
  INFO(result.out << result.err);
  CHECK(result.status == 0);
  CHECK(run({"pdfinfo", (here.report_folder() / "report.pdf").string()}).status == 0);
  CHECK(run({"xmllint", "--noout", (here.report_folder() / "junit.xml").string()}).status == 0);
}

TEST_CASE("where nothing has a value, checks and evidence say why, and nothing is compared with it") {
  const Workshop here;
  const Result result = here.report(
      "title = \"Far\"\n[mechanism]\nuse = \"delta\"\n[motion]\nduration = \"1 s\"\nsamples = 5\nx = \"2 m\"\n"
      "[[section]]\nkind = \"displacement\"\n[[section]]\nkind = \"statics\"\n"
      "[[check]]\nthat = \"max(abs(actuator_force))\"\nbelow = \"1 N*m\"\n");
  CHECK(result.status == 1);
  CHECK_THAT(result.out,
             Contains("max(abs(actuator_force)) has no value: theta1_force has none at any sample: no sample can be assembled ("));
  CHECK(std::regex_search(result.out, std::regex("FAILED: [0-9]+ checks, [0-9]+ lines of evidence, [0-9]+ failed, .*[0-9]+ not examined")));
  const std::string page = bytes_of(here.report_folder() / "report.html");
  CHECK_THAT(page, Contains("not examined: no sample can be assembled (a platform joint is too far from its motor"));
  CHECK_FALSE(std::regex_search(result.out, std::regex("(^|[^a-z])nan[^a-z]")));
}

TEST_CASE("rounding beside numbers of its sort is zero in the matrices of a source too") {
  const Workshop here;
  // Where the platform stands over Y its fifth slider does not feel X and beta: the sums that say so leave 4e-17.
  REQUIRE(here.report("title = \"Arc\"\n[mechanism]\nuse = \"5pus-upu\"\n[motion]\nduration = \"10 s\"\nsamples = 3\n"
                      "y = \"50 mm * cos(60 deg + 6 deg * t/1 s)\"\nz = \"-50 mm * sin(60 deg + 6 deg * t/1 s)\"\n"
                      "[[section]]\nkind = \"velocity\"\n")
              .status == 0);
  const std::string page = bytes_of(here.report_folder() / "report.html");
  const auto at = page.find("Matrix J, ");
  REQUIRE(at != std::string::npos);
  const std::string matrix = page.substr(at, page.find("</table>", at) - at);
  CHECK_FALSE(std::regex_search(matrix, std::regex("e−1[0-9]<")));
  CHECK_THAT(matrix, Contains(">0<"));
}
