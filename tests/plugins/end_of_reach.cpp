// The Delta near the end of its reach: its arms and rods stretched under the middle of the base, a singularity of type 1.
#include <core/mechanics/model/closed_form.hpp>
#include <core/mechanics/model/differences.hpp>
#include <core/mechanics/singularity/end_of_reach.hpp>
#include <core/mechanics/singularity/singularity.hpp>
#include <tests/plugins/delta.hpp>
#include <tests/plugins/hexapods.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;

namespace {

// Arm and rod in one line from A_i to the platform, which is b - p nearer to the axis: the deepest point of the workspace's middle.
struct Stretched {
  test::DeltaSizes sizes;
  double across = sizes.base - sizes.platform, along = sizes.arm + sizes.rod;
  double depth = std::sqrt(along * along - across * across);
  // The edge is a sphere about each A_i: what is left of the way along the limb, of what is left of the depth.
  double share = depth / along;
};

std::unique_ptr<Machine> wide_delta() {
  const pm_mechanism& table = test::delta();
  return std::make_unique<Machine>(table, test::delta_values({}, {{"ball_cone", {std::numbers::pi}}}));
}
SmallVector below(const Machine& machine, double z) {
  SmallVector q = machine.home();
  q(2) = z;
  return q;
}

}  // namespace

TEST_CASE("the end of reach of a Delta is named from one millimetre to one nanometre before it, with how far it is") {
  const Stretched stretched;
  const auto machine = wide_delta();
  const double length = characteristic_length(*machine);
  for (const double left : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9}) {
    INFO(left << " m");
    const auto end = end_of_reach(*machine, below(*machine, -(stretched.depth - left)), length);
    REQUIRE(end);
    // What rounding leaves of the way, some 1e-16 m, is a millionth of a nanometre; the law of the root holds to a share of left / length.
    CHECK(end->distance == Approx(left * stretched.share).epsilon(std::max(1e-5, 10 * left)));
    CHECK(end->actuators == std::vector<int>{0, 1, 2});
  }
  CHECK_FALSE(end_of_reach(*machine, machine->home(), length));
  CHECK_FALSE(end_of_reach(*machine, below(*machine, -(stretched.depth - 0.2)), length));
}

TEST_CASE("no hexapod at home is near the end of its reach: a leg along its own line has none") {
  for (const char* name : {"gough", "stewart", "cross1", "cross2"}) {
    const auto machine = test::hexapod(name);
    INFO(name);
    CHECK_FALSE(end_of_reach(*machine, machine->home(), characteristic_length(*machine)));
  }
}

TEST_CASE("beside the end of reach the wrenches on the platform are as regular as they are") {
  const Stretched stretched;
  const auto machine = wide_delta();
  const double length = characteristic_length(*machine);
  State s = state_at_rest(*machine, below(*machine, -(stretched.depth - 1e-9)));
  REQUIRE(s.status == PM_OK);
  const ClosedForm c = closed_form(*machine, s, length);
  CHECK(c.side != 0);
  CHECK(c.condition > 1e3);  // rates of the arms by the platform's: the levers vanish
  // Three rods that lean by `across` of `along`: forces of slope 0.07, whose condition number is some twenty; their couples add little.
  CHECK(c.wrench_condition < 100);
  s = state_at_rest(*machine, below(*machine, -stretched.depth - 1e-6));
  CHECK(s.status == PM_UNREACHABLE);
}

TEST_CASE("evidence beside the end of reach is known to fewer digits, and knows it") {
  const Stretched stretched;
  const auto machine = wide_delta();
  double known = 0;
  for (const double left : {1e-1, 1e-3, 1e-5, 1e-7, 1e-9}) {
    INFO(left << " m");
    const SmallVector q = below(*machine, -(stretched.depth - left));
    const Eigen::Vector3d rate = Eigen::Vector3d::Zero(), acceleration = 0.2 * Eigen::Vector3d::UnitZ();
    State s;
    evaluate(*machine, q.data(), rate.data(), acceleration.data(), s);
    REQUIRE(s.status == PM_OK);
    const Deviation d = jets_against_differences(*machine, s);
    REQUIRE(d.reachable);
    CHECK(d.acceleration <= std::max(1e-9, d.acceleration_error));
    if (left < 1e-4) CHECK(d.acceleration_error > known);  // fewer digits with every step towards the end
    known = d.acceleration_error;
  }
  CHECK(known < 0.01);  // at one nanometre two digits are left at least
  CHECK(known > 1e-9);
}
