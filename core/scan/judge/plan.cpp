#include <core/program/batch.hpp>
#include <core/scan/judge/plan.hpp>
#include <core/scan/judge/stages.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace pmreport::scan {

namespace {

constexpr std::size_t looked_at = 16384;  // poses of the range that the order of margins and the weights are taken from

void demand_fit(const PoseSet& set, const Scan& scan, const program::Program* sign) {
  const auto refuse = [](const std::string& why) { throw std::invalid_argument(why); };
  const std::size_t inputs = static_cast<std::size_t>(set.margins.inputs());
  if (set.margins.outputs().empty()) refuse("a set of poses has at least one margin, the reach; this one has none");
  if (set.rounding.size() != set.size())
    refuse(fmt::format("{} margins have {} numbers for their rounding; each needs one", set.size(), set.rounding.size()));
  if (scan.at.size() != inputs) refuse(fmt::format("a scan has values for {} coordinates, the margins are of {}", scan.at.size(), inputs));
  if (inputs > 64) refuse(fmt::format("{} coordinates; no more than 64 can be scanned", inputs));
  if (sign != nullptr && (sign->inputs() != set.margins.inputs() || sign->outputs().size() != 1))
    refuse("the sign is to be one number, of the same coordinates as the margins");
  std::vector<int> used = scan.turned;
  for (const Axis& a : scan.points) used.push_back(a.input);
  std::sort(used.begin(), used.end());
  if (!used.empty() && (used.front() < 0 || static_cast<std::size_t>(used.back()) >= inputs))
    refuse(fmt::format("a scan moves a coordinate that the margins do not have; they have {}", inputs));
  if (std::adjacent_find(used.begin(), used.end()) != used.end()) refuse("a scan moves a coordinate twice; each moves once");
  for (const std::vector<double>& o : scan.orientations)
    if (o.size() != scan.turned.size())
      refuse(fmt::format("an orientation has {} values for {} coordinates", o.size(), scan.turned.size()));
}

// Places of poses in the range, spread evenly: multiples of irrational numbers, less their whole parts.
class Spread {
 public:
  Spread(const Scan& scan, std::size_t count) : scan_(scan), count_(count) {}

  // Coordinates of all poses, input after input. `moved`: the axis that has other values than without, the number of axes for the
  // orientation; -1: none.
  std::vector<double> poses(int moved) const {
    std::vector<double> out(scan_.at.size() * count_);
    for (std::size_t i = 0; i < scan_.at.size(); ++i)
      std::fill_n(out.begin() + static_cast<std::ptrdiff_t>(i * count_), count_, scan_.at[i]);
    const std::size_t axes = scan_.points.size();
    for (std::size_t a = 0; a < axes; ++a) {
      const Axis& axis = scan_.points[a];
      for (std::size_t k = 0; k < count_; ++k)
        out[static_cast<std::size_t>(axis.input) * count_ + k] = axis.from + (axis.to - axis.from) * share(a, k, moved);
    }
    if (scan_.orientations.empty()) return out;
    for (std::size_t k = 0; k < count_; ++k) {
      const auto n = static_cast<std::size_t>(share(axes, k, moved) * static_cast<double>(scan_.orientations.size()));
      for (std::size_t i = 0; i < scan_.turned.size(); ++i)
        out[static_cast<std::size_t>(scan_.turned[i]) * count_ + k] = scan_.orientations[n][i];
    }
    return out;
  }

 private:
  static double share(std::size_t axis, std::size_t k, int moved) {
    const double step = std::sqrt(static_cast<double>(primes[axis % std::size(primes)]));
    const double x = step * static_cast<double>(k + 1) + (static_cast<int>(axis) == moved ? 0.381966 : 0.0);
    return x - std::floor(x);
  }
  static constexpr int primes[] = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37};

  const Scan& scan_;
  std::size_t count_;
};

std::vector<double> margins_of(const PoseSet& set, const std::vector<double>& poses) {
  std::vector<double> out(set.margins.outputs().size() * looked_at);
  program::Batch(set.margins).run(looked_at, poses.data(), out.data());
  return out;
}

// Mean change of each margin in its own spread, summed over margins.
double change(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t start = 0; start < a.size(); start += looked_at) {
    double difference = 0, size = 0;
    for (std::size_t k = start; k < start + looked_at; ++k) {
      if (!std::isfinite(a[k]) || !std::isfinite(b[k])) continue;
      difference += std::abs(a[k] - b[k]);
      size += std::abs(a[k]);
    }
    if (size > 0) sum += difference / size;
  }
  return sum;
}

}  // namespace

Plan::Plan(const PoseSet& of_set, const Scan& of_scan, bool with_reasons, const program::Program* sign_program)
    : set(of_set), scan(of_scan), reasons(with_reasons), margins(of_set.margins.outputs().size()) {
  demand_fit(set, scan, sign_program);
  for (const Axis& a : scan.points) point_inputs |= std::uint64_t{1} << a.input;
  for (const Axis& a : scan.points) slots.push_back(slot_of(a.input));

  program::Split two = program::split(sign_program != nullptr ? program::joined(set.margins, *sign_program) : set.margins, point_inputs);
  outer = std::move(two.outer);
  inner = std::move(two.inner);
  if (sign_program != nullptr) {
    const int last = static_cast<int>(margins);
    sign = inner.slice(std::span(&last, 1));
  }

  const Spread spread(scan, looked_at);
  const std::vector<double> seen = margins_of(set, spread.poses(-1));
  for (std::size_t a = 0; a <= scan.points.size(); ++a) weights.push_back(change(seen, margins_of(set, spread.poses(static_cast<int>(a)))));

  stage_of.resize(margins);
  const auto groups = reasons ? stages_in_order(inner, margins) : stages_by_yield(inner, margins, set.rounding, seen);
  for (const std::vector<int>& group : groups) {
    Stage stage{group, inner.slice(group), {}};
    for (const int m : group) {
      stage.slack.push_back(set.rounding[static_cast<std::size_t>(m)]);
      stage_of[static_cast<std::size_t>(m)] = static_cast<int>(stages.size());
    }
    stages.push_back(std::move(stage));
  }
}

}  // namespace pmreport::scan
