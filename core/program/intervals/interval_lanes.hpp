// Several intervals at once, one in each lane of a vector register. Each lane has the digits that it would have alone.
#pragma once

#include <array>
#include <core/program/intervals/interval.hpp>
#include <pmreport/lanes.hpp>

namespace pmreport::program {

using IntervalLanes = BasicInterval<Lanes>;

// The functions of the mathematical library, one lane after the other.
template <class F, class... X>
IntervalLanes on_lanes(F&& f, const IntervalLanes& a, const X&... b) {
  using Numbers = std::array<double, Lanes::width>;
  const auto stored = [](const Lanes& x) {
    Numbers out;
    x.store(out.data());
    return out;
  };
  const auto lanes = [&stored](const IntervalLanes& x) { return std::pair(stored(x.negative_low), stored(x.high)); };
  const auto evaluated = [&f](const auto&... x) {
    Numbers n, h;
    for (std::size_t i = 0; i < Lanes::width; ++i) {
      const Ends r = f(Ends{x.first[i], x.second[i]}...);
      n[i] = r.negative_low;
      h[i] = r.high;
    }
    return IntervalLanes::of_ends(Lanes::load(n.data()), Lanes::load(h.data()));
  };
  return evaluated(lanes(a), lanes(b)...);
}

}  // namespace pmreport::program
