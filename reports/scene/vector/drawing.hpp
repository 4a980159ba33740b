// A picture of a scene as vectors: regions filled with a paint, lines, labels. It is made once and painted on any paper.
#pragma once

#include <cairo.h>

#include <reports/scene/labels.hpp>
#include <reports/scene/vector/visibility.hpp>
#include <string>
#include <vector>

namespace pmreport::scene {

struct Paint {
  enum class Kind { flat, across, round } kind = Kind::flat;  // one colour; changing from `from` to `to`; about the ball at `to`
  Eigen::Vector2d from{0, 0}, to{0, 0};                       // [px]
  double radius = 0;                                          // [px] of the ball
  struct Stop {
    double at;  // 0 to 1
    Color color;
  };
  std::vector<Stop> stops;  // of a flat one the first
};

struct Stroke {
  std::vector<Eigen::Vector2d> points;  // [px]
  Color color;
  double width;  // [pt]
  bool closed = false;
  std::vector<double> dash;  // [pt] on, off
};

struct Area {
  Region region;
  Paint paint;
};

// Painted in this order: areas one over the other, then strokes.
struct Layer {
  double opacity = 1;  // of the whole
  std::vector<Area> areas;
  std::vector<Stroke> strokes;
};

enum class Manner {
  shaded,  // light from the upper left
  plain    // each solid in its colour, as line drawings are
};

struct Drawing {
  Manner manner = Manner::shaded;
  int width = 0, height = 0;  // [px] of the picture that it stands beside
  double printed = 85;        // [mm]
  std::vector<Layer> layers;
  std::vector<LabelSpot> labels;
  std::vector<Color> label_colors;
  double points_per_pixel() const { return printed * 72 / 25.4 / width; }
};

// The scene as the renderer shows it, without ground: hidden surfaces away, hidden parts of what shows through as thin dashed lines.
// Silhouettes and the boundaries of hidden parts are dark lines, edges and intersections within a body thin ones. Translucent surfaces lie
// over solids that they do not stand behind, in two layers, the side turned away and the side turned to the viewer.
Drawing draw(const Scene& scene, const Camera& camera, const Quality& quality, Manner manner = Manner::shaded);

// Over a rectangle `width` [pt] wide from the origin on, on white unless `transparent`.
void paint(cairo_t* cr, const Drawing& drawing, double width, bool transparent = false);

// A page `printed` wide; the same bytes every time.
std::string to_pdf(const Drawing& drawing);
// Ids begin with `id`, so that several fit one page; `title` is its accessible name.
std::string to_svg(const Drawing& drawing, const std::string& id, const std::string& title);
std::string to_png(const Drawing& drawing, bool transparent = false);  // as large as the picture

}  // namespace pmreport::scene
