// Pictures: decoded when they are drawn, one at a time; laid on white, so that the file needs no mask; no finer than print can show.
#include <reports/document/narrowed.hpp>
#include <reports/document/pdf/pdf_blocks.hpp>
#include <reports/document/pdf/pdf_breaks.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace pmreport::document::pdf {

namespace {

// Height of a picture `width` wide, in the proportions that its PNG header states; those of 4:3 when it has none.
double height_at(const Picture& p, double width) {
  const auto big_endian = [&](std::size_t at) {
    double value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = 256 * value + static_cast<unsigned char>(p.png[at + i]);
    return value;
  };
  if (p.png.size() < 24 || p.png.compare(0, 8, "\x89PNG\r\n\x1a\n") != 0) return 0.75 * width;
  const double w = big_endian(16), h = big_endian(20);
  return w > 0 && h > 0 ? width * h / w : 0.75 * width;
}

struct Shown {
  const Picture* picture;
  Box box;
  Lines below;
};

// As large as `width` and `most` high allow, in the middle of its column.
Shown show(Composer& c, const Picture& p, const std::string& text, double x, double width, double most) {
  const double height = height_at(p, width), scale = std::min(1.0, most / height);
  return {&p, {x + (1 - scale) / 2 * width, 0, scale * width, scale * height}, Lines(c.cr, text, caption, width)};
}

void put_shown(Composer& c, const std::vector<Shown>& row, bool keep_with_next) {
  double pictures = 0, texts = 0;
  std::vector<int> figures, captions;
  for (const auto& s : row) {
    pictures = std::max(pictures, s.box.height);
    texts = std::max(texts, s.below.height());
    figures.push_back(c.add("Figure", printable_line(s.picture->caption.empty() ? "Picture of the machine" : s.picture->caption)));
    captions.push_back(c.add("Caption"));
  }
  Piece above{.height = pictures + 4, .keep_with_next = true};
  above.draw_scaled = [&c, row, figures](cairo_t* cr, double scale) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      const Box& whole = row[i].box;
      const Box box{whole.x + (1 - scale) / 2 * whole.width, 0, scale * whole.width, scale * whole.height};
      const Mark mark = Mark::figure(cr, c.structure, figures[i], box);
      draw_picture(cr, *row[i].picture, box);
    }
  };
  c.flow.put(std::move(above));
  Piece below{.height = texts, .reluctance = split_paragraph, .keep_with_next = keep_with_next};
  below.draw = [&c, row, captions](cairo_t* cr) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      const Mark mark(cr, c.structure, captions[i]);
      row[i].below.draw(cr, row[i].box.x, 0);
    }
  };
  c.flow.put(std::move(below));
}

}  // namespace

void draw_picture(cairo_t* cr, const Picture& p, const Box& box) {
  if (p.as_lines) {
    cairo_save(cr);
    cairo_translate(cr, box.x, box.y);
    p.as_lines(cr, box.width);
    cairo_restore(cr);
    return;
  }
  constexpr double pixels_per_point = 300.0 / 72;
  const Surface image = decoded(p.png, static_cast<int>(std::lround(box.width * pixels_per_point)));
  if (image) {
    cairo_save(cr);
    cairo_translate(cr, box.x, box.y);
    cairo_scale(cr, box.width / cairo_image_surface_get_width(image.get()), box.height / cairo_image_surface_get_height(image.get()));
    cairo_set_source_surface(cr, image.get(), 0, 0);
    cairo_paint(cr);
    cairo_restore(cr);
  } else {
    Lines(cr, coloured("This picture cannot be read.", bad), caption, box.width - 16).draw(cr, box.x + 8, box.y + 8);
  }
  set_colour(cr, hairline);
  cairo_set_line_width(cr, 0.4);
  cairo_rectangle(cr, box.x, box.y, box.width, box.height);
  cairo_stroke(cr);
}

Box picture_box(const Picture& p, double width, double most_height) {
  const double height = height_at(p, width), scale = std::min(1.0, most_height / height);
  return {0, 0, scale * width, scale * height};
}

void put_gallery(Composer& c, const Gallery& g, int number) {
  if (g.pictures.empty()) return;
  c.flow.gap(12);
  if (g.pictures.size() == 1) {
    const Picture& p = g.pictures.front();
    const std::string between = g.caption.empty() || p.caption.empty() ? "" : " ";
    const std::string text = numbered("Figure", number, markup_line(g.caption) + between + markup_line(p.caption));
    constexpr double width = 140 * mm;
    put_shown(c, {show(c, p, text, (text_width - width) / 2, width, 0.6 * text_height)}, false);
  } else {
    constexpr double width = (text_width - 4 * mm) / 2;
    for (std::size_t i = 0; i < g.pictures.size(); i += 2) {
      std::vector<Shown> row;
      for (std::size_t j = i; j < std::min(i + 2, g.pictures.size()); ++j) {
        const std::string text = coloured(letter_of(j) + " ", grey) + markup_line(g.pictures[j].caption);
        row.push_back(show(c, g.pictures[j], text, j == i ? 0 : text_width - width, width, 0.45 * text_height));
      }
      put_shown(c, row, i + 2 >= g.pictures.size());
      c.flow.gap(8);
    }
    put_lines(c, c.add("Caption"), numbered("Figure", number, markup_line(g.caption)), caption);
  }
  c.flow.gap(14);
}

}  // namespace pmreport::document::pdf
