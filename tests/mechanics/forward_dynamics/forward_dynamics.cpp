// Motion from forces against motions known in closed form, and against what is conserved.
#include <core/mechanics/forward_dynamics/forward_dynamics.hpp>

#include <tests/mechanics/mechanisms.hpp>
#include <tests/mechanics/swinging.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace pmreport;
using namespace pmreport::mechanics;
using Catch::Contains;
using test::Pendulum;
using test::Trolley;

namespace {

constexpr double g = 9.81, pi = 3.14159265358979323846;

Machine pendulum(double drive = 0, double lowest = -10, double turn = 10, double room = 10) {
  return Machine(test::pendulum(), {{drive}, {lowest}, {turn}, {room}});
}
Machine trolley(double arm = 0.5) { return Machine(test::trolley(), {{arm}}); }

std::vector<double> uniform(double end, int count) {
  std::vector<double> out;
  for (int i = 0; i < count; ++i) out.push_back(end * i / (count - 1));
  return out;
}
Eigen::VectorXd vector(std::initializer_list<double> x) {
  return Eigen::Map<const Eigen::VectorXd>(x.begin(), static_cast<Eigen::Index>(x.size()));
}

void no_forces(double, const std::vector<Scalar>& actuators, double* forces) { std::fill_n(forces, actuators.size(), 0.0); }

ForwardProblem problem(std::initializer_list<double> start, std::initializer_list<double> rate, double end, int count,
                       bool gravity = false) {
  ForwardProblem p;
  p.actuator_forces = no_forces;
  if (gravity) p.gravity = {0, 0, -g};
  p.start = vector(start), p.start_rate = vector(rate);
  p.times = uniform(end, count);
  return p;
}

// theta'' = -a^2 sin(theta), released at rest from `amplitude`: from there to `theta` on the first way down it takes
// (K(k) - F(phi, k)) / a, k = sin(amplitude / 2), sin(phi) = sin(theta / 2) / k; a whole swing 4 K(k) / a.
const double pace = std::sqrt(Pendulum::mass * g * Pendulum::arm / Pendulum::about_hinge);
double time_to(double theta, double amplitude) {
  const double k = std::sin(0.5 * amplitude);
  return (std::comp_ellint_1(k) - std::ellint_1(k, std::asin(std::sin(0.5 * theta) / k))) / pace;
}
double period(double amplitude) { return 4 * std::comp_ellint_1(std::sin(0.5 * amplitude)) / pace; }

// A step errs by 1e-10 of what it advances; some hundred steps a swing add up.
constexpr double integrated = 1e-8;

}  // namespace

TEST_CASE("a pendulum swings with the period of the elliptic integral, however far") {
  const Machine m = pendulum();
  for (const double amplitude : {0.01, 0.5, 1.5, 3.0}) {
    CAPTURE(amplitude);
    const double quarter = period(amplitude) / 4;
    const ForwardMotion motion = forward_dynamics(m, problem({amplitude}, {0}, 8 * quarter, 9, true));
    CHECK(motion.ending.empty());
    CHECK(motion.ended == 8 * quarter);
    for (const int k : {0, 4, 8}) CHECK(motion.value(k, 0) == Approx(amplitude).epsilon(integrated));
    for (const int k : {2, 6}) CHECK(motion.value(k, 0) == Approx(-amplitude).epsilon(integrated));
    const double fastest = 2 * pace * std::sin(0.5 * amplitude);  // from the energy
    for (const int k : {1, 5}) {
      CHECK(motion.value(k, 0) == Approx(0).margin(10 * integrated * amplitude));  // errors grow along the way, at a rate of `fastest`
      CHECK(motion.rate(k, 0) == Approx(-fastest).epsilon(10 * integrated));
    }
    CHECK(motion.acceleration(0, 0) == Approx(-pace * pace * std::sin(amplitude)).epsilon(1e-13));
    CHECK(motion.drift_share < integrated);
  }
}

TEST_CASE("a damped and driven oscillator follows its closed form") {
  // (m1 + m2) x'' = -k x - c x' + F sin(w t) with k, c, F of the actuator; x(0) = x0, x'(0) = 0
  const Machine m = trolley(0);
  const double mass = Trolley::trolley_mass + Trolley::load_mass, k = 700, c = 20, force = 30, w = 7, x0 = 0.1;
  ForwardProblem p = problem({x0, 0}, {0, 0}, 3, 61);
  p.actuator_forces = [&](double t, const std::vector<Scalar>& l, double* f) {
    f[0] = -k * l[0].value - c * l[0].rate + force * std::sin(w * t);
    f[1] = 0;
  };
  const ForwardMotion motion = forward_dynamics(m, p);
  const double n2 = k / mass, d = c / (2 * mass), wd = std::sqrt(n2 - d * d);
  const double phase = std::atan2(2 * d * w, n2 - w * w), steady = force / mass / std::hypot(n2 - w * w, 2 * d * w);
  const double a = x0 + steady * std::sin(phase), b = (d * a - steady * w * std::cos(phase)) / wd;
  for (Eigen::Index i = 0; i < 61; ++i) {
    const double t = p.times[static_cast<std::size_t>(i)];
    CAPTURE(t);
    CHECK(motion.value(i, 0) == Approx(std::exp(-d * t) * (a * std::cos(wd * t) + b * std::sin(wd * t)) + steady * std::sin(w * t - phase))
                                    .margin(integrated * x0));
    CHECK(motion.value(i, 1) == 0);
    // What went in is what there is, at every sample.
    CHECK(motion.energy[static_cast<std::size_t>(i)] - motion.energy[0] ==
          Approx(motion.work[static_cast<std::size_t>(i)]).margin(integrated * 3.5));
  }
  CHECK(motion.drift_share < integrated);
}

TEST_CASE("a load acts beside the actuators, at any time") {
  const Machine m = trolley(0);
  ForwardProblem p = problem({0, 0}, {0, 0}, 2, 21);
  p.load = [](double t) { return (Vector6d() << 14 * t, 0, 0, 0, 0.6, 0).finished(); };
  const ForwardMotion motion = forward_dynamics(m, p);
  for (Eigen::Index i = 0; i < 21; ++i) {
    const double t = p.times[static_cast<std::size_t>(i)];
    CHECK(motion.value(i, 0) == Approx(14.0 / 7 * t * t * t / 6).margin(integrated));
    CHECK(motion.value(i, 1) == Approx(0.5 * 6 * t * t).margin(integrated));
  }
  CHECK(motion.work.back() == Approx(0.5 * 7 * 16 + 0.5 * 0.1 * 144).epsilon(integrated));
}

TEST_CASE("energy and momentum are kept over many swings, and a motion runs back the way it came") {
  const Machine m = trolley();
  const double total = Trolley::trolley_mass + Trolley::load_mass;
  const ForwardMotion there = forward_dynamics(m, problem({0.2, 2.5}, {0.3, -1}, 60, 601, true));
  REQUIRE(there.ending.empty());
  CHECK(there.drift_share < 1e-8);
  CHECK(there.drift > 0);
  // No force along X: the momentum (M + m) x' - m d cos(theta) theta' stays, and the centre of mass with it keeps its pace. The mass is 0.5
  // m below the hinge, so it moves by -d cos(theta) theta' along X.
  const auto momentum = [&](Eigen::Index i) {
    return total * there.rate(i, 0) - Trolley::load_mass * 0.5 * std::cos(there.value(i, 1)) * there.rate(i, 1);
  };
  double furthest = 0;
  for (Eigen::Index i = 0; i < 601; ++i) {
    CHECK(momentum(i) == Approx(momentum(0)).margin(1e-7));
    furthest = std::max(furthest, std::abs(there.value(i, 1) - 2.5));
  }
  CHECK(furthest > 4);  // it did swing

  const ForwardMotion short_way = forward_dynamics(m, problem({0.2, 1}, {0.3, -1}, 3, 31, true));
  const auto last = short_way.value.rows() - 1;
  ForwardProblem back =
      problem({short_way.value(last, 0), short_way.value(last, 1)}, {-short_way.rate(last, 0), -short_way.rate(last, 1)}, 3, 31, true);
  const ForwardMotion home = forward_dynamics(m, back);
  CHECK((home.value.colwise().reverse() - short_way.value).lpNorm<Eigen::Infinity>() < integrated);
  CHECK((home.rate.colwise().reverse() + short_way.rate).lpNorm<Eigen::Infinity>() < 10 * integrated);
}

TEST_CASE("between the samples the motion is one smooth curve through them") {
  const Machine m = trolley();
  const ForwardProblem p = problem({0.2, 1.2}, {0.3, -1}, 2, 9, true);
  const ForwardMotion motion = forward_dynamics(m, p);
  const auto at = [&](double t) {
    Eigen::MatrixXd x(2, 3);
    REQUIRE(motion.at(t, x.col(0).data(), x.col(1).data(), x.col(2).data()));
    return x;
  };
  for (Eigen::Index i = 0; i < 9; ++i) {
    const Eigen::MatrixXd x = at(p.times[static_cast<std::size_t>(i)]);
    CHECK(x.col(0).transpose() == motion.value.row(i));
    CHECK(x.col(1).transpose() == motion.rate.row(i));
    CHECK(x.col(2).transpose() == motion.acceleration.row(i));
  }
  for (int i = 1; i < 200; ++i) {
    const double t = 0.01 * i - 0.003, h = 1e-4;
    const Eigen::MatrixXd before = at(t - h), here = at(t), after = at(t + h);
    // Differences err by h^2 / 6 of the third derivative, here below 200; the curve itself by less.
    CHECK(((after.col(0) - before.col(0)) / (2 * h) - here.col(1)).lpNorm<Eigen::Infinity>() < 1e-6);
    CHECK(((after.col(1) - before.col(1)) / (2 * h) - here.col(2)).lpNorm<Eigen::Infinity>() < 1e-5);
  }
  double x[2], rate[2], acceleration[2];
  CHECK_FALSE(motion.at(-1e-9, x, rate, acceleration));
  CHECK_FALSE(motion.at(2 + 1e-9, x, rate, acceleration));
}

TEST_CASE("a stroke ends the motion when the elliptic integral says, even where the pendulum only just overruns it") {
  const double amplitude = 1.2;
  for (const double lowest : {0.9, -0.3, -1.19, -amplitude + 1e-7}) {
    CAPTURE(lowest);
    const Machine m = pendulum(0, lowest);
    const ForwardMotion motion = forward_dynamics(m, problem({amplitude}, {0}, 5, 501, true));
    CHECK(motion.outcome == Outcome::at_limit);
    // Where it turns back the time shakes with the root of the angle's error.
    CHECK(motion.ended == Approx(time_to(lowest, amplitude)).margin(lowest < -1.195 ? 1e-5 : 5e-9));
    CHECK_THAT(motion.ending, Contains("s: psi (hinge) reaches the lower end of its stroke, "));
    const auto reached = static_cast<Eigen::Index>(std::floor(motion.ended / 0.01)) + 1;
    CHECK(motion.value.topRows(reached).allFinite());
    CHECK_FALSE(motion.value.bottomRows(501 - reached).array().isFinite().any());
    CHECK(std::isnan(motion.energy.back()));
    double q, rate, acceleration;
    REQUIRE(motion.at(motion.ended, &q, &rate, &acceleration));
    CHECK(q == Approx(lowest).margin(1e-8));
    CHECK(q >= lowest - 1e-11);
    CHECK_FALSE(motion.at(motion.ended + 1e-6, &q, &rate, &acceleration));
  }
  const ForwardMotion inside = forward_dynamics(pendulum(0, -amplitude - 1e-7), problem({amplitude}, {0}, 5, 501, true));
  CHECK(inside.ending.empty());
}

TEST_CASE("a joint's limit, the edge of reach and a singular surface end the motion when they are met") {
  // Without gravity it turns evenly: theta = 0.2 + 0.7 t.
  const auto run = [](const Machine& m) { return forward_dynamics(m, problem({0.2}, {0.7}, 10, 11)); };
  const ForwardMotion joint = run(pendulum(0, -10, 1));
  CHECK(joint.outcome == Outcome::at_limit);
  CHECK(joint.ended == Approx(0.8 / 0.7).margin(2e-9));
  CHECK(joint.ending == "ends at t = 1.14286 s: joint O reaches its limit, 57.2958°");

  const ForwardMotion edge = run(pendulum(0, -10, 10, 1.3));
  CHECK(edge.outcome == Outcome::unreachable);
  CHECK(edge.ended == Approx(1.1 / 0.7).margin(2e-9));
  CHECK(edge.ending == "runs out of reach at t = 1.57143 s: beyond it the mechanism cannot be assembled (a wall is in the way)");
  CHECK(edge.value.topRows(2).allFinite());
  CHECK(std::isnan(edge.value(2, 0)));

  const ForwardMotion dead = run(pendulum(1));
  CHECK(dead.outcome == Outcome::singular);
  CHECK(dead.ended == Approx((0.5 * pi - 0.2) / 0.7).margin(5e-9));  // det G is a billionth of that at home 1e-9 rad before
  CHECK(dead.ending == "meets a singular surface at t = 1.95828 s: there the actuators do not hold the platform");
}

TEST_CASE("a yoke's force drives the pendulum by its lever") {
  // Along X with r cos(theta) to the hinge: I theta'' = F r cos(theta), hence I theta'^2 / 2 = F r sin(theta) from rest at 0.
  ForwardProblem p = problem({0}, {0}, 0.4, 41);
  p.actuator_forces = [](double, const std::vector<Scalar>&, double* f) { f[0] = 40; };
  const ForwardMotion motion = forward_dynamics(pendulum(1), p);
  REQUIRE(motion.ending.empty());
  CHECK(motion.value(40, 0) > 0.3);
  for (Eigen::Index i = 0; i < 41; ++i)
    CHECK(0.5 * Pendulum::about_hinge * motion.rate(i, 0) * motion.rate(i, 0) ==
          Approx(40 * Pendulum::radius * std::sin(motion.value(i, 0))).margin(integrated));
}

TEST_CASE("forces may jump, and act for a short time") {
  const Machine m = trolley(0);
  ForwardProblem p = problem({0, 0}, {0, 0}, 2, 3);
  const double from = 0.7654321, width = 0.002;
  p.actuator_forces = [&](double t, const std::vector<Scalar>&, double* f) { f[0] = t >= from && t < from + width ? 7000 : 0, f[1] = 0; };
  const ForwardMotion motion = forward_dynamics(m, p);
  REQUIRE(motion.ending.empty());
  // Each jump is passed in a step of 1e-10 s, with an error of the acceleration of 1000 m/s^2 over it.
  CHECK(motion.rate(2, 0) == Approx(1000 * width).margin(4e-7));
  CHECK(motion.value(2, 0) == Approx(1000 * width * (2 - from - 0.5 * width)).margin(8e-7));
}

TEST_CASE("a motion that cannot go on ends with a reason instead of hanging") {
  const Machine m = trolley(0);
  ForwardProblem p = problem({0, 0}, {0, 0}, 2, 21);
  p.actuator_forces = [](double t, const std::vector<Scalar>&, double* f) { f[0] = std::sqrt(1 - t), f[1] = 0; };
  const ForwardMotion unknown = forward_dynamics(m, p);
  CHECK(unknown.outcome == Outcome::failed);
  CHECK(unknown.ended == Approx(1).margin(1e-9));
  CHECK(unknown.ending == "ends at t = 1 s: the force of drive has no finite value");

  p.actuator_forces = no_forces;
  p.load = [](double t) { return Vector6d(Vector6d::Constant(t < 0.5 ? 0.0 : NAN)); };
  CHECK(forward_dynamics(m, p).ending == "ends at t = 0.5 s: the load has no finite value");
  p.load = nullptr;

  // Dry friction without a slope keeps changing its sign.
  p.start_rate(0) = 0.1;
  p.actuator_forces = [](double, const std::vector<Scalar>& l, double* f) { f[0] = l[0].rate > 0 ? -7.0 : 7.0, f[1] = 0; };
  const ForwardMotion chatter = forward_dynamics(m, p);
  CHECK(chatter.outcome == Outcome::failed);
  CHECK_THAT(chatter.ending, Contains("forces jump to and fro there"));
  CHECK(chatter.ended == Approx(0.1).margin(2e-4));  // it is told when 1/10000 of the motion takes too long

  // x'' = x'^2 leaves every bound at t = 1 / x'(0).
  p.start_rate(0) = 1;
  p.actuator_forces = [](double, const std::vector<Scalar>& l, double* f) { f[0] = 7 * l[0].rate * l[0].rate, f[1] = 0; };
  const ForwardMotion runaway = forward_dynamics(m, p);
  CHECK_FALSE(runaway.ending.empty());
  CHECK(runaway.ended <= 1);
  CHECK(runaway.ended > 0.99);

  p.actuator_forces = no_forces;
  p.evaluations = 100;
  CHECK_THAT(forward_dynamics(m, p).ending, Contains("100 evaluations of the equations of motion lead no farther"));
}

TEST_CASE("a motion that cannot begin is refused") {
  const auto refused = [](const Machine& m, const ForwardProblem& p) -> std::string {
    try {
      (void)forward_dynamics(m, p);
    } catch (const MechanismError& e) {
      return e.status == PM_BAD_ARGUMENT ? e.what() : "broken";
    }
    return "accepted";
  };
  CHECK(refused(pendulum(0, 0.1), problem({0}, {0}, 1, 2)) == "psi (hinge) is 5.72958° beyond the lower end of its stroke, 5.72958°");
  CHECK(refused(pendulum(0, -10, 1), problem({1.5}, {0}, 1, 2)) == "joint O is 28.6479° beyond its limit, 57.2958°");
  CHECK(refused(pendulum(0, -10, 10, 1), problem({1.5}, {0}, 1, 2)) == "the mechanism cannot be assembled there: a wall is in the way");
  CHECK(refused(pendulum(1), problem({0.5 * pi}, {0}, 1, 2)) == "the pose is singular: the actuators do not hold the platform");
  CHECK(refused(test::make(test::arm()), problem({0.2, 0.3, 0}, {0, 0, 0}, 1, 2)) == "nothing that has mass moves with theta");
  ForwardProblem nothing = problem({0}, {0}, 1, 2);
  nothing.actuator_forces = [](double, const std::vector<Scalar>&, double* f) { f[0] = NAN; };
  CHECK(refused(pendulum(), nothing) == "the force of psi has no finite value");
  CHECK(refused(pendulum(0, 0), problem({0}, {1}, 1, 2)) == "accepted");  // a limit met exactly is kept
}
