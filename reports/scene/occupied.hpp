// How much of a rectangle of the picture is already taken by what is drawn there.
#pragma once

#include <reports/scene/view.hpp>
#include <vector>

namespace pmreport::scene {

struct Disc {
  Eigen::Vector2d centre;  // [px]
  double radius;           // [px]
};

class Occupied {
 public:
  Occupied(const Scene& scene, const View& view, int width, int height);
  double share(double x, double y, double width, double height) const;  // 0 free, 1 full of things better left uncovered
  const std::vector<Disc>& joints() const { return joints_; }           // balls and labelled symbols: no label may touch them

 private:
  int columns_, rows_;
  std::vector<std::uint32_t> sums_;  // of all cells above and to the left
  std::vector<Disc> joints_;
};

}  // namespace pmreport::scene
