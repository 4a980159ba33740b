// Inputs as people bring them, each of a kind that programs of this sort have answered wrongly. What is right was found independently: by
// Newton's method of one's own, virtual work by hand, the same machine in other coordinates.
#include <catch2/catch.hpp>
#include <tests/program/workshop.hpp>

#include <nlohmann/json.hpp>

#include <cmath>

using namespace program_test;
using Catch::Contains;

namespace {

struct Answer {
  Result result;
  nlohmann::json json;
  std::string warnings;

  double value(const std::string& section, const std::string& name) const {
    for (const auto& v : json["values"])
      if (v["section"] == section && v["name"] == name) return v["value"].is_null() ? std::nan("") : v["value"].get<double>();
    return std::nan("");
  }
  double largest(const std::string& section, const std::string& column) const {
    return std::max(std::abs(value(section, "min(" + column + ")")), std::abs(value(section, "max(" + column + ")")));
  }
};

// The case with changes of its text, made in a folder of its own with the data that it reads.
Answer answer(const Workshop& here, const std::string& name, const std::vector<std::pair<std::string, std::string>>& changes = {}) {
  const std::filesystem::path folder = std::filesystem::path(TEST_DATA) / "field-cases";
  for (const char* data : {"recorded.csv", "wrapped-yaw.csv"}) here.write(data, bytes_of(folder / data));
  Answer out{here.report(with(bytes_of(folder / (name + ".toml")), changes)), {}, ""};
  INFO(out.result.out << out.result.err);
  CHECK_THAT(out.result.out, !Contains("nan exceeds"));
  if (!std::filesystem::exists(here.report_folder() / "results.json")) return out;
  out.json = nlohmann::json::parse(bytes_of(here.report_folder() / "results.json"));
  for (const auto& w : out.json["warnings"]) out.warnings += w["text"].get<std::string>() + "\n";
  return out;
}

}  // namespace

TEST_CASE("field case y-up-platform: the platform's own axes do not change the forces, and singular angles are named") {
  const Workshop here;
  const Answer a = answer(here, "y-up-platform");
  CHECK(a.result.status == 0);
  double largest = 0;
  for (int i = 1; i <= 6; ++i) largest = std::max(largest, a.largest("dynamics", "rho" + std::to_string(i) + "_dynamic_force"));
  CHECK(largest == Approx(44.81).margin(0.005));
  CHECK(std::isfinite(a.value("dynamics", "max(kinetic_energy)")));
  CHECK_THAT(a.warnings, Contains("alpha and gamma turn the platform about one axis"));
  CHECK(a.value("singularity", "crossings") == 0);
}

TEST_CASE("field case y-up-platform: actuators that are prescribed there are not followed, and the angles are named with what to do") {
  const Workshop here;
  const Answer a = answer(here, "y-up-platform", {{"x = \"50 mm * sin(2*pi*t/2 s)\"", "rho1_rate = \"1 mm/s\""}});
  CHECK(a.result.status == 1);
  CHECK_THAT(a.result.out, Contains("alpha and gamma turn the platform about one axis") && !Contains("edge of reach"));
}

TEST_CASE("field case shaker: samples that cannot show a motion are told") {
  const Workshop here;
  const Answer a = answer(here, "shaker");
  CHECK(a.result.status == 1);
  CHECK_THAT(a.warnings, Contains("Between samples x goes up to 1 mm beyond them") && Contains("2001 do"));
}

TEST_CASE("field case shaker: samples enough show its millimetre and its fifteen kilonewtons") {
  const Workshop here;
  const Answer a = answer(here, "shaker", {{"samples = 101", "samples = 2001"}});
  CHECK(a.result.status == 1);  // its own checks ask for less
  CHECK(a.largest("displacement", "x") == Approx(1e-3).epsilon(1e-6));
  double largest = 0;
  for (int i = 1; i <= 6; ++i) largest = std::max(largest, a.largest("dynamics", "rho" + std::to_string(i) + "_dynamic_force"));
  CHECK(largest == Approx(15.1e3).epsilon(0.01));
}

TEST_CASE("field case constant-speed: a velocity that jumps is told with its time") {
  const Workshop here;
  const Answer a = answer(here, "constant-speed");
  CHECK(a.result.status == 1);
  CHECK_THAT(a.warnings, Contains("jump") && Contains("2 s"));
}

TEST_CASE("field case similar-hexagons: an architecture that is singular at every pose is told in one sentence") {
  const Workshop here;
  const Answer a = answer(here, "similar-hexagons");
  CHECK(a.result.status == 1);
  CHECK_THAT(a.warnings, Contains("The architecture is singular at every pose"));
  CHECK_THAT(a.warnings, !Contains("through infinity") && !Contains("crosses"));
  CHECK(a.value("singularity", "crossings") == 0);
  CHECK(a.value("assembly", "modes") == 0);
  CHECK(a.value("assembly", "continua") >= 1);
}

TEST_CASE("field case recorded: sound data with the noise of a recorder pass") {
  const Workshop here;
  const Answer a = answer(here, "recorded");
  INFO(a.result.out);
  CHECK(a.result.status == 0);
}

TEST_CASE("field case wrapped-yaw: a yaw that wraps is refused at its line, and unwrapped where that is asked for") {
  const Workshop here;
  const Answer refused = answer(here, "wrapped-yaw");
  CHECK(refused.result.status == 2);
  CHECK_THAT(refused.result.err, Contains("unwrap = true"));
  const Workshop there;
  const Answer a = answer(there, "wrapped-yaw", {{"profile =", "unwrap = true\nprofile ="}});
  CHECK(a.result.status == 0);
  CHECK(a.value("displacement", "max(alpha)") - a.value("displacement", "min(alpha)") == Approx(8 * 3.141592653589793 / 180).epsilon(1e-9));
}

TEST_CASE("field case impossible-inertia: a body that cannot be is refused by its name") {
  const Workshop here;
  const Answer a = answer(here, "impossible-inertia");
  CHECK(a.result.status == 2);
  CHECK_THAT(a.result.err, Contains("platform") && Contains("inertia"));
}

TEST_CASE("field case small-hexapod: bodies out of all proportion to their legs are remarked") {
  const Workshop here;
  const Answer a = answer(here, "small-hexapod");
  CHECK_THAT(a.warnings, Contains("760 mm"));
}

TEST_CASE("field case leg-through-zero: the pose in which a leg has no length is out of reach, and the rest is reported") {
  const Workshop here;
  const Answer a = answer(here, "leg-through-zero");
  CHECK(a.result.status == 1);
  CHECK_THAT(a.warnings, Contains("t = 0.5 s: the mechanism cannot be assembled (1 sample): a leg has no length"));
  const auto data = columns(here.report_folder() / "data/displacement.csv");
  for (std::size_t k = 0; k < 11; ++k) CHECK(std::isnan(data.at("rho1")[k]) == (k == 5));
}

TEST_CASE("field case delta-nearly-stretched: the end of reach is named, and evidence beside it knows its digits") {
  const Workshop here;
  const Answer a = answer(here, "delta-nearly-stretched");
  INFO(a.result.out);
  CHECK(a.result.status == 0);
  CHECK_THAT(a.warnings, Contains("the end of the reach (a singularity of type 1)") && Contains("type 1"));
}

TEST_CASE("field case nano: a motion of ten micrometres on a machine of sixty-six millimetres is seen") {
  const Workshop here;
  const Answer a = answer(here, "nano");
  CHECK(a.result.status == 0);
  CHECK(a.largest("displacement", "x") == Approx(10e-6).epsilon(1e-4));
  CHECK_THAT(bytes_of(here.report_folder() / "report.html"), Contains("66.00002"));
}

TEST_CASE("field case rate-integral: an integral over twelve thousand periods is exact") {
  const Workshop here;
  const Answer a = answer(here, "rate-integral");
  CHECK(a.result.status == 0);
  CHECK(a.value("displacement", "max(x)") == Approx(0.150).epsilon(1e-9));
}

TEST_CASE("field case noncharacter: a code point that no character has does not break a document") {
  const Workshop here;
  const Answer a = answer(here, "noncharacter");
  CHECK((a.result.status == 0 || a.result.status == 2));
  if (a.result.status == 2) CHECK_THAT(a.result.err, Contains("scenario.toml:1"));
}

TEST_CASE("field case dotted keys: thirty thousand tables in one another are refused at their place") {
  const Workshop here;
  std::string key = "a";
  for (int k = 1; k < 30'000; ++k) key += ".a";
  const Result r = here.report(key + " = 1\n");
  CHECK(r.status == 2);
  CHECK_THAT(r.err, Contains("scenario.toml:1:"));
}
