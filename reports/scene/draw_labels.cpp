#include <algorithm>
#include <memory>
#include <reports/figure/text.hpp>
#include <reports/scene/labels.hpp>

namespace pmreport::scene {

namespace {

struct Drop {
  void operator()(cairo_surface_t* p) const { cairo_surface_destroy(p); }
  void operator()(cairo_t* p) const { cairo_destroy(p); }
};

void draw_leader(cairo_t* cr, const LabelSpot& spot, const Color& color, double size) {
  cairo_set_line_cap(cr, CAIRO_LINE_CAP_ROUND);
  for (const bool rim : {true, false}) {
    cairo_move_to(cr, spot.from.x(), spot.from.y());
    cairo_line_to(cr, spot.to.x(), spot.to.y());
    cairo_set_line_width(cr, (rim ? 0.17 : 0.07) * size);
    rim ? cairo_set_source_rgba(cr, 1, 1, 1, 0.6) : cairo_set_source_rgba(cr, color.r, color.g, color.b, 1);
    cairo_stroke(cr);
  }
}

void draw_text(cairo_t* cr, const LabelSpot& spot, const Color& color, double size) {
  const figure::Text text(cr, label_markup(spot.box.text, size), {size}, 0, true);
  PangoRectangle ink;
  pango_layout_get_extents(text.layout(), &ink, nullptr);
  cairo_move_to(cr, spot.box.x + halo * size - ink.x / double(PANGO_SCALE), spot.box.y + halo * size - ink.y / double(PANGO_SCALE));
  pango_cairo_layout_path(cr, text.layout());
  cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_width(cr, 2 * halo * size);
  cairo_set_source_rgba(cr, 1, 1, 1, 0.85);
  cairo_stroke_preserve(cr);
  cairo_set_source_rgba(cr, color.r, color.g, color.b, 1);
  cairo_fill(cr);
}

// Cairo's pixels are premultiplied, in words of alpha, red, green, blue from the highest byte down.
void lay_over(Image& image, const cairo_surface_t* surface) {
  auto* s = const_cast<cairo_surface_t*>(surface);
  const unsigned char* data = cairo_image_surface_get_data(s);
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(s));
  for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) {
    const auto* row = reinterpret_cast<const std::uint32_t*>(data + y * stride);
    for (std::size_t x = 0; x < static_cast<std::size_t>(image.width); ++x) {
      const std::uint32_t word = row[x], over = word >> 24;
      if (over == 0) continue;
      std::uint8_t* pixel = &image.rgba[4 * (y * static_cast<std::size_t>(image.width) + x)];
      const std::uint32_t under = pixel[3] * (255 - over), alpha = 255 * over + under;  // both times 255
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t c = (word >> (16 - 8 * k)) & 255;
        pixel[k] = static_cast<std::uint8_t>(std::min(255u, (255 * 255 * c + pixel[k] * under + alpha / 2) / alpha));
      }
      pixel[3] = static_cast<std::uint8_t>((alpha + 127) / 255);
    }
  }
}

}  // namespace

void draw_labels(Image& image, const Scene& scene, const Camera& camera, const Quality& quality) {
  if (scene.labels.empty()) return;
  const std::unique_ptr<cairo_surface_t, Drop> surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, image.width, image.height));
  const std::unique_ptr<cairo_t, Drop> cr(cairo_create(surface.get()));
  const double size = label_size(quality.width, quality.printed);
  const std::vector<LabelSpot> spots = find_spots(scene, camera, quality);
  for (const LabelSpot& s : spots)
    if (s.leader) draw_leader(cr.get(), s, scene.labels[s.index].color, size);
  for (const LabelSpot& s : spots) draw_text(cr.get(), s, scene.labels[s.index].color, size);
  cairo_surface_flush(surface.get());
  lay_over(image, surface.get());
}

}  // namespace pmreport::scene
