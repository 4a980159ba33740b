// Section `assembly` on a lever whose modes are known: a leg of length l from A, at distance d from the lever's hinge O, to its tip, at
// distance r, fits the lever at theta and at -theta, l^2 = r^2 + d^2 - 2 r d cos(theta), and at no other angle.
#include <catch2/catch.hpp>

#include <reports/section/assembly/assembly.hpp>
#include <tests/section/gantry.hpp>

#include <cmath>
#include <numbers>

using namespace pmreport;
using Catch::Matchers::Contains;
using report_words::table_of;

namespace {

constexpr double reach = 0.2, away = 0.3;  // r, d [m]
// The platform's joints are O, at its reference point, and B, at the tip.
constexpr double size = reach / 2;

class Lever : public Mechanism<1> {
 public:
  static constexpr const char *name = "lever", *title = "lever", *source = "this test";
  static constexpr std::array<Parameter, 0> parameters{};
  explicit Lever(const Parameters&) {}
  Topology topology() const {
    constexpr double deg = std::numbers::pi / 180;
    Topology t;
    t.coordinates = {{"theta", "angle of the lever", "rad", 0.7, {-1, 1}}};
    t.platform = t.add(Body{"lever", 0, false, {}});
    t.add(Body{"cylinder", 1, false, {}});
    t.add(Body{"piston", 1, false, {}});
    t.add(Joint{"O", JointKind::revolute, 0, 1, {{-60 * deg, 60 * deg}}});  // from home, 40.1 degrees: the other mode lies outside
    t.add(Joint{"A", JointKind::revolute, 0, 2, {}});
    t.add(Joint{"P", JointKind::prismatic, 2, 3, {}});
    t.add(Joint{"B", JointKind::revolute, 3, 1, {}});
    t.add(Actuator{"l", "length of the leg", "m", 2, {0, 1}});
    for (const char* n : {"force_x", "force_y", "force_z"}) t.constraints.push_back({n, "", "N"});
    for (const char* n : {"couple_x", "couple_y"}) t.constraints.push_back({n, "", "N*m"});
    return t;
  }
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> o = Eigen::Vector3d::Zero().cast<T>(), a = Eigen::Vector3d(away, 0, 0).cast<T>(),
                     z = Eigen::Vector3d::UnitZ().cast<T>();
    const Vector3<T> along(cos(q[0]), sin(q[0]), T(0.0)), b = along * T(reach), n = unit(Vector3<T>(b - a));
    at.body(1, o, frame_xz(along, z));
    at.body(2, a, frame_xz(n, z));
    at.body(3, b, frame_xz(n, z));
    at.joint(0, o, z);
    at.joint(1, a, z);
    at.joint(2, b, n);
    at.joint(3, b, z);
    at.actuator(0, pmreport::length(Vector3<T>(b - a)));
  }
  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    Matrix6<T> g = Matrix6<T>::Zero();
    force_row<T>(g, 0, at.axis(2), at.centre(3));
    for (int k = 0; k < 5; ++k) g(k + 1, k) = T(1.0);
    return g;
  }
};

scenario::MechanismSource source() { return test::only<Lever>(); }

// From 40 degrees up to 50, down to 30 at 1.5 s, and back.
struct Run {
  Run()
      : loaded(scenario::load_text("title = \"Lever\"\n[mechanism]\nuse = \"lever\"\n[motion]\nduration = \"2 s\"\nsamples = 21\n"
                                   "theta = \"40 deg + 10 deg * sin(2*pi*t/2 s)\"\n[[section]]\nkind = \"assembly\"\n",
                                   "a.toml", source(), section::kinds())),
        analysis(loaded.scenario, loaded.trajectory, *loaded.machine, analysis::asked_by(loaded.scenario), {}) {}
  section::Result assembly(const section::AssemblyOptions& request) {
    scene::Studio studio;
    return section::assembly_section(analysis, request, section::Stage(analysis, studio), {});
  }
  scenario::Loaded loaded;
  section::Analysis analysis;
};

}  // namespace

TEST_CASE("a lever on a leg has two assembly modes, and the section tells both") {
  Run run;
  const section::Result r = run.assembly({});
  CHECK(gantry::value(r, "modes") == 2);
  CHECK(gantry::value(r, "own_working_mode") == 2);
  const document::Table& t = table_of(r.section);
  REQUIRE(t.rows.size() == 2);
  // Mark, number, theta [deg], sign of det G, distance [mm], limits. The leg pushes against the lever the other way on the other side.
  CHECK(t.rows[0][0] == "•");
  CHECK(t.rows[0][2] == "40.00");
  CHECK(t.rows[0].back() == "kept");
  CHECK(t.rows[1][0].empty());
  CHECK(t.rows[1][2] == "−40.00");
  CHECK(t.rows[0][3] != t.rows[1][3]);
  CHECK(std::stod(t.rows[1][4]) == Approx(1000 * size * 80 * std::numbers::pi / 180).margin(0.006));  // shown to 0.01 mm
  CHECK(t.rows[1].back() == "broken");
  CHECK_THAT(gantry::text_of(r.section), Contains("2 real assembly modes; 1 of them is within all strokes and joint limits"));
}

TEST_CASE("the pictures are those of the modes, and their captions tell them apart") {
  Run run;
  const section::Result r = run.assembly({});
  for (const document::Block& b : r.section.blocks)
    if (const auto* g = std::get_if<document::Gallery>(&b)) {
      REQUIRE(g->pictures.size() == 2);
      CHECK_THAT(g->pictures[0].caption, Contains("the present one"));
      CHECK_THAT(g->pictures[1].caption, Contains("away"));
      CHECK(g->pictures[0].png.starts_with("\x89PNG"));
      CHECK(g->pictures[0].png != g->pictures[1].png);
      return;
    }
  FAIL("no pictures");
}

TEST_CASE("along the motion the other mode comes nearest where the lever is lowest") {
  Run run;
  const section::Result r = run.assembly({});
  CHECK(gantry::value(r, "nearest") == Approx(size * 60 * std::numbers::pi / 180));
  CHECK_THAT(gantry::text_of(r.section), Contains("mode 2 comes nearest to the pose of the mechanism") && Contains("at t = 1.5 s"));
  const document::Data& d = r.data.at(0);
  REQUIRE(d.headings.at(2) == "mode_2_distance [m]");
  for (std::size_t k = 0; k < 21; ++k) {
    const double theta = (40 + 10 * std::sin(std::numbers::pi * d.columns[0][k])) * std::numbers::pi / 180;
    CHECK(d.columns[2][k] == Approx(size * 2 * theta));
  }
  gantry::check_proofs(r.section, 5);  // the motion is closed: as many modes at both ends
  CHECK_THAT(gantry::text_of(r.section), Contains("The motion has 2 assembly modes at all of its samples"));
}

TEST_CASE("whether the joints allow poses beyond the coordinates is told, with how hard it was tried") {
  Run run;
  const section::Result r = run.assembly({});
  CHECK_THAT(gantry::text_of(r.section), Contains("the poses that the 1 coordinate and the working modes of the mechanism express") &&
                                             Contains("always in a pose that those express"));
  CHECK(gantry::value(r, "further") == 0);
}

TEST_CASE("values given for the actuators are used instead of the motion's") {
  Run run;
  section::AssemblyOptions request;
  request.actuators = Eigen::VectorXd::Constant(1, std::sqrt(reach * reach + away * away - 2 * reach * away * std::cos(0.5)));
  const section::Result r = run.assembly(request);
  REQUIRE(table_of(r.section).rows.size() == 2);
  CHECK(table_of(r.section).rows[0][2] == "28.65");  // 0.5 rad
  CHECK(table_of(r.section).rows[1][2] == "−28.65");
  CHECK(r.data.empty());
  gantry::check_proofs(r.section, 3);
}

TEST_CASE("a leg too short for any pose has no mode") {
  Run run;
  section::AssemblyOptions request;
  request.actuators = Eigen::VectorXd::Constant(1, 0.05);  // less than d - r
  const section::Result r = run.assembly(request);
  CHECK(gantry::value(r, "modes") == 0);
  CHECK_THAT(gantry::text_of(r.section), Contains("0 real assembly modes"));
}
