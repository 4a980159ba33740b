// Rows of the overall Jacobian, homes and quantities that no rate tells of, each with the sentence that leads to it.
#include <tests/mechanics/conformance/tilt_table.hpp>

#include <core/mechanics/conformance/wrench_properties.hpp>

#include <set>

using namespace pmreport;
using namespace pmreport::test;
using Catch::Contains;
using Catch::StartsWith;

namespace {

std::vector<Property> properties(Mistake m, int poses = 50) {
  const With mistake(m);
  return check_properties(machine_of(m), {poses, 1});
}
const Property& property(const std::vector<Property>& all, const std::string& claim) {
  for (const Property& p : all)
    if (p.claim == claim) return p;
  throw std::out_of_range(claim);
}

// A parallelogram in the plane z = 0, cranks of 0.2 m and coupler of 0.4 m, whose home lies flat: there it may also fold.
class Parallelogram : public Mechanism<1> {
 public:
  static constexpr const char *name = "parallelogram", *title = "a parallelogram", *source = "a test";
  static constexpr std::array<Parameter, 0> parameters{};
  explicit Parallelogram(const Parameters&) {}
  Topology topology() const {
    Topology t;
    t.coordinates = {{"theta", "crank angle", "rad", 0, {-1, 1}}};
    for (const char* n : {"crank", "coupler", "rocker"}) t.add(Body{n, 0, false, {}});
    t.platform = 2;
    for (int i = 0; i < 4; ++i) t.add(Joint{std::string(1, static_cast<char>('A' + i)), JointKind::revolute, i, (i + 1) % 4, {}});
    t.add(Actuator{"q", "crank", "rad", 0, {-2, 2}});
    for (const char* n : {"fx", "fy", "fz"}) t.constraints.push_back({n, "", "N"});
    for (const char* n : {"mx", "my"}) t.constraints.push_back({n, "", "N*m"});
    return t;
  }
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> z = Vector3d::UnitZ().cast<T>(), a = Vector3d::Zero().cast<T>(), x = Vector3d::UnitX().cast<T>();
    const Vector3<T> along(cos(q[0]), sin(q[0]), T(0.0)), b = along * T(0.2), d = x * T(0.4);
    const Vector3<T> c = b + d;
    at.body(1, a, frame_xz(along, z));
    at.body(2, b, Matrix3<T>(Matrix3<T>::Identity()));
    at.body(3, c, frame_xz(along, z));
    at.joint(0, a, z);
    at.joint(1, b, z);
    at.joint(2, c, z);
    at.joint(3, d, z);
    at.actuator(0, q[0]);
  }
  template <class T>
  Matrix6<T> jacobian(const Placement<T>&) const {
    return Matrix6<T>(Matrix6<T>::Identity());
  }
};

const std::string unit_size = "constraint wrenches are of unit size", regular_home = "home is regular",
                  regular_jacobian = "jacobian is regular at home";

}  // namespace

TEST_CASE("a constraint row of zeros is named") {
  CHECK_THAT(failure(Mistake::row_zero, unit_size), StartsWith("home: row 3 of the Jacobian (fx) is zero; does jacobian fill it?"));
  CHECK_THAT(failure(Mistake::row_zero, regular_jacobian), StartsWith("home: row 3 of the Jacobian (fx) is zero at home"));
}

TEST_CASE("a constraint row that is no unit wrench is named with its size and what it does to the numbers") {
  CHECK_THAT(failure(Mistake::row_twice, unit_size),
             StartsWith("home: row 5 of the Jacobian (fz) has a force of 2 where a unit wrench has 1: 1 N of it would be told as 0.5 N"));
  CHECK_THAT(failure(Mistake::couple_thousandfold, unit_size),
             Contains(": row 6 of the Jacobian (mz) has a moment of 1000 where a unit wrench in N*m has 1: 1 N*m of it would be told "
                      "as 0.001 N*m"));
}

TEST_CASE("a force and a couple in each other's rows are named") {
  CHECK_THAT(failure(Mistake::rows_exchanged, unit_size),
             Contains("row 5 of the Jacobian (fz) is a couple, though fz is declared in N: are the rows in the order of the constraints?"));
}

TEST_CASE("a row that is given twice leaves the Jacobian singular where the joints hold the platform") {
  const std::string where = failure(Mistake::row_repeated, regular_jacobian);
  CHECK_THAT(where, Contains("the rows of the overall Jacobian depend on one another at home, though the joints hold the platform there"));
}

TEST_CASE("what a singular Jacobian kept from being looked at does not pass") {
  const auto all = properties(Mistake::row_zero);
  for (const char* claim : {"forward inverts inverse displacement", "closed-form statics equal the generic model's",
                            "virtual power balances", "energy balances", "every body is in balance"}) {
    const Property& p = property(all, claim);
    CAPTURE(claim, p.unexamined);
    CHECK(p.verdict() == Verdict::not_examined);
    CHECK(p.evaluations == 0);
    CHECK_FALSE(p.holds());
    CHECK_THAT(p.unexamined, Contains("the overall Jacobian is singular, or nearly (condition above 1e+06), at every pose"));
  }
}

TEST_CASE("without random poses what needs them is not examined, with the reason") {
  const auto all = properties(Mistake::none, 0);
  std::set<std::string> unexamined;
  for (const Property& p : all)
    if (p.verdict() == Verdict::not_examined) {
      unexamined.insert(p.claim);
      CHECK(p.unexamined == "no pose but home was asked for");
    } else {
      CAPTURE(p.claim, p.where);
      CHECK(p.holds());
    }
  CHECK(unexamined ==
        std::set<std::string>{"poses are in reach", "quantities do not jump", "lanes equal doubles", "extended precision agrees"});
}

TEST_CASE("what a mechanism has nothing of does not apply to it, and everything else is looked at") {
  for (const Property& p : properties(Mistake::none)) {
    CAPTURE(p.claim);
    const bool nothing = p.claim == "matrices of the source hold" || p.claim == "constraint wrenches are of the limbs they name" ||
                         p.claim == "mass matrix is positive definite" || p.claim == "self-stresses balance";
    CHECK(p.verdict() == (nothing ? Verdict::not_applicable : Verdict::passed));
    CHECK((p.evaluations > 0) != nothing);
  }
}

TEST_CASE("home on a singular surface is named as that, with the motion that nothing holds") {
  const auto all = failures(Mistake::home_stretched);
  REQUIRE(all.contains(regular_home));
  CHECK(all.at(regular_home) ==
        "home: home is on a singular surface; with every actuator held the platform can turn about (1.000, 0.000, 0.000); choose another "
        "home, or other sizes");
  CHECK(all.size() == 1);  // beside home it is sound
}

TEST_CASE("home that gains a freedom of its own is singular, though the mobility beside it is as declared") {
  const pm_mechanism& flat = contract::mechanism<Parallelogram>;
  const auto all = check_properties(Machine(flat, default_values(describe(flat))), {50, 1});
  CHECK(property(all, "mobility is as declared").verdict() == Verdict::passed);
  CHECK_THAT(property(all, regular_home).where,
             StartsWith("home: home is on a singular surface; with every actuator free the platform has 2 freedoms there, not 1"));
}

TEST_CASE("an architecture that is singular everywhere is told as that") {
  CHECK_THAT(failure(Mistake::legs_alike, regular_home),
             StartsWith("home: home is singular, and so is every other pose that was tried: such an architecture is no machine"));
}

TEST_CASE("an angle that jumps by a turn is named") {
  const std::string where = failure(Mistake::heading_jumps, "quantities do not jump");
  CHECK_THAT(where, StartsWith("heading jumps by -6.283 rad at alpha = -") || StartsWith("heading jumps by 6.283 rad at alpha = -"));
  CHECK_THAT(where, Contains("look at the cut of the arc tangent"));
}

TEST_CASE("the limb of a constraint is read from its title") {
  const auto named = [](const char* title) { return limb_named(Constraint{"c", title, "N"}); };
  CHECK(named("couple of the rods of limb 3 on the platform") == 3);
  CHECK(named("limb 12") == 12);
  CHECK(named("couple of limbs 2 and 3") == 0);
  CHECK(named("of limb 1 and of limb 2") == 0);
  CHECK(named("force along the hinge") == 0);
  CHECK(named("of the UPU limb") == 0);
  CHECK(named("climb 2") == 0);
}
