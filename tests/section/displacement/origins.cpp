// A report says what the motions of its joints count from. The mechanism: a carriage 1 m above the base, driven along X, and a telescopic
// leg that follows it between two balls, A on the base, counted from Z, and B, counted from home, where the leg stands upright.
#include <pmreport/mechanism.hpp>
#include <tests/given/only.hpp>
#include <tests/section/report_words.hpp>
#include <tests/section/whole_report.hpp>

#include <catch2/catch.hpp>

#include <algorithm>

using namespace pmreport;
using namespace whole_report;
using Catch::Contains;

namespace {

class Follower : public Mechanism<1> {
 public:
  static constexpr const char *name = "follower", *title = "follower", *source = "made for the tests";
  static constexpr std::array<Parameter, 0> parameters{};
  explicit Follower(const Parameters&) {}
  Topology topology() const {
    Topology t;
    t.coordinates = {{"x", "place of the carriage", "m", 0, {-0.5, 0.5}}};
    t.platform = t.add(Body{"carriage", 0, false, {}});
    t.add(Body{"lower", 1, true, {}});
    t.add(Body{"upper", 1, true, {}});
    t.add(Joint{"P", JointKind::prismatic, 0, 1, {}});
    t.add(Joint{"A", JointKind::spherical, 0, 2, {{0, 0.5}}, 2, {0, 0, 3}});
    t.add(Joint{"T", JointKind::prismatic, 2, 3, {}});
    t.add(Joint{"B", JointKind::spherical, 3, 1, {{0, 1}}, 3});
    t.add(Actuator{"q", "drive", "m", 0, {-1, 1}});
    for (const char* n : {"force_y", "force_z"}) t.constraints.push_back({n, "", "N"});
    for (const char* n : {"couple_x", "couple_y", "couple_z"}) t.constraints.push_back({n, "", "N*m"});
    t.idle = 1;
    return t;
  }
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> here(q[0], T(0.0), T(1.0)), foot = Vector3<T>::Zero(), along = unit(here);
    at.body(1, here, Matrix3<T>(Matrix3<T>::Identity()));
    at.slender(2, foot, along);
    at.slender(3, here, along);
    at.joint(0, here, Eigen::Vector3d::UnitX().cast<T>());
    at.joint(1, foot);
    at.joint(2, here, along);
    at.joint(3, here);
    at.actuator(0, q[0]);
  }
  template <class T>
  Matrix6<T> jacobian(const Placement<T>&) const {
    return Matrix6<T>::Identity();
  }
};

document::Report report() {
  return report_of(
      "title = \"Follower\"\n[mechanism]\nuse = \"follower\"\n[motion]\nduration = \"1 s\"\nsamples = 11\nx = \"1 m * t / 1 s\"\n" +
          asking_for({"mechanism", "displacement"}),
      test::only<Follower>());
}

}  // namespace

TEST_CASE("tables and figures tell from what directions balls are counted") {
  const document::Report r = report();
  CHECK(report_words::table_of(section_of(r, "mechanism"), "Joints").caption ==
        "Joints. Deflections and rotations count from home; those of A from axis z of base.");
  const document::Section& s = section_of(r, "displacement");
  CHECK(report_words::row_of(s, "Extremes", "A_deflection").at(1) == "deflection of joint A from axis z of base");
  CHECK(report_words::row_of(s, "Extremes", "B_deflection").at(1) == "deflection of joint B from home");
  const auto figures = report_words::pointers<figure::Figure>(s);
  REQUIRE(figures.size() == 1);
  CHECK_THAT(figures[0]->caption, Contains("Joints count from home; those of A from axis z of base."));
  CHECK(panel_of(s, "joints").y.label == "motion");  // of two origins
}

TEST_CASE("a limit that counts from a direction is broken from there") {
  // 0.5 rad are broken from x = 1 m tan 0.5 = 0.546 m on, of the samples from 0.6 s on; at the end x = 1 m the leg leans by 45 degrees.
  const document::Report r = report();
  CHECK_THAT(report_words::text_of(section_of(r, "displacement")),
             Contains("joint A (from axis z of base) needs 45°, its limit is 28.6") && Contains("5 samples"));
}
