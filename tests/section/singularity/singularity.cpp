// Sections `mobility` and `singularity`, and what a run says of singular surfaces. The mechanism is a leg that pushes a sleigh along a
// rail: with the leg across the rail, at x = 0, the sleigh is free.
#include <catch2/catch.hpp>

#include <reports/section/common/words/singular_words.hpp>
#include <reports/section/common/words/words.hpp>
#include <reports/section/kinds.hpp>
#include <reports/section/mobility/mobility.hpp>
#include <reports/section/singularity/singularity.hpp>
#include <tests/given/only.hpp>
#include <tests/scenario/trial.hpp>
#include <tests/section/report_words.hpp>

#include <algorithm>
#include <cmath>

using namespace pmreport;

namespace {

// Sleigh on a rail along X; a leg from A (0, 0, h) to its middle, hinged at both ends about Y, whose length drives it:
// l^2 = x^2 + h^2, l' = x / l x', so that G is singular at x = 0 and there alone.
class Sleigh : public Mechanism<1> {
 public:
  static constexpr const char *name = "sleigh", *title = "sleigh", *source = "this test";
  static constexpr std::array<Parameter, 0> parameters{};
  explicit Sleigh(const Parameters&) {}
  Topology topology() const {
    Topology t;
    t.coordinates = {{"x", "place on the rail", "m", 0.1, {-0.2, 0.2}}};
    t.platform = t.add(Body{"sleigh", 0, false, {}});
    t.add(Body{"cylinder", 1, false, {}});
    t.add(Body{"piston", 1, false, {}});
    t.add(Joint{"G", JointKind::prismatic, 0, 1, {}});
    t.add(Joint{"A", JointKind::revolute, 0, 2, {}});
    t.add(Joint{"P", JointKind::prismatic, 2, 3, {}});
    t.add(Joint{"B", JointKind::revolute, 3, 1, {}});
    t.add(Actuator{"l", "length of the leg", "m", 2, {0, 1}});
    for (const char* n : {"force_y", "force_z"}) t.constraints.push_back({n, "", "N"});
    for (const char* n : {"couple_x", "couple_y", "couple_z"}) t.constraints.push_back({n, "", "N*m"});
    return t;
  }
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> b(q[0], T(0.0), T(0.0)), a = Eigen::Vector3d(0, 0, 0.3).cast<T>(), y = Eigen::Vector3d::UnitY().cast<T>();
    const Vector3<T> n = unit(Vector3<T>(b - a));
    at.body(1, b, Matrix3<T>(Matrix3<T>::Identity()));
    at.body(2, a, frame_xz(y, n));
    at.body(3, b, frame_xz(y, n));
    at.joint(0, b, Eigen::Vector3d::UnitX().cast<T>());
    at.joint(1, a, y);
    at.joint(2, b, n);
    at.joint(3, b, y);
    at.actuator(0, length(Vector3<T>(b - a)));
  }
  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    Matrix6<T> g = Matrix6<T>::Constant(T(0.0));
    const Vector3<T> n = at.axis(2);
    for (int k = 0; k < 3; ++k) g(0, k) = n(k);
    for (int k = 1; k < 6; ++k) g(k, k) = T(1.0);
    return g;
  }
};

scenario::MechanismSource source() { return test::only<Sleigh>(); }

struct Run {
  explicit Run(const std::string& x, const std::string& more = "")
      : loaded(scenario::load_text("title = \"Sleigh\"\n[mechanism]\nuse = \"sleigh\"\n[motion]\nduration = \"2 s\"\nsamples = 11\n" +
                                       more + "x = \"" + x + "\"\n[[section]]\nkind = \"velocity\"\n",
                                   "a.toml", source(), section::kinds())),
        analysis(loaded.scenario, loaded.trajectory, *loaded.machine, analysis::asked_by(loaded.scenario), {}) {}
  section::Result singularity(const section::SingularityOptions& r) {
    scene::Studio studio;
    return section::singularity_section(analysis, r, section::Stage(analysis, studio), {});
  }
  scenario::Loaded loaded;
  section::Analysis analysis;
};

using Catch::Matchers::Contains;
using report_words::check_proofs, report_words::text_of, report_words::value;

}  // namespace

TEST_CASE("a crossing between two samples is found in time to the last digits") {
  const Run r("60 mm - 100 mm * (t / 1 s)^2");  // zero at sqrt(0.6) s; samples every 0.2 s
  REQUIRE(r.analysis.crossings().size() == 1);
  const section::Crossing& c = r.analysis.crossings()[0];
  CHECK(c.before == 3);
  CHECK(std::abs(c.time - std::sqrt(0.6)) < 1e-15 * 4);  // 0.1 m/s: a rounding of the position is one of the time
  CHECK(std::abs(c.coordinates(0)) < 1e-15);
  CHECK_FALSE(c.touches);
  const auto told = section::singularity_sentences(r.analysis);
  REQUIRE(told.size() == 1);
  CHECK_THAT(told[0], Contains("Between t = 0.6 s and t = 0.8 s the motion crosses a singular surface") && Contains("0.7745967 s"));
}

TEST_CASE("a surface that is met at a sample itself is crossed there, or touched there, and not between samples") {
  const Run crossed("100 mm * (t / 1 s - 1)");
  REQUIRE(crossed.analysis.crossings().size() == 1);
  const section::Crossing& c = crossed.analysis.crossings()[0];
  CHECK(c.time == 1);
  CHECK(c.before == 5);
  CHECK_FALSE(c.touches);
  CHECK_FALSE(c.lasts());
  REQUIRE(section::singularity_sentences(crossed.analysis).size() == 1);  // not the sample once more
  CHECK_THAT(section::singularity_sentences(crossed.analysis)[0], Contains("At the sample t = 1 s the motion crosses a singular surface"));
  CHECK(section::singularities_met(crossed.analysis) == 1);

  const Run touched("100 mm * (t / 1 s - 1)^2");
  REQUIRE(touched.analysis.crossings().size() == 1);
  CHECK(touched.analysis.crossings()[0].time == 1);
  CHECK(touched.analysis.crossings()[0].touches);
}

TEST_CASE("a motion that may last until a singular surface keeps the last sample before one that is on it, and speaks of no one side") {
  Run r("100 mm * (1 - t / 1 s)", "until = \"singularity\"\n");
  REQUIRE(r.analysis.samples() == 5);
  CHECK(r.analysis.time().back() == Approx(0.8));
  CHECK_THAT(r.analysis.trajectory().ending, Contains("meets a singular surface at t = 1 s"));
  CHECK(r.analysis.crossings().empty());
  CHECK(section::singularities_met(r.analysis) == 0);
  const section::Result out = r.singularity({});
  CHECK_THAT(text_of(out.section), !Contains("stays on one side") && Contains("meets a singular surface at t = 1 s"));
}

TEST_CASE("a motion that stays on a singular surface is told with when it comes and when it leaves") {
  const Run r("max(0 mm, 100 mm * (t / 1 s - 1))");
  REQUIRE(r.analysis.crossings().size() == 1);
  const section::Crossing& c = r.analysis.crossings()[0];
  CHECK(c.time == 0);
  CHECK(c.until == 1);
  CHECK_THAT(section::singularity_sentences(r.analysis)[0], Contains("From t = 0 s to t = 1 s the motion stays on a singular surface"));
}

TEST_CASE("a surface crossed and left again between two samples is found twice") {
  // Below zero from 1.05 s to 1.15 s only: no sample is there.
  const Run r("200 mm * ((t / 1 s) - 1.05) * ((t / 1 s) - 1.15)");
  REQUIRE(r.analysis.crossings().size() == 2);
  CHECK(r.analysis.crossings()[0].time == Approx(1.05).epsilon(1e-12));
  CHECK(r.analysis.crossings()[1].time == Approx(1.15).epsilon(1e-12));
}

TEST_CASE("a surface touched between two samples is told, one that is only approached is not") {
  const Run touched("200 mm * ((t / 1 s) - 1.1)^2");
  REQUIRE(touched.analysis.crossings().size() == 1);
  CHECK(touched.analysis.crossings()[0].touches);
  CHECK(touched.analysis.crossings()[0].time == Approx(1.1).epsilon(1e-6));  // a square's minimum shows half the digits
  CHECK_THAT(section::singularity_sentences(touched.analysis)[0], Contains("touches"));
  CHECK(Run("1 mm + 200 mm * ((t / 1 s) - 1.1)^2").analysis.crossings().empty());
}

TEST_CASE("the section tells a crossing with its type and how the platform escapes") {
  Run r("60 mm - 100 mm * (t / 1 s)^2");
  const section::Result out = r.singularity({});
  const std::string text = text_of(out.section);
  CHECK_THAT(text, Contains("Between t = 0.6 s and t = 0.8 s the motion crosses a singular surface: det G changes its sign at t = "
                            "0.7745967 s") &&
                       Contains("type 2, direct"));
  CHECK_THAT(text, Contains("with all actuators locked the platform can move along X without turning"));
  CHECK(value(out, "crossings") == 1);
  CHECK(value(out, "smallest_singular_value") < 1e-12);
  CHECK(value(out, "line_rank") == 1);
  CHECK(value(out, "wrench_rank") == 5);
  check_proofs(out.section);
  // The leg's slope is G's only entry that changes: det G^ = x / l.
  const auto& d = out.data.at(0);
  REQUIRE(d.headings.at(1) == "determinant");
  for (std::size_t k = 0; k < d.columns[0].size(); ++k) {
    const double t = d.columns[0][k], x = 0.06 - 0.1 * t * t;
    CHECK(d.columns[1][k] == Approx(x / std::hypot(x, 0.3)).margin(1e-14));
  }
}

TEST_CASE("a regular motion is told with its margin and its worst time") {
  Run r("60 mm + 50 mm * t / 1 s");
  const section::Result out = r.singularity({});
  CHECK_THAT(text_of(out.section), Contains("stays on one side of every singular surface") && Contains("least at t = 0 s"));
  CHECK(value(out, "crossings") == 0);
  CHECK(value(out, "wrench_rank") == 6);
  check_proofs(out.section);
}

TEST_CASE("poses given by rounded numbers are judged on the surface that they mean") {
  Run r("60 mm");
  section::SingularityOptions request;
  request.poses = {Eigen::VectorXd::Constant(1, 2e-6), Eigen::VectorXd::Constant(1, 0.02)};
  const section::Result out = r.singularity(request);
  CHECK(value(out, "wrench_rank_1") == 5);
  CHECK(value(out, "wrench_rank_2") == 6);
  CHECK_THAT(text_of(out.section), Contains("pose 1 is given by rounded numbers"));
  CHECK_THAT(text_of(out.section), !Contains("pose 2 is given by rounded numbers"));
}

TEST_CASE("mobility of a planar sleigh: one translation, and the constraints that its plane makes redundant") {
  const Run r("60 mm");
  const section::Result out = section::mobility_section(r.analysis, {});
  CHECK(value(out, "freedoms") == 1);
  CHECK(value(out, "translations") == 1);
  CHECK(value(out, "rotations") == 0);
  CHECK(value(out, "gruebler") == -2);
  CHECK(value(out, "redundant") == 3);
  const std::string text = text_of(out.section);
  CHECK_THAT(text, Contains("1T. The 20 constraints that the joints impose have rank 17 at home and at 100 of 100 random poses"));
  CHECK_THAT(text, Contains("M = 6 (n − g − 1) + Σf − ζ + ν = 6 (4 − 4 − 1) + 4 − 0 + 3 = 1"));
  CHECK_THAT(text, Contains("translates, without turning, along X; it does not turn"));
  CHECK_THAT(text, Contains("a couple about X, the same at every joint of the loop"));
  check_proofs(out.section);
}
