// Scenarios from settings of controllers. The oracles are the controllers' own formulas, written here once more.
#include <tests/program/workshop.hpp>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

using namespace program_test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using Eigen::Matrix3d, Eigen::Vector3d;

namespace {

constexpr double deg = std::numbers::pi / 180;

Matrix3d about_x(double a) { return Eigen::AngleAxisd(a, Vector3d::UnitX()).toRotationMatrix(); }
Matrix3d about_y(double a) { return Eigen::AngleAxisd(a, Vector3d::UnitY()).toRotationMatrix(); }
Matrix3d about_z(double a) { return Eigen::AngleAxisd(a, Vector3d::UnitZ()).toRotationMatrix(); }

struct Joints {
  std::array<Vector3d, 6> base, platform;  // as the HAL has them
};

// Six pairs of joints that have no symmetry, so that a wrong number or sign shows.
Joints crooked() {
  Joints j;
  for (std::size_t i = 0; i < 6; ++i) {
    const double n = double(i), at_base = (-150 + 120 * double(i / 2) + (i % 2 == 0 ? -12 : 13)) * deg,
                 at_platform = (-150 + 120 * double(i / 2) + (i % 2 == 0 ? -44 : 41)) * deg;
    j.base[i] = {220 * std::cos(at_base) + n, 220 * std::sin(at_base), 12 + 3 * n};
    j.platform[i] = {120 * std::cos(at_platform), 118 * std::sin(at_platform) - n, -8 + n};
  }
  return j;
}

std::string hal_of(const Joints& j, const std::string& more = "") {
  std::string out =
      "# joints of the bench\nloadrt [KINS]KINEMATICS\nloadrt motmod servo_period_nsec=1000000\naddf motion-controller servo-thread\n";
  for (std::size_t i = 0; i < 6; ++i)
    for (const auto& [name, point] : {std::pair{"base", &j.base[i]}, std::pair{"platform", &j.platform[i]}})
      for (int k = 0; k < 3; ++k) {
        char line[120];
        std::snprintf(line, sizeof line, "setp genhexkins.%s.%zu.%c   %.17g\n", name, i, "xyz"[k], (*point)(k));
        out += line;
      }
  return out + more;
}

std::string ini_of(const std::string& unit, const std::string& home, const std::string& more = "") {
  std::string out =
      "[EMC]\nMACHINE = bench\n[KINS]\nKINEMATICS = genhexkins\nJOINTS = 6\n[HAL]\nHALFILE = bench.hal\nHALFILE = io.hal\n[TRAJ]\n";
  out += "LINEAR_UNITS = " + unit + "\nANGULAR_UNITS = degree\n" + (home.empty() ? "" : "HOME = " + home + "\n");
  for (int i = 0; i < 6; ++i)
    out += "[JOINT_" + std::to_string(i) + "]\nTYPE = LINEAR\nMIN_LIMIT = 250\nMAX_LIMIT = " + (i == 4 ? "690" : "700") +
           "\nMAX_VELOCITY = 500\n";
  return out + more;
}

// LinuxCNC's length of strut i at x y z a b c, in its units and degrees.
double strut(const Joints& j, std::size_t i, const std::array<double, 6>& pose, double shift) {
  const Matrix3d r = about_z(pose[5] * deg) * about_y(pose[4] * deg) * about_x(pose[3] * deg);
  const Vector3d lift(0, 0, shift), p(pose[0], pose[1], pose[2]);
  return (p + r * (j.platform[i] + lift) - (j.base[i] + lift)).norm();
}

// The pose of a row of gough's data as LinuxCNC tells it: roll, pitch and yaw of Rz(alpha) Rx(beta) Ry(gamma).
std::array<double, 6> pose_of(std::map<std::string, std::vector<double>>& data, std::size_t row, double metres) {
  const Matrix3d r = about_z(data["alpha"][row]) * about_x(data["beta"][row]) * about_y(data["gamma"][row]);
  return {data["x"][row] / metres,   data["y"][row] / metres,           data["z"][row] / metres, std::atan2(r(2, 1), r(2, 2)) / deg,
          std::asin(-r(2, 0)) / deg, std::atan2(r(1, 0), r(0, 0)) / deg};
}

struct Bench {
  Workshop here;
  Result import(const std::vector<std::string>& files) const {
    std::vector<std::string> words{"import"};
    words.insert(words.end(), files.begin(), files.end());
    return run_pmreport(words, {.folder = here.path()});
  }
  // Of one file of that name.
  Result import(const std::string& name, const std::string& text) const {
    here.write(name, text);
    return import(std::vector<std::string>{name});
  }
};

constexpr const char* kossel = R"(# a printer
[stepper_a]
step_pin: PF0  # of the board
position_endstop: 297.05
arm_length: 333.0
[stepper_b]
[stepper_c]
angle = 91.5
[printer]
kinematics: delta
max_velocity: 300
delta_radius: 170
print_radius: 120
[extruder]
gcode:
   G28
   G1 Z5

#*# <---------------------- SAVE_CONFIG ---------------------->
#*# DO NOT EDIT THIS BLOCK OR BELOW. The contents are auto-generated.
#*#
#*# [printer]
#*# delta_radius = 174.312000
#*#
#*# [stepper_b]
#*# arm_length = 332.9
#*# position_endstop = 297.4
)";

constexpr const char* marlin = R"(/* what was:
#define DELTA_RADIUS 1 */
#define DELTA
#if ENABLED(DELTA)
  #define DELTA_SEGMENTS_PER_SECOND 160
  #define DELTA_ROD_OFFSET 145.0
  #define DELTA_EFFECTOR 19.9
  #define DELTA_RADIUS (DELTA_ROD_OFFSET-(DELTA_EFFECTOR)-2*9.75) // mm
  #define DELTA_DIAGONAL_ROD 215.0 // (mm)
  #define DELTA_HEIGHT 240.0
  #define PRINTABLE_RADIUS 85.0
  #define DELTA_ENDSTOP_ADJ { 0.0, -0.15, -0.4 }
  #define DELTA_TOWER_ANGLE_TRIM { 0.2, -0.1, 0.0 }
  #define DELTA_DIAGONAL_ROD_TRIM_TOWER { 0.3, 0.0, -0.2 }
  //#define DELTA_RADIUS_TRIM_TOWER { 9.0, 0.0, 0.0 }
#endif
#define MOTHERBOARD BOARD_RAMPS
)";

// Height of a carriage over the nozzle: z + sqrt(l^2 - |tower - (x, y)|^2).
double carriage(double radius, double rod, double angle, double x, double y, double z) {
  return z + std::sqrt(rod * rod - std::pow(radius * std::cos(angle * deg) - x, 2) - std::pow(radius * std::sin(angle * deg) - y, 2));
}

void check_carriages(const Workshop& here, const std::array<double, 3>& radius, const std::array<double, 3>& rod,
                     const std::array<double, 3>& angle) {
  auto data = columns(here.report_folder() / "data/displacement.csv");
  REQUIRE(data["t"].size() == 161);
  for (std::size_t row = 0; row < 161; row += 10)
    for (std::size_t i = 0; i < 3; ++i) {
      CAPTURE(row, i);
      const double expected = carriage(radius[i], rod[i], angle[i], 1e3 * data["x"][row], 1e3 * data["y"][row], 1e3 * data["z"][row]);
      CHECK(std::abs(1e3 * data["s" + std::to_string(i + 1)][row] - expected) < 1e-9);  // [mm], of some 300: rounding
    }
}

}  // namespace

TEST_CASE("a hexapod of LinuxCNC has LinuxCNC's strut lengths, in mm and in inches") {
  const auto& [unit, metres] = GENERATE(std::pair{"mm", 1e-3}, std::pair{"inch", 0.0254});
  const Joints j = crooked();
  const Bench bench;
  bench.here.write("bench.ini", ini_of(unit, "5 -4 420 3 -5 8", "[GEOMETRY]\nLIFT = 40\n"));
  bench.here.write("bench.hal", hal_of(j, "genhexkins.spindle-offset = [GEOMETRY]LIFT\nsetp genhexkins.limit-iterations 100 # plenty\n"));
  const Result made = bench.import({"bench.ini", "bench.hal"});
  CAPTURE(made.out, made.err);
  REQUIRE(made.status == 0);
  REQUIRE(bench.here.report(made.out).status == 0);
  auto data = columns(bench.here.report_folder() / "data/displacement.csv");
  REQUIRE(data["t"].size() == 161);
  for (std::size_t row = 0; row < 161; row += 10)
    for (std::size_t i = 0; i < 6; ++i) {
      CAPTURE(row, i);
      const double length = data["rho" + std::to_string(i + 1)][row] / metres;
      CHECK(std::abs(length - strut(j, i, pose_of(data, row, metres), 40)) < 1e-9);  // of some 450: 15 digits of points, and rounding
    }
  const std::array<double, 6> home = pose_of(data, 0, metres), asked{5, -4, 420, 3, -5, 8};
  for (std::size_t k = 0; k < 6; ++k) CHECK(std::abs(home[k] - asked[k]) < (k < 3 ? 1e-3 : 1e-4));  // home in the motion has six digits
  const std::string own = metres > 0.01 ? "in" : "mm";
  CHECK_THAT(made.out, Contains("x = \"5 " + own + " + ") && Contains("y = \"-4 " + own + " + ") && Contains("z = \"420 " + own + " + "));
  CHECK_THAT(made.out, Contains("stroke_min = \"250 " + own + "\"") && Contains("stroke_max = \"690 ") &&
                           Contains("which differ, the strictest") && Contains("rho6 = \"500 "));
  CHECK_THAT(made.out, Contains("# not taken over: bench.hal:42: genhexkins.limit-iterations 100\n") &&
                           Contains("# not taken over: bench.ini:8: HALFILE io.hal was not given") && Contains("1 addf and 2 loadrt"));
}

TEST_CASE("a HOME of zeros is told as that, and not as none") {
  const Bench bench;
  bench.here.write("bench.hal", hal_of(crooked()));
  for (const auto& [home, told] : {std::pair{"0 0 0 0 0 0", "[TRAJ]HOME is all zeros, in the plane of the base: home is over the base"},
                                   std::pair{"", "No [TRAJ]HOME was given: home is over the base"}}) {
    bench.here.write("bench.ini", ini_of("mm", home));
    const Result made = bench.import({"bench.ini", "bench.hal"});
    CAPTURE(made.err);
    CHECK(made.status == 0);
    CHECK_THAT(made.out, Contains(told));
  }
}

TEST_CASE("a HOME where the machine is none is told by its line") {
  const Bench bench;
  // Pairs of joints in thirds of a turn: at a quarter of a turn about Z such a hexapod is singular.
  Joints even;
  for (std::size_t i = 0; i < 6; ++i) {
    const double third = (-150 + 120 * double(i / 2)) * deg, side = i % 2 == 0 ? -1 : 1;
    even.base[i] = {220 * std::cos(third + 12 * deg * side), 220 * std::sin(third + 12 * deg * side), 0};
    even.platform[i] = {120 * std::cos(third + 44 * deg * side), 120 * std::sin(third + 44 * deg * side), 0};
  }
  // A platform like the base turns it into a machine that holds its platform nowhere.
  Joints similar = even;
  for (std::size_t i = 0; i < 6; ++i) similar.platform[i] = 0.5 * even.base[i];
  struct Case {
    const Joints& joints;
    const char *home, *told;
  };
  const Joints own = crooked();
  for (const Case& c :
       {Case{own, "0 0 900", "bench.ini:12:1: error: expected HOME with rho1 from 250 mm to 690 mm, its stroke; seen 890.129 mm"},
        Case{own, "0 0 100", "bench.ini:12:1: error: expected HOME with rho1 from 250 mm to 690 mm, its stroke; seen 155.979 mm"},
        Case{even, "0 0 420 0 0 90", "bench.ini:12:1: error: expected HOME where the actuators hold the platform, seen it on a singular"},
        Case{similar, "0 0 420", "bench.ini:4:1: error: what the settings say is no machine: its actuators do not hold"},
        Case{similar, "", "bench.ini:4:1: error: what the settings say is no machine: its actuators do not hold"}}) {
    bench.here.write("bench.ini", ini_of("mm", c.home));
    bench.here.write("bench.hal", hal_of(c.joints));
    const Result made = bench.import({"bench.ini", "bench.hal"});
    CAPTURE(c.home, made.err);
    CHECK(made.status == 2);
    CHECK(made.out.empty());
    CHECK_THAT(made.err, StartsWith(c.told));
  }
  bench.here.write("delta.hal", "loadrt lineardeltakins\nsetp lineardeltakins.R 130\nsetp lineardeltakins.L 280\n");
  bench.here.write("delta.ini",
                   "[KINS]\nKINEMATICS = lineardeltakins\n[TRAJ]\nHOME = 0 0 1000\n[JOINT_0]\nMIN_LIMIT = 50\nMAX_LIMIT = 400\n");
  const Result made = bench.import({"delta.ini", "delta.hal"});
  CHECK(made.status == 2);
  CHECK_THAT(made.err, StartsWith("delta.ini:4:1: error: expected HOME with s1 from 50 mm to 400 mm, its stroke; seen 1247.99 mm"));
}

TEST_CASE("a print radius that the rods do not reach is told to be cut where it counts") {
  const Bench bench;
  const std::string printer =
      "[printer]\nkinematics: delta\ndelta_radius: 150\n[stepper_a]\nposition_endstop: 297\narm_length: 333\n[printer]\n";
  const auto lowest = [&](const std::string& more) {
    const Result made = bench.import("printer.cfg", printer + more);
    CAPTURE(made.err);
    CHECK(made.status == 0);
    const std::size_t at = made.out.find("\nstroke_min = ");
    REQUIRE(at != std::string::npos);
    return made.out.substr(at + 1, made.out.find('\n', at + 1) - at - 1);
  };
  CHECK(lowest("print_radius: 120\n") ==
        "stroke_min = \"193.9 mm\"  # what print_radius and minimum_z_position ask for, and 1 mm; the file has no lower end");
  // 97 % of 333 mm less 150 mm; sqrt(333² - 323.01²) - 1.
  CHECK(
      lowest("print_radius: 200\n") ==
      "stroke_min = \"79.95 mm\"  # what a radius of 173 mm, as far as the rods reach, and minimum_z_position ask for, and 1 mm; the file "
      "has no lower end; print_radius 200 mm was cut");
  CHECK_THAT(lowest(""), Contains("# what delta_radius, as the print_radius, and minimum_z_position ask for"));
}

TEST_CASE("joints that a HAL leaves alone are LinuxCNC's own, and told to be") {
  const Bench bench;
  const Result none = bench.import("none.hal", "loadrt genhexkins\n");
  REQUIRE(none.status == 0);
  CHECK_THAT(none.out,
             Contains("\"-22.95 mm\", \"13.25 mm\", \"0 mm\",  # base joint of strut 0") && Contains("those that LinuxCNC has by itself"));
  CHECK(bench.here.report(none.out).status == 0);
  std::string hal = hal_of(crooked());
  const std::size_t at = hal.find("setp genhexkins.platform.2.y");
  hal.erase(at, hal.find('\n', at) + 1 - at);
  const Result some = bench.import("some.hal", hal);
  REQUIRE(some.status == 0);
  CHECK_THAT(some.out, Contains("Not set by the files, and as LinuxCNC has it by itself: platform.2.y.\n") && Contains("\"-4.884 mm\""));
}

TEST_CASE("a screw's lead becomes that of the drives, and what it corrects is told to be left out") {
  const Bench bench;
  const Result made = bench.import("bench.hal", hal_of(crooked(), "setp genhexkins.screw-lead 5\n"));
  REQUIRE(made.status == 0);
  CHECK_THAT(made.out, Contains("[drive]\nlead = \"5 mm\"") && Contains("kind = \"drives\"") && Contains("what the lead corrects"));
  CHECK(bench.here.report(made.out).status == 0);
}

TEST_CASE("towers of a Klipper printer are where Klipper has them, with what it saved in place of what was written") {
  const Bench bench;
  const Result made = bench.import("printer.cfg", kossel);
  CAPTURE(made.out, made.err);
  REQUIRE(made.status == 0);
  REQUIRE(bench.here.report(made.out).status == 0);
  check_carriages(bench.here, {174.312, 174.312, 174.312}, {333, 332.9, 333}, {210, 330, 91.5});
  CHECK_THAT(made.out,
             Contains("# not taken over: printer.cfg, [printer]: max_velocity\n") && Contains("[extruder]: gcode\n") &&
                 Contains("stroke_max = \"" + std::to_string(297.05 + std::sqrt(333.0 * 333.0 - 174.312 * 174.312)).substr(0, 7)));
}

TEST_CASE("towers of a Marlin printer are where Marlin has them, trims and sums of other definitions among them") {
  const Bench bench;
  const Result made = bench.import("Configuration.h", marlin);
  CAPTURE(made.out, made.err);
  REQUIRE(made.status == 0);
  REQUIRE(bench.here.report(made.out).status == 0);
  check_carriages(bench.here, {105.6, 105.6, 105.6}, {215.3, 215, 214.8}, {210.2, 329.9, 90});
  CHECK_THAT(made.out, Contains("# not taken over: Configuration.h:5: DELTA_SEGMENTS_PER_SECOND 160\n") && !Contains("DELTA_EFFECTOR 19"));
}

TEST_CASE("sums of Marlin's definitions are what C makes of them") {
  // 505 / 2 is 252 of whole numbers, -7 / 2 is -3, and 252.5 where one of them is none.
  struct Case {
    const char *text, *radius;
  };
  const Bench bench;
  for (const Case& c : {Case{"505/2", "252"}, Case{"505/2.0", "252.5"}, Case{"505.0f/2", "252.5"}, Case{"5e2/8", "62.5"},
                        Case{"(100+101)/2*2", "200"}, Case{"250+-7/2", "247"}, Case{"SUM/2", "100"}, Case{"300-NEGATIVE", "305"}}) {
    const Result made = bench.import("a.h", std::string("#define DELTA\n#define DELTA_HEIGHT 300\n#define DELTA_DIAGONAL_ROD 400\n") +
                                                "#define SUM (100 + 101)\n#define NEGATIVE -5\n#define DELTA_RADIUS " + c.text + "\n");
    CAPTURE(c.text, made.err);
    REQUIRE(made.status == 0);
    // What is written is R + r, and r.
    const auto number_behind = [&](const std::string& key) {
      const std::size_t at = made.out.find("\n" + key + " = \"");
      REQUIRE(at != std::string::npos);
      return std::stod(made.out.substr(at + key.size() + 5));
    };
    CHECK(number_behind("tower_radius") - number_behind("platform_radius") == Approx(std::stod(c.radius)).epsilon(1e-13));
  }
}

TEST_CASE("files that a printer.cfg includes are told one by one, with their lines") {
  const Bench bench;
  const Result made = bench.import("printer.cfg", "[include towers.cfg]\n" + std::string(kossel) + "[include macros/*.cfg] # more\n");
  REQUIRE(made.status == 0);
  CHECK_THAT(made.out, Contains("# not taken over: printer.cfg:1: [include towers.cfg], which was not read") &&
                           Contains("# not taken over: printer.cfg:29: [include macros/*.cfg], which was not read"));
  CHECK_THAT(
      bench.import("a.cfg", "[include towers.cfg]\n").err,
      StartsWith("a.cfg: error: expected kinematics in [printer], which is not there") && Contains("files that it includes are not read"));
}

TEST_CASE("towers of LinuxCNC's lineardeltakins begin at Y") {
  const Bench bench;
  const Result made = bench.import("delta.hal", "loadrt lineardeltakins\nsetp lineardeltakins.R 130\nsetp lineardeltakins.L 280\n");
  REQUIRE(made.status == 0);
  REQUIRE(bench.here.report(made.out).status == 0);
  check_carriages(bench.here, {130, 130, 130}, {280, 280, 280}, {90, 210, 330});
}

TEST_CASE("machines that no mechanism is are refused by what they are, at their line") {
  const Bench bench;
  struct Case {
    const char *name, *text, *told;
  };
  for (const Case& c : {Case{"a.hal", "# five\nloadrt pentakins\n",
                             "a.hal:2:1: error: expected genhexkins or lineardeltakins, seen \"pentakins\": a pentapod"},
                        Case{"b.ini", "[KINS]\nKINEMATICS = trivkins\n",
                             "b.ini:2:1: error: expected genhexkins or lineardeltakins, seen \"trivkins\": slides"},
                        Case{"c.cfg", "[printer]\nkinematics: corexy\n",
                             "c.cfg:2:1: error: expected kinematics: delta, seen \"corexy\": slides at right angles"},
                        Case{"d.h", "#define COREXY\n", "d.h:1:1: error: expected #define DELTA, seen COREXY"},
                        Case{"e.h", "int main() {}\n", "e.h: error: expected #define DELTA, which is not there"},
                        Case{"f.ini", "[TRAJ]\nAXES = 3\n", "f.ini: error: expected a machine"}}) {
    const Result made = bench.import(c.name, c.text);
    CAPTURE(c.name, made.err);
    CHECK(made.status == 2);
    CHECK(made.out.empty());
    CHECK_THAT(made.err, StartsWith(c.told));
  }
}

TEST_CASE("what is broken in settings is told with file and line") {
  const Bench bench;
  struct Case {
    const char* name;
    std::string text;
    const char* told;
  };
  const std::string delta = "[printer]\nkinematics: delta\ndelta_radius: 100\n[stepper_a]\n",
                    defines = "#define DELTA\n#define DELTA_HEIGHT 200\n";
  for (const Case& c :
       {Case{"a.hal", "setp genhexkins.base.0.x 1e400\n",
             "a.hal:1:1: error: expected genhexkins.base.0.x, seen \"1e400\", which is out of all"},
        Case{"a.hal", "setp genhexkins.base.0.x nan\n", "a.hal:1:1: error: expected genhexkins.base.0.x, a number; seen \"nan\""},
        Case{"a.hal", "\n  setp genhexkins.base.0.x 1e300\n", "a.hal:2:3: error: expected genhexkins.base.0.x of at most 100 m"},
        Case{"a.hal", "setp genhexkins.base.0.x\n", "a.hal:1:1: error: expected setp NAME VALUE"},
        Case{"a.hal", "setp genhexkins.base.0.x [A]B\n", "a.hal:1:1: error: expected genhexkins.base.0.x, seen \"[A]B\", which no INI"},
        Case{"a.ini", "[KINS\nKINEMATICS = genhexkins\n", "a.ini:1:1: error: expected a section in brackets"},
        Case{"a.ini", "[KINS]\nKINEMATICS genhexkins\n", "a.ini:2:1: error: expected NAME = VALUE"},
        Case{"a.ini", "[KINS]\nKINEMATICS = genhexkins\n[TRAJ]\nLINEAR_UNITS = cubit\n",
             "a.ini:4:1: error: expected LINEAR_UNITS mm or inch"},
        Case{"a.cfg", delta + "arm_length: 90\nposition_endstop: 200\n", "a.cfg:5:1: error: expected an arm_length above delta_radius"},
        Case{"a.cfg", delta + "arm_length: -9\n", "a.cfg:5:1: error: expected arm_length above 0"},
        Case{"a.cfg", delta + "arm_length: 250\n", "a.cfg: error: expected position_endstop in [stepper_a]"},
        Case{"a.cfg", delta + "arm_length: 250\nposition_endstop: 200\n[stepper_b]\nangle: 210.1\n",
             "a.cfg:2:1: error: what the settings say is no machine: linear-delta refuses"},
        Case{"a.cfg", "  on its own\n", "a.cfg:1:3: error: expected [SECTION] first"},
        Case{"a.cfg", delta + "  arm_length: 250\n", "a.cfg:5:3: error: expected a setting of [stepper_a], seen a line that goes on"},
        Case{"a.cfg", delta + "arm_length: 250\n#*# [stepper_a]\n#*#  angle = 3\n",
             "a.cfg:7:1: error: expected [SECTION] first, seen a line that goes on"},
        Case{"a.ini", "[KINS]\nKINEMATICS = genhexkins\n[JOINT_0]\nMAX_VELOCITY = 1e6\n",
             "a.ini:4:1: error: expected the MAX_VELOCITY of a joint of at most 100 m/s, seen 1000 m/s"},
        Case{"a.h",
             defines + "#if A\n#define OFFSET 200\n#else\n#define OFFSET 150\n#endif\n#define DELTA_RADIUS (OFFSET - 20)\n" +
                 "#define DELTA_DIAGONAL_ROD 300\n",
             "a.h:6:1: error: OFFSET is defined a second time, as something else than in a.h:4"},
        Case{"a.h", defines + "#define OFFSET 10+5\n#define DELTA_RADIUS (200-20-OFFSET)\n#define DELTA_DIAGONAL_ROD 300\n",
             "a.h:3:1: error: expected OFFSET, which is part of DELTA_RADIUS in mm, as a number or in brackets; seen \"10+5\""},
        Case{"a.h", defines + "#define DELTA_RADIUS A\n#define A B\n#define B A\n#define DELTA_DIAGONAL_ROD 200\n",
             "a.h:3:1: error: expected DELTA_RADIUS in mm, a number; it is put together in too many steps"},
        Case{"a.h", defines + "#define DELTA_RADIUS 100/0\n#define DELTA_DIAGONAL_ROD 200\n",
             "a.h:3:1: error: expected DELTA_RADIUS in mm, a number or a sum"},
        Case{"a.h", defines + "#define DELTA_RADIUS 100\n#define DELTA_RADIUS 101\n#define DELTA_DIAGONAL_ROD 200\n",
             "a.h:4:1: error: DELTA_RADIUS is defined a second time"},
        Case{"a.h", defines + "#define DELTA_RADIUS 100\n#define DELTA_DIAGONAL_ROD " + std::string(4000, '(') + "\n",
             "a.h:4:1: error: expected DELTA_DIAGONAL_ROD in mm, a number; it is put together"},
        Case{"a.toml", "", "a.toml: error: expected settings of a controller"},
        Case{"a.cfg", std::string("[a]\0", 4), "a.cfg: error: expected a text file"},
        Case{"a.cfg", std::string(5000, 'a'), "a.cfg:1:1: error: expected lines of at most"},
        Case{"a.cfg", std::string(30000, '\n'), "a.cfg:20001:1: error: expected at most 20000 lines"},
        Case{"a.cfg", std::string(2 << 20, 'a'), "a.cfg: error: is longer than 1 MiB"}}) {
    const Result made = bench.import(c.name, c.text);
    CAPTURE(c.name, c.text.substr(0, 200), made.err);
    CHECK(made.status == 2);
    CHECK(made.out.empty());
    CHECK_THAT(made.err, StartsWith(c.told));
  }
  CHECK(bench.import({"none.hal"}).status == 2);
  CHECK_THAT(bench.import({"a.cfg", "a.hal"}).err, Contains("expected files of one controller"));
}

TEST_CASE("what a file says ends in comments of one line, whatever it holds") {
  const Bench bench;
  const std::string evil = "\x1b[31m\xff\"]\r[mechanism]";
  const Result made = bench.import("printer.cfg", std::string(kossel) + "[" + evil + "\n" + evil + ": 1\n");
  CHECK(made.status == 0);
  CHECK(made.out.find('\x1b') == std::string::npos);
  CHECK(made.out.find('\r') == std::string::npos);
  CHECK(bench.here.report(made.out, {"--check"}).status == 0);
}

TEST_CASE("an imported scenario goes to a new file, and never over another") {
  const Bench bench;
  bench.here.write("printer.cfg", kossel);
  CHECK(bench.import({"printer.cfg", "-o", "made.toml"}).status == 0);
  CHECK(bytes_of(bench.here / "made.toml") == bench.import({"printer.cfg"}).out);
  const Result again = bench.import({"printer.cfg", "-o", "made.toml"});
  CHECK(again.status == 2);
  CHECK_THAT(again.err, Contains("made.toml is there already"));
}
