// A workspace as a user asks for it: settings for controllers, mistakes, scans that are too large, interrupted, or resumed.
#include <catch2/catch.hpp>
#include <tests/program/workshop.hpp>

#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <functional>
#include <thread>

using namespace program_test;
using Catch::Contains;

namespace {

// The section's lines are put where {} stands.
std::string scenario(const std::string& mechanism, const std::string& lines) {
  return "title = \"Reach\"\n[mechanism]\nuse = \"" + mechanism +
         "\"\n[[section]]\nkind = \"workspace\"\npictures = false\nexports = false\n" + lines;
}

const std::string cube =
    "scan = { x = [\"-200 mm\", \"200 mm\", 9], y = [\"-200 mm\", \"200 mm\", 9], z = [\"800 mm\", \"1100 mm\", 9] }\n";

double value(const Workshop& here, const std::string& name) {
  const auto json = nlohmann::json::parse(bytes_of(here.report_folder() / "results.json"));
  for (const auto& v : json.at("values"))
    if (v.at("name") == name) return v.at("value").is_number() ? v.at("value").get<double>() : std::nan("");
  return std::nan("");
}

// Takes some seconds, for an index is judged pose by pose; in three chunks.
const std::string long_scan =
    scenario("gough",
             "method = \"grid\"\nsafe = false\nlimits = [\"strokes\"]\nscan = { x = [\"-500 mm\", \"500 mm\", 49], y = "
             "[\"-500 mm\", \"500 mm\", 49], z = [\"600 mm\", \"1300 mm\", 61] }\n[[section.limit]]\nindex = "
             "\"condition\"\nmax = \"12\"\n");

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> out;
  std::error_code not_there;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, not_there))
    if (entry.is_regular_file() && !entry.path().has_extension()) out.push_back(entry.path());
  return out;
}

}  // namespace

TEST_CASE("the safe box is printed for controllers, rounded to the safe side") {
  const Workshop here;
  here.write("s.toml", scenario("gough", "safe = false\n" + cube));
  const auto printed = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"limits", "s.toml"});
    return run_pmreport(more, {.folder = here.path()});
  };
  const Result toml = printed({});
  INFO(toml.out << toml.err);
  REQUIRE(toml.status == 0);
  CHECK_THAT(toml.out, Contains("[safe_limits]") && Contains("x = [\"-") && Contains(" mm\"]  #") && Contains("the scanned range"));
  const Result linuxcnc = printed({"--format", "linuxcnc"});
  CHECK_THAT(linuxcnc.out, Contains("setp ini.x.min_limit -") && Contains("setp ini.z.max_limit "));
  const Result klipper = printed({"--format", "klipper"});
  CHECK_THAT(klipper.out, Contains("[stepper_x]\nposition_min: -") && Contains("position_max: "));
  // No angle has a letter of its own.
  here.write("s.toml", scenario("gough", "scan = { z = [\"900 mm\", \"1000 mm\"], alpha = [\"-5 deg\", \"5 deg\"] }\n"));
  CHECK_THAT(printed({"--format", "linuxcnc"}).out, Contains("# alpha from ") && Contains("--axes alpha=c"));
  CHECK_THAT(printed({"--format", "linuxcnc", "--axes", "alpha=c"}).out, Contains("setp ini.c.min_limit -"));
  const Result wrong = printed({"--axes", "delta=c"});
  CHECK(wrong.status == 2);
  CHECK_THAT(wrong.err, Contains("\"delta=c\""));
}

TEST_CASE("safe limits of a scenario without a workspace, or of a home outside, are told as what is missing") {
  const Workshop here;
  here.write("s.toml", small);
  const Result none = run_pmreport({"limits", "s.toml"}, {.folder = here.path()});
  CHECK(none.status == 2);
  CHECK_THAT(none.err, Contains("expected a section \"workspace\""));
  here.write("s.toml", scenario("gough", cube + "[[section.limit]]\nvalue = \"rho3\"\nmin = \"1.3 m\"\n"));
  const Result outside = run_pmreport({"limits", "s.toml"}, {.folder = here.path()});
  CHECK(outside.status == 1);
  CHECK_THAT(outside.err, Contains("home lies outside") && Contains("rho3<"));
}

TEST_CASE("mistakes in a workspace are told together, each with what to do") {
  const Workshop here;
  const Result result =
      here.report(scenario("4sps-spr",
                           "method = \"grid\"\n"
                           "scan = { x = [\"-100 mm\", \"100 mm\"], y = [\"0 mm\", \"1 mm\", 3], z = [\"550 mm\", \"550 mm\", 5] }\n"
                           "at = { x = \"5 mm\", delta = \"1 deg\" }\n"
                           "limits = [\"stroke\"]\n"
                           "orientations = [ { alpha = \"0 deg\" }, { alpha = \"2 deg\" }, { alpha = \"0 deg\" } ]\n"
                           "at_least = [7]\n"
                           "[[section.limit]]\nangle = [9]\nagainst = \"base z\"\nmax = \"60 deg\"\n"
                           "[[section.limit]]\nvalue = \"l9\"\nmax = \"1 m\"\n"
                           "[[section.limit]]\nvalue = \"l1\"\n"
                           "[[section.limit]]\nvalue = \"l1\"\nmin = \"2 m\"\nmax = \"1 m\"\n"
                           "[[section.limit]]\nindex = \"condition\"\nagainst = \"base z\"\nmax = \"1 m\"\n"
                           "[[section.limit]]\nindex = \"compliance\"\nmax = \"1e-3 m/N\"\n"));
  CHECK(result.status == 2);
  for (const char* told :
       {"a grid needs to know how many values x takes", "y is a dependent coordinate of 4sps-spr", "expected a range of z, seen one value",
        "x is scanned and cannot be held", "unknown key \"delta\"", "did you mean \"strokes\"", "this orientation is given twice",
        "expected at most the 2 orientations that there are, seen 7",
        "there is no actuator, derived quantity, reading or joint motion \"l9\"", "expected a least value, a most, or both",
        "expected a least value below the most", "against belongs to a limit with angle", "expected the stiffness of the drives"}) {
    INFO(result.err);
    CHECK_THAT(result.err, Contains(told));
  }
  CHECK_FALSE(std::filesystem::exists(here.report_folder()));
}

TEST_CASE("a grid of 10^12 points, or of too many poses, is refused as too large, with what to do") {
  const Workshop here;
  const Result points =
      here.report(scenario("gough",
                           "method = \"grid\"\nscan = { x = [\"-1 m\", \"1 m\", 10000], y = [\"-1 m\", \"1 m\", 10000], z = "
                           "[\"0.5 m\", \"1.5 m\", 10000] }\n"));
  CHECK(points.status == 5);
  CHECK_THAT(points.err, Contains("1e+12 points") && Contains("ask for fewer values on its axes"));
  const std::string turns = "[\"-9 deg\", \"9 deg\", 30]";
  const Result poses = here.report(scenario("gough",
                                            "method = \"grid\"\nscan = { x = [\"-1 m\", \"1 m\", 200], y = [\"-1 m\", \"1 m\", 200], z = "
                                            "[\"0.5 m\", \"1.5 m\", 200] }\norientations = { alpha = " +
                                                turns + ", beta = " + turns + ", gamma = " + turns + " }\n"));
  CHECK(poses.status == 5);
  CHECK_THAT(poses.err, Contains("2.16e+11 poses") && Contains("use method"));
  CHECK_FALSE(std::filesystem::exists(here.report_folder()));
}

TEST_CASE("an empty workspace is proved empty, and a home outside is told") {
  const Workshop here;
  const Result result = here.report(scenario("gough", cube + "[[section.limit]]\nvalue = \"rho1\"\nmin = \"3 m\"\n"));
  INFO(result.out << result.err);
  CHECK(result.status == 0);
  const std::string html = bytes_of(here.report_folder() / "report.html");
  CHECK_THAT(html, Contains("The workspace is empty") && Contains("Home lies outside"));
  CHECK(value(here, "volume_high") == 0);
}

TEST_CASE("a limit that always holds changes nothing, and a reversed range is the same range") {
  const Workshop here;
  const std::string forward = "method = [\"proof\", \"grid\"]\nsafe = false\n" + cube;
  REQUIRE(here.report(scenario("gough", forward)).status == 0);
  const double accepted = value(here, "accepted"), low = value(here, "volume_low"), high = value(here, "volume_high");
  CHECK(low > 0);
  REQUIRE(here.report(scenario("gough", forward + "[[section.limit]]\nvalue = \"rho1\"\nmax = \"9 m\"\n")).status == 0);
  CHECK(value(here, "accepted") == accepted);
  CHECK(value(here, "volume_low") <= high);
  CHECK(value(here, "volume_high") >= low);
  const std::string reversed = with(forward, {{"x = [\"-200 mm\", \"200 mm\", 9]", "x = [\"200 mm\", \"-200 mm\", 9]"}});
  REQUIRE(here.report(scenario("gough", reversed)).status == 0);
  CHECK(value(here, "accepted") == accepted);
  CHECK(value(here, "volume_low") <= high);
  CHECK(value(here, "volume_high") >= low);
}

TEST_CASE("one coordinate alone may be scanned: where a leg meets its stroke is a closed form") {
  const Workshop here;
  const Result result = here.report(scenario("gough", "limits = [\"strokes\"]\nscan = { z = [\"0.2 m\", \"1.8 m\"] }\n"));
  INFO(result.out << result.err);
  REQUIRE(result.status == 0);
  // All legs are alike on the axis: rho^2 = z^2 + d^2, with the feet 10.6 and the platform's joints 60 - 15.2 degrees from the middle of
  // their pairs, on circles of 300 and 200 mm.
  const double deg = 3.14159265358979323846 / 180, spread = (60 - 15.2 - 10.6) * deg;
  const double squared = 0.3 * 0.3 + 0.2 * 0.2 - 2 * 0.3 * 0.2 * std::cos(spread);
  const double exact = std::sqrt(1.41 * 1.41 - squared) - std::sqrt(0.76 * 0.76 - squared);
  CHECK(value(here, "volume_low") <= exact);
  CHECK(value(here, "volume_high") >= exact);
}

TEST_CASE("the workspace of a tool point at one orientation is that of the platform, moved with it") {
  const Workshop here;
  const std::string lines = "method = \"grid\"\nlimits = [\"strokes\"]\nat = { beta = \"90 deg\" }\n";
  REQUIRE(here.report(scenario("gough", lines + "scan = { x = [\"-1 m\", \"1 m\", 41], z = [\"0.2 m\", \"1.8 m\", 33] }\n")).status == 0);
  const double accepted = value(here, "accepted"), left = value(here, "x_low"), lowest = value(here, "z_low");
  REQUIRE(accepted > 100);
  // Turned by 90 degrees about x the platform's y points up, and its z along -y: the tool is 100 mm higher, and y, held at home, is that of
  // the tool, whose home is 100 mm from the platform's.
  const Result result = here.report(
      scenario("gough", lines + "tool = [\"0 mm\", \"100 mm\", \"-250 mm\"]\nscan = { x = [\"-1 m\", \"1 m\", 41], z = [\"0.3 m\", \"1.9 "
                                "m\", 33] }\n"));
  INFO(result.out << result.err);
  REQUIRE(result.status == 0);
  CHECK_THAT(bytes_of(here.report_folder() / "report.html"), Contains("tool point"));
  const double moved = value(here, "accepted");
  const std::string held = with(lines, {{"beta = \"90 deg\"", "beta = \"90 deg\", y = \"250 mm\""}});
  REQUIRE(
      here.report(scenario("gough", held + "tool = [\"0 mm\", \"100 mm\", \"-250 mm\"]\nscan = { x = [\"-1 m\", \"1 m\", 41], z = [\"0.3 "
                                           "m\", \"1.9 m\", 33] }\n"))
          .status == 0);
  CHECK(value(here, "accepted") == accepted);
  CHECK(value(here, "x_low") == Approx(left).margin(1e-12));
  CHECK(value(here, "z_low") == Approx(lowest + 0.1).margin(1e-12));
  CHECK(moved != accepted);
}

TEST_CASE("a tool point is told by three lengths, of a mechanism whose coordinates tell the platform's place") {
  const Workshop here;
  const Result two = here.report(scenario("gough", "tool = [\"0 mm\", \"1 mm\"]\n" + cube));
  CHECK(two.status == 2);
  CHECK_THAT(two.err, Contains("expected the tool point in the platform's axes") && Contains("tool = [\"0 mm\", \"0 mm\", \"-120 mm\"]"));
  const Result dependent = here.report(scenario(
      "4sps-spr", "tool = [\"0 mm\", \"0 mm\", \"10 mm\"]\nscan = { x = [\"-10 mm\", \"10 mm\"], z = [\"550 mm\", \"560 mm\"] }\n"));
  CHECK(dependent.status == 2);
  CHECK_THAT(dependent.err, Contains("no tool point can be scanned: the coordinates of 4sps-spr do not tell the place"));
}

TEST_CASE("a scan that was interrupted goes on where it stopped, to the same bytes") {
  const Workshop here;
  here.write("scenario.toml", long_scan);
  REQUIRE(run_pmreport({"scenario.toml", "-o", "whole"}, {.folder = here.path()}).status == 0);
  const auto interrupted = [&](std::vector<std::string> more, const std::function<bool(Process&)>& in_the_middle) {
    std::vector<std::string> command{PROGRAM, "scenario.toml", "-o", "parts", "--threads", "1"};
    command.insert(command.end(), more.begin(), more.end());
    Process process(command, {.environment = {{"TERM", "xterm"}}, .folder = here.path(), .terminal = true});
    REQUIRE(in_the_middle(process));
    process.send(SIGINT);
    CHECK(process.finish().status == 130);
    CHECK_FALSE(std::filesystem::exists(here / "parts"));
  };
  // What is done in the first second is not kept, and that may be all.
  interrupted({}, [](Process& process) { return process.says("grid: "); });
  std::filesystem::remove_all(here / "parts.chunks");
  // A shard keeps everything.
  const auto kept = [&] { return files_in(here / "parts.chunks").size(); };
  interrupted({"--shard", "1/1"}, [&](Process&) {
    for (int i = 0; i < 6000 && kept() == 0; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return kept() > 0;
  });
  CHECK(kept() < 3);
  const Result resumed = run_pmreport({"scenario.toml", "-o", "parts", "--resume"}, {.folder = here.path()});
  INFO(resumed.err);
  REQUIRE(resumed.status == 0);
  CHECK(contents(here / "whole") == contents(here / "parts"));
  CHECK_FALSE(std::filesystem::exists(here / "parts.chunks"));
}
