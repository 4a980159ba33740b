#include <core/program/intervals/interval_lanes.hpp>
#include <core/program/intervals/rounding.hpp>
#include <tests/bench/interval_kernel.hpp>

namespace pmreport::bench {

namespace {

using program::Interval;
using program::IntervalLanes;

// The alternative: rounding to nearest, and each end then moved to a neighbour or beyond, x + (|x| 2^-53 (1 + 2^-52) + 2^-1022). For this
// kernel, and with no thought of what is not bounded.
template <class S>
struct Widened {
  S negative_low, high;

  Widened(double c) : negative_low(-c), high(c) {}
  Widened(const S& n, const S& h) : negative_low(n), high(h) {}

  static S outward(const S& x) { return x + (abs(x) * 0x1.0000000000001p-53 + 0x1p-1022); }
  static S most(const S& a, const S& b) { return choose(a < b, b, a); }
  friend Widened operator+(const Widened& a, const Widened& b) {
    return {outward(a.negative_low + b.negative_low), outward(a.high + b.high)};
  }
  friend Widened operator-(const Widened& a, const Widened& b) {
    return {outward(a.negative_low + b.high), outward(a.high + b.negative_low)};
  }
  friend Widened operator+(const Widened& a, double c) { return {outward(a.negative_low - c), outward(a.high + c)}; }
  friend Widened operator*(const Widened& a, double c) {
    return c > 0 ? Widened(outward(a.negative_low * c), outward(a.high * c)) : Widened(outward(a.high * -c), outward(a.negative_low * -c));
  }
  friend Widened square(const Widened& a) {
    const S farthest = most(a.negative_low, a.high), nearest = most(S(0.0), most(-a.negative_low, -a.high));
    return {outward(-nearest * nearest), outward(farthest * farthest)};
  }
  friend Widened sqrt(const Widened& a) { return {outward(-sqrt(most(S(0.0), -a.negative_low))), outward(sqrt(a.high))}; }
};

template <class S>
struct Ends {
  std::array<S, 3> negative_low, high;
};
Ends<double> ends_of(const PositionBox& b) {
  Ends<double> out;
  for (std::size_t c = 0; c < 3; ++c) {
    out.negative_low[c] = b.half - b.middle[c];
    out.high[c] = b.middle[c] + b.half;
  }
  return out;
}
Ends<Lanes> ends_of(const PositionBox* b) {
  Ends<Lanes> out;
  for (std::size_t c = 0; c < 3; ++c) {
    double n[Lanes::width], h[Lanes::width];
    for (std::size_t i = 0; i < Lanes::width; ++i) {
      n[i] = b[i].half - b[i].middle[c];
      h[i] = b[i].middle[c] + b[i].half;
    }
    out.negative_low[c] = Lanes::load(n);
    out.high[c] = Lanes::load(h);
  }
  return out;
}
double sum_of(const Lanes& x) {
  double each[Lanes::width], sum = 0;
  x.store(each);
  for (const double e : each) sum += e;
  return sum;
}

// One box after the other, or as many as there are lanes. `make` gives a coordinate from its negative low and its high end.
template <class T, class Make>
double one_by_one(const Hexapod& hexapod, std::span<const PositionBox> boxes, Make&& make) {
  double sum = 0;
  for (const PositionBox& b : boxes) {
    const Ends<double> e = ends_of(b);
    sum -= margins<T>(hexapod, {make(e.negative_low[0], e.high[0]), make(e.negative_low[1], e.high[1]), make(e.negative_low[2], e.high[2])})
               .negative_low;
  }
  return sum;
}
template <class T, class Make>
double by_lanes(const Hexapod& hexapod, std::span<const PositionBox> boxes, Make&& make) {
  Lanes sum(0.0);
  for (std::size_t k = 0; k + Lanes::width <= boxes.size(); k += Lanes::width) {
    const Ends<Lanes> e = ends_of(&boxes[k]);
    sum -= margins<T>(hexapod, {make(e.negative_low[0], e.high[0]), make(e.negative_low[1], e.high[1]), make(e.negative_low[2], e.high[2])})
               .negative_low;
  }
  return sum_of(sum);
}

}  // namespace

double in_plain_numbers(const Hexapod& hexapod, std::span<const PositionBox> boxes) {
  double sum = 0;
  for (const PositionBox& b : boxes) sum += margins<double>(hexapod, {b.middle[0], b.middle[1], b.middle[2]});
  return sum;
}
double in_plain_lanes(const Hexapod& hexapod, std::span<const PositionBox> boxes) {
  Lanes sum(0.0);
  for (std::size_t k = 0; k + Lanes::width <= boxes.size(); k += Lanes::width) {
    std::array<Lanes, 3> p;
    for (std::size_t c = 0; c < 3; ++c) {
      double at[Lanes::width];
      for (std::size_t i = 0; i < Lanes::width; ++i) at[i] = boxes[k + i].middle[c];
      p[c] = Lanes::load(at);
    }
    sum += margins<Lanes>(hexapod, p);
  }
  return sum_of(sum);
}

double in_intervals(const Hexapod& hexapod, std::span<const PositionBox> boxes) {
  return program::round_upward(
      [&] { return one_by_one<Interval>(hexapod, boxes, [](double n, double h) { return Interval::of_ends(n, h); }); });
}
double in_interval_lanes(const Hexapod& hexapod, std::span<const PositionBox> boxes) {
  return program::round_upward(
      [&] { return by_lanes<IntervalLanes>(hexapod, boxes, [](const Lanes& n, const Lanes& h) { return IntervalLanes::of_ends(n, h); }); });
}
double in_widened(const Hexapod& hexapod, std::span<const PositionBox> boxes) {
  return one_by_one<Widened<double>>(hexapod, boxes, [](double n, double h) { return Widened<double>(n, h); });
}
double in_widened_lanes(const Hexapod& hexapod, std::span<const PositionBox> boxes) {
  return by_lanes<Widened<Lanes>>(hexapod, boxes, [](const Lanes& n, const Lanes& h) { return Widened<Lanes>(n, h); });
}

}  // namespace pmreport::bench
