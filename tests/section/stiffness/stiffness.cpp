// Section `stiffness`, and reactions that elasticity settles, on a carriage on two rails whose every number can be worked out by hand.
#include <reports/scene/studio.hpp>
#include <reports/section/stiffness/stiffness.hpp>

#include <tests/section/gantry.hpp>
#include <tests/section/reactions/reactions_of.hpp>

#include <cmath>

using namespace pmreport;
using analysis::ColumnId;
using Catch::Matchers::Contains;

namespace {

const std::string reactions = "[[section]]\nkind = \"reactions\"\n", stiffness = "[[section]]\nkind = \"stiffness\"\n";
// Rail P1, the driven one, and rail P2 beside it give way across their slides; P2 three times as stiff.
const std::string across =
    "[[element]]\nname = \"first\"\njoint = \"P1\"\nradial = \"100 N/um\"\n"
    "[[element]]\nname = \"second\"\njoint = \"P2\"\nradial = \"300 N/um\"\n";
const std::string turning =
    "[[element]]\nname = \"first\"\njoint = \"P1\"\nradial = \"100 N/um\"\ntwisting = \"1000 N*m/rad\"\ntilting = \"2000 N*m/rad\"\n"
    "[[element]]\nname = \"second\"\njoint = \"P2\"\nradial = \"300 N/um\"\ntwisting = \"4000 N*m/rad\"\ntilting = \"6000 N*m/rad\"\n";
const std::string pushed = "[load]\nforce = [\"0 N\", \"400 N\", \"0 N\"]\n";

section::Result told(const gantry::Run& r) {
  scene::Studio studio;
  const section::Stage stage(r.analysis, studio);
  const auto* request = analysis::stiffness_request(r.loaded.scenario);
  REQUIRE(request != nullptr);
  return section::stiffness_section(r.analysis, *request, stage, {});
}

double at(const gantry::Run& r, const std::string& column, std::size_t sample) {
  return r.analysis.column(ColumnId::named(column))[sample];
}

}  // namespace

// Least norm: P1 carries a, P2 and the hinge behind it b each, a + b given and a^2 + 2 b^2 least.
TEST_CASE("two rails share a load as they are stiff, where least norm would give the first two thirds") {
  const gantry::Run rigid(pushed + reactions), elastic(pushed + across + reactions);
  CHECK(at(rigid, "P1_force_y", 0) == Approx(-400 * 2 / 3.0));
  CHECK(at(elastic, "P1_force_y", 0) == Approx(-100).epsilon(1e-9));
  CHECK(at(elastic, "P2_force_y", 0) == Approx(-300).epsilon(1e-9));
}

TEST_CASE("reactions that elasticity settles are told as unique by it, with what least norm missed") {
  const gantry::Run r(pushed + turning + reactions);
  const section::Result out = reactions_of(r.analysis);
  CHECK(gantry::value(out, "indeterminate") == 0);
  CHECK(gantry::value(out, "by_elasticity") == 12);  // forces across and couples about X and Y of both rails; of the hinge, too
  CHECK(gantry::value(out, "self_stresses") == 4);
  CHECK_THAT(gantry::text_of(out.section),
             Contains("unique by elasticity") && Contains("misses the force in joint") && Contains("by 167 N"));
}

TEST_CASE("what no element settles stays indeterminate, and only that") {
  const gantry::Run r(pushed + across + reactions);
  const section::Result out = reactions_of(r.analysis);
  CHECK_THAT(gantry::text_of(out.section), Contains("2 self-stresses that no element gives energy leave"));
  CHECK(gantry::value(out, "indeterminate") > 0);
  CHECK(at(r, "P1_force_y", 0) == Approx(-100).epsilon(1e-9));
  CHECK((r.analysis.indeterminate()[0] & 7) == 0);   // forces of P1 are settled
  CHECK((r.analysis.indeterminate()[0] & 56) != 0);  // its moments are not
}

TEST_CASE("the platform gives way by the load over the stiffness of both rails") {
  const gantry::Run r(pushed + turning + stiffness);
  CHECK(at(r, "deflection_y", 0) == Approx(400 / 400e6).epsilon(1e-9));
  CHECK(at(r, "load_deflection", 0) == Approx(400 / 400e6).epsilon(1e-9));
  CHECK(at(r, "first_share", 0) == Approx(0.25).epsilon(1e-9));  // c q^2 of a quarter of the force on a quarter of the stiffness
  CHECK(at(r, "second_share", 0) == Approx(0.75).epsilon(1e-9));
  CHECK(at(r, "pF_max", 0) == Approx(1 / 400e6).epsilon(1e-9));
  CHECK(at(r, "PhiT_max", 0) == Approx(1 / 2000.0).epsilon(1e-9));  // about Z, where the hinge leaves the first rail alone
  // Both bodies swing across together, on both rails; about X and Y both, about Z, which the hinge and the drive's rail hold, the platform
  // alone.
  const double pi = std::acos(-1.0);
  CHECK(at(r, "frequency1", 0) == Approx(std::sqrt(2000 / 0.01) / (2 * pi)).epsilon(1e-9));
}

TEST_CASE("the section says what gives way, in how many directions, and proves it") {
  const gantry::Run r(pushed + turning + stiffness);
  const section::Result out = told(r);
  const std::string text = gantry::text_of(out.section);
  CHECK_THAT(text, Contains("Compliance at t = 0 s") && Contains("gives way in 5 of 6 directions"));
  CHECK_THAT(text, Contains("The elements settle 4 self-stresses"));
  CHECK(gantry::value(out, "largest_deflection") == Approx(1e-6).epsilon(1e-6));
  CHECK(gantry::value(out, "rank") == 5);
  CHECK(std::isnan(gantry::value(out, "least_buckling")));
  gantry::check_proofs(out.section, 3, 0);
}

TEST_CASE("a mechanism without elements is told to be rigid, and stiffness as not examined") {
  const gantry::Run r(pushed + stiffness);
  const section::Result out = told(r);
  CHECK_THAT(gantry::text_of(out.section), Contains("Nothing gives way"));
  REQUIRE(out.findings.size() == 1);
  CHECK_THAT(out.findings[0].text, Contains("stiffness was not examined") && Contains("[[element]]"));
  gantry::check_proofs(out.section, 1, 1);
}

TEST_CASE("a drive that yields moves the platform along its slide") {
  const gantry::Run r("[load]\nforce = [\"30 N\", \"0 N\", \"0 N\"]\n[drive]\nstiffness = \"10 N/um\"\n" + stiffness);
  // At the middle of the first swing nothing accelerates.
  CHECK(at(r, "deflection_x", 0) == Approx(30 / 10e6).epsilon(1e-9));
  // Elsewhere inertia of both bodies is in it: at the end of the swing x'' is -0.05 pi^2.
  const double pi = std::acos(-1.0), inertia = 0.05 * pi * pi * (gantry::platform_mass + gantry::trolley_mass);
  CHECK(at(r, "deflection_x", 5) == Approx((30 + inertia) / 10e6).epsilon(1e-9));
  CHECK(at(r, "inertia_deflection", 5) == Approx(inertia / 10e6).epsilon(1e-9));
  CHECK(at(r, "frequency1", 0) == Approx(std::sqrt(10e6 / (gantry::platform_mass + gantry::trolley_mass)) / (2 * pi)).epsilon(1e-9));
}
