// Small numbers in figures and tables: signal where nothing larger stands beside them, rounding where it does. On the stage, whose actuator
// q bears the load along X, and whose constraint c1 bears that along Y, each alone.
#include <catch2/catch.hpp>

#include <reports/section/common/words/noise.hpp>
#include <tests/analysis/run.hpp>
#include <tests/scenario/trial.hpp>
#include <tests/section/report_words.hpp>
#include <tests/section/whole_report.hpp>

#include <cmath>

using namespace pmreport;
using namespace whole_report;
using report_words::row_of;

namespace {

document::Report loaded_by(const std::string& x, const std::string& y) {
  return of_stage("", "x = \"0 mm\"\nphi = \"0 deg\"\n",
                  "[load]\nforce = [\"" + x + "\", \"" + y + "\", \"0 N\"]\n" + asking_for({"statics"}));
}

}  // namespace

TEST_CASE("a ramp through zero stays a ramp, however small it is, where it is all there is") {
  for (const char* size : {"1 N", "1e-9 N", "1e-15 N"}) {
    CAPTURE(size);
    const auto r = loaded_by("0 N", std::string(size) + " * (t - 0.95 s) / 1 s");
    const document::Section& s = section_of(r, "statics");
    const std::vector<double>& curve = series_of(s, "constraint force", "c₁").y;
    REQUIRE(curve.size() == 21);
    const double step = curve[1] - curve[0];
    CHECK(step != 0);
    for (std::size_t k = 0; k + 1 < curve.size(); ++k) CHECK(curve[k + 1] - curve[k] == Approx(step));
  }
}

TEST_CASE("what is tiny beside its like is zero in figures and tables, and stands in the data") {
  const auto r = loaded_by("100 N", "1e-15 N * (t - 0.95 s) / 1 s");
  const document::Section& s = section_of(r, "statics");
  CHECK_THAT(report_words::text_of(s), Catch::Contains("Constant, so not drawn: constraint force, c₁ = c₂ = c₃ = c₄ = 0 N."));
  CHECK(row_of(s, "Extremes", "c1")[2] == "0");
  CHECK(row_of(s, "Extremes", "c1")[4] == "0");
  CHECK(column_of(r, "statics", "c1 [N]")[20] == Approx(-1.05e-15));
}

TEST_CASE("what is small beside its like and no rounding is shown") {
  const auto r = loaded_by("100 N", "1e-9 N * (t - 0.95 s) / 1 s");
  const document::Section& s = section_of(r, "statics");
  CHECK(std::abs(series_of(s, "constraint force", "c₁").y[20]) > 0);
}

TEST_CASE("forces and moments share a threshold by the machine's length, a unit of its own kind has its own") {
  const trial::Run run(trial::with("kind = \"displacement\"", "kind = \"statics\"") +
                       "[load]\nforce = [\"50 N\", \"0 N\", \"0 N\"]\nmoment = [\"0 N*m\", \"0 N*m\", \"2 N*m\"]\n");
  const section::Analysis& a = run.analysis;
  const double of_forces = section::noise(a, "N", {}), of_moments = section::noise(a, "N*m", {});
  CHECK(of_moments == Approx(of_forces * a.length()));
  // Some dozen roundings of what is there: 50 N, or 2 N m by the length.
  const double largest = std::max(50.0, 2 / a.length());
  CHECK(of_forces > 1e-15 * largest);
  CHECK(of_forces < 1e-13 * largest);
  CHECK(section::noise(a, "W", {}) == 0);
}
