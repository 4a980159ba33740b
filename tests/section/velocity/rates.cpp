// Sections `velocity` and `acceleration` on the gantry: x = A sin(w t), A = 50 mm, w = pi / s, and the drive is x.
#include <catch2/catch.hpp>

#include <tests/section/report_words.hpp>
#include <tests/section/whole_report.hpp>

#include <cmath>
#include <numbers>

using namespace pmreport;
using namespace whole_report;
using Catch::Contains;
using report_words::check_proofs, report_words::row_of, report_words::text_of;

namespace {

constexpr double amplitude = 50, w = std::numbers::pi;  // [mm], [1/s]

}  // namespace

TEST_CASE("rates of the actuators and the twist of the platform are the derivatives of the motion") {
  const auto r = of_gantry(asking_for({"velocity"}));
  const document::Section& s = section_of(r, "velocity");
  const auto &rate = series_of(s, "actuator rate", "q\u0307").y, &vx = series_of(s, "velocity of the platform", "vx").y,
             &vy = series_of(s, "velocity of the platform", "vy").y;
  CHECK(panel_of(s, "actuator rate").y.unit == "mm/s");
  for (std::size_t k = 0; k < 21; ++k) {
    const double expected = amplitude * w * std::cos(w * 0.1 * double(k));
    CHECK(rate[k] == Approx(expected).margin(1e-9));
    CHECK(vx[k] == Approx(expected).margin(1e-9));
    CHECK(vy[k] == 0);
  }
  // What does not move is told, not drawn.
  CHECK(panels_of(s) == std::vector<std::string>{"actuator rate", "velocity of the platform"});
  CHECK_THAT(report_words::pointers<figure::Figure>(s).at(0)->caption,
             Catch::EndsWith("Constant, so not drawn: angular velocity of the platform, ωx = ωy = ωz = 0 °/s. "
                             "Constant, so not drawn: condition number of G, 1."));
  check_proofs(s, 4);
}

TEST_CASE("a Jacobian that is the identity has the determinant one and the condition number one at every sample") {
  const auto r = of_gantry(asking_for({"velocity"}));
  CHECK(row_of(section_of(r, "velocity"), "Extremes", "det_G")[2] == "1");
  CHECK(row_of(section_of(r, "velocity"), "Extremes", "det_G")[4] == "1");
  for (const double c : column_of(r, "velocity", "condition")) CHECK(c == Approx(1));
}

TEST_CASE("accelerations are the second derivatives of the motion") {
  const auto r = of_gantry(asking_for({"acceleration"}));
  const document::Section& s = section_of(r, "acceleration");
  const auto& q = column_of(r, "acceleration", "q_acceleration [m/s^2]");
  for (std::size_t k = 0; k < 21; ++k) CHECK(q[k] == Approx(-1e-3 * amplitude * w * w * std::sin(w * 0.1 * double(k))).margin(1e-12));
  const auto row = row_of(s, "Extremes", "q_acceleration");
  CHECK(row[3] == "0.5 s");  // the smallest, where x is largest
  CHECK(row[5] == "1.5 s");
  check_proofs(s, 4);
}

TEST_CASE("a table that turns while it slides has the velocity of its slide and the angular velocity of its turn") {
  const auto r = of_stage("", "x = \"100 mm * t / 1 s\"\nphi = \"15 deg * (t / 1 s)^2\"\n", asking_for({"velocity", "acceleration"}));
  constexpr double deg = std::numbers::pi / 180;
  const auto &vx = column_of(r, "velocity", "velocity_x [m/s]"), &wz = column_of(r, "velocity", "angular_velocity_z [rad/s]");
  for (std::size_t k = 0; k < 21; ++k) {
    CHECK(vx[k] == Approx(0.1));
    CHECK(wz[k] == Approx(30 * deg * 0.1 * double(k)).margin(1e-12));
    CHECK(column_of(r, "acceleration", "psi_acceleration [rad/s^2]")[k] == Approx(30 * deg));
  }
}
