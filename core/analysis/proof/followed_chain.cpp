#include <core/analysis/proof/followed_chain.hpp>

#include <algorithm>

namespace pmreport::analysis {

using mechanics::Bounded;

namespace {

using Coordinates = std::array<Bounded, 6>;

Bounded both_of(const Bounded& a, const Bounded& b) {
  return {common(a.value, b.value), common(a.rate, b.rate), common(a.acceleration, b.acceleration)};
}
Bounded either_of(const Bounded& a, const Bounded& b) {
  return {hull(a.value, b.value), hull(a.rate, b.rate), hull(a.acceleration, b.acceleration)};
}

}  // namespace

bool FollowedChain::prescribed(Bounds time, Bounded* out) const {
  const auto known = [](const Bounded& b) { return b.value.bounded() && b.rate.bounded(); };
  return actuators_(time, out) && std::all_of(out, out + geometry_.dof, known);
}

bool FollowedChain::over(Bounds time, Bounded* out) const {
  if (links_.empty() || !(links_.front().time.low <= time.low && time.low <= time.high && time.high <= links_.back().time.high))
    return false;
  std::unique_ptr<Tools> tools;
  {
    const std::lock_guard lock(shelf_);
    if (!tools_.empty()) tools = std::move(tools_.back()), tools_.pop_back();
  }
  if (!tools) tools = std::make_unique<Tools>(*this);

  auto link = std::ranges::lower_bound(links_, time.low, {}, [](const Link& l) { return l.time.high; });
  Coordinates all = within(*link, common(time, link->time), *tools);
  for (++link; link != links_.end() && link->time.low < time.high; ++link) {
    const Coordinates more = within(*link, common(time, link->time), *tools);
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = either_of(all[i], more[i]);
  }
  std::copy_n(all.begin(), geometry_.dof, out);

  const std::lock_guard lock(shelf_);
  tools_.push_back(std::move(tools));
  return true;
}

bool FollowedChain::steady(Bounds time) const {
  const auto next = std::ranges::lower_bound(jumps_, time.low - near_);
  return next == jumps_.end() || *next > time.high + near_;
}

// What is known of all of the link holds of a part of it; and a frame that moves with the part sees it sharper.
std::array<Bounded, 6> FollowedChain::within(const Link& link, Bounds time, Tools& tools) const {
  if (time == link.time) return link.whole;
  const auto m = static_cast<std::size_t>(geometry_.dof);
  Coordinates over, at_middle, out = link.whole, sharper;
  const double middle = time.middle();
  if (!prescribed(time, over.data()) || !prescribed(Bounds::exactly(middle), at_middle.data())) return out;
  const auto frame = tools.frames.at(middle, at_middle.data(), link.frame.origin + (middle - link.frame.middle) * link.frame.velocity);
  const Krawczyk::Prescribed actuators{over.data(), at_middle.data(), steady(time)};
  Offsets offsets;
  if (!frame || !find(link, time, *frame, actuators, tools, offsets) ||
      !tools.krawczyk.enclose(*frame, time, actuators, offsets, sharper.data()))
    return out;
  for (std::size_t i = 0; i < m; ++i) out[i] = both_of(out[i], sharper[i]);
  return out;
}

// What has exactly one solution in a box of its own, that lies where the link has only one, has the same. Where that does not show, the
// link's box is made smaller.
bool FollowedChain::find(const Link& link, Bounds time, const MovingFrame& frame, const Krawczyk::Prescribed& actuators, Tools& tools,
                         Offsets& offsets) const {
  Offsets none, only;
  none.fill(Bounds::exactly(0));
  int rounds = 0;
  if (tools.krawczyk.find(frame, time, actuators, none, only, offsets, rounds) == Krawczyk::Found::one) {
    const Offsets seen = Krawczyk::seen_from(link.frame, time, {frame, offsets});
    bool inside = true;
    for (std::size_t i = 0; i < static_cast<std::size_t>(geometry_.dof); ++i)
      inside = inside && link.only[i].low <= seen[i].low && seen[i].high <= link.only[i].high;
    if (inside) return true;
  }
  offsets = Krawczyk::seen_from(frame, time, {link.frame, link.within});
  return tools.krawczyk.contract(frame, time, actuators, offsets);
}

}  // namespace pmreport::analysis
