// Where labels stand, and how they are written over a finished picture.
#pragma once

#include <cairo.h>

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

// How labels are written: in letters of `size`, with the picture's pixels `scale` units wide. `boxed`: on a white box in place of a rim,
// which interrupts the lines of a drawing.
struct Lettering {
  double size, scale = 1;
  bool boxed = false;
};
// `colors`: of each spot. Words are kept as words where a page can hold them.
void write_labels(cairo_t* cr, const std::vector<LabelSpot>& spots, const std::vector<Color>& colors, const Lettering& lettering);

void draw_labels(Image& image, const Scene& scene, const Camera& camera, const Quality& quality);

}  // namespace pmreport::scene
