// Coordinates whose angles are singular where the machine is not: a hexapod whose platform has its axes turned, so that home stands at
// beta = 90 degrees, where alpha and gamma turn about one axis. It is the same machine as with the axes as they are: that is the judge.
#include <core/mechanics/displacement/follow.hpp>
#include <core/mechanics/dynamics/virtual_work.hpp>
#include <core/mechanics/singularity/singularity.hpp>
#include <core/numbers.hpp>
#include <tests/plugins/dynamics.hpp>
#include <tests/plugins/hexapods.hpp>

#include <random>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Vector3d, Eigen::VectorXd;

namespace {

// Points of the platform of Gough's platform as its defaults give them, in axes turned by a quarter about X: the new y axis along the old
// -z, so that p_old = Rx(90 deg) p_new.
std::unique_ptr<Machine> turned_axes() {
  const auto machine = test::hexapod("gough");
  std::vector<double> points;
  for (int i = 1; i <= 6; ++i) {
    const Vector3d b = machine->centre(machine->home_pose(), test::joint_named(*machine, "B" + std::to_string(i))) -
                       machine->origin(machine->home_pose(), machine->topology().platform);
    points.insert(points.end(), {b.x(), b.z(), -b.y()});
  }
  const pm_mechanism& table = test::plugin("gough");
  return std::make_unique<Machine>(table, test::values_with(table, {{"platform_points", points}, {"home_angles", {0, pi / 2, 0}}}));
}

// Both at x, y, z and a turn alpha about Z: R = Rz(alpha) R_home in either axes. Rates and accelerations likewise.
struct Twins {
  State plain, turned;
};
Twins twins(const Machine& plain, const Machine& turned, std::mt19937_64& random) {
  std::uniform_real_distribution<double> some(-1, 1);
  VectorXd q = plain.home(), other = turned.home(), rate = VectorXd::Zero(6), acceleration = VectorXd::Zero(6);
  for (int i = 0; i < 4; ++i) {
    const double shift = (i < 3 ? 0.08 : 0.3) * some(random);
    q(i) += shift, other(i) += shift, rate(i) = some(random), acceleration(i) = 3 * some(random);
  }
  Twins out;
  evaluate(plain, q.data(), rate.data(), acceleration.data(), out.plain);
  evaluate(turned, other.data(), rate.data(), acceleration.data(), out.turned);
  REQUIRE(out.plain.status == PM_OK);
  REQUIRE(out.turned.status == PM_OK);
  return out;
}

}  // namespace

TEST_CASE("forces do not hang on the angles that tell a platform's pose") {
  // The platform is a disc about its own z axis: massless here, so that turned axes leave the bodies as they are.
  const auto plain = test::hexapod("gough"), turned = turned_axes();
  const std::size_t mass = [&] {
    const auto& declared = plain->info().parameters;
    return static_cast<std::size_t>(std::ranges::find(declared, "platform_mass", &ParameterInfo::name) - declared.begin());
  }();
  ParameterValues a = plain->values(), b = turned->values();
  a[mass] = b[mass] = {0};
  const auto first = plain->with(a), second = turned->with(b);
  std::mt19937_64 random(90);
  for (int k = 0; k < 20; ++k) {
    const Twins t = twins(*first, *second, random);
    CHECK_FALSE(tangent(*second, t.turned).by_coordinates);
    CHECK(tangent(*first, t.plain).by_coordinates);
    Loading loading{Vector6d::Zero(), {0, 0, -9.81}};
    loading.platform << 10, -20, -100, 3, -2, 1;
    const SmallVector expected = virtual_work(*first, t.plain, tangent(*first, t.plain), loading).total();
    const SmallVector seen = virtual_work(*second, t.turned, tangent(*second, t.turned), loading).total();
    CHECK((seen - expected).lpNorm<Eigen::Infinity>() < 1e-9 * expected.lpNorm<Eigen::Infinity>());
    const Tangent here = tangent(*first, t.plain), there = tangent(*second, t.turned);
    const SmallVector inertia = reflected_inertia(here, equations_of_motion(*first, t.plain, here, loading.gravity).mass);
    const SmallVector other = reflected_inertia(there, equations_of_motion(*second, t.turned, there, loading.gravity).mass);
    CHECK((other - inertia).lpNorm<Eigen::Infinity>() < 1e-9 * inertia.lpNorm<Eigen::Infinity>());
    CHECK(kinetic_energy(*second, t.turned) == Approx(kinetic_energy(*first, t.plain)).epsilon(1e-12));
  }
}

TEST_CASE("singular angles are named with the coordinates that take part, nearly singular ones as nearly, sound ones not at all") {
  const auto turned = turned_axes();
  const double length = characteristic_length(*turned);
  SmallVector q = turned->home();
  const auto fault = chart_fault(*turned, q, length);
  REQUIRE(fault);
  CHECK(fault->quality < 1e-12);
  CHECK(fault->coordinates == std::vector<int>{3, 5});  // alpha and gamma
  CHECK(in_words(*turned, *fault).find("alpha and gamma turn the platform about one axis") == 0);

  // Beside it the axes of alpha and gamma make the angle delta, and unit columns c1, c2 have the least singular value sqrt(1 - cos delta).
  const double delta = 0.5 * pi / 180;
  q(4) -= delta;
  const auto near = chart_fault(*turned, q, length);
  REQUIRE(near);
  CHECK(near->quality == Approx(std::sqrt(1 - std::cos(delta))).epsilon(1e-9));
  CHECK(in_words(*turned, *near).find("nearly about one axis") != std::string::npos);
  q(4) -= 0.2;
  CHECK_FALSE(chart_fault(*turned, q, length));
  for (const char* name : {"gough", "stewart", "cross1"}) {
    const auto sound = test::hexapod(name);
    CHECK_FALSE(chart_fault(*sound, sound->home(), characteristic_length(*sound)));
  }
}

TEST_CASE("actuators that are prescribed from singular angles are not followed, and the angles are named") {
  const auto turned = turned_axes();
  const SmallVector start = turned->home(), from = actuators_at(*turned, start);
  SmallVector to = from;
  to(0) += 0.01;
  const Approach a = approach(*turned, start, to);
  CHECK(a.outcome == Outcome::singular);
  CHECK(a.share == 0);
  CHECK(a.why.find("alpha and gamma") == 0);
  const ForwardSolution s = ForwardSolver(*turned).solve(to, start);
  CHECK(s.outcome == Outcome::singular);
  CHECK(s.why.find("alpha and gamma") == 0);
}

TEST_CASE("singular angles leave the machine on its side of the singular surface") {
  const auto turned = turned_axes();
  const double length = characteristic_length(*turned);
  const auto w = wrench_determinant(*turned, turned->home(), length);
  REQUIRE(w);
  CHECK(w->side != 0);
  const auto plain = test::hexapod("gough");
  CHECK(w->value == Approx(wrench_determinant(*plain, plain->home(), length)->value).epsilon(1e-9));
}
