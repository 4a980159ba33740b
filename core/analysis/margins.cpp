#include <core/analysis/margins.hpp>

#include <core/analysis/motion_search.hpp>
#include <core/mechanics/singularity/singularity.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace pmreport::analysis {

using mechanics::BodyFreedoms;

namespace {

// Of what a sound pose has of it: a margin that has vanished. Between samples it is found to half the digits of a double.
constexpr double vanished = 1e-7;
// Likewise: a margin is looked at between samples where it is less.
constexpr double low = 0.5;
// Of the whole motion: times found by the least of two margins that vanish together.
constexpr double same_time = 1e-6;
// |det G_| of a pose whose wrenches hold the platform.
constexpr double regular = 1e-6;

constexpr std::array<Crossing::What, BodyFreedoms::count> meaning{Crossing::What::bodies, Crossing::What::freedoms, Crossing::What::limb,
                                                                  Crossing::What::limb_locked};

// Where a margin vanishes. The wrenches on the platform tell of the platform's own loss of control, with its sides; what they tell is left
// to them.
class Losses {
 public:
  Losses(const mechanics::Trajectory& trajectory, const mechanics::Machine& machine, const BodyFreedoms& freedoms, const Margins& margins,
         double length)
      : t_(trajectory.time),
        machine_(machine),
        freedoms_(freedoms),
        margins_(margins),
        length_(length),
        motion_(trajectory, machine.dof()) {}

  std::vector<Crossing> of(BodyFreedoms::Margin which) {
    const double sound = std::min(1.0, margins_.sound[which]);
    const auto clamped = [&](double x) { return x < vanished * sound ? 0.0 : x; };
    const auto value = [&](std::size_t k) { return clamped(margins_.at_sample[k][which]); };
    std::vector<Crossing> out;
    for (std::size_t k = 0; k < t_.size(); ++k) {
      if (!(value(k) < low * sound)) continue;
      // The last sample of a run of equals speaks for it. No minimum, or the edge of poses that cannot be assembled, which are told as
      // such.
      const double right = k + 1 < t_.size() ? value(k + 1) : INFINITY;
      std::size_t first = k;
      while (first > 0 && value(first - 1) == value(k)) --first;
      const double left = first > 0 ? value(first - 1) : INFINITY;
      if (!(value(k) <= left && value(k) < right)) continue;
      double when = t_[first], until = t_[k];
      if (value(k) > 0) {
        when = until = least_time(first > 0 ? t_[first - 1] : t_[first], k + 1 < t_.size() ? t_[k + 1] : t_[k],
                                  [&](double t) { return clamped(at(t)[which]); });
        if (!(clamped(at(when)[which]) == 0)) continue;
      }
      const auto w = mechanics::wrench_determinant(machine_, motion_.at(when), length_);
      if (which != BodyFreedoms::limb && w && !(std::abs(w->value) > regular)) continue;
      const auto before = static_cast<int>(std::upper_bound(t_.begin(), t_.end(), when) - t_.begin()) - 1;
      out.push_back({before, when, until, motion_.at(when), meaning[which], true});
    }
    return out;
  }

 private:
  BodyFreedoms::Margins at(double t) {
    const Eigen::VectorXd q = motion_.at(t);
    if (q.allFinite()) return freedoms_.at(q);
    BodyFreedoms::Margins none;
    none.fill(std::nan(""));
    return none;
  }

  const std::vector<double>& t_;
  const mechanics::Machine& machine_;
  const BodyFreedoms& freedoms_;
  const Margins& margins_;
  double length_;
  PosesInTime motion_;
};

}  // namespace

Margins follow_margins(const mechanics::Trajectory& trajectory, const mechanics::Machine& machine, double length) {
  const BodyFreedoms freedoms(machine);
  const std::vector<double>& t = trajectory.time;
  const std::size_t n = t.size();
  Margins out;
  const auto home = mechanics::wrench_determinant(machine, machine.home(), length);
  out.home_is_singular = home && home->side == 0;
  out.at_sample.resize(n);
  std::vector<std::optional<mechanics::EndOfReach>> ends(n);
  std::vector<std::optional<mechanics::ChartFault>> faults(n);
  tbb::parallel_for(std::size_t{0}, n, [&](std::size_t k) {
    const Eigen::VectorXd q = trajectory.value.row(static_cast<Eigen::Index>(k));
    out.at_sample[k].fill(std::nan(""));
    if (!q.allFinite()) return;
    out.at_sample[k] = freedoms.at(q);
    ends[k] = mechanics::end_of_reach(machine, q, length);
    faults[k] = mechanics::chart_fault(machine, q, length);
  });
  // Home alone may be singular itself.
  out.sound = freedoms.at_home();
  for (std::size_t which = 0; which < out.sound.size(); ++which)
    if (!(out.sound[which] > 1e-6))
      for (const BodyFreedoms::Margins& m : out.at_sample)
        if (std::isfinite(m[which])) out.sound[which] = std::max(out.sound[which], m[which]);
  Losses losses(trajectory, machine, freedoms, out, length);
  for (const auto which : {BodyFreedoms::locked, BodyFreedoms::free, BodyFreedoms::limb, BodyFreedoms::limb_locked})
    std::ranges::copy(losses.of(which), std::back_inserter(out.losses));
  // A freedom that no actuator has a say in is one with all actuators locked as well: one loss, told once.
  std::erase_if(out.losses, [&, all = out.losses](const Crossing& c) {
    return c.what == Crossing::What::bodies && std::ranges::any_of(all, [&](const Crossing& other) {
             return other.what == Crossing::What::freedoms && std::abs(other.time - c.time) < same_time * (t.back() - t.front());
           });
  });
  for (std::size_t k = 0; k < n; ++k) {
    const int sample = static_cast<int>(k);
    if (ends[k] && (!out.end_of_reach || ends[k]->distance < out.end_of_reach->end.distance)) out.end_of_reach = {*ends[k], sample};
    if (!faults[k]) continue;
    const int samples = (out.chart ? out.chart->samples : 0) + 1;
    if (!out.chart || faults[k]->quality < out.chart->fault.quality) out.chart = {*faults[k], sample, samples};
    out.chart->samples = samples;
  }
  return out;
}

}  // namespace pmreport::analysis
