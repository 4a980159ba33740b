// Forces in motion, of every sample: columns of the sections dynamics, drives and reactions, and their residuals.
#include <core/analysis/analysis.hpp>
#include <core/analysis/conditioning.hpp>
#include <core/analysis/samples/motion_probe.hpp>
#include <core/analysis/samples/sample_forces.hpp>
#include <core/analysis/samples/smooth_rate.hpp>
#include <core/analysis/samples/stretch.hpp>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pmreport::analysis {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// As many of the samples that have forces, spread evenly, the ends left out.
std::vector<int> spread(const Analysis& a, int wanted) {
  std::vector<int> good, out;
  for (int k = 0; k < a.samples(); ++k)
    if (a.outcome(k) == Outcome::good) good.push_back(k);
  const int n = static_cast<int>(good.size()), count = std::min(n, wanted);
  for (int i = 0; i < count; ++i) out.push_back(good[static_cast<std::size_t>((i + 0.5) * n / count)]);
  return out;
}

}  // namespace

void Analysis::add_force_columns() {
  const Topology& t = machine_.topology();
  const auto add = [&](ColumnList* list, auto&& wanted) {
    for (const Column& c : list(t))
      if (wanted(c)) columns_.add(c, time().size());
  };
  const auto all = [](const Column&) { return true; };
  add(dynamics_columns, all);
  if (asked_.drives) {
    add(drive_columns, [&](const Column& c) {
      for (std::size_t i = 0; i < t.actuators.size(); ++i)
        if (of_motor(t.actuators[i], c)) return i < scenario_.drives.size() && scenario_.drives[i].ratio > 0;
      return true;
    });
  }
  if (asked_.reactions) add(reaction_columns, all);
}

void Analysis::run_dynamics(const Progress& progress) {
  const Topology& t = machine_.topology();
  add_force_columns();
  const ForceColumns columns(t, [&](const ColumnId& id) { return columns_.find(id); });

  std::vector<SampleForces::Order> orders;
  const std::vector<int> judged = spread(*this, 16);
  for (int k = 0; k < samples(); ++k)
    if (outcome(k) == Outcome::good)
      orders.push_back({k, wrenches(k).are_comparable(), std::binary_search(judged.begin(), judged.end(), k)});

  const mechanics::JointFrames frames(machine_);
  tbb::enumerable_thread_specific<SampleForces> workers([&] {
    return SampleForces(trajectory_, scenario_.load, scenario_.drives, machine_, frames, length_, columns, asked_.force_evidence);
  });
  // Chunks that always begin at the same samples, so that no number depends on the threads; blocks of them, so that a request to stop is
  // heard in time.
  constexpr std::size_t chunk = 64, block = 64 * chunk;
  for (std::size_t begin = 0; begin < orders.size(); begin += block) {
    progress.stop_if_asked();
    const std::size_t end = std::min(orders.size(), begin + block);
    tbb::parallel_for(std::size_t{0}, (end - begin + chunk - 1) / chunk, [&](std::size_t i) {
      const std::size_t first = begin + i * chunk;
      workers.local().run(std::span(orders).subspan(first, std::min(chunk, end - first)), residuals_);
    });
  }
  indeterminate_.assign(t.joints.size(), 0);
  elastic_.settled.assign(t.joints.size(), 0);
  for (const SampleForces& worker : workers) {
    elastic_.join(worker.elastic());
    self_stresses_ = std::max(self_stresses_, worker.self_stresses());
    for (std::size_t j = 0; j < indeterminate_.size(); ++j)
      indeterminate_[j] = static_cast<Indeterminate>(indeterminate_[j] | worker.indeterminate()[j]);
  }
  if (asked_.power_evidence) balance_power();
}

// The power of actuators and load against the rate of the energy, which comes from positions and velocities along the motion around a
// sample: no acceleration and no force enters it. Differences never straddle a knot; a sample that lies on one, or close to it, is
// represented by the middle of the stretch that begins there. Where the energy is not smooth even so, differences tell nothing, and the
// sample is left out.
void Analysis::balance_power() {
  constexpr int wanted = 64;
  constexpr double smooth = 1e-9;   // change of the rate that is called none, relative as the measure is
  constexpr double room = 1.0 / 8;  // to either end of a stretch, of its length, that differences need
  std::vector<ColumnId> powers{column_of(OfMachine::load_power)};
  for (const Actuator& a : machine_.topology().actuators) powers.push_back(column_of(a, OfActuator::power));
  const double largest_power = largest(powers);
  const std::vector<double> knots = knots_along(trajectory_, scenario_.load);
  const double first = time().front(), last = time().back();

  const std::vector<int> chosen = spread(*this, wanted);
  tbb::enumerable_thread_specific<MotionProbe> probes([&] { return MotionProbe(trajectory_, scenario_.load, machine_); });
  tbb::parallel_for(std::size_t{0}, chosen.size(), [&](std::size_t i) {
    const auto k = static_cast<std::size_t>(chosen[i]);
    double power = column(column_of(OfMachine::total_power))[k] + column(column_of(OfMachine::load_power))[k];
    if (!std::isfinite(power) || !wrenches(chosen[i]).are_comparable()) return;
    MotionProbe& probe = probes.local();
    double t = time()[k];
    const auto [begin, end] = stretch_at(knots, t, first, last);
    const double margin = room * (end - begin);
    if ((begin > first && t - begin < margin) || (end < last && end - t < margin)) {
      t = 0.5 * (begin + end);
      if (!probe.go(t)) return;
      std::vector<double> there;
      probe.powers(there);
      power = std::accumulate(there.begin(), there.end(), 0.0);
    }
    const auto rate = smooth_rate([&](double x) { return probe.go(x) ? probe.energy() : nan; }, t, begin, end);
    if (!rate) return;
    const double scale = std::max(largest_power, std::abs(rate->value)), deviation = std::abs(power - rate->value);
    if (rate->change <= smooth * scale) set(residuals_[k], Measure::power_balance, relative(deviation, scale));
  });
}

}  // namespace pmreport::analysis
