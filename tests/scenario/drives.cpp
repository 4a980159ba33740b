// [drive]. The stage drives its slide q by a screw and its turn psi by a gear; machines of one sort are made for the purpose.
#include <catch2/catch.hpp>
#include <core/numbers.hpp>
#include <core/scenario/sizing_part.hpp>
#include <tests/scenario/trial.hpp>

using namespace pmreport;
using namespace pmreport::scenario;
using namespace trial;
using Catch::Contains;
using mechanics::DriveTrain;
using mechanics::EfficiencyConvention;

namespace {

std::string driven(std::string_view lines) { return with_more("[[section]]\nkind = \"drives\"\n[drive]\n" + std::string(lines)); }
std::vector<DriveTrain> drives_of(std::string_view lines) {
  const std::string text = driven(lines);
  INFO(told(text));
  return load_text(text, "a.toml", stage::source(), section::kinds()).scenario.drives;
}
std::string told_of(std::string_view lines) { return told(driven(lines)); }

// What a machine says whose actuators a and b are both linear, "m", or both rotary, "rad".
std::string told_by(const std::string& unit, const std::string& drive) {
  MechanismPart part;
  part.topology.emplace();
  part.topology->actuators = {{"a", "first", unit, 0, {}}, {"b", "second", unit, 1, {}}};
  Diagnostics diagnostics("a.toml", drive);
  const Value document = parse_document(drive, "a.toml", diagnostics);
  (void)read_drives(&document.entries.at(0), part, Reader(diagnostics));
  try {
    diagnostics.throw_if_any();
  } catch (const ScenarioError& e) {
    return e.what();
  }
  return {};
}

}  // namespace

TEST_CASE("a scenario without [drive] has no drives") {
  CHECK(load_text(std::string(sound), "a.toml", stage::source(), section::kinds()).scenario.drives.empty());
}

TEST_CASE("a lead is of the linear actuators, a ratio of the rotary ones, the rest of all") {
  const auto d = drives_of("efficiency = \"90 %\"\nconvention = \"divides\"\nlead = \"5 mm\"\nratio = 50\ninertia = \"1.2e-5 kg*m^2\"\n");
  REQUIRE(d.size() == 2);
  for (const DriveTrain& one : d) {
    CHECK(one.efficiency == Approx(0.9));
    CHECK(one.convention == EfficiencyConvention::always_divides);
    CHECK(one.inertia == Approx(1.2e-5));
  }
  CHECK(d[0].ratio == Approx(2 * pi / 0.005));
  CHECK(d[1].ratio == 50);
}

TEST_CASE("what is said of one actuator goes over what is said of all") {
  const auto d = drives_of(
      "efficiency = 0.9\nlead = \"5 mm\"\nratio = 50\ninertia = \"12 kg*mm^2\"\n"
      "[drive.q]\nlead = \"1 cm\"\nefficiency = 0.8\n[drive.psi]\nconvention = \"divides\"\ninertia = \"0 kg*m^2\"\n");
  CHECK(d == std::vector<DriveTrain>{{0.8, EfficiencyConvention::by_power, 2 * pi / 0.01, 12e-6},
                                     {0.9, EfficiencyConvention::always_divides, 50, 0}});
}

TEST_CASE("a drive of which little is said is ideal, and has no motor") {
  CHECK(drives_of("efficiency = 1\n") == std::vector<DriveTrain>(2));
  const auto d = drives_of("[drive.psi]\nratio = 1\n");
  CHECK(d[0] == DriveTrain{});
  CHECK(d[1].ratio == 1);
}

TEST_CASE("a drive that cannot be is refused, with its range") {
  const std::pair<const char*, const char*> cases[] = {
      {"efficiency = 1.2", "a.toml:15:14: error: expected 0.001 to 1 for efficiency, seen 1.2"},
      {"efficiency = 0", "seen 0"},
      {"efficiency = -0.9", "seen -0.9"},
      {"efficiency = \"90\"", "seen 90"},
      {"efficiency = \"0.9 m\"", "expected a plain number, seen a length"},
      {"efficiency = nan", "expected a finite number for \"drive.efficiency\", seen nan"},
      {"efficiency = true", "expected a plain number, seen true"},
      {"convention = \"divide\"", "expected \"power\" or \"divides\", seen \"divide\"; did you mean \"divides\"?"},
      {"convention = 1", "expected a text in quotes, seen the number 1"},
      {"lead = \"0 mm\"", "expected 0.001 mm to 10000 mm for lead, seen 0 mm"},
      {"lead = \"-5 mm\"", "seen -5 mm"},
      {"lead = \"1e300 m\"", "seen 1e303 mm"},
      {"lead = \"1e-320 m\"", "for lead, seen"},
      {"lead = 5", "expected a length (e.g. \"250 mm\"), seen the number 5 without a unit"},
      {"lead = \"5 deg\"", "expected a length (e.g. \"250 mm\"), seen an angle"},
      {"ratio = 0", "expected 0.001 to 1e6 for ratio, seen 0"},
      {"ratio = \"1/0\"", "expected a finite number, but \"1/0\" has no such value"},
      {"ratio = \"5 mm\"", "expected a plain number, seen a length"},
      {"lead = \"5 mm\"\nratio = 1\ninertia = \"-1 kg*m^2\"", "expected 0 kg*m^2 to 1000 kg*m^2 for inertia, seen -1 kg*m^2"},
      {"lead = \"5 mm\"\nratio = 1\ninertia = \"1 kg\"", "expected a moment of inertia (e.g. \"0.03 kg*m^2\"), seen a mass"},
      {"eficiency = 1", "unknown key \"eficiency\" in [drive]; did you mean \"efficiency\"?"},
      {"[drive.psy]\nratio = 1", "unknown key \"psy\" in [drive]; did you mean \"psi\"?"},
      {"[drive.q]\nleed = \"1 mm\"", "unknown key \"leed\" in [drive.q]; did you mean \"lead\"?"},
      {"[drive.q]\nefficiency = 2", "a.toml:16:14: error: expected 0.001 to 1 for efficiency, seen 2"},
      {"q = \"5 mm\"", "expected a table [drive.q], seen the text \"5 mm\""},
      {"", "a.toml:14:2: error: expected what the drive is made of, seen an empty table"},
      {"[drive.q]", "a.toml:15:8: error: expected what the drive is made of, seen an empty table"},
  };
  for (const auto& [lines, message] : cases) {
    CAPTURE(lines);
    CHECK_THAT(told_of(lines), Contains(message));
  }
  CHECK_THAT(told("drive = 3\n" + with_more("[[section]]\nkind = \"drives\"\n")), Contains("expected a table [drive], seen the number 3"));
}

TEST_CASE("the ends of a range are within it") {
  for (const char* lines : {"efficiency = \"100 %\"", "efficiency = 0.001", "lead = \"1 um\"", "lead = \"10 m\"", "ratio = 1e6"}) {
    CAPTURE(lines);
    CHECK(told_of(lines).empty());
  }
}

TEST_CASE("a lead for a rotary actuator is refused, and a ratio for a linear one") {
  CHECK(told_of("[drive.psi]\nlead = \"5 mm\"\n") ==
        "a.toml:16:1: error: a lead is of a screw, and psi is rotary\n  lead = \"5 mm\"\n  ^\n"
        "  hint: write ratio = 50, the motor's turns per turn of the joint");
  CHECK_THAT(told_of("[drive.q]\nratio = 50\n"),
             Contains("a.toml:16:1: error: a ratio is of gears to a rotary actuator, and q is linear") &&
                 Contains("hint: write lead = \"5 mm\", the way per turn of the screw"));
  CHECK_THAT(told_by("rad", "drive = { lead = \"5 mm\" }"),
             Contains("a.toml:1:11: error: a lead is of a screw, and all actuators are rotary"));
  CHECK_THAT(told_by("m", "drive = { ratio = 5 }"), Contains("and all actuators are linear"));
  CHECK(told_by("rad", "drive = { ratio = 5 }").empty());
  CHECK(told_by("m", "drive = { lead = \"5 mm\", b = { lead = \"7 mm\" } }").empty());
}

TEST_CASE("inertia without what carries it to the actuator is refused") {
  CHECK(told_of("lead = \"5 mm\"\ninertia = \"1e-5 kg*m^2\"\n") ==
        "a.toml:16:1: error: the inertia of a motor acts on its actuator through a ratio, which is not given for psi\n"
        "  inertia = \"1e-5 kg*m^2\"\n  ^\n"
        "  hint: add to [drive], or to [drive.psi], ratio = 50, or ratio = 1 for a motor on the joint itself");
  CHECK_THAT(
      told_of("[drive.q]\ninertia = \"1e-5 kg*m^2\"\n"),
      Contains("a.toml:16:1: error: the inertia of a motor acts on its actuator through the lead of a screw, which is not given for q") &&
          Contains("hint: add to [drive], or to [drive.q], lead = \"5 mm\""));
  CHECK_THAT(told_by("m", "drive = { inertia = \"1 kg*m^2\" }"), Contains("is not given for a and b"));
  CHECK_THAT(told_by("m", "drive = { inertia = \"1 kg*m^2\", b = { lead = \"5 mm\" } }"), Contains("is not given for a\n"));
  // A lead that is wrong is told once, and not missed on top.
  CHECK_THAT(told_by("m", "drive = { inertia = \"1 kg*m^2\", lead = \"5 N\" }"), Contains("seen a force") && !Contains("not given"));
}

TEST_CASE("a section drives and its table need one another") {
  CHECK(told(with_more("[[section]]\nkind = \"drives\"\n")) ==
        "a.toml:13:8: error: a section \"drives\" needs the table [drive], which is not there\n  kind = \"drives\"\n         ^\n"
        "  hint: add [drive] and, for instance, efficiency = 0.9");
  CHECK(told(with_more("[drive]\nefficiency = 0.9\n")) ==
        "a.toml:12:2: error: [drive] is for the section \"drives\", which this scenario does not have\n  [drive]\n   ^\n"
        "  hint: add [[section]] and kind = \"drives\"; forces of the other sections are those of the actuators themselves");
  // A kind that is misspelled may have been that one.
  CHECK_THAT(told(with_more("[drive]\nefficiency = 0.9\n[[section]]\nkind = \"drivs\"\n")), !Contains("does not have"));
}

TEST_CASE("motors that a scenario does not describe cannot be checked") {
  const auto tell = [](const std::string& drive, const std::string& that) {
    return told_of(drive + "\n[[check]]\nthat = \"" + that + "\"\nbelow = 1e9\n");
  };
  CHECK(told_of("efficiency = 0.9\nlead = \"5 mm\"\n[[check]]\nthat = \"max(psi_motor_torque)\"\nbelow = \"1 N*m\"\n") ==
        "a.toml:18:13: error: no motor is described for psi: [drive] does not say what stands between motor and actuator\n"
        "  that = \"max(psi_motor_torque)\"\n              ^\n"
        "  hint: add to [drive], or to [drive.psi], ratio = 50, or ratio = 1 for a motor on the joint itself");
  CHECK_THAT(tell("efficiency = 0.9", "max(abs(motor_power))"), Contains("a.toml:17:17: error: no motor is described for q and psi: "));
  CHECK_THAT(tell("efficiency = 0.9", "drives.peak_speed"), Contains("a.toml:17:9: error: no motor is described for q and psi: "));
  CHECK_THAT(told_of("efficiency = 0.9\n[[check]]\nthat = \"max(q_reflected_inertia)\"\nbelow = \"1 kg\"\n"), Catch::Equals(""));
}

TEST_CASE("a group of motor columns holds those of the motors that are there") {
  const auto columns = [](const std::string& drive) {
    const std::string text = driven(drive + "[[check]]\nthat = \"max(abs(motor_torque))\"\nbelow = \"1 N*m\"\n[[check]]\n" +
                                    "that = \"drives.peak_torque\"\nbelow = \"1 N*m\"\n");
    INFO(told(text));
    const Loaded loaded = load_text(text, "a.toml", stage::source(), section::kinds());
    CHECK(loaded.scenario.checks.at(1).quantity == "drives.peak_torque");
    return loaded.scenario.checks.at(0).columns;
  };
  CHECK(columns("lead = \"5 mm\"\nratio = 3\n") == std::vector<std::string>{"q_motor_torque", "psi_motor_torque"});
  CHECK(columns("ratio = 3\n") == std::vector<std::string>{"psi_motor_torque"});
}
