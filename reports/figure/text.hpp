// Text through Pango, the same on every machine: DejaVu, hinting off, no dependence on locale or screen.
#pragma once

#include <pango/pangocairo.h>

#include <reports/figure/geometry.hpp>

#include <memory>
#include <string>

namespace pmreport::figure {

struct Font {
  double size = 8;  // [pt]
  bool bold = false, mono = false, italic = false;
};

struct Extents {
  double width, height, baseline;  // [pt]
};

// A laid-out piece of text; `width` > 0 wraps it there. `markup` is Pango's; plain text is escaped by the caller with escape_markup.
class Text {
 public:
  Text(cairo_t* cr, const std::string& text, const Font& font, double width = 0, bool markup = false);
  Extents extents() const;
  int lines() const;
  void show(double x, double y) const;  // (x, y): top left corner
  PangoLayout* layout() const { return layout_.get(); }

 private:
  struct Unref {
    void operator()(PangoLayout* p) const { g_object_unref(p); }
  };
  cairo_t* cr_;
  double size_;
  std::unique_ptr<PangoLayout, Unref> layout_;
};

// Ground for words over a grid or a curve: nearly white, so that both can be read.
void clear_ground(cairo_t* cr, const Box& box);

std::string escape_markup(const std::string& plain);
// As the content of an element, and without the control characters that XML 1.0 has not, not even escaped.
std::string as_xml(std::string plain);

}  // namespace pmreport::figure
