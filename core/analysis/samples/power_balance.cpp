#include <core/analysis/samples/power_balance.hpp>

#include <core/analysis/samples/evenly.hpp>
#include <core/analysis/samples/motion_probe.hpp>
#include <core/analysis/samples/smooth_rate.hpp>
#include <core/analysis/samples/stretch.hpp>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pmreport::analysis {

void balance_power(const mechanics::Trajectory& trajectory, const scenario::Load& load, const mechanics::Machine& machine,
                   MotionAnswers& answers) {
  constexpr std::size_t wanted = 64;
  constexpr double smooth = 1e-9;   // change of the rate that is called none, relative as the measure is
  constexpr double room = 1.0 / 8;  // to either end of a stretch, of its length, that differences need
  const ColumnStore& columns = answers.columns;
  std::vector<ColumnId> powers{column_of(OfMachine::load_power)};
  for (const Actuator& a : machine.topology().actuators) powers.push_back(column_of(a, OfActuator::power));
  const double largest_power = columns.largest(powers);
  const std::vector<double> knots = knots_along(trajectory, load);
  std::vector<std::size_t> good;
  for (std::size_t k = 0; k < answers.samples(); ++k)
    if (answers.outcomes[k] == mechanics::Outcome::good) good.push_back(k);
  const std::vector<std::size_t> chosen = evenly(good, wanted);

  std::vector<Row> rows(chosen.size());
  tbb::enumerable_thread_specific<MotionProbe> probes([&] { return MotionProbe(trajectory, load, machine); });
  tbb::parallel_for(std::size_t{0}, chosen.size(), [&](std::size_t i) {
    const std::size_t k = chosen[i];
    double power = columns[column_of(OfMachine::total_power)][k] + columns[column_of(OfMachine::load_power)][k];
    if (!std::isfinite(power) || !answers.wrenches[k].are_comparable()) return;
    MotionProbe& probe = probes.local();
    const double first = trajectory.time.front(), last = trajectory.time.back();
    double t = trajectory.time[k];
    const auto [begin, end] = stretch_at(knots, t, first, last);
    const double margin = room * (end - begin);
    if ((begin > first && t - begin < margin) || (end < last && end - t < margin)) {
      t = 0.5 * (begin + end);
      if (!probe.go(t)) return;
      std::vector<double> there;
      probe.powers(there);
      power = std::accumulate(there.begin(), there.end(), 0.0);
    }
    const auto energy = [&](double x) { return probe.go(x) ? probe.energy() : std::numeric_limits<double>::quiet_NaN(); };
    const auto rate = smooth_rate(energy, t, begin, end);
    if (!rate) return;
    const double scale = std::max(largest_power, std::abs(rate->value)), deviation = std::abs(power - rate->value);
    if (rate->change <= smooth * scale) set(rows[i], Measure::power_balance, relative(deviation, scale));
  });
  for (std::size_t i = 0; i < chosen.size(); ++i) answers.residuals.add(static_cast<int>(chosen[i]), rows[i]);
}

}  // namespace pmreport::analysis
