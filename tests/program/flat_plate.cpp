// A motion through a pose in which bodies of an articulated platform move though all motors stand, while G of the platform is regular.
#include <catch2/catch.hpp>
#include <tests/program/workshop.hpp>

#include <algorithm>

using namespace program_test;

TEST_CASE("a plate that flattens on the way shows in the forces of its hinges, not in det G") {
  const Workshop here;
  const Result result = here.report(bytes_of(TEST_DATA "/par4-flattening.toml"));
  INFO(result.out << result.err);
  REQUIRE(result.status <= 1);  // the report is there, whatever it says of the motion
  const auto data = [&](const char* file, const char* column) { return columns(here.report_folder() / "data" / file).at(column); };
  const std::vector<double> opening = data("displacement.csv", "opening"), det = data("velocity.csv", "det_G");
  REQUIRE(opening.size() == 401);
  CHECK(*std::min_element(opening.begin(), opening.end()) < -0.25);  // 15 degrees beyond flat
  CHECK(*std::max_element(opening.begin(), opening.end()) > 1);
  CHECK(*std::min_element(det.begin(), det.end()) > 0.25 * *std::max_element(det.begin(), det.end()));

  // Under 10 N on the tool they are 5.5 N over the angle that is left, in radians; one sample falls within 0.02 degrees of flat.
  const std::vector<double> force = data("reactions.csv", "H1_force");
  CHECK(*std::max_element(force.begin(), force.end()) > 10e3);
}
