#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <reports/scene/occupied.hpp>

namespace pmreport::scene {

namespace {

constexpr int cell = 4;  // [px]

// Weights: text over a plate reads well, over a limb or an axis it does not.
constexpr double weight_plate = 0.22, weight_limb = 0.7, weight_line = 0.6;

struct Canvas {
  cairo_surface_t* surface;
  cairo_t* cr;
  Canvas(int width, int height) : surface(cairo_image_surface_create(CAIRO_FORMAT_A8, width, height)), cr(cairo_create(surface)) {}
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;
  ~Canvas() {
    cairo_destroy(cr);
    cairo_surface_destroy(surface);
  }
};

void polygon(cairo_t* cr, const std::vector<Eigen::Vector3d>& points, const View& view) {
  for (const auto& p : points) {
    const Eigen::Vector3d s = view.see(p);
    cairo_line_to(cr, s.x(), s.y());
  }
}

// The circle around a solid that stands, by its middle, at a labelled point: a ball, a hinge, an arm of a cross. A label that knows
// what it is to keep clear of labels no joint.
std::optional<Disc> joint_symbol(const Scene& scene, const Solid& s, const View& view) {
  const bool round = s.kind == Solid::Kind::ball, bar = s.kind == Solid::Kind::cylinder;
  if (!round && !bar) return std::nullopt;
  const Eigen::Vector3d middle = round ? s.a : Eigen::Vector3d((s.a + s.b) / 2);
  const bool labelled = std::any_of(scene.labels.begin(), scene.labels.end(),
                                    [&](const Label& l) { return l.clear == 0 && (l.at - middle).norm() * view.scale() < 0.5; });
  if (!round && !labelled) return std::nullopt;
  const double half = round ? 0 : (view.see(s.b) - view.see(s.a)).head<2>().norm() / 2;
  return Disc{view.see(middle).head<2>(), std::max(half, s.radius * view.scale())};
}

}  // namespace

Occupied::Occupied(const Scene& scene, const View& view, int width, int height)
    : columns_((width + cell - 1) / cell), rows_((height + cell - 1) / cell) {
  const Canvas canvas(columns_, rows_);
  cairo_t* cr = canvas.cr;
  cairo_scale(cr, 1.0 / cell, 1.0 / cell);
  cairo_set_line_cap(cr, CAIRO_LINE_CAP_ROUND);
  for (const Solid& s : scene.solids) {
    if (const auto symbol = joint_symbol(scene, s, view)) joints_.push_back(*symbol);
    cairo_new_path(cr);
    if (s.kind == Solid::Kind::plate) {
      polygon(cr, s.outline, view);
      cairo_set_source_rgba(cr, 0, 0, 0, weight_plate * s.color.a);
      cairo_fill(cr);
      continue;
    }
    const double r = s.radius * view.scale();
    const Eigen::Vector3d a = view.see(s.a);
    cairo_set_source_rgba(cr, 0, 0, 0, weight_limb * s.color.a);
    if (s.kind == Solid::Kind::ball) {
      cairo_arc(cr, a.x(), a.y(), r, 0, 2 * std::numbers::pi);
      cairo_fill(cr);
    } else if (s.kind == Solid::Kind::box) {
      const auto c = corners(s);
      for (const std::size_t axis : {1u, 2u, 4u})
        for (const std::size_t side : {std::size_t{0}, axis}) {
          const std::size_t u = axis == 1 ? 2 : 1, v = axis == 4 ? 2 : 4;
          cairo_new_path(cr);
          polygon(cr, {c[side], c[side | u], c[side | u | v], c[side | v]}, view);
          cairo_set_source_rgba(cr, 0, 0, 0, weight_limb * s.color.a);
          cairo_fill(cr);
        }
    } else {
      polygon(cr, {s.a, s.b}, view);
      cairo_set_line_width(cr, std::max(2 * r, 1.0));
      cairo_stroke(cr);
    }
  }
  cairo_set_source_rgba(cr, 0, 0, 0, weight_line);
  for (const Polyline& l : scene.lines) {
    cairo_new_path(cr);
    polygon(cr, l.points, view);
    cairo_set_line_width(cr, std::max(l.width, 2.0));
    cairo_stroke(cr);
  }
  cairo_surface_flush(canvas.surface);

  const unsigned char* data = cairo_image_surface_get_data(canvas.surface);
  const int stride = cairo_image_surface_get_stride(canvas.surface);
  const auto line = static_cast<std::size_t>(columns_ + 1);
  sums_.assign(line * static_cast<std::size_t>(rows_ + 1), 0);
  for (int y = 0; y < rows_; ++y)
    for (int x = 0; x < columns_; ++x) {
      const std::size_t at = static_cast<std::size_t>(y + 1) * line + static_cast<std::size_t>(x + 1);
      sums_[at] = data[y * stride + x] + sums_[at - 1] + sums_[at - line] - sums_[at - line - 1];
    }
}

double Occupied::share(double x, double y, double width, double height) const {
  const auto column = [&](double v) { return static_cast<std::size_t>(std::clamp(static_cast<int>(std::floor(v / cell)), 0, columns_)); };
  const auto row = [&](double v) { return static_cast<std::size_t>(std::clamp(static_cast<int>(std::floor(v / cell)), 0, rows_)); };
  const std::size_t left = column(x), right = column(x + width + cell), top = row(y), bottom = row(y + height + cell);
  const std::size_t line = static_cast<std::size_t>(columns_ + 1), cells = (right - left) * (bottom - top);
  if (cells == 0) return 0;
  const std::uint32_t sum =
      sums_[bottom * line + right] - sums_[top * line + right] - sums_[bottom * line + left] + sums_[top * line + left];
  return sum / (255.0 * static_cast<double>(cells));
}

}  // namespace pmreport::scene
