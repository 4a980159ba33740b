// How the report looks: its few kinds of text, its colours, and plain strings made safe for Pango and for a reader.
#pragma once

#include <reports/document/pdf/pdf_page.hpp>
#include <reports/figure/text.hpp>

#include <memory>
#include <string>
#include <vector>

namespace pmreport::document::pdf {

struct Colour {
  double r, g, b;
};
inline constexpr Colour ink{0.10, 0.11, 0.13}, grey{0.40, 0.42, 0.45}, hairline{0.72, 0.74, 0.77};
inline constexpr Colour good{0.05, 0.42, 0.25}, bad{0.72, 0.11, 0.11}, caution{0.69, 0.36, 0.00}, accent{0.10, 0.32, 0.55};

struct Style {
  figure::Font font;
  double pitch;  // from baseline to baseline [pt]
  Colour colour = ink;
};
inline constexpr Style body{{.size = 9.25}, 13.6};
inline constexpr Style secondary{{.size = 8.5}, 12.2, grey};
inline constexpr Style caption{{.size = 8.5}, 12};
inline constexpr Style heading{{.size = 14, .bold = true}, 20};
inline constexpr Style subheading{{.size = 10.5, .bold = true}, 15};
inline constexpr Style title{{.size = 20, .bold = true}, 27};
inline constexpr Style listing{{.size = 7.6, .mono = true}, 10.6};

void set_colour(cairo_t* cr, const Colour& c);

// What may be printed as it stands: valid UTF-8 without controls, and without the marks by which text can be made to read otherwise than it
// is. Newlines stay in `printable`; `printable_line` makes spaces of them.
std::string printable(const std::string& untrusted);
std::string printable_line(const std::string& untrusted);

// The same as Pango markup: printable, escaped.
std::string markup(const std::string& untrusted);
std::string markup_line(const std::string& untrusted);
std::string unbroken(const std::string& markup);  // stays on one line
std::string coloured(const std::string& markup, const Colour& c);

// Breaks long words where the line ends, without a hyphen: it would seem to be part of a name or a path.
void break_words(PangoLayout* layout);

// A text set in lines of equal pitch, wrapped at `width`.
class Lines {
 public:
  Lines(cairo_t* cr, const std::string& markup, const Style& style, double width);
  int count() const { return static_cast<int>(lines_.size()); }
  double height() const { return count() * style_.pitch; }  // [pt]
  double width(int line) const { return lines_[static_cast<std::size_t>(line)].width; }
  void draw_line(cairo_t* cr, int line, double x, double y) const;  // (x, y): top left corner of the line
  void draw(cairo_t* cr, double x, double y) const;

 private:
  struct Line {
    PangoLayoutLine* line;
    double x, width;  // [pt]
  };
  std::shared_ptr<figure::Text> text_;
  std::vector<Line> lines_;
  Style style_;
};

// Width that a single line of markup takes [pt].
double width_of(cairo_t* cr, const std::string& markup, const figure::Font& font);

void rule(cairo_t* cr, double x, double y, double length, double thickness, const Colour& c);

}  // namespace pmreport::document::pdf
