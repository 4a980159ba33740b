#include <core/scan/judge/judge.hpp>

#include <core/scan/judge/kernel.hpp>

#include <algorithm>
#include <numeric>

namespace pmreport::scan {

Tally empty_tally(std::size_t margins, bool reasons) {
  Tally t;
  if (reasons) t.first.assign(margins, 0), t.any.assign(margins, 0);
  return t;
}

Judge::Judge(const Plan& plan) : plan_(plan) {
  for (const Stage& s : plan.stages) batches_.emplace_back(s.program, plan.point_inputs);
  if (!plan.sign.outputs().empty()) sign_.emplace_back(plan.sign, plan.point_inputs);
}

std::span<const std::uint32_t> Judge::run(std::size_t count, const double* points, const double* others, std::span<const Verdict> verdicts,
                                          Tally& tally) {
  others_ = others;
  known_.assign(count, is_kept);
  numbers_.resize(count);
  std::iota(numbers_.begin(), numbers_.end(), 0u);
  points_.resize(std::max(points_.size(), plan_.slots.size() * count));
  Left left{points, count, count};
  if (plan_.reasons)
    explain(left, verdicts, tally);
  else
    judge(left, verdicts);
  if (plan_.set.late.size > 0) judge_late(left, tally);
  keep(left);
  accepted_ = left;
  tally.accepted += left.count;
  for (std::size_t k = 0; k < left.count; ++k) tally.on_a_limit += known_[k] == is_on_a_limit;
  return {numbers_.data(), left.count};
}

void Judge::run_stage(const Left& left, std::size_t stage) {
  values_.resize(std::max(values_.size(), plan_.stages[stage].margins.size() * left.count));
  batches_[stage].run(left.count, others_, left.points, values_.data());
}

void Judge::judge(Left& left, std::span<const Verdict> verdicts) {
  constexpr std::size_t of_eight = 6;  // so many of eight poses may be left, and it does not pay yet to move them together
  for (std::size_t s = 0; s < plan_.stages.size() && left.count > 0; ++s) {
    const Stage& stage = plan_.stages[s];
    const auto open = [&](int m) { return verdicts.empty() || verdicts[static_cast<std::size_t>(m)] == Verdict::open; };
    if (std::ranges::none_of(stage.margins, open)) continue;
    run_stage(left, s);
    left.left = judge_kernel().judge(stage.margins.size(), stage.slack.data(), left.count, values_.data(), known_.data());
    if (left.left * 8 < left.count * of_eight) keep(left);
  }
}

// Poses that cannot be assembled count for the reach alone, and are left behind first of all.
void Judge::explain(Left& left, std::span<const Verdict> verdicts, Tally& tally) {
  const auto verdict = [&](std::size_t m) { return verdicts.empty() ? Verdict::open : verdicts[m]; };
  const auto count = [&](std::size_t m, const Refusals& r) { tally.any[m] += r.any, tally.first[m] += r.first, left.left -= r.first; };
  std::size_t computed = plan_.stages.size();  // the stage whose margins are in values_
  for (std::size_t m = 0; m < plan_.margins && left.count > 0; ++m) {
    if (verdict(m) == Verdict::refused) {
      tally.any[m] += left.count;
      tally.first[m] += left.left;
      left.left = 0;
      std::fill_n(known_.begin(), left.count, is_refused);
    } else if (verdict(m) == Verdict::open) {
      const auto s = static_cast<std::size_t>(plan_.stage_of[m]);
      const Stage& stage = plan_.stages[s];
      if (s != computed) run_stage(left, s), computed = s;
      const std::size_t place = m - static_cast<std::size_t>(stage.margins.front());
      count(m, judge_kernel().explain(stage.slack[place], left.count, values_.data() + place * left.count, known_.data()));
    }
    if (m == 0) keep(left);
  }
}

// Without reasons only what all others accept is asked about.
void Judge::judge_late(Left& left, Tally& tally) {
  if (!plan_.reasons) keep(left);
  if (left.count == 0) return;
  const std::size_t n = left.count, inputs = plan_.scan.at.size(), late = plan_.set.late.size;
  late_poses_.resize(inputs * n);
  for (std::size_t i = 0; i < inputs; ++i) std::fill_n(late_poses_.begin() + static_cast<std::ptrdiff_t>(i * n), n, others_[i]);
  for (std::size_t a = 0; a < plan_.slots.size(); ++a)
    std::copy_n(left.points + plan_.slots[a] * n, n,
                late_poses_.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(plan_.scan.points[a].input) * n));
  values_.resize(std::max(values_.size(), late * n));
  plan_.set.late.judge(n, late_poses_.data(), values_.data());
  for (std::size_t l = 0; l < late; ++l) {
    const std::size_t m = plan_.margins + l;
    const Refusals r = judge_kernel().explain(plan_.set.rounding[m], n, values_.data() + l * n, known_.data());
    left.left -= r.first;
    if (plan_.reasons) tally.any[m] += r.any, tally.first[m] += r.first;
  }
}

// Moves together the poses that are left. What is left of a slot is never further on than it was, so it may move within one buffer.
void Judge::keep(Left& left) {
  const std::size_t n = left.count, slots = plan_.slots.size();
  if (left.left == n) return;
  places_.resize(n);
  std::size_t to = 0;
  for (std::size_t k = 0; k < n; ++k) {
    places_[to] = static_cast<std::uint32_t>(k);
    to += known_[k] > is_refused;
  }
  for (std::size_t s = 0; s < slots; ++s)
    for (std::size_t k = 0; k < to; ++k) points_[s * to + k] = left.points[s * n + places_[k]];
  for (std::size_t k = 0; k < to; ++k) known_[k] = known_[places_[k]], numbers_[k] = numbers_[places_[k]];
  left = {points_.data(), to, to};
}

std::span<const double> Judge::signs() {
  signs_.resize(accepted_.count);
  sign_.front().run(accepted_.count, others_, accepted_.points, signs_.data());
  return signs_;
}

}  // namespace pmreport::scan
