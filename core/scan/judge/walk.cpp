#include <core/scan/judge/walk.hpp>

#include <core/scan/judge/kernel.hpp>

#include <algorithm>
#include <utility>

namespace pmreport::scan {

namespace {

constexpr std::size_t together = 64;         // blocks that intervals look at in one call
constexpr std::size_t fewest = 1024;         // poses of a block that is not halved any more
constexpr std::size_t fewest_points = 64;    // and points: fewer do not pay for what each orientation costs beside them
constexpr std::size_t most_points = 4096;    // that are judged in one go: they stay in the second-level cache
constexpr std::size_t between_looks = 4096;  // poses that are judged before it is asked whether to stop: late margins take them 0.1 s

}  // namespace

Found& Found::operator+=(const Found& more) {
  tally += more.tally;
  for (std::size_t k = 0; k < accepted.size(); ++k) accepted[k] += more.accepted[k];
  for (std::size_t k = 0; k < by_others.size(); ++k) by_others[k] += more.by_others[k];
  positive += more.positive;
  negative += more.negative;
  return *this;
}

Walk::Walk(const Plan& plan, bool prune, std::function<void()> stop_if_asked)
    : plan_(plan),
      prune_(prune),
      stop_if_asked_(std::move(stop_if_asked)),
      judge_(plan, [this](const Accepted& accepted) { take(accepted); }) {
  for (const Stage& s : plan.stages) {
    if (prune) boxes_.emplace_back(s.program);
    inputs_of_.emplace_back();
    for (const program::Step& step : s.program.steps())
      if (step.operation == program::Operation::input) inputs_of_.back().push_back(step.a);
  }
  for (const Axis& a : plan.scan.points) {
    values_.emplace_back();
    for (std::size_t k = 0; k < a.count; ++k) values_.back().push_back(a.value(k));
  }
}

std::size_t Walk::turned(const Block& b) const {
  const Orientations::Node& n = orientations_->node(b.node);
  return n.end - n.begin;
}

Found Walk::run(const Tile& tile, const Orientations& orientations, int node, PoseBits bits) {
  orientations_ = &orientations;
  root_ = &tile;
  bits_ = bits;
  each_ = bits.accepted != nullptr || !plan_.sign.outputs().empty();
  posed_.reset();
  open_.clear();
  judge_.forget();
  found_ = {empty_tally(plan_.set.size(), plan_.reasons), std::vector<std::uint32_t>(tile.size(), 0), {}, 0, 0};
  if (plan_.set.late.every > 0) found_.by_others.resize(tile.size());
  open_.push_back({tile, node, std::vector<MarginVerdict>(plan_.margins, MarginVerdict::open)});
  found_.tally.poses = poses(open_.back());
  std::vector<Block> now;
  while (!open_.empty()) {
    stop_if_asked_();
    const std::size_t n = std::min(together, open_.size());
    now.assign(std::make_move_iterator(open_.end() - static_cast<std::ptrdiff_t>(n)), std::make_move_iterator(open_.end()));
    open_.resize(open_.size() - n);
    if (prune_) decide(now);
    for (Block& b : now) {
      if (finish(b)) continue;
      if (widest(b) < 0)
        judge(b);
      else
        halve(std::move(b));
    }
  }
  judge_.finish(found_.tally);
  return std::move(found_);
}

// Stage by stage, on blocks that have open margins in it. A block that is refused for good is not looked at again.
void Walk::decide(std::span<Block> blocks) {
  const auto verdict = [](const Block& b, int m) { return b.verdicts[static_cast<std::size_t>(m)]; };
  const auto refused = [&](const Block& b) {
    return plan_.reasons ? verdict(b, 0) == MarginVerdict::refused
                         : std::ranges::any_of(b.verdicts, [](MarginVerdict v) { return v == MarginVerdict::refused; });
  };
  std::size_t alive = blocks.size();
  for (std::size_t s = 0; s < plan_.stages.size() && alive > 0; ++s) {
    const Stage& stage = plan_.stages[s];
    const auto looked_at = std::partition(blocks.begin(), blocks.begin() + static_cast<std::ptrdiff_t>(alive), [&](const Block& b) {
      return std::ranges::any_of(stage.margins, [&](int m) { return verdict(b, m) == MarginVerdict::open; });
    });
    const auto n = static_cast<std::size_t>(looked_at - blocks.begin());
    if (n == 0) continue;
    bound(blocks.first(n), s);
    for (std::size_t i = 0; i < stage.margins.size(); ++i)
      for (std::size_t k = 0; k < n; ++k) {
        const program::Bounds& margin = out_[i * n + k];
        MarginVerdict& v = blocks[k].verdicts[static_cast<std::size_t>(stage.margins[i])];
        if (!margin.bounded()) continue;
        if (margin.low > stage.slack[i]) v = MarginVerdict::kept;
        if (margin.high < -stage.slack[i]) v = MarginVerdict::refused;
      }
    alive = static_cast<std::size_t>(
        std::partition(blocks.begin(), blocks.begin() + static_cast<std::ptrdiff_t>(alive), [&](const Block& b) { return !refused(b); }) -
        blocks.begin());
  }
}

// Bounds of a stage's margins over each block, into out_.
void Walk::bound(std::span<const Block> blocks, std::size_t stage) {
  const std::size_t n = blocks.size();
  in_.resize(std::max(in_.size(), plan_.width() * n));
  out_.resize(std::max(out_.size(), plan_.stages[stage].margins.size() * n));
  for (std::size_t k = 0; k < n; ++k) {
    const auto hull = orientations_->bounds(blocks[k].node);
    for (const int i : inputs_of_[stage]) in_[static_cast<std::size_t>(i) * n + k] = hull[static_cast<std::size_t>(i)];
  }
  for (std::size_t a = 0; a < values_.size(); ++a) {
    program::Bounds* in = in_.data() + static_cast<std::size_t>(plan_.scan.points[a].input) * n;
    for (std::size_t k = 0; k < n; ++k) {
      const double first = values_[a][blocks[k].tile.begin[a]], last = values_[a][blocks[k].tile.end[a] - 1];
      in[k] = {std::min(first, last), std::max(first, last)};
    }
  }
  boxes_[stage].run(n, in_.data(), out_.data());
}

// Adds what a block comes to that is decided as one.
bool Walk::finish(const Block& b) {
  const std::size_t n = poses(b);
  const auto refused = std::ranges::find(b.verdicts, MarginVerdict::refused);
  if (!plan_.reasons && refused != b.verdicts.end()) return true;
  if (b.verdicts.front() == MarginVerdict::refused) {
    found_.tally.first.front() += n;
    found_.tally.any.front() += n;
    return true;
  }
  if (plan_.set.late.size > 0 || std::ranges::find(b.verdicts, MarginVerdict::open) != b.verdicts.end()) return false;
  if (refused == b.verdicts.end()) {
    if (each_) return false;
    accept(b);
    return true;
  }
  found_.tally.first[static_cast<std::size_t>(refused - b.verdicts.begin())] += n;
  for (std::size_t m = 0; m < b.verdicts.size(); ++m)
    if (b.verdicts[m] == MarginVerdict::refused) found_.tally.any[m] += n;
  return true;
}

void Walk::accept(const Block& b) {
  const auto n = static_cast<std::uint32_t>(turned(b));
  found_.tally.accepted += poses(b);
  each_point(b.tile, [&](std::size_t, std::span<const std::size_t> at) { found_.accepted[root_->place(at)] += n; });
}

// What a block is halved across: a point axis, the number of them for the orientation; -1: its poses are judged one by one.
int Walk::widest(const Block& b) const {
  const std::size_t axes = values_.size(), points = b.tile.size(), orientations = turned(b);
  if (!prune_) return points > most_points ? static_cast<int>(b.tile.longest()) : -1;
  if (points * orientations <= fewest) return -1;
  int out = -1;
  double most = -1;
  if (points > fewest_points)
    for (std::size_t a = 0; a < axes; ++a) {
      const std::size_t n = b.tile.end[a] - b.tile.begin[a];
      if (n < 2) continue;
      const double wide = plan_.weights[a] * static_cast<double>(n - 1) / static_cast<double>(plan_.scan.points[a].count - 1);
      if (wide > most) most = wide, out = static_cast<int>(a);
    }
  if (orientations > 1 && plan_.weights[axes] * orientations_->node(b.node).share > most) out = static_cast<int>(axes);
  return out;
}

void Walk::halve(Block b) {
  const auto a = static_cast<std::size_t>(widest(b));
  Block other = b;
  if (a == values_.size()) {
    b.node = orientations_->node(b.node).children;
    other.node = b.node + 1;
  } else {
    const std::size_t middle = b.tile.begin[a] + (b.tile.end[a] - b.tile.begin[a]) / 2;
    b.tile.end[a] = middle;
    other.tile.begin[a] = middle;
  }
  open_.push_back(std::move(b));
  open_.push_back(std::move(other));
}

void Walk::judge(const Block& b) {
  if (posed_ != b.tile) pose_points(b.tile);
  judge_.set(b.verdicts);
  const Orientations::Node& node = orientations_->node(b.node);
  for (std::size_t o = node.begin; o < node.end; ++o) {
    judge_.run(points_, orientations_->others(o), static_cast<std::uint32_t>(o), found_.tally);
    ask(points_.count);
  }
}

void Walk::ask(std::size_t judged) {
  judged_ += judged;
  if (judged_ < between_looks) return;
  judged_ = 0;
  stop_if_asked_();
}

void Walk::take(const Accepted& accepted) {
  for (std::size_t k = 0; k < accepted.places.size(); ++k) found_.accepted[accepted.places[k]] += accepted.known[k] > is_refused;
  if (plan_.set.late.every > 0)
    for (const std::uint32_t place : accepted.places) ++found_.by_others[place];
  if (!each_) return;
  for (std::size_t k = 0; k < accepted.places.size(); ++k) {
    if (!(accepted.known[k] > is_refused)) continue;
    const double sign = accepted.signs.empty() ? 0.0 : accepted.signs[k];
    found_.positive += sign > 0;
    found_.negative += sign < 0;
    if (bits_.accepted == nullptr) continue;
    const std::size_t pose = accepted.places[k] * orientations_->size() + orientations_->place(accepted.turns[k]);
    PoseBits::mark(bits_.accepted, pose);
    if (sign > 0) PoseBits::mark(bits_.positive, pose);
    if (sign < 0) PoseBits::mark(bits_.negative, pose);
  }
}

// Blocks that differ in their orientations alone stand one after another, and share this.
void Walk::pose_points(const Tile& tile) {
  posed_ = tile;
  points_.resize(tile.size(), plan_.slots.size());
  each_point(tile, [&](std::size_t k, std::span<const std::size_t> at) {
    for (std::size_t a = 0; a < values_.size(); ++a) points_.values[plan_.slots[a] * points_.stride + k] = values_[a][at[a]];
    points_.places[k] = static_cast<std::uint32_t>(root_->place(at));
  });
  points_.fill_up();
}

}  // namespace pmreport::scan
