#include <core/analysis/proof/followed.hpp>

#include <core/analysis/proof/followed_chain.hpp>
#include <core/mechanics/model/effort.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/text/units.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace pmreport::analysis {

using mechanics::Bounded, mechanics::Enclosure, mechanics::Machine, mechanics::Trajectory;

namespace {

// The first span that is tried is this share of the motion; one that is proved at the first go is followed by one that much longer.
constexpr double first_share = 1.0 / 64, growth = 1.5;
// Of the motion's duration: how exactly the times are known at which a law may jump.
constexpr double exactness = 1e-9;

// Makes the chain, from the beginning of the motion on.
class ChainMaker {
 public:
  ChainMaker(const Trajectory& trajectory, const FollowedOptions& options, FollowedChain& chain)
      : trajectory_(trajectory), options_(options), chain_(chain), tools_(chain) {
    while (reached_ < trajectory.samples() && trajectory.reaches(reached_)) ++reached_;
  }

  // Why it ends before the motion does; empty: it does not.
  std::string run() {
    if (reached_ == 0) return "the motion was not followed";
    begin_ = proved_ = trajectory_.time.front();
    if (const Obstacle o = begin(); o != Obstacle::none) return in_words(o);
    const double end = trajectory_.time.back();
    double step = std::max(first_share * (end - begin_), options_.finest);
    for (int tried = 0; proved_ < end; ++tried) {
      if (tried == options_.most_spans)
        return fmt::format("{}: {} spans of time were tried by then, and no more are", from(), options_.most_spans);
      const double next = end - proved_ <= step ? end : proved_ + step;
      const Obstacle o = link(next);
      if (o == Obstacle::none) {
        if (rounds_ == 1) step *= growth;
        continue;
      }
      step = (next - proved_) / 2;
      if (step < options_.finest || !(proved_ + step > proved_)) return in_words(o);
    }
    return "";
  }
  double proved() const { return proved_; }

 private:
  enum class Obstacle { none, law, jump, geometry, singular, path, unfollowed };

  Obstacle begin();
  Obstacle link(double next);
  Obstacle arrive(const MovingBox& from, double at);
  Obstacle find_path(const MovingFrame& frame, Bounds time, Offsets& include);
  bool goes_on(double to) const;
  static Obstacle obstacle(Krawczyk::Found found);
  std::string from() const { return fmt::format("from t = {} s on", format_number(proved_, 7)); }
  std::string in_words(Obstacle o) const;

  const Trajectory& trajectory_;
  const FollowedOptions& options_;
  FollowedChain& chain_;
  FollowedChain::Tools tools_;
  int reached_ = 0;  // samples with a pose
  double begin_ = 0, proved_ = 0;
  MovingBox arrival_;  // the pose at `proved_`
  int rounds_ = 0;
};

ChainMaker::Obstacle ChainMaker::obstacle(Krawczyk::Found found) {
  switch (found) {
    case Krawczyk::Found::one:
      return Obstacle::none;
    case Krawczyk::Found::no_bounds:
      return Obstacle::geometry;
    default:
      return Obstacle::singular;
  }
}

// The pose at the first sample.
ChainMaker::Obstacle ChainMaker::begin() {
  std::array<Bounded, 6> actuators;
  if (!chain_.prescribed(Bounds::exactly(begin_), actuators.data())) return Obstacle::law;
  const auto frame = tools_.frames.at(begin_, actuators.data(), trajectory_.value.row(0));
  if (!frame) return Obstacle::path;
  Offsets path, only;
  path.fill(Bounds::exactly(0));
  if (const Obstacle o = find_path(*frame, Bounds::exactly(begin_), path); o != Obstacle::none) return o;
  arrival_.frame = *frame;
  return obstacle(
      tools_.krawczyk.find(*frame, Bounds::exactly(begin_), {actuators.data(), actuators.data()}, path, only, arrival_.offsets, rounds_));
}

// One more span, to `next`. The pose at which the chain has arrived lies in its box, in which it is the only one.
ChainMaker::Obstacle ChainMaker::link(double next) {
  for (const mechanics::Break& b : trajectory_.breaks)
    if (b.of == mechanics::Break::Of::value && proved_ <= b.time + chain_.near() && b.time - chain_.near() <= next) return Obstacle::jump;
  FollowedChain::Link link{{proved_, next}, {}, {}, {}, {}};
  const double middle = link.time.middle();
  std::array<Bounded, 6> over, at_middle;
  if (!chain_.prescribed(link.time, over.data()) || !chain_.prescribed(Bounds::exactly(middle), at_middle.data())) return Obstacle::law;
  const MovingFrame& before = arrival_.frame;
  const auto frame = tools_.frames.at(middle, at_middle.data(), before.origin + (middle - before.middle) * before.velocity);
  if (!frame) return Obstacle::singular;
  link.frame = *frame;
  const Offsets start = Krawczyk::seen_from(*frame, Bounds::exactly(proved_), arrival_);
  Offsets include = start;
  if (const Obstacle o = find_path(*frame, link.time, include); o != Obstacle::none) return o;
  const Krawczyk::Prescribed actuators{over.data(), at_middle.data(), chain_.steady(link.time)};
  const auto look = [&](const Offsets& with) {
    return tools_.krawczyk.find(*frame, link.time, actuators, with, link.only, link.within, rounds_);
  };
  if (const auto found = look(include); found == Krawczyk::Found::undecided && look(start) == Krawczyk::Found::one)
    return Obstacle::path;  // which has gone to another pose
  else if (found != Krawczyk::Found::one)
    return obstacle(found);
  if (!goes_on(next)) return Obstacle::unfollowed;
  if (!tools_.krawczyk.enclose(*frame, link.time, actuators, link.within, link.whole.data())) return Obstacle::singular;
  if (const Obstacle o = arrive({link.frame, link.within}, next); o != Obstacle::none) return o;
  chain_.add(std::move(link));
  proved_ = next;
  return Obstacle::none;
}

// The pose at the end of a span, as sharp as it can be.
ChainMaker::Obstacle ChainMaker::arrive(const MovingBox& from, double at) {
  const Bounds instant = Bounds::exactly(at);
  std::array<Bounded, 6> actuators;
  if (!chain_.prescribed(instant, actuators.data())) return Obstacle::law;
  const auto frame = tools_.frames.at(at, actuators.data(), from.frame.origin + (at - from.frame.middle) * from.frame.velocity);
  if (!frame) return Obstacle::singular;
  Offsets offsets = Krawczyk::seen_from(*frame, instant, from);
  if (!tools_.krawczyk.contract(*frame, instant, {actuators.data(), actuators.data()}, offsets)) return Obstacle::geometry;
  arrival_ = {*frame, offsets};
  return Obstacle::none;
}

// The path's samples during `time`, or where there are none the path in the middle, are where the actuators lead, and are to lie in the
// box.
ChainMaker::Obstacle ChainMaker::find_path(const MovingFrame& frame, Bounds time, Offsets& include) {
  const auto look = [&](double t, const SmallVector& q) {
    std::array<Bounded, 6> actuators;
    if (!chain_.prescribed(Bounds::exactly(t), actuators.data())) return Obstacle::law;
    if (!(tools_.frames.deviation(frame, q, actuators.data()) < options_.agreement)) return Obstacle::path;
    const SmallVector d = q - frame.origin - (t - frame.middle) * frame.velocity;
    for (int i = 0; i < d.size(); ++i) {
      Bounds& b = include[static_cast<std::size_t>(i)];
      b = hull(b, Bounds::exactly(d(i)));
    }
    return Obstacle::none;
  };
  const auto first = trajectory_.time.begin(), last = first + reached_;
  const auto from = std::lower_bound(first, last, time.low), to = std::upper_bound(from, last, time.high);
  Obstacle out = Obstacle::none;
  for (auto sample = from; sample != to && out == Obstacle::none; ++sample) out = look(*sample, trajectory_.value.row(sample - first));
  if (from != to) return out;
  SmallVector q(frame.origin.size()), rate(q.size()), acceleration(q.size());
  return trajectory_.at(frame.middle, q.data(), rate.data(), acceleration.data()) ? look(frame.middle, q) : Obstacle::unfollowed;
}

// Beyond its last sample with a pose the path ends somewhere.
bool ChainMaker::goes_on(double to) const {
  if (to <= trajectory_.time[static_cast<std::size_t>(reached_ - 1)]) return true;
  SmallVector q(trajectory_.value.cols()), rate(q.size()), acceleration(q.size());
  return trajectory_.at(to, q.data(), rate.data(), acceleration.data());
}

std::string ChainMaker::in_words(Obstacle o) const {
  switch (o) {
    case Obstacle::law:
      return from() + " the prescribed actuators have no bounds";
    case Obstacle::jump:
      return from() + " a prescribed actuator jumps";
    case Obstacle::geometry:
      return from() + " the geometry has no bounds, or jumps";
    case Obstacle::path:
      return from() + " the path that was followed is not where these actuators lead";
    case Obstacle::unfollowed:
      return from() + " the motion was not followed" + (trajectory_.ending.empty() ? "" : ": it " + trajectory_.ending);
    default:
      return from() + " the actuators are not proved to determine one pose: the motion comes too near to a singular surface";
  }
}

}  // namespace

FollowedProof prove_followed(const Machine& machine, const Trajectory& trajectory, const Enclosure& actuators,
                             const FollowedOptions& options) {
  FollowedProof out;
  const double first = trajectory.time.empty() ? 0 : trajectory.time.front();
  out.proved = Bounds::exactly(first);
  std::string why;
  const program::Program* geometry = machine.program(&why);
  if (geometry == nullptr) {
    out.reason = why;
    return out;
  }
  const double length = mechanics::characteristic_length(machine);
  SmallVector sizes(machine.dof());
  for (int i = 0; i < machine.dof(); ++i)
    sizes(i) = mechanics::size_of(machine.topology().coordinates[static_cast<std::size_t>(i)].sense(), length);
  const double duration = trajectory.time.empty() ? 0 : trajectory.time.back() - first;
  const auto chain = std::make_shared<FollowedChain>(ActuatorGeometry(*geometry, machine.layout().actuator(0)), sizes, actuators,
                                                     trajectory.knots, exactness * duration);
  ChainMaker prover(trajectory, options, *chain);
  out.reason = prover.run();
  out.spans = static_cast<int>(chain->links().size());
  if (chain->links().empty()) return out;
  out.proved.high = prover.proved();
  out.over = [chain](Bounds time, Bounded* bounded) { return chain->over(time, bounded); };
  return out;
}

}  // namespace pmreport::analysis
