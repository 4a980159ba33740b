#include <core/analysis/proof/spans.hpp>

#include <core/analysis/proof/sharpen.hpp>
#include <core/linear/square.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/model/overall_jacobian.hpp>
#include <core/program/derivative.hpp>

#include <algorithm>
#include <cmath>

namespace pmreport::analysis {

namespace {

constexpr std::size_t block = 64;  // spans at a time

bool all_bounded(std::span<const Bounds> x) { return std::ranges::all_of(x, &Bounds::bounded); }

}  // namespace

Spans::Spans(const mechanics::Machine& machine, const mechanics::MotionProgram& program, const Quantities& quantities,
             const mechanics::Enclosure& motion)
    : machine_(machine),
      quantities_(quantities),
      motion_(motion),
      dof_(static_cast<std::size_t>(machine.dof())),
      placed_(machine.layout().size()),
      wrenches_(program.wrenches),
      length_(characteristic_length(machine)),
      instant_(timed(program, false)),
      span_(timed(program, true)),
      at_instants_(instant_.program),
      over_spans_(span_.program),
      moved_(dof_) {
  per_length_ = std::exp2(std::round(-std::log2(length_)));
}

// All outputs of the mechanism's program; the rates and accelerations of what is followed with them; over spans also the rates by which
// reach, joints and G become sharp.
Spans::Timed Spans::timed(const mechanics::MotionProgram& program, bool all_rates) const {
  const std::size_t n = program.program.outputs().size();
  const program::Program moving = program::in_time(program.program, 2);
  Timed out;
  std::vector<int> outputs;
  const auto take = [&](std::vector<int>& place, std::size_t output, std::size_t order) {
    if (place[output] >= 0) return;
    place[output] = static_cast<int>(outputs.size());
    outputs.push_back(static_cast<int>(order * n + output));
  };
  for (std::vector<int>* place : {&out.of.value, &out.of.rate, &out.of.acceleration}) place->assign(n, -1);
  for (std::size_t o = 0; o < n; ++o) take(out.of.value, o, 0);
  for (const Quantity& q : quantities_.all) {
    if (q.of == Quantity::Of::derived || q.of == Quantity::Of::actuator) {
      take(out.of.rate, q.output, 1);
      take(out.of.acceleration, q.output, 2);
    } else if (all_rates && q.of != Quantity::Of::coordinate) {
      take(out.of.rate, q.output, 1);
    }
  }
  for (std::size_t e = 0; all_rates && e < 36; ++e) take(out.of.rate, wrenches_ + e, 1);
  out.program = moving.slice(outputs);
  return out;
}

// Fills the inputs of the k-th span of so many: coordinates, rates, accelerations. Where nothing is known of the motion, nothing is known.
void Spans::inputs(Bounds time, std::size_t k, std::size_t count) {
  const bool known = motion_(time, moved_.data());
  for (std::size_t i = 0; i < dof_; ++i) {
    in_[i * count + k] = known ? moved_[i].value : Bounds{};
    in_[(dof_ + i) * count + k] = known ? moved_[i].rate : Bounds{};
    in_[(2 * dof_ + i) * count + k] = known ? moved_[i].acceleration : Bounds{};
  }
}

// Of the k-th span of so many: the quantities' bounds, and their rates where the program has them.
void Spans::gather(const Places& of, std::size_t k, std::size_t count, std::vector<Bounds>& value, std::vector<Bounds>& rate) const {
  const auto at = [&](int place) { return place < 0 ? Bounds{} : out_[static_cast<std::size_t>(place) * count + k]; };
  value.clear();
  rate.clear();
  for (const Quantity& q : quantities_.all) {
    const auto order = static_cast<std::size_t>(q.order);
    if (q.of == Quantity::Of::coordinate) {
      const auto i = static_cast<std::size_t>(q.index);
      value.push_back(in_[(order * dof_ + i) * count + k]);
      rate.push_back(order < 2 ? in_[((order + 1) * dof_ + i) * count + k] : Bounds{});
      continue;
    }
    const int places[] = {of.value[q.output], of.rate[q.output], of.acceleration[q.output]};
    value.push_back(at(places[order]));
    rate.push_back(order < 2 ? at(places[order + 1]) : Bounds{});
  }
}

void Spans::at(std::span<const double> times, std::span<InstantFacts> out) {
  std::vector<Bounds> unused;
  for (std::size_t begin = 0; begin < times.size(); begin += block) {
    const std::size_t count = std::min(block, times.size() - begin);
    in_.resize(3 * dof_ * count);
    out_.resize(instant_.program.outputs().size() * count);
    for (std::size_t k = 0; k < count; ++k) inputs(Bounds::exactly(times[begin + k]), k, count);
    at_instants_.run(count, in_.data(), out_.data());
    evaluations_ += static_cast<long>(count);
    for (std::size_t k = 0; k < count; ++k) {
      InstantFacts& facts = out[begin + k];
      facts.time = times[begin + k];
      gather(instant_.of, k, count, facts.value, unused);
      facts.placed = true;
      for (std::size_t o = 0; o < placed_; ++o)
        facts.placed = facts.placed && out_[static_cast<std::size_t>(instant_.of.value[o]) * count + k].bounded();
      linear::Matrix6d middle;
      for (std::size_t e = 0; e < 36; ++e) {
        facts.wrenches[e] = out_[static_cast<std::size_t>(instant_.of.value[wrenches_ + e]) * count + k];
        middle(static_cast<Eigen::Index>(e / 6), static_cast<Eigen::Index>(e % 6)) = facts.wrenches[e].middle();
      }
      facts.side = 0;
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

void Spans::over(std::span<const Bounds> times, std::span<const InstantFacts* const> middles, std::span<SpanFacts> out) {
  std::array<Bounds, 36> wrenches, rates;
  for (std::size_t begin = 0; begin < times.size(); begin += block) {
    const std::size_t count = std::min(block, times.size() - begin);
    in_.resize(3 * dof_ * count);
    out_.resize(span_.program.outputs().size() * count);
    for (std::size_t k = 0; k < count; ++k) inputs(times[begin + k], k, count);
    over_spans_.run(count, in_.data(), out_.data());
    evaluations_ += static_cast<long>(count);
    for (std::size_t k = 0; k < count; ++k) {
      const InstantFacts& middle = *middles[begin + k];
      SpanFacts& facts = out[begin + k];
      facts.time = times[begin + k];
      facts.middle = middle.time;
      gather(span_.of, k, count, facts.value, facts.rate);
      sharpen(facts.time, middle.time, middle.value, facts.rate, facts.value);
      facts.placed = true;
      for (std::size_t o = 0; o < placed_; ++o)
        facts.placed = facts.placed && out_[static_cast<std::size_t>(span_.of.value[o]) * count + k].bounded();
      for (std::size_t e = 0; e < 36; ++e) {
        wrenches[e] = out_[static_cast<std::size_t>(span_.of.value[wrenches_ + e]) * count + k];
        rates[e] = out_[static_cast<std::size_t>(span_.of.rate[wrenches_ + e]) * count + k];
      }
      facts.finite_wrenches = all_bounded(wrenches);
      facts.regular = false;
      if (!facts.finite_wrenches || middle.side == 0) continue;
      sharpen(facts.time, middle.time, middle.wrenches, rates, wrenches);
      linear::Matrix6d g;
      for (std::size_t e = 0; e < 36; ++e)
        g(static_cast<Eigen::Index>(e / 6), static_cast<Eigen::Index>(e % 6)) = middle.wrenches[e].middle();
      facts.regular = without_singular(wrenches, g);
    }
  }
}

}  // namespace pmreport::analysis
