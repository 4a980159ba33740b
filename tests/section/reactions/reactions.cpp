// Section `reactions` on a gantry whose reactions can be worked out by hand, and on the stage, where all of them are unique.
#include <reports/section/checks.hpp>
#include <reports/section/reactions/reactions.hpp>

#include <tests/scenario/trial.hpp>
#include <tests/section/gantry.hpp>
#include <tests/section/reactions/reactions_of.hpp>

#include <cmath>
#include <numbers>

using namespace pmreport;
using analysis::ColumnId;
using Catch::Matchers::Contains;

namespace {

const std::string asked = "[[section]]\nkind = \"reactions\"\n";
const std::string pushed = "[load]\nforce = [\"0 N\", \"7 N\", \"0 N\"]\n" + asked;

struct OnStage {  // at rest
  explicit OnStage(const std::string& more)
      : loaded(scenario::load_text(trial::with("20 mm * sin(2*pi*t/10 s)", "0 mm") + more, "a.toml", stage::source(), section::kinds())),
        analysis(loaded.scenario, loaded.trajectory, *loaded.machine, analysis::asked_by(loaded.scenario), {}) {}
  scenario::Loaded loaded;
  section::Analysis analysis;
};

using report_words::row_of;

}  // namespace

TEST_CASE("what the joints of an open chain carry is the load, and all of it is unique") {
  // The table is at its own load's point: rail and pin carry the force but for what the drives take, the one along X, the other about Z.
  const OnStage r("[load]\nforce = [\"3 N\", \"4 N\", \"0 N\"]\nmoment = [\"0 N*m\", \"0 N*m\", \"6 N*m\"]\n" + asked);
  const section::Result out = reactions_of(r.analysis);
  CHECK_THAT(gantry::text_of(out.section), Contains("All 10 components that the joints transmit are unique"));
  CHECK(gantry::value(out, "indeterminate") == 0);
  CHECK(gantry::value(out, "self_stresses") == 0);
  CHECK(gantry::value(out, "peak_force") == Approx(5));   // the pin: (3, 4) N
  CHECK(gantry::value(out, "peak_moment") == Approx(6));  // the rail
  const auto rail = row_of(out.section, "What the bearings carry", "P"), pin = row_of(out.section, "What the bearings carry", "R");
  CHECK(rail == std::vector<std::string>{"P", "prismatic", "base → carriage", "4", "0 s", "4", "6", "0 s", "6", "unique"});
  CHECK(pin == std::vector<std::string>{"R", "revolute", "carriage → table", "5", "0 s", "5", "0", "–", "0", "unique"});
  gantry::check_proofs(out.section, 3, 1);  // a chain has no limbs to compare
}

TEST_CASE("a picture tells where, when and to what scale the joints carry their largest forces") {
  const OnStage r("[load]\nforce = [\"3 N * t/2 s\", \"4 N * t/2 s\", \"0 N\"]\n" + asked);
  const section::Result out = reactions_of(r.analysis);
  const document::Gallery* gallery = nullptr;
  for (const document::Block& b : out.section.blocks)
    if (const auto* g = std::get_if<document::Gallery>(&b)) gallery = g;
  REQUIRE(gallery != nullptr);
  REQUIRE(gallery->pictures.size() == 1);
  const document::Picture& picture = gallery->pictures.front();
  CHECK_THAT(picture.caption, Contains("at t = 2 s, where joint R carries the largest of all") && Contains("the longest arrow 5 N"));
  CHECK_THAT(picture.caption, !Contains("least-norm"));
  // The drawing says the same: the pin has 5 N, the rail 4, and the load is drawn beside them.
  CHECK_THAT(picture.svg, Contains("R 5 N") && Contains("P 4 N") && Contains("load 5 N"));
}

TEST_CASE("where no joint carries a force there is no picture of forces") {
  const OnStage r(asked);
  const section::Result out = reactions_of(r.analysis);
  CHECK_THAT(gantry::text_of(out.section), Contains("All 10 components that the joints transmit are unique"));
  for (const document::Block& b : out.section.blocks) CHECK(!std::holds_alternative<document::Gallery>(b));
}

TEST_CASE("the cone of a force that swings by twenty degrees either way has this half-angle") {
  const OnStage r("[load]\nforce = [\"-10 N * cos(20 deg * sin(2*pi*t/2 s))\", \"-10 N * sin(20 deg * sin(2*pi*t/2 s))\", \"0 N\"]\n" +
                  asked);
  const section::JointLoad pin = section::joint_loads(r.analysis)[1];
  // Axis 1 of the pin is Z; 2, carried by the carriage, is X.
  CHECK((pin.direction - Eigen::Vector3d(0, 1, 0)).norm() < 1e-12);
  CHECK(pin.cone == Approx(20 * std::numbers::pi / 180));
  CHECK_FALSE(pin.reverses);
}

TEST_CASE("a force that reverses is told by the line that it keeps to") {
  const OnStage r("[load]\nforce = [\"10 N * cos(2*pi*t/2 s)\", \"1 N * cos(2*pi*t/2 s)\", \"0 N\"]\n" + asked);
  const section::JointLoad pin = section::joint_loads(r.analysis)[1];
  CHECK(pin.reverses);
  CHECK(std::abs(pin.direction.dot(Eigen::Vector3d(0, 10, 1).normalized())) == Approx(1));
  CHECK(pin.cone == Approx(0).margin(1e-6));  // an angle by its cosine keeps half the digits, by its chord more
  const auto row = row_of(reactions_of(r.analysis).section, "Where the forces point", "R");
  CHECK(row.back().starts_with("± "));
}

TEST_CASE("self-stresses are counted, and what they reach is marked and never called unique") {
  const gantry::Run r(pushed);
  const section::Result out = reactions_of(r.analysis);
  const std::string text = gantry::text_of(out.section);
  // Of five components in each of three joints, the forces along X of the hinge and the couples about Z of the rails are unique.
  CHECK_THAT(text, Contains("Of the 15 components that the joints transmit, 3 are unique") && Contains("The other 12 are indeterminate") &&
                       Contains("in 4 ways more than needed"));
  CHECK(gantry::value(out, "indeterminate") == 12);
  CHECK(gantry::value(out, "self_stresses") == 4);
  CHECK(row_of(out.section, "What the bearings carry", "P1").back() == "† F₂ F₃ M₁ M₂");
  CHECK(row_of(out.section, "What the bearings carry", "R").back() == "† F₁ F₃ M₂ M₃");  // axes 1, 2, 3 are Z, X, Y
  gantry::check_proofs(out.section, 4, 1);
}

TEST_CASE("a self-stress names the loop that has it") {
  const gantry::Run r(pushed);
  const document::Section s = reactions_of(r.analysis).section;
  int stresses = 0;
  for (const document::Block& b : s.blocks)
    if (const auto* t = std::get_if<document::Table>(&b); t != nullptr && t->caption.starts_with("Self-stresses"))
      for (const auto& row : t->rows) {
        CHECK(row.back() == (stresses == 0 ? "base – P1 – platform – R – trolley – P2 – base: 4 redundant" : "the same"));
        ++stresses;
      }
  CHECK(stresses == 4);
}

TEST_CASE("what is shown of a shared force is the least-norm share of it") {
  // 7 N go through P1, or through R and then P2: a in the one, b in the two, a + b = 7, a^2 + 2 b^2 least: a = 14/3, b = 7/3.
  const gantry::Run r(pushed);
  for (const int k : {0, 3, 20}) {
    CHECK(r.analysis.column(ColumnId::named("P1_force_y"))[static_cast<std::size_t>(k)] == Approx(-14.0 / 3));
    CHECK(r.analysis.column(ColumnId::named("R_force_y"))[static_cast<std::size_t>(k)] == Approx(-7.0 / 3));
    CHECK(r.analysis.column(ColumnId::named("limb1_force_y"))[static_cast<std::size_t>(k)] == Approx(-7.0 / 3));
  }
}

TEST_CASE("a unique component beside indeterminate ones is that of Newton") {
  const gantry::Run r(pushed);  // the platform pulls the trolley along, whose reaction holds it back
  for (std::size_t k = 0; k < 21; ++k) {
    const double w = std::numbers::pi, acceleration = -0.05 * w * w * std::sin(w * r.analysis.time()[k]);
    CHECK(r.analysis.column(ColumnId::named("R_force_x"))[k] == Approx(-gantry::trolley_mass * acceleration).margin(1e-13));
  }
}

TEST_CASE("only the joints that a scenario chooses are drawn, least-norm ones with their mark") {
  const gantry::Run r(pushed);
  section::ReactionsOptions request;
  request.joints = {2};
  const section::Result out = reactions_of(r.analysis, request);
  const auto figures = report_words::pointers<figure::Figure>(out.section);
  REQUIRE(figures.size() >= 2);
  REQUIRE(figures[0]->panels.size() == 1);
  REQUIRE(figures[0]->panels[0].series.size() == 1);
  CHECK(figures[0]->panels[0].series[0].label == "R†");
  CHECK_THAT(figures[0]->caption, Contains("least-norm"));
}

TEST_CASE("a joint force above its limit is told in its section and breaks the gate of every report") {
  const OnStage r("[load]\nforce = [\"0 N\", \"10 N * t / 1 s\", \"0 N\"]\n[limits]\njoint_force = { R = \"12.5 N\" }\n" + asked);
  const std::string sentence = "t = 1.3 s to 2 s: force in joint R is 20 N, the limit is 12.5 N (worst at t = 2 s, 8 samples).";
  CHECK_THAT(gantry::text_of(reactions_of(r.analysis).section), Contains(sentence));
  int gates = 0;
  for (const document::Check& c : section::evaluate_checks(r.analysis, {}))
    if (c.name == "limits of forces, speeds, powers and reactions are kept") {
      ++gates;
      CHECK_FALSE(c.passed);
      CHECK(c.measured == "at 13 of 21 samples");
      CHECK(c.message == sentence);
    }
  CHECK(gates == 1);
}

TEST_CASE("a joint force that just meets its limit keeps it") {
  const OnStage r("[load]\nforce = [\"0 N\", \"10 N * t / 1 s\", \"0 N\"]\n[limits]\njoint_force = { R = \"20 N\" }\n" + asked);
  for (const document::Check& c : section::evaluate_checks(r.analysis, {})) CHECK(c.passed);
}
