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

void set(cairo_t* cr, const Color& c) { cairo_set_source_rgba(cr, c.r, c.g, c.b, c.a); }

void write_leader(cairo_t* cr, const LabelSpot& spot, const Color& color, const Lettering& l) {
  cairo_set_line_cap(cr, CAIRO_LINE_CAP_ROUND);
  for (const bool rim : {true, false}) {
    cairo_move_to(cr, l.scale * spot.from.x(), l.scale * spot.from.y());
    cairo_line_to(cr, l.scale * spot.to.x(), l.scale * spot.to.y());
    cairo_set_line_width(cr, (rim ? 0.17 : 0.065) * l.size);
    set(cr, rim ? Color{1, 1, 1, 0.6f} : color);
    cairo_stroke(cr);
  }
}

// Everything is scaled here and not by Cairo: it keeps words with the text at the place where they are asked for.
void write_text(cairo_t* cr, const LabelSpot& spot, const Color& color, const Lettering& l) {
  const figure::Text text(cr, label_markup(spot.box.text, l.size), {l.size}, 0, true);
  PangoRectangle ink;
  pango_layout_get_extents(text.layout(), &ink, nullptr);
  const double x = l.scale * spot.box.x + halo * l.size - ink.x / double(PANGO_SCALE);
  const double y = l.scale * spot.box.y + halo * l.size - ink.y / double(PANGO_SCALE);
  set(cr, {1, 1, 1, 0.85f});
  if (l.boxed) {
    cairo_rectangle(cr, l.scale * spot.box.x, l.scale * spot.box.y, l.scale * spot.box.width, l.scale * spot.box.height);
    cairo_fill(cr);
  } else {
    cairo_move_to(cr, x, y);
    pango_cairo_layout_path(cr, text.layout());
    cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_width(cr, 2 * halo * l.size);
    cairo_stroke(cr);
  }
  set(cr, color);
  text.show(x, y);
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

void write_labels(cairo_t* cr, const std::vector<LabelSpot>& spots, const std::vector<Color>& colors, const Lettering& lettering) {
  for (std::size_t i = 0; i < spots.size(); ++i)
    if (spots[i].leader) write_leader(cr, spots[i], colors[i], lettering);
  for (std::size_t i = 0; i < spots.size(); ++i) write_text(cr, spots[i], colors[i], lettering);
}

void draw_labels(Image& image, const Scene& scene, const Camera& camera, const Quality& quality) {
  if (scene.labels.empty()) return;
  const std::unique_ptr<cairo_surface_t, Drop> surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, image.width, image.height));
  const std::unique_ptr<cairo_t, Drop> cr(cairo_create(surface.get()));
  const std::vector<LabelSpot> spots = find_spots(scene, camera, quality);
  std::vector<Color> colors;
  for (const LabelSpot& s : spots) colors.push_back(scene.labels[s.index].color);
  write_labels(cr.get(), spots, colors, {label_size(quality.width, quality.printed)});
  cairo_surface_flush(surface.get());
  lay_over(image, surface.get());
}

}  // namespace pmreport::scene
