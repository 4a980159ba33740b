// Orientations of a scan with all that they decide, and what is common to neighbours among them.
#pragma once

#include <core/program/intervals/bounds.hpp>
#include <core/scan/judge/plan.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace pmreport::scan {

// A stretch of the list, sorted such that neighbours stand together: halved again and again across the coordinate in which they differ
// most.
class Orientations {
 public:
  Orientations(const Plan& plan, std::size_t first, std::size_t count);

  std::size_t size() const { return numbers_.size(); }
  std::size_t place(std::size_t k) const { return numbers_[k] - first_; }  // within the stretch as it is listed
  // All inputs of the plan's inner program; those that points move are not set.
  const double* others(std::size_t k) const { return rows_.data() + k * width_; }

  // A node has the orientations from `begin` to `end`; a half of it each of its children, if there are any. The first has all.
  struct Node {
    std::size_t begin, end;
    int children;  // the first of the two; 0: none
    double share;  // how far its orientations differ, of all of the scan
  };
  const Node& node(int n) const { return nodes_[static_cast<std::size_t>(n)]; }
  // Nodes that have all orientations among them, each no more than so many where it has more than one.
  std::vector<int> parts(std::uint64_t most) const;
  // Of each input of the inner program the least and the largest value that an orientation of the node gives it: what is computed from them
  // in intervals bounds what is computed for each orientation alone.
  std::span<const program::Bounds> bounds(int n) const { return {hulls_.data() + static_cast<std::size_t>(n) * width_, width_}; }

 private:
  double spread(std::size_t begin, std::size_t end, std::size_t* widest) const;
  void halve(int n);
  void fill();
  void enclose(int n);
  void add_parts(int n, std::uint64_t most, std::vector<int>& out) const;

  const Plan& plan_;
  std::size_t first_, width_;
  std::vector<std::size_t> numbers_;
  std::vector<double> whole_;  // of each turned coordinate its range in the scan
  std::vector<double> rows_;
  std::vector<Node> nodes_;
  std::vector<program::Bounds> hulls_;
};

}  // namespace pmreport::scan
