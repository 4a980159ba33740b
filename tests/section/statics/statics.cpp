// Section `statics` on the gantry. Its Jacobian is the identity, so drive and constraint wrenches are the load turned round: the drive
// bears X, the rest is held.
#include <catch2/catch.hpp>

#include <tests/section/report_words.hpp>
#include <tests/section/whole_report.hpp>

#include <string>

using namespace pmreport;
using namespace whole_report;
using Catch::Contains;
using report_words::check_proofs, report_words::row_of, report_words::text_of;

namespace {

const std::string asked = asking_for({"statics"});

}  // namespace

TEST_CASE("the drive bears the load along the rails, the constraints all else, each against it") {
  const auto r = of_gantry("[load]\nforce = [\"7 N * t / 1 s\", \"4 N\", \"5 N\"]\nmoment = [\"1 N*m\", \"2 N*m\", \"3 N*m\"]\n" + asked);
  const document::Section& s = section_of(r, "statics");
  const auto& drive = column_of(r, "statics", "q_force [N]");
  const std::pair<const char*, double> held[] = {
      {"force_y [N]", -4}, {"force_z [N]", -5}, {"couple_x [N*m]", -1}, {"couple_y [N*m]", -2}, {"couple_z [N*m]", -3}};
  for (std::size_t k = 0; k < 21; ++k) {
    CHECK(drive[k] == Approx(-0.7 * double(k)).margin(1e-12));
    for (const auto& [heading, expected] : held) CHECK(column_of(r, "statics", heading)[k] == Approx(expected));
  }
  CHECK(row_of(s, "Extremes", "q_force")[2] == "−14");
  CHECK(row_of(s, "Extremes", "q_force")[3] == "2 s");
  CHECK(panels_of(s) == std::vector<std::string>{"actuator force"});
  CHECK_THAT(report_words::pointers<figure::Figure>(s).at(0)->caption,
             Contains("Constant, so not drawn: constraint force, force_y = −4 N, force_z = −5 N.") &&
                 Contains("Constant, so not drawn: constraint moment, couple_x = −1 N·m, couple_y = −2 N·m, couple_z = −3 N·m."));
  CHECK(series_of(s, "actuator force", "F").y.back() == Approx(-14));
  check_proofs(s);
}

TEST_CASE("numbers of one kind in a table of extremes have as many decimals, and each unit its own") {
  const auto r =
      of_gantry("[load]\nforce = [\"7 N * t / 1 s\", \"4 N\", \"-105.25 N\"]\nmoment = [\"0 N*m\", \"2 N*m\", \"3 N*m\"]\n" + asked);
  const document::Section& s = section_of(r, "statics");
  CHECK(row_of(s, "Extremes", "force_y")[2] == "−4.00");
  CHECK(row_of(s, "Extremes", "force_z")[4] == "105.25");
  CHECK(row_of(s, "Extremes", "couple_y")[2] == "−2");
  CHECK(row_of(s, "Extremes", "couple_x")[2] == "0");
}

TEST_CASE("bodies are weightless without gravity, and the drive lifts all of them with it") {
  const auto light = of_gantry(asked);
  CHECK_THAT(text_of(section_of(light, "statics")), Contains("The scenario gives no gravity: all bodies are taken as weightless."));
  for (const double f : column_of(light, "statics", "q_force [N]")) CHECK(f == Approx(0).margin(1e-12));

  // Along the rails: platform and trolley, 3 kg.
  const auto heavy = of_gantry("[load]\ngravity = [\"-9.81 m/s^2\", \"0 m/s^2\", \"0 m/s^2\"]\n" + asked);
  CHECK_THAT(text_of(section_of(heavy, "statics")), Contains("The weights of all bodies are included, gravity (-9.81, 0, 0) m/s²"));
  for (const double f : column_of(heavy, "statics", "q_force [N]")) CHECK(f == Approx(3 * 9.81));
}
