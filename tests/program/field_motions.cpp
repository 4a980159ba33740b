// Motions as they come from the field: a shaker that is sampled too rarely, a path without acceleration, a recorder that rounds, a tracker
// that counts from -180 to 180 degrees, a speed that wavers for ten minutes. Right values by other ways: peak forces and places by hand and
// by a Newton of its own.
#include <fmt/format.h>
#include <catch2/catch.hpp>
#include <tests/program/workshop.hpp>

#include <cmath>
#include <nlohmann/json.hpp>

using namespace program_test;
using Catch::Contains;
using Json = nlohmann::json;

namespace {

Json results(const Workshop& here) { return Json::parse(bytes_of(here.report_folder() / "results.json")); }

double value(const Json& results, const std::string& name) {
  for (const Json& v : results["values"])
    if (v["name"] == name) return v["value"];
  FAIL("no value " << name);
  return 0;
}

Json evidence(const Json& results, const std::string& claim) {
  for (const Json& s : results["sections"])
    for (const Json& e : s["evidence"])
      if (e["claim"] == claim) return e;
  FAIL("no evidence " << claim);
  return {};
}

const std::string weights = "[load]\ngravity = [\"0 m/s^2\", \"0 m/s^2\", \"-9.81 m/s^2\"]\n";

// A hexapod: its motion, then its sections.
std::string hexapod(const std::string& motion, const std::string& more) {
  return "title = \"Hexapod\"\n[mechanism]\nuse = \"gough\"\n[motion]\n" + motion + weights + more;
}
const std::string displacement = "[[section]]\nkind = \"displacement\"\n", dynamics = "[[section]]\nkind = \"dynamics\"\n";

std::string shaker(int samples) {
  return hexapod(
      fmt::format("duration = \"1 s\"\nsamples = {}\nx = \"1 mm * sin(2*pi*100 Hz*t)\"\nz = \"950 mm + 1 mm * sin(2*pi*50 Hz*t)\"\n",
                  samples),
      displacement + dynamics);
}

}  // namespace

TEST_CASE("a shaker of 100 Hz cannot be shown by 101 samples in a second, and is right with as many as are asked for") {
  const Workshop here;
  const Result rare = here.report(shaker(101));
  CHECK(rare.status == 1);
  CHECK_THAT(rare.out, Contains("FAILED  the samples show the motion: Between samples x goes up to") &&
                           Contains("it moves by 2 mm in all") && Contains("101 samples cannot show it, 2001 do."));
  const Result often = here.report(shaker(2001));
  INFO(often.out);
  CHECK(often.status == 0);
  const Json r = results(here);
  CHECK(value(r, "max(x)") == Approx(0.001));
  CHECK(value(r, "peak_force") == Approx(15.1e3).epsilon(0.005));
}

TEST_CASE("to and fro at constant speed no finite force goes, and the report says when") {
  const Workshop here;
  const Result result =
      here.report(hexapod("duration = \"4 s\"\nsamples = 401\nx = \"50 mm - 100 mm * abs(t/2 s - 1)\"\n", displacement + dynamics));
  CHECK(result.status == 1);
  CHECK_THAT(result.out,
             Contains("FAILED  values and rates of the motion do not jump: The rate of x jumps by 100 mm/s at t = 2 s: no finite "
                      "force follows it."));
  CHECK_THAT(bytes_of(here.report_folder() / "report.html"), Contains("not examined: values or rates of the motion jump"));
}

TEST_CASE("positions that a recorder rounds to a hundredth of a millimetre are sound data") {
  const Workshop here;
  std::string table = "t [s],x [mm]\n";
  for (int i = 0; i <= 1000; ++i) table += fmt::format("{:.3f},{:.2f}\n", 0.001 * i, 50 * std::sin(0.0005 * i));
  here.write("recorded.csv", table);
  const Result result = here.report(hexapod("samples = 1001\nprofile = \"cubic-spline\"\nfile = \"recorded.csv\"\n", dynamics));
  INFO(result.out);
  CHECK(result.status == 0);
  const Json energy = evidence(results(here), "Work becomes energy");
  CHECK(energy["passed"] == true);
  CHECK(energy["tolerance"].get<double>() < 1e-9);  // and the proof is no weaker than that of smooth motions
}

TEST_CASE("a tracked yaw that wraps is refused with its row, and turns by two degrees a second when it is unwrapped") {
  const Workshop here;
  here.write("yaw.csv", "t [s],alpha [deg]\n0,176\n1,178\n2,180\n3,-178\n4,-176\n");
  const auto turning = [](const std::string& unwrap) {
    return "title = \"Yaw\"\n[mechanism]\nuse = \"gough\"\nparameters = { stroke_min = \"100 mm\", stroke_max = \"3000 mm\", base_cone = "
           "\"180 "
           "deg\", platform_cone = \"180 deg\", home_angles = [\"176 deg\", \"0 deg\", \"0 deg\"] }\n[motion]\nsamples = 101\nprofile = "
           "\"cubic-spline\"\nfile = \"yaw.csv\"\n" +
           unwrap + displacement + "[[section]]\nkind = \"velocity\"\n";
  };
  const Result wrapped = here.report(turning(""));
  CHECK(wrapped.status == 2);
  CHECK_THAT(wrapped.err,
             Contains("yaw.csv:5:1: error: alpha jumps by -358 deg from the point before, and a turn less, 2 deg, would go on"));
  const Result turned = here.report(turning("unwrap = true\n"));
  INFO(turned.out << turned.err);
  const Json r = results(here);
  constexpr double degree = 3.14159265358979323846 / 180;
  CHECK(value(r, "max(alpha)") == Approx(184 * degree));
  CHECK(value(r, "min(alpha_rate)") == Approx(2 * degree));
  CHECK(value(r, "max(alpha_rate)") == Approx(2 * degree));
}

TEST_CASE("a speed that wavers at 20 Hz for ten minutes leads to 150 mm") {
  const Workshop here;
  const Result result = here.report(
      "title = \"Steps\"\n[mechanism]\nuse = \"delta\"\n[motion]\nduration = \"600 s\"\nsamples = 121\nx_rate = \"0.5 mm/s * "
      "(sin(2*pi*20*t/1 s))^2\"\n" +
      displacement);
  INFO(result.out);
  CHECK(result.status == 0);
  CHECK(value(results(here), "max(x)") == Approx(0.15).epsilon(1e-9));
}

TEST_CASE("a gate at a time between two samples measures the motion, not a line between them") {
  const Workshop here;
  // Samples of 100 mm sin(pi t / s) every quarter of a second: a line would give 28.3 mm at 0.1 s.
  const std::string motion = "duration = \"2 s\"\nsamples = 9\nx = \"100 mm * sin(pi*t/1 s)\"\n";
  const std::string gate = "[[check]]\nthat = \"at(x, 0.1 s)\"\nabove = \"30.90 mm\"\nbelow = \"30.91 mm\"\n";  // sin 18 deg = 0.30902
  const Result result = here.report(hexapod(motion, displacement + gate));
  INFO(result.out);
  CHECK(result.status == 0);
}
