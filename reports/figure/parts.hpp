// What of a drawing a page must find again: panels, curves and keys of the legend as groups with a name, and all words as text. Cairo's SVG
// has neither groups of ours nor text, only outlines of glyphs.
#pragma once

#include <cairo.h>
#include <pango/pangocairo.h>

#include <string>
#include <string_view>
#include <vector>

namespace pmreport::figure {

// Collects them from the context that it is attached to for as long as it lives. A drawing without one has no parts, and costs nothing.
class Parts {
 public:
  explicit Parts(cairo_t* cr);
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;
  ~Parts();

  // Cairo's SVG, when it is finished, with the groups in their places and the words laid over it: invisible, exactly where the glyphs are,
  // so that they can be searched, selected and copied. Throws std::runtime_error where this version of Cairo does not write what is
  // expected.
  std::string put_into(const std::string& svg) const;

 private:
  friend void begin_part(cairo_t* cr, std::string_view attributes);
  friend void end_part(cairo_t* cr);
  friend void keep_words(cairo_t* cr, PangoLayout* layout, double size, double x, double y);
  void mark(std::string tag);

  cairo_t* cr_;
  std::vector<std::string> tags_;  // in the order of drawing
  std::string words_;              // <text> elements
};

// What is drawn between the two is a group with these attributes. Parts nest; the clip is the same at both.
void begin_part(cairo_t* cr, std::string_view attributes);
void end_part(cairo_t* cr);

// This layout was drawn with its top left corner at (x, y), in a font of this size [pt].
void keep_words(cairo_t* cr, PangoLayout* layout, double size, double x, double y);

}  // namespace pmreport::figure
