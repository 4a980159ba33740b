// What leaves its range along a motion: strokes of actuators and limits of joints.
#pragma once

#include <core/analysis/column_store.hpp>
#include <pmreport/topology.hpp>

#include <string>
#include <vector>

namespace pmreport::analysis {

struct LimitBreach {    // one limited quantity that leaves its range
  std::string subject;  // "l3 (length of limb 3)", "A2 (deflection of the ball joint)"
  std::string unit;     // SI
  std::vector<int> samples;
  int worst = 0;  // sample with the largest excess
  double value = 0, limit = 0;
  bool above = false;  // above the upper end, else below the lower
  bool stroke = false;
};

struct SampleRun {
  int first, last;  // samples, inclusive
};
// Runs of the samples 0 to n - 1 that are `in`.
template <class Predicate>
std::vector<SampleRun> runs(int n, Predicate&& in) {
  std::vector<SampleRun> out;
  for (int k = 0; k < n; ++k) {
    if (!in(k)) continue;
    if (!out.empty() && out.back().last == k - 1)
      out.back().last = k;
    else
      out.push_back({k, k});
  }
  return out;
}

// From the columns of actuators and joints. A limit that is met exactly is kept.
std::vector<LimitBreach> find_breaches(const Topology& t, const ColumnStore& columns);
// Runs of samples that break some limit.
std::vector<SampleRun> broken_runs(const std::vector<LimitBreach>& breaches, int samples);

}  // namespace pmreport::analysis
