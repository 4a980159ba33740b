// What a claim of a proof says of one instant, and whether that is so.
#pragma once

#include <core/analysis/proof/proof.hpp>
#include <tests/proof/law.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace pmreport::test {

using Number = long double;

inline bool within(const program::Bounds& time, Number t) { return time.low <= t && t <= time.high; }
// About the ends of a stretch, where the claim may hold or not.
inline bool doubtful(const analysis::Claim& claim, Number t) {
  return std::ranges::any_of(claim.undecided, [&](const program::Bounds& u) { return within(u, t); }) ||
         std::ranges::any_of(claim.broken, [&](const analysis::Claim::Broken& b) { return within(b.begin, t) || within(b.end, t); });
}
inline const analysis::Claim::Broken* certainly_broken(const analysis::Claim& claim, Number t) {
  for (const analysis::Claim::Broken& b : claim.broken)
    if (b.begin.high <= t && t <= b.end.low) return &b;
  return nullptr;
}

// One claim against the value at an instant; a sentence where they differ.
inline std::string against(const analysis::Claim& claim, Number t, Number value, Number tolerance) {
  const bool above = value > claim.range.max + tolerance, below = value < claim.range.min - tolerance;
  if (const analysis::Claim::Broken* b = certainly_broken(claim, t)) {
    if (b->above ? !(value > claim.range.max - tolerance) : !(value < claim.range.min + tolerance))
      return fmt::format("said to be broken at {} s, and is {} there", t, value);
    if (b->above ? value > b->worst.high + tolerance : value < b->worst.low - tolerance)
      return fmt::format("said to be at worst between {} and {}, and is {} at {} s", b->worst.low, b->worst.high, value, t);
    return "";
  }
  if (doubtful(claim, t)) return "";
  if (above || below || std::isnan(value)) return fmt::format("said to hold at {} s, and is {} there", t, value);
  return "";
}

}  // namespace pmreport::test
