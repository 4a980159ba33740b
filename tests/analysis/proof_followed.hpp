// Mechanisms that follow sines of their actuators, with what is known of these: their bounds over a span of time, and in extended precision
// where the coordinates are at an instant.
#pragma once

#include <core/analysis/proof/followed.hpp>

#include <core/mechanics/trajectory/followed.hpp>
#include <core/program/evaluate.hpp>
#include <pmreport/jet.hpp>
#include <pmreport/partials.hpp>

#include <Eigen/LU>
#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <random>

namespace trial {

using namespace pmreport;
using analysis::FollowedProof, analysis::prove_followed;
using mechanics::Bounded, mechanics::Enclosure, mechanics::Machine, mechanics::Trajectory, program::Bounds;
using Extended = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

// Of an actuator: mean + amplitude sin(frequency t), or `folded`, mean + amplitude |sin(frequency t)|, whose rate jumps.
struct Sine {
  double mean = 0, amplitude = 0, frequency = 0;
  bool folded = false;

  // k-th derivative.
  long double at(long double t, int k) const {
    const long double phase = frequency * t, sine = std::sin(phase);
    const long double wave = k == 0 ? sine : k == 1 ? std::cos(phase) : -sine;
    return (k == 0 ? mean : 0) + amplitude * std::pow(static_cast<long double>(frequency), k) * (folded && sine < 0 ? -wave : wave);
  }
  // Least and greatest at an end, or at an extreme within.
  Bounds over(Bounds t, int k) const {
    const Sine wave{0, amplitude, frequency, false};
    const auto exactly = [&](long double time) { return Bounds::exactly(static_cast<double>(wave.at(time, k))); };
    Bounds out = hull(exactly(t.low), exactly(t.high));
    const double quarter = std::numbers::pi / 2;
    bool meets_fold = false;
    for (double n = std::ceil(frequency * t.low / quarter - 1e-9); n <= frequency * t.high / quarter + 1e-9; ++n) {
      const bool even = std::fmod(n, 2) == 0;
      if (even == (k == 1)) out = hull(out, exactly(n * quarter / frequency));
      meets_fold = meets_fold || even;
    }
    if (folded) {
      const Bounds turned{-out.high, -out.low};
      out = meets_fold ? hull(out, turned) : std::sin(frequency * t.middle()) < 0 ? turned : out;
    }
    // More than what the phase is rounded by, and the sum.
    const double rounding = 1e-15 * (std::abs(mean) + std::abs(amplitude) * (1 + frequency * frequency)), shift = k == 0 ? mean : 0;
    return {out.low + shift - rounding, out.high + shift + rounding};
  }
};

struct Sines {
  std::vector<Sine> of;

  mechanics::Path path() const {
    return [of = of](double t, double* value, double* rate, double* acceleration) {
      for (std::size_t i = 0; i < of.size(); ++i) {
        value[i] = static_cast<double>(of[i].at(t, 0));
        rate[i] = static_cast<double>(of[i].at(t, 1));
        acceleration[i] = static_cast<double>(of[i].at(t, 2));
      }
      return true;
    };
  }
  Enclosure over() const {
    return [of = of](Bounds t, Bounded* out) {
      for (std::size_t i = 0; i < of.size(); ++i) out[i] = {of[i].over(t, 0), of[i].over(t, 1), of[i].over(t, 2)};
      return true;
    };
  }
  Extended at(long double t, int k) const {
    Extended out(static_cast<Eigen::Index>(of.size()));
    for (std::size_t i = 0; i < of.size(); ++i) out(static_cast<Eigen::Index>(i)) = of[i].at(t, k);
    return out;
  }
};

inline std::vector<double> even(double end, int samples) {
  std::vector<double> out;
  for (int k = 0; k < samples; ++k) out.push_back(end * k / (samples - 1));
  return out;
}

// Coordinates, rates and accelerations at an instant, by Newton's method in extended precision on the recorded geometry with partials and
// jets: nothing of core/program/derivative.hpp.
struct Exact {
  Extended value, rate, acceleration;
};
class Oracle {
 public:
  Oracle(const Machine& machine, const Sines& sines) : dof_(machine.dof()), sines_(sines) {
    const program::Program* geometry = machine.program();
    REQUIRE(geometry != nullptr);
    std::vector<int> outputs;
    for (int i = 0; i < dof_; ++i) outputs.push_back(static_cast<int>(machine.layout().actuator(0)) + i);
    program_ = geometry->slice(outputs);
  }

  Exact at(double t, const Eigen::VectorXd& nearby) const {
    using Partial = Partials<long double, 6>;
    using Taylor = Jet<long double>;
    const auto m = static_cast<std::size_t>(dof_);
    Exact out{nearby.cast<long double>(), {}, {}};
    Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic> jacobian(dof_, dof_);
    Extended error(dof_);
    const Extended wanted = sines_.at(t, 0);
    program::Evaluator<Partial> partials(program_);
    std::vector<Partial> in(m), l(m);
    for (int round = 0; round < 8; ++round) {
      for (int i = 0; i < dof_; ++i) in[static_cast<std::size_t>(i)] = Partial::variable(out.value(i), i);
      partials.run(in, l);
      for (int i = 0; i < dof_; ++i) {
        error(i) = wanted(i) - l[static_cast<std::size_t>(i)].value;
        for (int j = 0; j < dof_; ++j) jacobian(i, j) = l[static_cast<std::size_t>(i)].partial[static_cast<std::size_t>(j)];
      }
      if (round < 7) out.value += jacobian.partialPivLu().solve(error);
    }
    REQUIRE(static_cast<double>(error.cwiseAbs().maxCoeff()) < 1e-17);  // so much closer than any bounds are
    out.rate = jacobian.partialPivLu().solve(sines_.at(t, 1));
    program::Evaluator<Taylor> taylor(program_);
    std::vector<Taylor> along(m), moved(m);
    for (int i = 0; i < dof_; ++i) along[static_cast<std::size_t>(i)] = Taylor(out.value(i), out.rate(i), 0.0L);
    taylor.run(along, moved);
    Extended left = sines_.at(t, 2);
    for (int i = 0; i < dof_; ++i) left(i) -= moved[static_cast<std::size_t>(i)].acceleration;
    out.acceleration = jacobian.partialPivLu().solve(left);
    return out;
  }

 private:
  int dof_;
  Sines sines_;
  program::Program program_;
};

// A motion of a mechanism, followed from its home.
struct Followed {
  Followed(const Machine& m, Sines law, double end, int samples = 501) : Followed(m, std::move(law), end, samples, m.home()) {}
  Followed(const Machine& m, Sines law, double end, int samples, const Eigen::VectorXd& start)
      : machine(m), sines(std::move(law)), oracle(m, sines) {
    trajectory = mechanics::followed(m, sines.path(), even(end, samples), start).trajectory;
    for (const Sine& s : sines.of)
      for (int n = 1; s.folded && n * std::numbers::pi / s.frequency < end; ++n) {
        trajectory.knots.push_back(n * std::numbers::pi / s.frequency);
        trajectory.breaks.push_back({mechanics::Break::Of::rate, "an actuator", "m", trajectory.knots.back(), 0});
      }
    std::ranges::sort(trajectory.knots);
  }

  FollowedProof proof(const analysis::FollowedOptions& options = {}) const {
    return prove_followed(machine, trajectory, sines.over(), options);
  }
  Eigen::VectorXd at(double t) const {
    Eigen::VectorXd q(machine.dof()), rate(machine.dof()), acceleration(machine.dof());
    REQUIRE(trajectory.at(t, q.data(), rate.data(), acceleration.data()));
    return q;
  }

  const Machine& machine;
  Sines sines;
  Oracle oracle;
  Trajectory trajectory;
};

// How many values, rates and accelerations at random instants lie outside the bounds of random spans around them, of all widths.
struct Outside {
  int value = 0, rate = 0, acceleration = 0, looked_at = 0;
  int all() const { return value + rate + acceleration; }
};
inline Outside outside(const Followed& motion, const Enclosure& over, Bounds proved, int spans, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto m = static_cast<std::size_t>(motion.machine.dof());
  Outside out;
  for (int k = 0; k < spans; ++k) {
    const double t = proved.low + proved.width() * uniform(random), half = proved.width() * std::pow(10, -7 * uniform(random));
    const Bounds span{std::max(proved.low, t - half * uniform(random)), std::min(proved.high, t + half * uniform(random))};
    std::vector<Bounded> b(m);
    REQUIRE(over(span, b.data()));
    const Exact exact = motion.oracle.at(t, motion.at(t));
    for (std::size_t i = 0; i < m; ++i) {
      const auto misses = [&](const Bounds& x, const Extended& of) {
        const long double number = of(static_cast<Eigen::Index>(i));
        return !x.bounded() || number < x.low || number > x.high;
      };
      out.value += misses(b[i].value, exact.value);
      out.rate += misses(b[i].rate, exact.rate);
      out.acceleration += misses(b[i].acceleration, exact.acceleration);
      ++out.looked_at;
    }
  }
  return out;
}

}  // namespace trial
