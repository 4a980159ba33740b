#include <core/scan/judge/judge.hpp>

#include <core/scan/judge/kernel.hpp>

#include <algorithm>
#include <numeric>

namespace pmreport::scan {

namespace {

constexpr std::size_t few = 40;      // poses of a block that wait for others rather than go on together
constexpr std::size_t enough = 512;  // poses that need not wait any longer

std::vector<int> inputs_read(const program::Program& p) {
  std::vector<int> out;
  for (const program::Step& s : p.steps())
    if (s.operation == program::Operation::input) out.push_back(s.a);
  return out;
}

}  // namespace

void PointBlock::resize(std::size_t points, std::size_t slots) {
  count = points;
  stride = stride_of(points);
  values.resize(slots * stride);
  places.resize(points);
}

void PointBlock::fill_up() {
  for (std::size_t first = 0; first < values.size(); first += stride)
    for (std::size_t k = count; k < stride; ++k) values[first + k] = values[first + count - 1];
}

Tally empty_tally(std::size_t margins, bool reasons) {
  Tally t;
  if (reasons) t.first.assign(margins, 0), t.any.assign(margins, 0);
  return t;
}

Judge::Judge(const Plan& plan, std::function<void(const Accepted&)> accepted) : plan_(plan), accepted_(std::move(accepted)) {
  for (const Stage& s : plan.stages) {
    hoisted_.emplace_back(s.program, plan.point_inputs);
    loose_.emplace_back(s.program);
    inputs_of_.push_back(inputs_read(s.program));
  }
  loose_.emplace_back(plan.sign);
  inputs_of_.push_back(inputs_read(plan.sign));
  waiting_.resize(plan.stages.size() + 2);
  for (Waiting& w : waiting_) {
    w.points.resize(plan.slots.size() * most);
    w.others.resize(most);
    w.places.resize(most), w.turns.resize(most);
    w.known.resize(most);
    w.open.resize(most);
  }
  in_.resize(plan.width() * most);
  set({});
}

void Judge::set(std::span<const MarginVerdict> verdicts) {
  verdicts_.assign(verdicts.begin(), verdicts.end());
  verdicts_.resize(plan_.margins, MarginVerdict::open);
  open_ = 0;
  for (std::size_t s = 0; s < std::min<std::size_t>(plan_.stages.size(), 64); ++s) {
    const auto open = [&](int m) { return verdicts_[static_cast<std::size_t>(m)] == MarginVerdict::open; };
    if (std::ranges::any_of(plan_.stages[s].margins, open)) open_ |= std::uint64_t{1} << s;
  }
}

// The first stage from this one on that is open; behind the last the late margins. A stage beyond the bits that there are is looked at.
std::size_t Judge::next(std::size_t stage, std::uint64_t open) const {
  while (stage < std::min<std::size_t>(plan_.stages.size(), 64) && (open >> stage & 1) == 0) ++stage;
  return stage;
}

void Judge::run(const PointBlock& points, const double* others, std::uint32_t turn, Tally& tally) {
  others_ = others;
  block_ = &points;
  known_.assign(points.stride, is_refused);
  std::fill_n(known_.begin(), points.count, is_kept);
  numbers_.resize(points.stride);
  std::iota(numbers_.begin(), numbers_.end(), 0u);
  points_.resize(std::max(points_.size(), plan_.slots.size() * points.stride));
  Left left{points.values.data(), points.count, points.stride, points.count};
  if (plan_.reasons) {
    explain(left, tally);
    if (plan_.set.late.size == 0) keep(left);
    wait(plan_.stages.size(), left, turn, tally);
  } else {
    judge(left, turn, tally);
  }
}

void Judge::run_stage(const Left& left, std::size_t stage) {
  values_.resize(std::max(values_.size(), plan_.stages[stage].margins.size() * left.stride));
  hoisted_[stage].run(left.stride, others_, left.points, values_.data());
}

void Judge::judge(Left& left, std::uint32_t turn, Tally& tally) {
  std::size_t s = next(0, open_);
  for (; s < plan_.stages.size() && left.count >= few; s = next(s + 1, open_)) {
    const Stage& stage = plan_.stages[s];
    run_stage(left, s);
    left.left = judge_kernel().judge(stage.margins.size(), stage.slack.data(), left.stride, values_.data(), known_.data());
    keep(left);
  }
  wait(s, left, turn, tally);
}

// Poses that cannot be assembled count for the reach alone, and are left behind first of all.
void Judge::explain(Left& left, Tally& tally) {
  std::size_t computed = plan_.stages.size();  // the stage whose margins are in values_
  for (std::size_t m = 0; m < plan_.margins && left.count > 0; ++m) {
    if (verdicts_[m] == MarginVerdict::refused) {
      tally.any[m] += left.count;
      tally.first[m] += left.left;
      left.left = 0;
      std::fill_n(known_.begin(), left.count, is_refused);
    } else if (verdicts_[m] == MarginVerdict::open) {
      const auto s = static_cast<std::size_t>(plan_.stage_of[m]);
      const Stage& stage = plan_.stages[s];
      if (s != computed) run_stage(left, s), computed = s;
      const std::size_t place = m - static_cast<std::size_t>(stage.margins.front());
      const Refusals r = judge_kernel().explain(stage.slack[place], left.count, values_.data() + place * left.stride, known_.data());
      tally.any[m] += r.any;
      tally.first[m] += r.first;
      left.left -= r.first;
    }
    if (m == 0) keep(left);
  }
}

// Moves together the poses that are left. What is left of a slot is never further on than it was, so it may move within one buffer.
void Judge::keep(Left& left) {
  if (left.left == left.count) return;
  stood_.resize(left.count + 1);
  std::size_t n = 0;
  for (std::size_t k = 0; k < left.count; ++k) {
    stood_[n] = static_cast<std::uint32_t>(k);
    n += known_[k] > is_refused;
  }
  const std::size_t stride = PointBlock::stride_of(n);
  for (std::size_t s = 0; n > 0 && s < plan_.slots.size(); ++s) {
    double* to = points_.data() + s * stride;
    const double* from = left.points + s * left.stride;
    for (std::size_t k = 0; k < n; ++k) to[k] = from[stood_[k]];
    std::fill(to + n, to + stride, to[n - 1]);
  }
  for (std::size_t k = 0; k < n; ++k) known_[k] = known_[stood_[k]], numbers_[k] = numbers_[stood_[k]];
  std::fill_n(known_.begin() + static_cast<std::ptrdiff_t>(n), stride - n, is_refused);
  left = {points_.data(), n, stride, n};
}

void Judge::wait(std::size_t stage, const Left& left, std::uint32_t turn, Tally& tally) {
  for (std::size_t done = 0; done < left.count;) {
    Waiting& w = waiting_[stage];
    const std::size_t n = std::min(left.count - done, most - w.count), at = w.count;
    for (std::size_t s = 0; s < plan_.slots.size(); ++s)
      std::copy_n(left.points + s * left.stride + done, n, w.points.data() + s * most + at);
    for (std::size_t k = 0; k < n; ++k) {
      w.others[at + k] = others_;
      w.places[at + k] = block_->places[numbers_[done + k]];
      w.turns[at + k] = turn;
      w.known[at + k] = known_[done + k];
      w.open[at + k] = open_;
    }
    w.count += n;
    done += n;
    if (w.count >= enough) drain(stage, tally);
  }
}

void Judge::pass_on(std::size_t stage, const Waiting& from, std::size_t k, Tally& tally) {
  Waiting& w = waiting_[stage];
  const std::size_t at = w.count++;
  for (std::size_t s = 0; s < plan_.slots.size(); ++s) w.points[s * most + at] = from.points[s * most + k];
  w.others[at] = from.others[k];
  w.places[at] = from.places[k];
  w.turns[at] = from.turns[k];
  w.known[at] = from.known[k];
  w.open[at] = from.open[k];
  if (w.count == most) drain(stage, tally);
}

// What a program reads of poses that wait, into in_; behind the last stands some number.
void Judge::gather(const Waiting& w, std::size_t stride, std::span<const int> inputs) {
  const std::size_t n = w.count;
  for (const int i : inputs) {
    double* to = in_.data() + static_cast<std::size_t>(i) * stride;
    if (i < 64 && (plan_.point_inputs >> i & 1) != 0)
      std::copy_n(w.points.data() + plan_.slot_of(i) * most, n, to);
    else
      for (std::size_t k = 0; k < n; ++k) to[k] = w.others[k][i];
    std::fill(to + n, to + stride, to[n - 1]);
  }
}

// Nothing is passed on to a stage that is drained at this moment: all go further on.
void Judge::drain(std::size_t stage, Tally& tally) {
  if (stage == plan_.stages.size()) return drain_late(tally);
  if (stage > plan_.stages.size()) return accept(tally);
  Waiting& w = waiting_[stage];
  const Stage& s = plan_.stages[stage];
  const std::size_t stride = PointBlock::stride_of(w.count);
  values_.resize(std::max(values_.size(), s.margins.size() * stride));
  gather(w, stride, inputs_of_[stage]);
  loose_[stage].run(stride, in_.data(), values_.data());
  judge_kernel().judge(s.margins.size(), s.slack.data(), stride, values_.data(), w.known.data());
  for (std::size_t k = 0; k < w.count; ++k)
    if (w.known[k] > is_refused) pass_on(next(stage + 1, w.open[k]), w, k, tally);
  w.count = 0;
}

// Without reasons only what all others accept has come here.
void Judge::drain_late(Tally& tally) {
  Waiting& w = waiting_[plan_.stages.size()];
  const std::size_t n = w.count, late = plan_.set.late.size;
  if (late > 0 && n > 0) {
    std::vector<int> all(plan_.scan.at.size());
    std::iota(all.begin(), all.end(), 0);
    gather(w, n, all);
    values_.resize(std::max(values_.size(), late * n));
    plan_.set.late.judge(n, in_.data(), values_.data());
    for (std::size_t l = 0; l < late; ++l) {
      if (l == late - plan_.set.late.every) by_others_ = w.known;
      const std::size_t m = plan_.margins + l;
      const Refusals r = judge_kernel().explain(plan_.set.rounding[m], n, values_.data() + l * n, w.known.data());
      if (plan_.reasons) tally.any[m] += r.any, tally.first[m] += r.first;
    }
  }
  const Numbers& passed = plan_.set.late.every > 0 ? by_others_ : w.known;
  for (std::size_t k = 0; k < n; ++k)
    if (passed[k] > is_refused) pass_on(plan_.stages.size() + 1, w, k, tally);
  w.count = 0;
}

void Judge::accept(Tally& tally) {
  Waiting& w = waiting_.back();
  const std::size_t n = w.count;
  signs_.resize(plan_.sign.outputs().size() * n);
  if (!signs_.empty()) {
    gather(w, n, inputs_of_.back());
    loose_.back().run(n, in_.data(), signs_.data());
  }
  for (std::size_t k = 0; k < n; ++k) tally.accepted += w.known[k] > is_refused, tally.on_a_limit += w.known[k] == is_on_a_limit;
  accepted_({{w.places.data(), n}, {w.turns.data(), n}, {w.known.data(), n}, signs_});
  w.count = 0;
}

void Judge::finish(Tally& tally) {
  for (std::size_t s = 0; s < waiting_.size(); ++s)
    if (waiting_[s].count > 0) drain(s, tally);
}

void Judge::forget() {
  for (Waiting& w : waiting_) w.count = 0;
}

}  // namespace pmreport::scan
