#include <core/analysis/crossings.hpp>

#include <core/analysis/motion_search.hpp>
#include <core/mechanics/singularity/singularity.hpp>

#include <algorithm>
#include <cmath>

namespace pmreport::analysis {

namespace {

// Of the value at the nearest sample: beside a zero |det G_| is smaller, where the lever of an actuator changes its sign it is as large.
constexpr double small = 1e-3;

class Search {
 public:
  Search(const mechanics::Trajectory& trajectory, const mechanics::Machine& machine, const std::vector<HoldingWrenches>& wrenches,
         double length)
      : t_(trajectory.time), machine_(machine), wrenches_(wrenches), length_(length), motion_(trajectory, machine.dof()) {}

  std::vector<Crossing> run() {
    const int n = static_cast<int>(t_.size());
    for (int k = 0; k < n; ++k) {
      if (!std::isfinite(wrenches_[at(k)].determinant)) continue;
      if (side(k) == 0) {
        int last = k;
        while (last + 1 < n && side(last + 1) == 0 && std::isfinite(wrenches_[at(last + 1)].determinant)) ++last;
        on_the_surface(k, last);
        k = last;
        continue;
      }
      if (k + 1 < n && side(k) * side(k + 1) < 0)
        crosses(k, t_[at(k)], t_[at(k + 1)], side(k));
      else if (k > 0 && k + 1 < n && side(k - 1) == side(k) && side(k + 1) == side(k))
        dips(k);
    }
    return std::move(found_);
  }

 private:
  static std::size_t at(int k) { return static_cast<std::size_t>(k); }
  int side(int k) const { return wrenches_[at(k)].side; }
  int sample_before(double t) const { return static_cast<int>(std::upper_bound(t_.begin(), t_.end(), t) - t_.begin()) - 1; }
  std::optional<mechanics::WrenchDeterminant> wrenches(double t) {
    const Eigen::VectorXd q = motion_.at(t);
    return q.allFinite() ? mechanics::wrench_determinant(machine_, q, length_) : std::nullopt;
  }
  void meet(double time, Crossing::What what, bool touches, double until) {
    found_.push_back({sample_before(time), time, until, motion_.at(time), what, touches});
  }

  // Samples on the surface: a motion that passes through it, or touches it, there, or stays on it.
  void on_the_surface(int first, int last) {
    const int before = first > 0 ? side(first - 1) : 0, after = at(last) + 1 < t_.size() ? side(last + 1) : 0;
    meet(t_[at(first)], Crossing::What::surface, before * after >= 0, t_[at(last)]);
  }

  // One side at `low`, the other at `high`.
  void crosses(int sample, double low, double high, int side_before) {
    // Both ends have a sign that rounding cannot turn over; between them the value as it comes tells the time to its last digits.
    const double when = last_time(low, high, [&](double t) {
      const auto w = wrenches(t);
      return w && w->value * side_before > 0;
    });
    const auto there = wrenches(when);
    const bool zero = !there || std::abs(there->value) < small * std::abs(wrenches_[at(sample)].determinant);
    meet(when, zero ? Crossing::What::surface : Crossing::What::pole, false, when);
  }

  // A least |det G_| among three samples of one side: the surface may lie between them, crossed twice or touched. Differences that are
  // rounding show no minimum.
  void dips(int k) {
    const auto size = [&](int i) { return std::abs(wrenches_[at(i)].determinant); };
    const double left = size(k - 1), middle = size(k), right = size(k + 1);
    if (!(middle <= left && middle < right) || std::max(left, right) - middle <= 1e-9 * middle) return;
    const double lowest = least_time(t_[at(k - 1)], t_[at(k + 1)], [&](double t) {
      const auto w = wrenches(t);
      return w ? w->value * side(k) : std::nan("");
    });
    const auto w = wrenches(lowest);
    if (!w) return;
    if (w->side == -side(k)) {
      crosses(k, t_[at(k - 1)], lowest, side(k));
      crosses(k, lowest, t_[at(k + 1)], -side(k));
    } else if (w->side == 0) {
      meet(lowest, Crossing::What::surface, true, lowest);
    }
  }

  const std::vector<double>& t_;
  const mechanics::Machine& machine_;
  const std::vector<HoldingWrenches>& wrenches_;
  double length_;
  PosesInTime motion_;
  std::vector<Crossing> found_;
};

}  // namespace

std::vector<Crossing> find_crossings(const mechanics::Trajectory& trajectory, const mechanics::Machine& machine,
                                     const std::vector<HoldingWrenches>& wrenches, double length) {
  return Search(trajectory, machine, wrenches, length).run();
}

}  // namespace pmreport::analysis
