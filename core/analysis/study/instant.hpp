// A run at one time of its motion, between the samples too: one sample more, of which every column can be read.
#pragma once

#include <core/analysis/analysis.hpp>

#include <optional>

namespace pmreport::analysis {

// Keeps its own scenario and trajectory; the machine of the run must live as long.
class Instant {
 public:
  // `t` [s]: within the motion. The pose there is solved anew, from the motion's own law, and all that follows from it.
  Instant(const Analysis& a, double t);
  Instant(const Instant&) = delete;
  Instant& operator=(const Instant&) = delete;

  double value(const ColumnId& column) const;  // NaN where the motion has no pose, or the pose no such value

 private:
  scenario::Scenario scenario_;
  mechanics::Trajectory trajectory_;
  std::optional<Analysis> at_;
};

}  // namespace pmreport::analysis
