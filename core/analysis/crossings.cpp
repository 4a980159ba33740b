#include <core/analysis/crossings.hpp>

#include <core/analysis/conditioning.hpp>
#include <core/mechanics/singularity/singularity.hpp>

#include <cmath>
#include <numbers>

namespace pmreport::analysis {

namespace {

// det G along the motion, dimensionless. A sample's own value is that of its column, so that both tell the same sign.
class Along {
 public:
  Along(const mechanics::Trajectory& motion, const mechanics::Machine& machine, double length)
      : motion_(motion), machine_(machine), length_(length), unused_(machine.dof()) {}

  Eigen::VectorXd at(double t) {
    Eigen::VectorXd q(machine_.dof());
    if (!motion_.at || !motion_.at(t, q.data(), unused_.data(), unused_.data())) q.setConstant(std::nan(""));
    return q;
  }
  double det(double t) {
    const Eigen::VectorXd q = at(t);
    return q.allFinite() ? mechanics::dimensionless_determinant(machine_, q, length_) : std::nan("");
  }

  // From a sign at `low` to the other at `high`: halved until the two are neighbours, or a pose between them cannot be assembled.
  double zero(double low, double high, double at_low) {
    for (int k = 0; k < 200; ++k) {
      const double middle = 0.5 * (low + high);
      if (!(middle > low && middle < high)) break;
      const double value = det(middle);
      if (std::isnan(value)) break;
      (value * at_low > 0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  // Golden section for the least `sign` det in [low, high]; stops early where the sign has changed.
  double least(double low, double high, double sign) {
    constexpr double share = 1 / std::numbers::phi;
    double a = high - share * (high - low), b = low + share * (high - low), at_a = sign * det(a), at_b = sign * det(b);
    while (high - low > 1e-9 * std::abs(high) && at_a > 0 && at_b > 0) {
      if (at_a < at_b) {
        high = b, b = a, at_b = at_a;
        a = high - share * (high - low), at_a = sign * det(a);
      } else {
        low = a, a = b, at_a = at_b;
        b = low + share * (high - low), at_b = sign * det(b);
      }
    }
    return at_a < at_b ? a : b;
  }

 private:
  const mechanics::Trajectory& motion_;
  const mechanics::Machine& machine_;
  double length_;
  Eigen::VectorXd unused_;
};

}  // namespace

std::vector<Crossing> find_crossings(const mechanics::Trajectory& trajectory, const mechanics::Machine& machine,
                                     const std::vector<double>& determinant, const mechanics::Mobility& mobility, double length) {
  const std::vector<double>&d = determinant, &t = trajectory.time;
  Along motion(trajectory, machine, length);
  std::vector<Crossing> crossings;
  const auto meet = [&](std::size_t before, double when, bool touches) {
    // Beside a zero det G is smaller than at the samples, beside a pole larger.
    const double beside = std::abs(motion.det(when)), at_sample = std::abs(motion.det(t[before]));
    crossings.push_back({static_cast<int>(before), when, motion.at(when), touches, !(beside <= at_sample)});
  };
  for (std::size_t k = 0; k + 1 < d.size(); ++k) {
    if (d[k] * d[k + 1] < 0) {
      meet(k, motion.zero(t[k], t[k + 1], d[k]), false);
      continue;
    }
    // A least |det G| among three samples of one sign: the surface may lie between them, crossed twice or touched. Differences that are
    // rounding show no minimum.
    if (k == 0 || !(d[k] * d[k - 1] > 0) || !(d[k] * d[k + 1] > 0)) continue;
    const double left = std::abs(d[k - 1]), middle = std::abs(d[k]), right = std::abs(d[k + 1]);
    if (!(middle <= left && middle <= right) || std::max(left, right) - middle <= 1e-9 * middle) continue;
    const double sign = d[k] > 0 ? 1 : -1, lowest = motion.least(t[k - 1], t[k + 1], sign), value = sign * motion.det(lowest);
    if (value < 0) {
      const double in = motion.zero(t[k - 1], lowest, d[k]), out = motion.zero(lowest, t[k + 1], -d[k]);
      meet(in < t[k] ? k - 1 : k, in, false);
      meet(out < t[k] ? k - 1 : k, out, false);
    } else {
      const std::optional<mechanics::Singularity> s = mechanics::singularity_at(machine, motion.at(lowest), mobility, length);
      if (s && s->conditioning.condition() > singular) meet(lowest < t[k] ? k - 1 : k, lowest, true);
    }
  }
  return crossings;
}

}  // namespace pmreport::analysis
