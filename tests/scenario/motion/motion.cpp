#include <catch2/catch.hpp>
#include <core/numbers.hpp>
#include <tests/scenario/trial.hpp>

using namespace pmreport;
using namespace pmreport::scenario;
using namespace trial;
using Catch::Contains;

namespace {

std::string moving_as(std::string_view motion) {
  return "title = \"Stage\"\n[mechanism]\nuse = \"stage\"\n[[section]]\nkind = \"displacement\"\n[motion]\n" + std::string(motion);
}
struct Motion : mechanics::Trajectory {
  std::string description;
};
Motion motion_of(const std::string& text, const std::filesystem::path& file = "a.toml") {
  INFO(told(text, file));
  const Loaded l = load_text(text, file, stage::source(), section::kinds());  // a prescribed path asks no machine: it may outlive it
  return {l.trajectory, l.scenario.motion->description};
}

constexpr std::string_view points_text = R"(
[[motion.waypoint]]
time = "0 s"
[[motion.waypoint]]
time = "1 s"
x = "10 mm"
phi = "90 deg"
[[motion.waypoint]]
time = "4 s"
phi = "-90 deg"
)";

}  // namespace

TEST_CASE("samples are spread evenly over the duration, both ends included") {
  const Motion m = motion_of(moving_as("duration = \"1 min\"\nsamples = 7\nx = \"1 mm/s*t\"\n"));
  CHECK(m.time == std::vector<double>{0, 10, 20, 30, 40, 50, 60});
  CHECK(m.value(6, 0) == Approx(0.06));
  CHECK(m.rate.rows() == 7);
  CHECK(m.acceleration.cols() == 2);
}

TEST_CASE("a motion has its exact rates and accelerations") {
  const Motion m = motion_of(std::string(sound));
  for (Eigen::Index i = 0; i < 21; ++i) {
    const double t = m.time[static_cast<std::size_t>(i)], w = 2 * pi / 10;
    CAPTURE(t);
    CHECK(t == Approx(0.1 * double(i)));
    CHECK(m.rate(i, 0) == Approx(0.02 * w * std::cos(w * t)));
    CHECK(m.acceleration(i, 0) == Approx(-0.02 * w * w * std::sin(w * t)).margin(1e-17));
    CHECK(m.value(i, 1) == Approx(5 * pi / 180));
  }
}

TEST_CASE("a quintic profile rests at its waypoints") {
  const Motion m = motion_of(moving_as("profile = \"quintic\"\nsamples = 5" + std::string(points_text)));
  CHECK(m.time == std::vector<double>{0, 1, 2, 3, 4});
  CHECK(m.value(1, 0) == Approx(0.01));
  CHECK(m.value(4, 0) == Approx(0.01));  // left out: it stays
  CHECK(m.value(1, 1) == Approx(pi / 2));
  CHECK(m.value(4, 1) == Approx(-pi / 2));
  for (const Eigen::Index i : {0, 1, 4}) {
    CHECK(m.rate(i, 1) == Approx(0).margin(1e-14));
    CHECK(m.acceleration(i, 1) == Approx(0).margin(1e-14));
  }
  CHECK(m.rate(2, 1) < -0.1);
  CHECK(m.description ==
        "x: quintic profile through 3 waypoints, at rest in each\nphi: quintic profile through 3 waypoints, at rest in each");
}

TEST_CASE("a cubic-spline profile starts and ends at rest and passes its waypoints") {
  const Motion m = motion_of(moving_as("profile = \"cubic-spline\"\nsamples = 5" + std::string(points_text)));
  CHECK(m.value(1, 1) == Approx(pi / 2));
  CHECK(m.rate(0, 1) == Approx(0).margin(1e-14));
  CHECK(m.rate(4, 1) == Approx(0).margin(1e-14));
  // One inner point, at rest at both ends: 2 (h0 + h1) M = 6 (d1 - d0) - h0 M0 - h1 M1 with M0 = 3 d0/h0 - M/2, M1 = -3 d1/h1 - M/2 gives
  // the rate there, 3/2 (h1 d0 + h0 d1) / (h0 + h1).
  const double h0 = 1, h1 = 3, d0 = pi / 2, d1 = -pi / 3;
  CHECK(m.rate(1, 1) == Approx(1.5 * (h1 * d0 + h0 * d1) / (h0 + h1)));
}

TEST_CASE("a spline says how it ends and how far it goes beyond its points") {
  // At rest at 0, 1 s and 2 s: flat, then up by 10 mm. The rate at the middle point is 3/4 of the slope after it, so the first piece,
  // r (t^3 - t^2), dips by 4/27 r at 2/3 s.
  const Motion m =
      motion_of(moving_as("profile = \"cubic-spline\"\nsamples = 5\n[[motion.waypoint]]\ntime = \"0 s\"\n[[motion.waypoint]]\ntime = \"1 "
                          "s\"\n[[motion.waypoint]]\ntime = \"2 s\"\nx = \"10 mm\"\n"));
  CHECK(m.description ==
        "x: cubic spline through 3 waypoints, at rest at both ends, up to 1.11 mm beyond its points (at 0.6667 s)\nphi: constant");
  const Folder folder;
  folder.write("motion.csv", "t [s], x [mm], phi [deg]\n0,0,0\n1,10,1\n2,20,2\n4,40,4\n");
  const Motion file = motion_of(moving_as("file = \"motion.csv\"\n"), folder.path() / "a.toml");
  CHECK(file.description ==
        "x: cubic spline through 4 rows of motion.csv, its outer two pieces one cubic at either end\n"
        "phi: cubic spline through 4 rows of motion.csv, its outer two pieces one cubic at either end");
}

TEST_CASE("a duration before the last waypoint cuts the motion short") {
  const Motion m = motion_of(moving_as("profile = \"quintic\"\nduration = \"2 s\"\nsamples = 3" + std::string(points_text)));
  CHECK(m.time.back() == 2);
}

TEST_CASE("waypoints that make no motion are refused") {
  const auto tell = [](std::string_view keys, std::string_view waypoints) {
    return told(moving_as(std::string(keys) + std::string(waypoints)));
  };
  const std::string keys = "profile = \"quintic\"\nsamples = 5\n", w = "[[motion.waypoint]]\n";
  CHECK_THAT(tell("samples = 5", points_text), Contains("expected the key \"profile\" in [motion]"));
  CHECK_THAT(tell("profile = \"septic\"\nsamples = 5", points_text), Contains("expected \"quintic\" or \"cubic-spline\", seen \"septic\""));
  CHECK_THAT(tell(keys, w + "time = \"0 s\"\n"), Contains("expected at least two waypoints, seen one"));
  CHECK_THAT(tell(keys, w + "time = \"1 s\"\n" + w + "time = \"2 s\"\n"), Contains("expected the first waypoint at 0 s, seen 1 s"));
  CHECK_THAT(tell(keys, w + "time = \"0 s\"\n" + w + "time = \"0 s\"\n"),
             Contains("expected a time after the waypoint before, 0 s, seen 0 s"));
  const auto over = [&](const std::string& middle) {
    return tell("profile = \"cubic-spline\"\nsamples = 5\n",
                w + "time = \"0 s\"\n" + w + "time = \"" + middle + "\"\nx = \"1 mm\"\n" + w + "time = \"2 s\"\n");
  };
  CHECK_THAT(over("1e-10 s"), Contains("expected no step of time a billion times as long as another, seen 1e-10 s beside 2 s"));
  CHECK(over("1e-8 s").empty());
  CHECK_THAT(tell(keys, w + "time = \"0 s\"\n" + w + "x = \"1 mm\"\n"), Contains("expected the key \"time\" in [[motion.waypoint]]"));
  CHECK_THAT(tell(keys, w + "time = \"0 s\"\n" + w + "time = \"1 s\"\nz = \"1 mm\"\n"),
             Contains("unknown key \"z\" in [[motion.waypoint]]"));
  CHECK_THAT(tell("x = \"1 mm\"\n" + keys, points_text), Contains("x is given twice: here and by the waypoints"));
  CHECK_THAT(tell("duration = \"5 s\"\n" + keys, points_text), Contains("expected at most the time of the last waypoint, 4 s, seen 5 s"));
  CHECK_THAT(tell(keys, "waypoint = 3\n"), Contains("write [[motion.waypoint]] with two brackets, once for each"));
  CHECK_THAT(tell("duration = \"5 s\"\n" + keys, ""), Contains("a profile leads through points, and there are none"));
}

TEST_CASE("a motion without a finite value, rate or acceleration names the time") {
  CHECK_THAT(told(with("20 mm * sin(2*pi*t/10 s)", "1 mm * sqrt(t/1 s)")), Contains("x has no finite rate at t = 0 s"));
  CHECK_THAT(told(with("20 mm * sin(2*pi*t/10 s)", "1 mm / (t/1 s - 1)")), Contains("x has no finite value at t = 1 s"));
  CHECK_THAT(told(with("20 mm * sin(2*pi*t/10 s)", "1 mm * (t/1 s)^1.5")), Contains("x has no finite acceleration at t = 0 s"));
}

TEST_CASE("a motion is read from a file beside the scenario") {
  const Folder folder;
  folder.write("motion.csv", "t [s], x [mm], phi [deg]\r\n0,0,0\r\n1,10,90\r\n\r\n3,90,-90\r\n4,160,0\r\n");
  const std::filesystem::path file = folder.path() / "a.toml";
  const Motion own = motion_of(moving_as("file = \"motion.csv\"\n"), file);
  CHECK(own.time == std::vector<double>{0, 1, 3, 4});
  CHECK(own.value(3, 0) == Approx(0.16));
  CHECK(own.value(1, 1) == Approx(pi / 2));
  // x = 10 mm t^2 / s^2: a spline whose ends are no knots has its exact rate
  CHECK(own.rate(2, 0) == Approx(0.06));
  CHECK(own.acceleration(0, 0) == Approx(0.02));

  const Motion even = motion_of(moving_as("file = \"motion.csv\"\nsamples = 9\n"), file);
  CHECK(even.time[1] == 0.5);
  CHECK(even.value(1, 0) == Approx(0.0025));
  const Motion steps = motion_of(moving_as("file = \"motion.csv\"\nprofile = \"quintic\"\nsamples = 5\n"), file);
  CHECK(steps.rate(1, 0) == Approx(0).margin(1e-15));
  CHECK(steps.value(2, 0) == Approx(0.05));  // half way in time, half way in place
}

TEST_CASE("a file of motion that says nothing sound is refused with its line and column") {
  const Folder folder;
  const std::filesystem::path file = folder.path() / "a.toml";
  const auto tell = [&](std::string_view table) {
    folder.write("motion.csv", table);
    std::string out = told(moving_as("file = \"motion.csv\"\n"), file);
    const std::string path = folder.path().string() + "/";
    for (auto at = out.find(path); at != std::string::npos; at = out.find(path)) out.erase(at, path.size());
    return out;
  };
  CHECK(tell("t [s], x [mm]\n0, 0\n1, 1e\n2, nan\n3,,\n4,\n") ==
        "motion.csv:3:4: error: expected a finite number, seen \"1e\"\n  1, 1e\n     ^\n"
        "motion.csv:4:4: error: expected a finite number, seen \"nan\"\n  2, nan\n     ^\n"
        "motion.csv:5:1: error: expected 2 numbers as in the header, seen 3\n  3,,\n  ^\n"
        "motion.csv:6:3: error: expected a number, seen an empty cell\n  4,\n    ^");
  CHECK_THAT(tell("t [s], x\n0, 0\n"),
             Contains("motion.csv:1:8: error: expected a name with its unit in brackets (e.g. \"t [s]\"), seen \"x\""));
  CHECK_THAT(tell("t [s], x [mmm]\n0, 0\n"), Contains("unknown unit \"mmm\" in \"x [mmm]\"; did you mean \"mm\"?"));
  CHECK_THAT(tell("t [s], x [deg]\n0, 0\n1, 1\n"), Contains("expected a length in column x, seen the unit \"deg\" of an angle"));
  CHECK_THAT(tell("t [s], xx [mm]\n0, 0\n1, 1\n"), Contains("unknown column \"xx\"; did you mean \"x\"?"));
  CHECK_THAT(tell("t [s], x [mm], x [mm]\n0, 0, 0\n1, 1, 0\n"), Contains("column x stands here twice"));
  CHECK_THAT(tell("x [mm]\n0\n1\n"), Contains("expected a column of times, \"t [s]\""));
  CHECK_THAT(tell("t [s]\n0\n1\n1\n"), Contains("motion.csv:4:1: error: expected a time after the row before, 1 s, seen 1 s"));
  CHECK_THAT(tell("t [s]\n0\n"), Contains("expected a header and at least two rows, seen one"));
  CHECK_THAT(tell(""), Contains("expected a header and at least two rows"));
}

TEST_CASE("a motion comes from the folder of the scenario alone") {
  const Folder folder, outside;
  const std::filesystem::path secret = outside.write("secret.csv", "t [s]\n0\n1\n");
  folder.write("inside.csv", "t [s]\n0\n1\n");
  std::filesystem::create_symlink(secret, folder.path() / "link.csv");
  std::filesystem::create_symlink(folder.path() / "inside.csv", folder.path() / "fine.csv");
  std::filesystem::create_directory(folder.path() / "sub");
  const std::filesystem::path file = folder.path() / "a.toml";
  const auto tell = [&](const std::string& name) { return told(moving_as("file = '" + name + "'\n"), file); };
  CHECK(tell("inside.csv").empty());
  CHECK(tell("fine.csv").empty());
  CHECK(tell("./inside.csv").empty());
  CHECK_THAT(tell("../" + outside.path().filename().string() + "/secret.csv"), Contains("it leads out of the folder"));
  CHECK_THAT(tell("sub/../inside.csv"), Contains("it leads out of the folder"));
  CHECK_THAT(tell(secret.string()), Contains("an absolute path"));
  CHECK_THAT(tell("link.csv"), Contains("a link leads out of the folder"));
  CHECK_THAT(tell("sub"), Contains("not a regular file"));
  CHECK_THAT(tell("none.csv"), Contains("there is no such file"));
  CHECK_THAT(tell(""), Contains("no name of a file"));
  CHECK_THAT(told(moving_as("file = \"in\\u0000side.csv\"\n"), file), Contains("seen U+0000 as its character 3"));
}
