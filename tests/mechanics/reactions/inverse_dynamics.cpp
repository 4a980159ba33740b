#include <core/mechanics/reactions/inverse_dynamics.hpp>

#include <core/mechanics/reactions/by_limb/kernel.hpp>
#include <core/mechanics/reactions/by_limb/planner.hpp>
#include <tests/given/slider_crank.hpp>
#include <tests/mechanics/mechanisms.hpp>
#include <tests/mechanics/motions.hpp>

#include <algorithm>
#include <cstdlib>

using namespace pmreport;
using namespace pmreport::mechanics;
using test::LoadedMotion;

namespace {

// Equal to the last bit, NaN to NaN.
bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

void check_pose(const MotionReactions& one, const MotionReactions& many, std::size_t count, std::size_t k, double tolerance) {
  double largest = 0, worst = 0;
  for (const double x : one.joints) largest = std::max(largest, std::abs(x));
  const auto compare = [&](const std::vector<double>& a, const std::vector<double>& b, double scale) {
    REQUIRE(b.size() == a.size() * count);
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double off = std::abs(a[i] - b[i * count + k]) / scale;
      if (!(off <= worst)) worst = off;
    }
  };
  compare(one.actuator_forces, many.actuator_forces, largest);
  compare(one.joints, many.joints, largest);
  compare(one.regularity, many.regularity, 1);
  compare(one.stresses, many.stresses, 1);
  CHECK(worst <= tolerance);
  for (std::size_t j = 0; j < one.indeterminate.size(); ++j) CHECK(one.indeterminate[j] == many.indeterminate[j * count + k]);
}

Machine slider_crank_with(std::string_view fault) {
  const auto which = std::ranges::find(test::SliderCrank::faults, fault);
  ParameterValues values = default_values(describe(test::slider_crank()));
  values[0] = {static_cast<double>(which - std::begin(test::SliderCrank::faults))};
  return Machine(test::slider_crank(), values);
}

// The slider-crank with masses of any shape, and with every joint that it can be held by once more: a second prismatic joint of the slider,
// a cylindrical joint beside the crank's revolute one, and an idler that slides and turns about the slider's axis and holds the slider by a
// universal joint.
class HeavySliderCrank : public test::SliderCrank {
 public:
  using SliderCrank::SliderCrank;
  enum { idler = slider + 1 };

  Topology topology() const {
    Topology t = SliderCrank::topology();
    t.add(Body{"idler", 0, false, {}});
    t.add(Joint{"P2", JointKind::prismatic, 0, slider, {}});
    t.add(Joint{"O2", JointKind::cylindrical, crank, 0, {}});
    t.add(Joint{"D", JointKind::cylindrical, 0, idler, {}});
    t.add(Joint{"U", JointKind::universal, slider, idler, {}});
    const double inertia[] = {0.3, 0.5, 0.4, 0.05, -0.08, 0.11};
    for (const int body : {int{crank}, int{slider}, int{idler}}) {
      Inertia& i = t.bodies[static_cast<std::size_t>(body)].inertia = Inertia::central(1.0 + body, inertia);
      i.centre = Eigen::Vector3d(0.1, -0.2, 0.3) / body;
    }
    t.bodies[rod].inertia = Inertia::axisymmetric(2, 0.2, 0.05, 0.01);
    return t;
  }
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    SliderCrank::place(q, at);
    const Vector3<T> end = at.centre(2), axis = e().template cast<T>(), o = Eigen::Vector3d(0, 0, 0.1).cast<T>();
    const Eigen::Vector3d across = e().unitOrthogonal(), third = e().cross(across);
    at.body(idler, end, Eigen::Matrix3d::Identity().cast<T>());
    at.joint(4, Vector3<T>(end + Eigen::Vector3d(0, 0.3, 0.1)), axis);
    at.joint(5, o, Eigen::Vector3d::UnitZ().cast<T>());
    at.joint(6, Vector3<T>(end + e()), axis);
    at.joint(7, end, across.cast<T>(), third.cast<T>());
  }
};

}  // namespace

TEST_CASE("small mechanisms have the reactions of the system over all their bodies") {
  SECTION("legs on balls that spin idly") { test::require_same_as_dense(test::make_hexapod(test::BaseJoint::ball), 50, 1); }
  SECTION("legs on universal joints") { test::require_same_as_dense(test::make_hexapod(test::BaseJoint::universal), 50, 2); }
  SECTION("a platform that hangs on the base itself") { test::require_same_as_dense(test::make(test::slider_crank()), 50, 3); }
  SECTION("a planar loop with three self-stresses") { test::require_same_as_dense(test::make(test::four_bar()), 50, 4); }
  SECTION("masses of any shape, joints of every kind in the tree and cut") {
    const Machine machine = test::make(contract::mechanism<HeavySliderCrank>);
    CHECK(plan_of(machine).has_value());
    test::require_same_as_dense(machine, 50, 6);
  }
  SECTION("a serial arm, driven at its platform") { test::require_same_as_dense(test::make(test::arm()), 50, 5); }
}

TEST_CASE("a structure is planned limb by limb unless a driven joint must be cut") {
  const auto hexapod = plan_of(test::make_hexapod(test::BaseJoint::ball));
  REQUIRE(hexapod.has_value());
  CHECK(hexapod->groups.size() == 6);
  CHECK(hexapod->open == 6);
  const auto four_bar = plan_of(test::make(test::four_bar()));
  REQUIRE(four_bar.has_value());
  CHECK(four_bar->stresses() == 3);
  CHECK_FALSE(plan_of(test::make(test::arm())).has_value());
}

TEST_CASE("idle freedoms that are not declared, or not there, are not trusted") {
  CHECK(plan_of(slider_crank_with("none")).has_value());
  CHECK_FALSE(plan_of(slider_crank_with("idle")).has_value());
}

TEST_CASE("a pose has the same forces alone and among any number of others") {
  constexpr double rounding = 1e-12;  // the plugin's own lanes may round differently; see agreement
  const std::size_t width = DynamicsKernel::widest().width();
  for (const pm_mechanism* table : {&test::hexapod(), &test::four_bar(), &test::arm()}) {
    const Machine machine = test::make(*table);
    const LoadedMotion motion = test::random_loaded_motion(machine, 1000, 6);
    InverseDynamics dynamics(machine);
    for (const std::size_t count : {std::size_t{1}, std::size_t{2}, std::size_t{3}, width, width + 1, 2 * width, 2 * width + 1,
                                    std::size_t{1000}, std::size_t{2}}) {  // and memory that was once longer
      const MotionReactions many = test::solve(dynamics, motion.part(0, count));
      INFO(machine.info().name << ", " << count << " poses");
      for (std::size_t k = 0; k < count; k += std::max<std::size_t>(1, count / 7))
        check_pose(test::solve(dynamics, motion.at(k)), many, count, k, rounding);
      const MotionReactions forces = test::solve(dynamics, motion.part(0, count), false);
      CHECK(forces.actuator_forces == many.actuator_forces);
      CHECK(forces.joints.empty());
    }
  }
}

TEST_CASE("every width of the lanes gives the same numbers to the last bit") {
  const Machine machine = test::make(test::four_bar());
  const auto plan = plan_of(machine);
  REQUIRE(plan.has_value());
  constexpr std::size_t count = 16;
  const LoadedMotion motion = test::random_loaded_motion(machine, count, 7);
  std::vector<double> placement(3 * machine.layout().size() * count);
  REQUIRE(machine.place(PM_JET, count, motion.jets.data(), placement.data()) == PM_OK);
  const std::size_t joints = machine.topology().joints.size(), stresses = static_cast<std::size_t>(plan->stresses());
  std::vector<double> first;
  for (const DynamicsKernel& kernel : DynamicsKernel::all()) {
    std::vector<double> forces(count), regularity(count), reactions(6 * joints * count), stress(stresses * 6 * joints * count);
    std::vector<Indeterminate> indeterminate(joints * count);
    DynamicsBatch batch;
    batch.placement = placement.data(), batch.loads = motion.loads.data();
    batch.stride = batch.count = batch.written = count;
    batch.actuator_forces = forces.data(), batch.regularity = regularity.data(), batch.joints = reactions.data();
    batch.indeterminate = indeterminate.data(), batch.stresses = stress.data();
    double* memory = static_cast<double*>(std::aligned_alloc(64, (kernel.memory(*plan) * sizeof(double) + 63) / 64 * 64));
    kernel.solve(*plan, batch, memory);
    std::free(memory);
    for (const auto* more : {&regularity, &reactions, &stress}) forces.insert(forces.end(), more->begin(), more->end());
    forces.insert(forces.end(), indeterminate.begin(), indeterminate.end());
    if (first.empty()) first = forces;
    INFO(kernel.width() << " lanes");
    CHECK(std::ranges::equal(first, forces, same));
  }
}

TEST_CASE("a pose out of reach has no numbers and leaves its neighbours alone") {
  const Machine machine = slider_crank_with("reach");  // reaches 0.05 rad either way of its home
  InverseDynamics dynamics(machine);
  constexpr std::size_t count = 11, out_of_reach = 4;
  LoadedMotion motion{count, 1, std::vector<double>(3 * count, 0.0), std::vector<double>(6 * count, 1.0)};
  std::fill_n(motion.jets.begin(), count, 0.8);
  const MotionReactions before = test::solve(dynamics, motion);
  motion.jets[out_of_reach] = 1.2;
  const MotionReactions after = test::solve(dynamics, motion);
  for (const auto& [was, is] : {std::pair{&before.actuator_forces, &after.actuator_forces}, std::pair{&before.joints, &after.joints},
                                std::pair{&before.regularity, &after.regularity}})
    for (std::size_t i = 0; i < was->size(); ++i) {
      REQUIRE(std::isfinite((*was)[i]));
      CHECK(same((*is)[i], i % count == out_of_reach ? std::nan("") : (*was)[i]));
    }
  const MotionReactions alone = test::solve(dynamics, motion.at(out_of_reach));
  CHECK(std::isnan(alone.actuator_forces[0]));
  CHECK(std::ranges::all_of(alone.joints, [](double x) { return std::isnan(x); }));
}
