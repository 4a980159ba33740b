// Labels written over a finished picture.
#pragma once

#include <reports/scene/scene.hpp>
#include <string>

namespace pmreport::scene {

// How a label is set: "A1" as A with the subscript 1, in Pango's markup, at `size` [px].
std::string label_markup(const std::string& text, double size);
constexpr double halo = 0.13;  // white rim around the letters, in font sizes; part of the box

// A label's box with what drawing needs to know: which label of the scene it is, and its leader line where it stands away from its point.
struct LabelSpot {
  std::size_t index;
  PlacedLabel box;
  bool leader = false;
  Eigen::Vector2d from{0, 0}, to{0, 0};  // [px]
};
std::vector<LabelSpot> find_spots(const Scene& scene, const Camera& camera, const Quality& quality);

void draw_labels(Image& image, const Scene& scene, const Camera& camera, const Quality& quality);

}  // namespace pmreport::scene
