// Section `displacement` on the stage: x of the carriage and the turn phi of the table, or the feeler's height y = r sin(phi), r = 200 mm.
#include <catch2/catch.hpp>

#include <core/numbers.hpp>
#include <tests/section/report_words.hpp>
#include <tests/section/whole_report.hpp>

#include <cmath>

using namespace pmreport;
using namespace whole_report;
using Catch::Contains;
using report_words::check_proofs, report_words::row_of, report_words::text_of;

namespace {

const std::string asked = asking_for({"displacement"});
// x from 0 to 200 mm, phi from 0 to 30 degrees.
const std::string steady = "x = \"100 mm * t / 1 s\"\nphi = \"15 deg * t / 1 s\"\n";

}  // namespace

TEST_CASE("curves of a displacement are coordinates, dependent ones and actuators in the units that a reader expects") {
  const auto r = of_stage("", steady, asked);
  const document::Section& s = section_of(r, "displacement");
  const auto &x = series_of(s, "position", "x"), &y = series_of(s, "position", "y"), &phi = series_of(s, "orientation", "φ");
  CHECK(panel_of(s, "position").y.unit == "mm");
  CHECK(panel_of(s, "orientation").y.unit == "°");
  for (std::size_t k = 0; k < 21; ++k) {
    const double t = 0.1 * double(k);
    CHECK(x.x[k] == Approx(t));
    CHECK(x.y[k] == Approx(100 * t).margin(1e-9));
    CHECK(y.y[k] == Approx(200 * std::sin(15 * deg * t)).margin(1e-9));
    CHECK(phi.y[k] == Approx(15 * t).margin(1e-9));
  }
}

TEST_CASE("a table tells the smallest and the largest of each quantity, and when") {
  const auto r = of_stage("", "x = \"20 mm * sin(pi*t/1 s)\"\nphi = \"30 deg\"\n", asked);
  const document::Section& s = section_of(r, "displacement");
  CHECK(row_of(s, "Extremes", "x") == std::vector<std::string>{"x", "slide", "−20", "1.5 s", "20", "0.5 s", "mm"});
  CHECK(row_of(s, "Extremes", "y") == std::vector<std::string>{"y", "feeler", "100", "0 s", "100", "0 s", "mm"});
  CHECK(row_of(s, "Extremes", "psi") == std::vector<std::string>{"psi", "turn", "30", "0 s", "30", "0 s", "°"});
}

TEST_CASE("the text names what is prescribed and what follows from it") {
  CHECK_THAT(
      text_of(section_of(of_stage("", steady, asked), "displacement")),
      Contains("The platform follows 2 prescribed coordinates") && Contains("Dependent, from the constraint of the limbs: y (feeler)."));
  CHECK_THAT(text_of(section_of(of_stage(", dependent = \"phi\"", "x = \"0 mm\"\ny = \"50 mm\"\n", asked), "displacement")),
             Contains("Dependent, from the constraint of the limbs: φ (turn)."));
  CHECK_THAT(text_of(section_of(of_stage("", "q = \"100 mm * t / 1 s\"\npsi = \"10 deg\"\n", asked), "displacement")),
             Contains("The scenario prescribes the 2 actuators"));
}

TEST_CASE("a displacement proves that the joints close, and that the actuators lead back to the pose") {
  const auto r = of_stage("", steady, asked);
  check_proofs(section_of(r, "displacement"), 3);
}

TEST_CASE("a stroke that is broken is told with its times, and shaded in every panel") {
  // Over 500 mm after 5/3 s: samples 17 to 20, which stand for the time from 1.65 s on.
  const auto r = of_stage("", "x = \"300 mm * t / 1 s\"\nphi = \"0 deg\"\n", asked);
  const document::Section& s = section_of(r, "displacement");
  CHECK_THAT(text_of(s), Contains("t = 1.7 s to 2 s") && Contains("needs 600 mm") && Contains("its stroke ends at 500 mm"));
  REQUIRE(panel_of(s, "position").bands.size() == 1);
  const figure::Band& band = panel_of(s, "position").bands[0];
  CHECK(band.kind == figure::Band::Kind::limit);
  CHECK(band.from == Approx(1.65));
  CHECK(band.to == Approx(2));
}

TEST_CASE("samples out of reach are gaps in the curves, told with the mechanism's reason") {
  // The feeler, 200 mm, is too short after 4/3 s: samples 14 to 20.
  const auto r = of_stage(", dependent = \"phi\"", "x = \"0 mm\"\ny = \"150 mm * t / 1 s\"\n", asked);
  const document::Section& s = section_of(r, "displacement");
  CHECK_THAT(text_of(s), Contains("t = 1.4 s to 2 s") && Contains("the feeler is too short"));
  const auto& phi = series_of(s, "orientation", "φ").y;
  for (std::size_t k = 0; k < 21; ++k) {
    CAPTURE(k);
    if (k < 14)
      CHECK(phi[k] == Approx(std::asin(0.075 * double(k)) / deg).margin(1e-9));
    else
      CHECK(std::isnan(phi[k]));
  }
  bool shaded = false;
  for (const figure::Band& b : panel_of(s, "orientation").bands) shaded = shaded || b.kind == figure::Band::Kind::unreachable;
  CHECK(shaded);
  CHECK_FALSE(r.passed());
}
