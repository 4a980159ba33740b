// Section `speed` on the gantry: with x = A sin(w t) the drive gives F = (m + m1) A w^2 sin(w t) and nothing at rest.
#include <reports/section/speed/speed.hpp>

#include <tests/section/gantry.hpp>

#include <cmath>
#include <numbers>

using namespace pmreport;
using Catch::Matchers::Contains;

namespace {

constexpr double w = std::numbers::pi, fastest = 0.05 * w, sharpest = 0.05 * w * w;  // [rad/s], [m/s], [m/s^2]
const std::string asked = "[[section]]\nkind = \"speed\"\n";

section::Result speed_with(const std::string& limits) {
  const gantry::Run r("[limits]\n" + limits + "\n" + asked);
  return section::speed_section(r.analysis);
}

}  // namespace

TEST_CASE("a force limit admits the root of the ratio to the inertial force, where the motion accelerates most") {
  const section::Result out = speed_with("actuator_force = \"4 N\"");
  const double s = std::sqrt(4 / ((gantry::platform_mass + gantry::trolley_mass) * sharpest));
  CHECK(gantry::value(out, "scale") == Approx(s));
  CHECK(gantry::value(out, "duration") == Approx(2 / s));
  CHECK_THAT(gantry::text_of(out.section),
             Contains("The motion can run 1.643 times as fast") && Contains("force of q (drive) at t = 0.5 s"));
  gantry::check_proofs(out.section, 2);
}

TEST_CASE("a speed limit admits its ratio to the largest rate") {
  const section::Result out = speed_with("actuator_speed = \"0.5 m/s\"");
  CHECK(gantry::value(out, "scale") == Approx(0.5 / fastest));
  CHECK_THAT(gantry::text_of(out.section), Contains("speed of q (drive) at t = 0 s"));
  gantry::check_proofs(out.section, 2);
}

TEST_CASE("a power grows with the cube of the speed where there is no force at rest") {
  // F v = 3 kg A^2 w^3 sin cos, largest at samples 0.2 and 0.3 s: sin(2 w t) / 2 = sin(0.4 pi) / 2.
  const double power = 3 * sharpest * fastest * std::sin(0.4 * w) / 2;
  const section::Result out = speed_with("actuator_power = \"2 W\"");
  CHECK(gantry::value(out, "scale") == Approx(std::cbrt(2 / power)));
  gantry::check_proofs(out.section, 2);
}

TEST_CASE("a joint's limit binds by what the trolley's inertia leaves of it beside the force at rest") {
  // The hinge carries 7/3 N across the rails at any speed, the least-norm share of the load, and trolley_mass a along them.
  const gantry::Run r("[load]\nforce = [\"0 N\", \"7 N\", \"0 N\"]\n[limits]\njoint_force = { R = \"4 N\" }\n" + asked);
  const section::Result out = section::speed_section(r.analysis);
  const double along = std::sqrt(16 - 49.0 / 9);
  CHECK(gantry::value(out, "scale") == Approx(std::sqrt(along / (gantry::trolley_mass * sharpest))));
  CHECK_THAT(gantry::text_of(out.section), Contains("force in joint R at t = 0.5 s"));
  gantry::check_proofs(out.section, 2);
}

TEST_CASE("of several limits the tightest binds, and the next one is told with its own speed") {
  const section::Result out = speed_with("actuator_force = \"4 N\"\nactuator_speed = \"0.3 m/s\"");
  const std::string text = gantry::text_of(out.section);
  CHECK(gantry::value(out, "scale") == Approx(std::sqrt(4 / (3 * sharpest))));  // 1.6437; by speed 1.9099
  CHECK_THAT(text, Contains("Without this limit it would be 1.909, bound by the speed of q (drive)"));
  CHECK_THAT(text, Contains("force of q | 4 N | 37 % | 1.643 | 1.217 s | 0.5 s"));
}

TEST_CASE("a motion that breaks a limit as written is told to slow down") {
  const section::Result out = speed_with("actuator_force = \"1 N\"");
  CHECK(gantry::value(out, "scale") == Approx(std::sqrt(1 / (3 * sharpest))));
  CHECK_THAT(gantry::text_of(out.section),
             Contains("The motion as written breaks a limit. It may run at no more than 0.8218 of its speed"));
}

TEST_CASE("a speed that a reader takes from the report is never above the limit, nor a duration below it") {
  CHECK(section::speed_words(1.6437) == "1.643");
  CHECK(section::speed_words(0.99999) == "0.9999");
  CHECK(section::speed_words(1.5) == "1.5");
  CHECK(section::duration_words(1.2164) == "1.217 s");
  CHECK(section::duration_words(2) == "2 s");
}

TEST_CASE("no speed helps where a limit is broken at rest") {
  const gantry::Run r("[load]\nforce = [\"7 N\", \"0 N\", \"0 N\"]\n[limits]\nactuator_force = \"5 N\"\n" + asked);
  const section::Result out = section::speed_section(r.analysis);
  CHECK(gantry::value(out, "scale") == 0);
  CHECK_THAT(gantry::text_of(out.section), Contains("breaks a limit at any speed, even at rest"));
}

TEST_CASE("the phase plane shows the envelope in the kinds of limits that bind, and the constant speed below it") {
  const section::Result out = speed_with("actuator_force = \"4 N\"\nactuator_speed = \"0.3 m/s\"");
  const figure::Figure* f = nullptr;
  for (const document::Block& b : out.section.blocks)
    if (f == nullptr) f = std::get_if<figure::Figure>(&b);
  REQUIRE(f != nullptr);
  const auto& series = f->panels.at(0).series;
  REQUIRE(series.size() == 4);  // force, speed, the constant speed, the place
  CHECK(series[0].label == "actuator force");
  CHECK(series[1].label == "actuator speed");
  const double scale = gantry::value(out, "scale");
  for (const std::size_t k : {std::size_t{0}, std::size_t{5}, std::size_t{10}}) {
    const double force = std::sqrt(4 / (3 * sharpest * std::abs(std::sin(w * 0.1 * double(k))))),
                 speed = 0.3 / (fastest * std::abs(std::cos(w * 0.1 * double(k))));
    const double envelope = std::min(force, speed), drawn = force < speed ? series[0].y[k] : series[1].y[k];
    CHECK(drawn == Approx(envelope));
    CHECK(envelope >= scale * (1 - 1e-12));
  }
}

TEST_CASE("the data of the section are the largest speeds by each limit") {
  const section::Result out = speed_with("actuator_force = \"4 N\"\nactuator_speed = \"0.3 m/s\"");
  const document::Data& d = out.data.at(0);
  CHECK(d.headings == std::vector<std::string>{"t [s]", "largest_s", "q_force_largest_s", "q_rate_largest_s"});
  for (std::size_t k = 0; k < 21; ++k) CHECK(d.columns[1][k] == std::min(d.columns[2][k], d.columns[3][k]));
}
