// The chain of spans of time over which coordinates that follow prescribed actuators are proved, and what it answers.
#pragma once

#include <core/analysis/proof/followed_krawczyk.hpp>

#include <memory>
#include <mutex>
#include <vector>

namespace pmreport::analysis {

class FollowedChain {
 public:
  // `sizes`: of the coordinates. `jumps`: times at which, or within `near` of which, rates of the actuators may jump; rising.
  FollowedChain(ActuatorGeometry geometry, SmallVector sizes, mechanics::Enclosure actuators, std::vector<double> jumps, double near)
      : geometry_(std::move(geometry)), sizes_(std::move(sizes)), actuators_(std::move(actuators)), jumps_(std::move(jumps)), near_(near) {}

  struct Link {
    Bounds time;
    MovingFrame frame;
    Offsets only, within;                     // exactly one pose at every instant; where it is
    std::array<mechanics::Bounded, 6> whole;  // of all of its time
  };
  const std::vector<Link>& links() const { return links_; }
  void add(Link link) { links_.push_back(std::move(link)); }

  const ActuatorGeometry& geometry() const { return geometry_; }
  const SmallVector& sizes() const { return sizes_; }
  // The actuators over a span of time. False where they have no bounds.
  bool prescribed(Bounds time, mechanics::Bounded* out) const;

  double near() const { return near_; }
  bool steady(Bounds time) const;  // no rate of the actuators jumps

  // What one thread computes with.
  struct Tools {
    explicit Tools(const FollowedChain& chain) : frames(chain.geometry_, chain.sizes_), krawczyk(chain.geometry_, chain.sizes_) {}
    FrameFinder frames;
    Krawczyk krawczyk;
  };

  // The coordinates over a span of time. False where it is not within the chain's. Safe in threads.
  bool over(Bounds time, mechanics::Bounded* out) const;

 private:
  std::array<mechanics::Bounded, 6> within(const Link& link, Bounds time, Tools& tools) const;
  bool find(const Link& link, Bounds time, const MovingFrame& frame, const Krawczyk::Prescribed& actuators, Tools& tools,
            Offsets& offsets) const;

  ActuatorGeometry geometry_;
  SmallVector sizes_;
  mechanics::Enclosure actuators_;
  std::vector<double> jumps_;
  double near_;
  std::vector<Link> links_;
  mutable std::mutex shelf_;
  mutable std::vector<std::unique_ptr<Tools>> tools_;  // that nobody uses
};

}  // namespace pmreport::analysis
