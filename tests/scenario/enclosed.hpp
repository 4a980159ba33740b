// Bounds over spans of time against what is at instants of them, in extended precision.
#pragma once

#include <cmath>
#include <core/program/intervals/bounds.hpp>
#include <functional>
#include <pmreport/jet.hpp>
#include <random>
#include <string>

namespace enclosed {

using pmreport::Jet;
using pmreport::program::Bounds;
using Real = long double;
using Over = std::function<Jet<Bounds>(Bounds)>;
using At = std::function<Jet<Real>(Real)>;  // not finite: not known there

inline bool outside(const Bounds& b, Real x) { return std::isfinite(x) && (x < Real(b.low) || x > Real(b.high)); }

// A span within [begin, end], as often short as long: of all lengths between 1e-9 of the whole and the whole.
inline Bounds random_span(std::mt19937& generator, double begin, double end) {
  std::uniform_real_distribution<double> share(0, 1), digits(-9, 0);
  const double length = (end - begin) * std::pow(10, digits(generator)), low = begin + share(generator) * (end - begin - length);
  return {low, std::min(low + length, end)};
}

struct Escaped {
  int instants = 0, unbounded = 0, spans = 0;
  std::string first;  // of what is outside
};
// At `instants` of every span, its ends among them.
inline void check(const Over& over, const At& at, const Bounds& span, int instants, std::mt19937& generator, Escaped& out) {
  const Jet<Bounds> bounds = over(span);
  ++out.spans;
  if (!bounds.value.bounded()) ++out.unbounded;
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < instants; ++i) {
    const double t = i == 0 ? span.low : i == 1 ? span.high : std::min(span.high, span.low + share(generator) * (span.high - span.low));
    const Jet<Real> x = at(t);
    if (!outside(bounds.value, x.value) && !outside(bounds.rate, x.rate) && !outside(bounds.acceleration, x.acceleration)) continue;
    if (out.instants++ > 0) continue;
    char text[400];
    std::snprintf(text, sizeof text,
                  "span [%.17g, %.17g], t %.17g: %.20Lg in [%.17g, %.17g], %.20Lg in [%.17g, %.17g], %.20Lg in [%.17g, %.17g]", span.low,
                  span.high, t, x.value, bounds.value.low, bounds.value.high, x.rate, bounds.rate.low, bounds.rate.high, x.acceleration,
                  bounds.acceleration.low, bounds.acceleration.high);
    out.first = text;
  }
}
// Over random spans of the motion, over the whole of it and at points.
inline Escaped escaped(const Over& over, const At& at, double begin, double end, int spans, std::mt19937& generator) {
  Escaped out;
  check(over, at, {begin, end}, 50, generator, out);
  std::uniform_real_distribution<double> time(begin, end);
  for (int i = 0; i < spans; ++i) {
    check(over, at, random_span(generator, begin, end), 10, generator, out);
    check(over, at, Bounds::exactly(time(generator)), 1, generator, out);
  }
  return out;
}

}  // namespace enclosed
