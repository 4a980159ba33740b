#include <core/analysis/proof/followed.hpp>

#include <core/analysis/proof/followed_krawczyk.hpp>
#include <core/mechanics/model/effort.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/text/units.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <mutex>

namespace pmreport::analysis {

using mechanics::Bounded, mechanics::Enclosure, mechanics::Machine, mechanics::Trajectory;

namespace {

// The first span that is tried is this share of the motion; one that is proved at the first go is followed by a longer one.
constexpr double first_share = 1.0 / 64, growth = 1.5;

using Prescribed = std::array<Bounded, 6>;

// Of the chain.
struct Span {
  Bounds time;
  MovingFrame frame;
  Offsets only, within;             // exactly one pose at every instant; where it is
  std::array<Bounded, 6> enclosure;  // over all of the span
};

// What one thread computes with.
struct Bench {
  Bench(const ActuatorGeometry& geometry, const SmallVector& sizes) : frames(geometry, sizes), krawczyk(geometry, sizes) {}
  FrameFinder frames;
  Krawczyk krawczyk;
};

Bounded hull(const Bounded& a, const Bounded& b) {
  return {hull(a.value, b.value), hull(a.rate, b.rate), hull(a.acceleration, b.acceleration)};
}
Bounded common(const Bounded& a, const Bounded& b) {
  return {common(a.value, b.value), common(a.rate, b.rate), common(a.acceleration, b.acceleration)};
}

class Chain {
 public:
  Chain(const program::Program& geometry, std::size_t first, SmallVector sizes, Enclosure actuators)
      : geometry_(geometry, first), sizes_(std::move(sizes)), actuators_(std::move(actuators)) {}

  const ActuatorGeometry& geometry() const { return geometry_; }
  const SmallVector& sizes() const { return sizes_; }
  const std::vector<Span>& spans() const { return spans_; }
  void add(Span span) { spans_.push_back(std::move(span)); }
  bool prescribed(Bounds time, Prescribed& out) const { return actuators_(time, out.data()); }

  // Between the beginning and the end of the chain.
  bool over(Bounds time, Bounded* out) const {
    if (spans_.empty() || !(spans_.front().time.low <= time.low && time.low <= time.high && time.high <= spans_.back().time.high))
      return false;
    auto span = std::ranges::lower_bound(spans_, time.low, {}, [](const Span& s) { return s.time.high; });
    const std::unique_ptr<Bench> bench = borrow();
    std::array<Bounded, 6> all = over(*bench, *span, common(time, span->time));
    for (++span; span != spans_.end() && span->time.low < time.high; ++span) {
      const std::array<Bounded, 6> more = over(*bench, *span, common(time, span->time));
      for (std::size_t i = 0; i < dof(); ++i) all[i] = hull(all[i], more[i]);
    }
    give_back(bench);
    std::copy_n(all.begin(), dof(), out);
    return true;
  }

 private:
  std::size_t dof() const { return static_cast<std::size_t>(geometry_.dof); }
