// [elasticity] and [[element]]: what gives way, and mistakes in it.
#include <catch2/catch.hpp>
#include <tests/scenario/trial.hpp>

using namespace pmreport;
using namespace pmreport::scenario;
using namespace trial;
using Catch::Contains;

namespace {

const std::string section_text = "[[section]]\nkind = \"stiffness\"\n";
Loaded loaded(const std::string& more) {
  const std::string text = with_more(section_text + more);
  INFO(told(text));
  return load_text(text, "a.toml", stage::source(), section::kinds());
}
std::string told_of_elasticity(const std::string& more) { return told(with_more(section_text + more)); }
std::string element(const std::string& lines) { return "[[element]]\nname = \"part\"\n" + lines; }

}  // namespace

TEST_CASE("an element is a bearing, a drive, a beam or a rail, as it says") {
  const Loaded l = loaded(
      "[[element]]\nname = \"seat\"\njoint = \"R\"\naxial = \"80 N/um\"\ntilting = \"5000 N*m/rad\"\n"
      "[[element]]\nname = \"servo\"\ndrive = \"psi\"\nstiffness = \"2000 N*m/rad\"\n"
      "[[element]]\nname = \"arm\"\nbeam = [\"P\", \"R\"]\ndiameter = \"30 mm\"\nbore = \"20 mm\"\nmaterial = \"aluminium\"\n"
      "[[element]]\nname = \"screw\"\nrail = [\"P\", \"R\"]\ndiameter = \"16 mm\"\noffset = \"50 mm\"\nmaterial = { modulus = \"200 GPa\" "
      "}\n");
  const auto& e = l.machine->topology().elements;
  REQUIRE(e.size() == 4);
  CHECK(e[0].kind == ElementKind::bearing);
  CHECK(e[0].stiffness[0] == Approx(80e6));
  CHECK(std::isinf(e[0].stiffness[1]));
  CHECK(e[0].stiffness[3] == Approx(5000));
  CHECK(e[1].kind == ElementKind::drive);
  CHECK(e[1].stiffness[0] == Approx(2000));
  CHECK(e[2].kind == ElementKind::beam);
  CHECK(e[2].material.modulus == Approx(70e9));
  CHECK(e[2].section.area == Approx(3.14159265358979 * (0.03 * 0.03 - 0.02 * 0.02) / 4));
  CHECK(e[3].kind == ElementKind::rail);
  CHECK(e[3].offset == Approx(0.05));
  CHECK(e[3].material.shear_modulus == Approx(200e9 / 2.6));
}

TEST_CASE("elements are taken as rigid by their name or kind, and drives get their stiffness from [drive]") {
  const std::string two =
      "[[element]]\nname = \"seat\"\njoint = \"R\"\naxial = \"80 N/um\"\n[drive.q]\nstiffness = \"10 N/um\"\n[drive.psi]\nstiffness = \"2 "
      "kNm/rad\"\n";
  CHECK(loaded(two).machine->topology().elements.size() == 3);
  const Loaded without_drives = loaded(two + "[elasticity]\nrigid = [\"drives\"]\n");
  REQUIRE(without_drives.machine->topology().elements.size() == 1);
  CHECK(without_drives.machine->topology().elements[0].name == "seat");
  const Loaded without_seat = loaded(two + "[elasticity]\nrigid = [\"seat\", \"drive_q\"]\n");
  REQUIRE(without_seat.machine->topology().elements.size() == 1);
  CHECK(without_seat.machine->topology().elements[0].stiffness[0] == Approx(2000));
  // Other values of parameters keep the settings.
  const auto other = without_seat.machine->with(without_seat.machine->values());
  CHECK(other->topology().elements.size() == 1);
}

TEST_CASE("mistakes in elements are told with what to write") {
  struct Case {
    std::string more, expected;
  };
  const Case cases[] = {
      {element(""), "expected one of beam, rail, joint and drive in an element, seen 0"},
      {element("joint = \"R\"\ndrive = \"q\"\naxial = \"1 N/um\"\nstiffness = \"1 N/um\"\n"), "seen 2"},
      {"[[element]]\njoint = \"R\"\naxial = \"1 N/um\"\n", "name"},
      {element("joint = \"Q\"\naxial = \"1 N/um\"\n"), "expected \"P\" or \"R\", seen \"Q\""},
      {element("joint = \"R\"\n"), "expected how stiff the joint is"},
      {element("joint = \"R\"\naxial = \"0 N/um\"\n"), "for axial, seen 0 N/um"},
      {element("joint = \"R\"\naxial = \"-3 N/um\"\n"), "for axial, seen -3 N/um"},
      {element("joint = \"R\"\naxial = \"3 mm\"\n"), "expected a stiffness"},
      {element("joint = \"R\"\ntilting = \"3 N/um\"\n"), "expected an angular stiffness"},
      {element("drive = \"psi\"\nstiffness = \"3 N/um\"\n"), "expected an angular stiffness"},
      {element("drive = \"q\"\n"), "stiffness"},
      {element("beam = [\"P\", \"R\"]\nmaterial = \"steel\"\n"), "expected the section of the element"},
      {element("beam = [\"P\", \"R\"]\ndiameter = \"10 mm\"\n"), "material"},
      {element("beam = [\"P\", \"R\"]\ndiameter = \"10 mm\"\nbore = \"10 mm\"\nmaterial = \"steel\"\n"),
       "expected a bore less than the diameter"},
      {element("beam = [\"P\", \"R\"]\ndiameter = \"10 mm\"\nwidth = \"10 mm\"\nmaterial = \"steel\"\n"), "round or rectangular, not both"},
      {element("beam = [\"P\", \"R\"]\ndiameter = \"10 mm\"\nmaterial = \"wood\"\n"), "the materials"},
      {element("beam = [\"P\", \"R\"]\ndiameter = \"10 mm\"\nmaterial = { modulus = \"-210 GPa\" }\n"), "for modulus, seen -210 GPa"},
      {element("beam = [\"P\", \"P\"]\ndiameter = \"10 mm\"\nmaterial = \"steel\"\n"), "no bodies lead from joint P to joint P"},
      {element("beam = [\"P\"]\ndiameter = \"10 mm\"\nmaterial = \"steel\"\n"), "joints at the ends of a beam"},
      {element("rail = [\"R\", \"P\"]\ndiameter = \"10 mm\"\nmaterial = \"steel\"\n"), "joint R is no slide with an actuator"},
      {element("rail = [\"P\", \"R\"]\ndiameter = \"10 mm\"\noffset = \"-5 mm\"\nmaterial = \"steel\"\n"), "for offset, seen -5 mm"},
      {element("joint = \"R\"\naxial = \"1 N/um\"\nstiff = 3\n"), "unknown key \"stiff\""},
      {element("joint = \"R\"\naxial = \"1 N/um\"\n") + element("joint = \"P\"\nradial = \"1 N/um\"\n"),
       "two elements are called \"part\""},
      {"[[element]]\nname = \"a b\"\njoint = \"R\"\naxial = \"1 N/um\"\n", "letters, digits and underscores"},
      {"[elasticity]\nrigid = [\"legs\"]\n", "expected \"beams\", \"rails\", \"drives\" or \"bearings\", seen \"legs\""},
      {"[elasticity]\nbending = \"some\"\n", "expected \"none\", \"couples\" or \"full\", seen \"some\""},
      {"[elasticity]\nwarmer = \"20 s\"\n", "expected a plain number"},
      {"[elasticity]\nbase_compliance = [[1, 2], [3, 4]]\n", "rows of six numbers"},
      {"[elasticity]\nbase_compliance = [[0,1e-6,0,0,0,0],[0,0,0,0,0,0],[0,0,0,0,0,0],[0,0,0,0,0,0],[0,0,0,0,0,0],[0,0,0,0,0,0]]\n",
       "expected a symmetric matrix"},
      {"[elasticity]\nbase_compliance = "
       "[[1e-6,2e-6,0,0,0,0],[2e-6,1e-6,0,0,0,0],[0,0,0,0,0,0],[0,0,0,0,0,0],[0,0,0,0,0,0],[0,0,0,0,0,0]]\n",
       "has negative energy"},
      {"[elasticity]\nmisfit = { nothing = \"1 um\" }\n", "unknown key \"nothing\""},
      {"[drive]\nstiffness = \"1 N/um\"\n", "linear and rotary actuators have stiffnesses of different units"},
      {"[drive.q]\nstiffness = \"-1 N/um\"\n", "for stiffness, seen -1 N/um"},
  };
  for (const Case& c : cases) {
    CAPTURE(c.more);
    CHECK_THAT(told_of_elasticity(c.more), Contains(c.expected));
  }
}

TEST_CASE("what the section itself cannot take is told") {
  CHECK_THAT(told_of_elasticity("tool = [\"1 mm\", \"2 mm\"]\n"), Contains("lengths, x y z in the platform's axes"));
  CHECK_THAT(told_of_elasticity("axes = \"world\"\n"), Contains("expected \"base\" or \"platform\""));
  CHECK_THAT(told_of_elasticity("times = [\"9 s\"]\n"), Contains("9 s"));
  CHECK_THAT(told_of_elasticity("map = { x = [\"-10 mm\", \"10 mm\"], phi = [\"-1 deg\", \"1 deg\"], show = [\"pG_max\"] }\n"),
             Contains("pG_max"));
}
