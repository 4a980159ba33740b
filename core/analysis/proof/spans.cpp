#include <core/analysis/proof/spans.hpp>

#include <core/analysis/proof/sharpen.hpp>
#include <core/linear/square.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/model/overall_jacobian.hpp>

#include <algorithm>
#include <cmath>

namespace pmreport::analysis {

namespace {

constexpr std::size_t block = 64;  // spans at a time

bool all_bounded(std::span<const Bounds> x) { return std::ranges::all_of(x, &Bounds::bounded); }

// Bounds that hold nothing, or are no numbers, tell nothing.
Bounds sane(const Bounds& x) { return x.low <= x.high ? x : Bounds{}; }

linear::Matrix6d middle_of(std::span<const Bounds, 36> wrenches) {
  linear::Matrix6d out;
  for (std::size_t e = 0; e < 36; ++e) out(static_cast<Eigen::Index>(e / 6), static_cast<Eigen::Index>(e % 6)) = wrenches[e].middle();
  return out;
}

}  // namespace

Spans::Spans(const mechanics::Machine& machine, const mechanics::MotionProgram& program, const program::Program& moving,
             const Quantities& quantities, const mechanics::Enclosure& motion)
    : machine_(machine),
      quantities_(quantities),
      motion_(motion),
      dof_(static_cast<std::size_t>(machine.dof())),
      placed_(machine.layout().size()),
      wrenches_(program.wrenches),
      length_(characteristic_length(machine)),
      per_length_(std::exp2(std::round(-std::log2(length_)))),
      whole_{timed(moving, Look::whole, false), timed(moving, Look::whole, true)},
      lean_{timed(moving, Look::quantities, false), timed(moving, Look::quantities, true)},
      moved_(dof_) {}

// `moving` has the mechanism's outputs, their rates and their accelerations. Of the quantities all that is followed is taken; over spans
// also the rates by which joints, and with all of the outputs reach and G, become sharp.
Spans::Timed Spans::timed(const program::Program& moving, Look look, bool all_rates) const {
  const std::size_t n = moving.outputs().size() / 3;
  const bool whole = look == Look::whole;
  Places of;
  std::vector<int> outputs;
  const auto take = [&](std::vector<int>& place, std::size_t output, std::size_t order) {
    if (place[output] >= 0) return;
    place[output] = static_cast<int>(outputs.size());
    outputs.push_back(static_cast<int>(order * n + output));
  };
  for (std::vector<int>* place : {&of.value, &of.rate, &of.acceleration}) place->assign(n, -1);
  for (std::size_t o = 0; whole && o < n; ++o) take(of.value, o, 0);
  for (const Quantity& q : quantities_.all) {
    if (q.of == Quantity::Of::coordinate || (q.of == Quantity::Of::reach && !whole)) continue;
    take(of.value, q.output, 0);
    const bool moves = q.of == Quantity::Of::derived || q.of == Quantity::Of::actuator;
    if (moves || all_rates) take(of.rate, q.output, 1);
    if (moves) take(of.acceleration, q.output, 2);  // by which rates become sharp
  }
  for (std::size_t e = 0; whole && all_rates && e < 36; ++e) take(of.rate, wrenches_ + e, 1);
  return {std::move(of), outputs.size(), program::Boxes(moving.slice(outputs))};
}

// Of so many spans: inputs are coordinates, rates, accelerations. Where nothing is known of the motion, nothing is known.
void Spans::run(Timed& timed, std::size_t count, auto&& time_of) {
  in_.resize(3 * dof_ * count);
  out_.resize(timed.outputs * count);
  for (std::size_t k = 0; k < count; ++k) {
    const bool known = motion_(time_of(k), moved_.data());
    for (std::size_t i = 0; i < dof_; ++i) {
      in_[i * count + k] = known ? sane(moved_[i].value) : Bounds{};
      in_[(dof_ + i) * count + k] = known ? sane(moved_[i].rate) : Bounds{};
      in_[(2 * dof_ + i) * count + k] = known ? sane(moved_[i].acceleration) : Bounds{};
    }
  }
  timed.boxes.run(count, in_.data(), out_.data());
  evaluations_ += static_cast<long>(count);
}

// Of the k-th span of so many: whether all that places the mechanism is bounded.
bool Spans::placed(const Places& of, std::size_t k, std::size_t count) const {
  for (std::size_t o = 0; o < placed_; ++o)
    if (!out_[static_cast<std::size_t>(of.value[o]) * count + k].bounded()) return false;
  return true;
}

// Likewise the quantities' bounds, and their rates where the program has them.
void Spans::gather(const Places& of, std::size_t k, std::size_t count, std::vector<Bounds>& value, std::vector<Bounds>& rate) const {
  const auto at = [&](int place) { return place < 0 ? Bounds{} : out_[static_cast<std::size_t>(place) * count + k]; };
  value.resize(quantities_.all.size());
  rate.resize(quantities_.all.size());
  for (std::size_t n = 0; n < quantities_.all.size(); ++n) {
    const Quantity& q = quantities_.all[n];
    const auto order = static_cast<std::size_t>(q.order);
    if (q.of == Quantity::Of::coordinate) {
      const auto i = static_cast<std::size_t>(q.index);
      value[n] = in_[(order * dof_ + i) * count + k];
      rate[n] = order < 2 ? in_[((order + 1) * dof_ + i) * count + k] : Bounds{};
      continue;
    }
    const int places[] = {of.value[q.output], of.rate[q.output], of.acceleration[q.output], -1};
    value[n] = at(places[order]);
    rate[n] = at(places[order + 1]);
  }
}

void Spans::at(Look look, std::span<const double> times, std::span<InstantFacts> out) {
  Timed& timed = pair_for(look).at_instants;
  for (std::size_t begin = 0; begin < times.size(); begin += block) {
    const std::size_t count = std::min(block, times.size() - begin);
    run(timed, count, [&](std::size_t k) { return Bounds::exactly(times[begin + k]); });
    for (std::size_t k = 0; k < count; ++k) {
      InstantFacts& facts = out[begin + k];
      facts.time = times[begin + k];
      gather(timed.of, k, count, facts.value, unused_);
      facts.assembled = true;
      facts.side = 0;
      if (look == Look::quantities) continue;
      facts.assembled = facts.value[0].bounded() && facts.value[0].low >= 0 && placed(timed.of, k, count);
      for (std::size_t e = 0; e < 36; ++e) facts.wrenches[e] = out_[static_cast<std::size_t>(timed.of.value[wrenches_ + e]) * count + k];
      const linear::Matrix6d middle = middle_of(facts.wrenches);
      if (all_bounded(facts.wrenches) && without_singular(facts.wrenches, middle)) facts.side = mechanics::side_of(middle, length_);
    }
  }
}

// (2), C the inverse of `middle`.
bool Spans::without_singular(std::span<const Bounds, 36> wrenches, const linear::Matrix6d& middle) const {
  std::array<Bounds, 36> scaled;
  linear::Matrix6d g = middle;
  g.rightCols<3>() *= per_length_;
  for (std::size_t e = 0; e < 36; ++e)
    scaled[e] = e % 6 < 3 ? wrenches[e] : Bounds{wrenches[e].low * per_length_, wrenches[e].high * per_length_};
  const Eigen::Matrix<double, 6, 6, Eigen::RowMajor> inverse = g.inverse();
  return inverse.allFinite() && regular(scaled, std::span<const double, 36>(inverse.data(), 36));
}

void Spans::over(Look look, std::span<const Bounds> times, std::span<const InstantFacts* const> middles, std::span<SpanFacts> out) {
  Timed& timed = pair_for(look).over_spans;
  std::array<Bounds, 36> wrenches, rates;
  for (std::size_t begin = 0; begin < times.size(); begin += block) {
    const std::size_t count = std::min(block, times.size() - begin);
    run(timed, count, [&](std::size_t k) { return times[begin + k]; });
    for (std::size_t k = 0; k < count; ++k) {
      const InstantFacts& middle = *middles[begin + k];
      SpanFacts& facts = out[begin + k];
      facts.time = times[begin + k];
      gather(timed.of, k, count, facts.value, facts.rate);
      sharpen(facts.time, middle.time, middle.value, facts.rate, facts.value);
      facts.placed = true;
      if (look == Look::quantities) continue;
      facts.placed = placed(timed.of, k, count);
      for (std::size_t e = 0; e < 36; ++e) {
        wrenches[e] = out_[static_cast<std::size_t>(timed.of.value[wrenches_ + e]) * count + k];
        rates[e] = out_[static_cast<std::size_t>(timed.of.rate[wrenches_ + e]) * count + k];
      }
      facts.finite_wrenches = all_bounded(wrenches);
      if (!facts.finite_wrenches || middle.side == 0) continue;
      sharpen(facts.time, middle.time, middle.wrenches, rates, wrenches);
      facts.regular = without_singular(wrenches, middle_of(middle.wrenches));
    }
  }
}

}  // namespace pmreport::analysis
