// What a workspace came to, as single numbers.
#pragma once

#include <core/analysis/bracketed.hpp>
#include <core/analysis/workspace/workspace.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pmreport::analysis {

// Points of a grid with at least so many accepted orientations.
std::uint64_t points_with(const std::vector<std::uint32_t>& accepted_at, std::uint64_t need);
// Of these, those with a neighbour that is none, or without one: where the border of the set passes. A pose is a cell, and of those at the
// border another grid may have all or nothing. There must be a grid.
std::uint64_t rim_of(const Workspace& w, std::uint64_t need);

// The least, or the largest, value of a point axis among such points; nothing where there are none. There must be a grid.
std::optional<double> end_of_points(const Workspace& w, std::uint64_t need, std::size_t axis, bool high);

// By the method that the section names first; where that gave nothing, as a proof that was not made, by the next. With orientations: of the
// points where at least as many as at_least names first are accepted.
class WorkspaceAnswers {
 public:
  explicit WorkspaceAnswers(const Workspace& w);

  bool any() const { return method_.has_value(); }
  std::optional<ScanMethod> method() const { return method_; }
  // The bracket of a proof, the 95 % interval of random poses; of a grid as it was counted, with its resolution.
  Bracketed volume() const;
  // Of point axis `axis`. By a proof as far as poses are known to be within, with the bracket of the true end; NaN where the set may be
  // empty, or random poses looked at it.
  Bracketed end(std::size_t axis, bool high) const;
  bool empty() const;  // this and the next: of one that has any
  bool ended_early() const;
  // Names of the scanned coordinates whose range ends where the set may go on.
  std::vector<std::string> cut_off(const Topology& topology) const;

 private:
  std::uint64_t need() const { return w_.request.at_least.empty() ? 1 : w_.request.at_least.front(); }
  std::uint64_t accepted() const { return points_with(w_.grid->accepted_at, need()); }

  const Workspace& w_;
  std::optional<ScanMethod> method_;
};

}  // namespace pmreport::analysis
