// Loops, counted by hand.
#include <core/mechanics/mobility/loops.hpp>
#include <core/mechanics/mobility/mobility.hpp>
#include <pmreport/mechanism.hpp>
#include <tests/mechanics/mechanisms.hpp>

#include <catch2/catch.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;

namespace {

// Base, platform, and so many limbs of one link.
Topology legs(int count) {
  Topology t;
  t.platform = t.add(Body{"platform", 0, false, {}});
  for (int i = 1; i <= count; ++i) {
    const std::string n = std::to_string(i);
    const int link = t.add(Body{"link " + n, i, false, {}});
    t.add(Joint{"A" + n, JointKind::revolute, 0, link, {}});
    t.add(Joint{"B" + n, JointKind::revolute, link, t.platform, {}});
  }
  return t;
}

// The plate moves on a circle and does not turn.
class Plate : public Mechanism<1> {
 public:
  static constexpr const char *name = "plate", *title = "a plate on three links", *source = "a test";
  static constexpr std::array<Parameter, 0> parameters{};
  explicit Plate(const Parameters&) {}
  Topology topology() const {
    Topology t = legs(3);
    t.coordinates = {{"theta", "angle of the links", "rad", 1.0, {0.5, 1.5}}};
    t.add(Actuator{"q", "link 1", "rad", 0, {-3, 3}});
    for (const char* n : {"force_x", "force_y", "force_z"}) t.constraints.push_back({n, "", "N"});
    for (const char* n : {"couple_x", "couple_y"}) t.constraints.push_back({n, "", "N*m"});
    return t;
  }
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Eigen::Vector3d feet[] = {{0, 0, 0}, {0.4, 0, 0}, {0.1, 0.3, 0}};
    const Vector3<T> along(cos(q[0]), sin(q[0]), T(0.0)), z = Eigen::Vector3d::UnitZ().cast<T>();
    at.body(1, along, Matrix3<T>(Matrix3<T>::Identity()));
    for (int i = 0; i < 3; ++i) {
      const Vector3<T> foot = feet[i].cast<T>();
      at.body(2 + i, foot, frame_xz(along, z));
      at.joint(2 * i, foot, z);
      at.joint(2 * i + 1, foot + along, z);
    }
    at.actuator(0, q[0]);
  }
  template <class T>
  Matrix6<T> jacobian(const Placement<T>&) const {
    return Matrix6<T>::Identity();
  }
};

}  // namespace

TEST_CASE("two links between base and platform are one loop, told from the base on") {
  const auto all = loops(legs(2));
  REQUIRE(all.size() == 1);
  CHECK(in_words(legs(2), all[0]) == "base – A1 – link 1 – B1 – platform – B2 – link 2 – A2 – base");
}

TEST_CASE("of three links every two are a loop, and of one there is none") {
  CHECK(loops(legs(3)).size() == 3);
  CHECK(loops(legs(1)).empty());
}

TEST_CASE("smaller loops stand first, and two joints between the same bodies are one") {
  Topology t = legs(2);
  t.add(Joint{"C", JointKind::revolute, 3, t.platform, {}});  // link 2 is pinned to the platform twice
  const auto all = loops(t);
  REQUIRE(all.size() >= 2);
  CHECK(in_words(t, all[0]) == "platform – B2 – link 2 – C – platform");
  for (std::size_t i = 1; i < all.size(); ++i) CHECK(all[i].joints.size() >= all[i - 1].joints.size());
}

TEST_CASE("a plate on three parallel links has three redundant constraints in each of two loops, and one in both together") {
  // Two links and the plate are a parallelogram, a planar loop: a force across its plane and two couples in the plane are too many,
  // wherever the third link is. With it a third loop closes, whose three are those of the first two one after the other; but in the plane
  // three links hold what two hold already. 6 (5 - 6 - 1) + 6 + 7 = 1 degree of freedom.
  const pm_mechanism& table = contract::mechanism<Plate>;
  const Machine machine(table, default_values(describe(table)));
  const State s = state_at_rest(machine, machine.home());
  const std::vector<SelfStress> stresses = self_stresses(machine, s, generic_model(machine, s));
  REQUIRE(stresses.size() == 7);
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(stresses[k].loop.joints == std::vector<int>{0, 1, 3, 2});
    CHECK(stresses[3 + k].loop.joints == std::vector<int>{0, 1, 5, 4});
    CHECK(stresses[k].same);
  }
  CHECK(stresses[6].loop.joints.empty());
  CHECK(stresses[6].shares.size() == 6);
}

TEST_CASE("the redundant constraints of a four-bar are in its loop") {
  const Machine machine = test::make(test::four_bar());
  const State s = state_at_rest(machine, machine.home());
  const auto stresses = self_stresses(machine, s, generic_model(machine, s));
  REQUIRE(stresses.size() == 3);
  for (const SelfStress& stress : stresses)
    CHECK(in_words(machine.topology(), stress.loop) == "base – A – crank – B – coupler – C – rocker – D – base");
}
