#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <reports/figure/surface.hpp>
#include <reports/scene/vector/drawing.hpp>

namespace pmreport::scene {

namespace {

using Eigen::Vector2d;

class Painter {
 public:
  Painter(cairo_t* cr, const Drawing& drawing, double width)
      : cr_(cr), drawing_(drawing), scale_(width / drawing.width), line_(scale_ / drawing.points_per_pixel()) {}

  void layer(const Layer& layer) {
    const bool translucent = layer.opacity < 1;
    if (translucent) cairo_push_group(cr_);
    for (const Area& a : layer.areas) {
      outline(a.region);
      set(a.paint);
      cairo_fill(cr_);
    }
    strokes(layer.strokes);
    if (!translucent) return;
    cairo_pop_group_to_source(cr_);
    cairo_paint_with_alpha(cr_, layer.opacity);
  }

  void labels() {
    const double size = scale_ * label_size(drawing_.width, drawing_.printed);
    write_labels(cr_, drawing_.labels, drawing_.label_colors, {size, scale_, drawing_.manner == Manner::plain});
  }

 private:
  void outline(const Region& region) {
    cairo_new_path(cr_);
    for (const ClipperLib::Path& path : region) {
      cairo_new_sub_path(cr_);
      for (const ClipperLib::IntPoint& p : path)
        cairo_line_to(cr_, scale_ * static_cast<double>(p.X) / fine, -scale_ * static_cast<double>(p.Y) / fine);
      cairo_close_path(cr_);
    }
  }

  void set(const Color& c) { cairo_set_source_rgba(cr_, c.r, c.g, c.b, c.a); }

  void set(const Paint& paint) {
    if (paint.kind == Paint::Kind::flat) return set(paint.stops.front().color);
    const Vector2d from = scale_ * paint.from, to = scale_ * paint.to;
    cairo_pattern_t* pattern = paint.kind == Paint::Kind::across
                                   ? cairo_pattern_create_linear(from.x(), from.y(), to.x(), to.y())
                                   : cairo_pattern_create_radial(from.x(), from.y(), 0, to.x(), to.y(), scale_ * paint.radius);
    for (const Paint::Stop& s : paint.stops) cairo_pattern_add_color_stop_rgba(pattern, s.at, s.color.r, s.color.g, s.color.b, s.color.a);
    cairo_set_source(cr_, pattern);
    cairo_pattern_destroy(pattern);
  }

  // Neighbours that are drawn alike are one path: a file is a third smaller.
  void strokes(const std::vector<Stroke>& all) {
    cairo_set_line_join(cr_, CAIRO_LINE_JOIN_ROUND);
    const auto alike = [](const Stroke& a, const Stroke& b) {
      return a.width == b.width && a.dash == b.dash && a.color.r == b.color.r && a.color.g == b.color.g && a.color.b == b.color.b &&
             a.color.a == b.color.a;
    };
    for (std::size_t i = 0; i < all.size();) {
      cairo_new_path(cr_);
      std::size_t k = i;
      for (; k < all.size() && alike(all[i], all[k]); ++k) {
        cairo_new_sub_path(cr_);
        for (const Vector2d& p : all[k].points) cairo_line_to(cr_, scale_ * p.x(), scale_ * p.y());
        if (all[k].closed) cairo_close_path(cr_);
      }
      std::vector<double> dash = all[i].dash;
      for (double& d : dash) d *= line_;
      cairo_set_dash(cr_, dash.data(), static_cast<int>(dash.size()), 0);
      cairo_set_line_cap(cr_, dash.empty() ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
      cairo_set_line_width(cr_, all[i].width * line_);
      set(all[i].color);
      cairo_stroke(cr_);
      i = k;
    }
    cairo_set_dash(cr_, nullptr, 0, 0);
  }

  cairo_t* cr_;
  const Drawing& drawing_;
  double scale_, line_;  // [pt/px]; of line widths, 1 at the printed size
};

figure::Size page_of(const Drawing& d) { return {d.points_per_pixel() * d.width, d.points_per_pixel() * d.height}; }

cairo_status_t append(void* file, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(file)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

void paint(cairo_t* cr, const Drawing& drawing, double width, bool transparent) {
  cairo_save(cr);
  cairo_rectangle(cr, 0, 0, width, width * drawing.height / drawing.width);
  cairo_clip_preserve(cr);
  cairo_set_source_rgb(cr, 1, 1, 1);
  transparent ? cairo_new_path(cr) : cairo_fill(cr);
  Painter painter(cr, drawing, width);
  for (const Layer& layer : drawing.layers) painter.layer(layer);
  painter.labels();
  cairo_restore(cr);
}

std::string to_pdf(const Drawing& drawing) {
  const figure::Size page = page_of(drawing);
  return figure::written_pdf(
      page, [&](cairo_t* cr) { paint(cr, drawing, page.width); }, "a picture");
}

std::string to_svg(const Drawing& drawing, const std::string& id, const std::string& title) {
  const figure::Size page = page_of(drawing);
  figure::Figure named;
  named.id = id;
  named.panels.emplace_back().title = title;
  return figure::written_svg(
      page, [&](cairo_t* cr) { paint(cr, drawing, page.width); }, named);
}

std::string to_png(const Drawing& drawing, bool transparent) {
  const figure::Surface surface{cairo_image_surface_create(CAIRO_FORMAT_ARGB32, drawing.width, drawing.height)};
  paint(figure::Context{cairo_create(surface.get())}.get(), drawing, drawing.width, transparent);
  std::string png;
  if (cairo_surface_write_to_png_stream(surface.get(), append, &png) != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error("a picture: Cairo could not draw it as PNG");
  return png;
}

}  // namespace pmreport::scene
