#include <reports/document/pdf/pdf_style.hpp>
#include <reports/document/text.hpp>

#include <fmt/format.h>

#include <cmath>

namespace pmreport::document::pdf {

void set_colour(cairo_t* cr, const Colour& c) { cairo_set_source_rgb(cr, c.r, c.g, c.b); }

namespace {

bool reorders(gunichar c) {
  return (c >= 0x202a && c <= 0x202e) || (c >= 0x2066 && c <= 0x2069) || c == 0x200e || c == 0x200f || c == 0x061c;
}

std::string printable(const std::string& untrusted, const char* newline) {
  std::string result;
  const std::string cleaned = clean(untrusted);
  const char* const end = cleaned.data() + cleaned.size();
  for (const char *p = cleaned.data(), *next = p; p < end; p = next) {
    next = g_utf8_next_char(p);
    const gunichar c = g_utf8_get_char(p);
    const bool second_of_pair = c == '\n' && p > cleaned.data() && p[-1] == '\r';
    if (second_of_pair) continue;
    if (c == '\n' || c == '\r' || c == 0x2028 || c == 0x2029) {
      result += newline;
    } else if (c == '\t') {
      result += "  ";
    } else if (reorders(c)) {
      result += "\uFFFD";
    } else {
      result.append(p, next);
    }
  }
  return result;
}

}  // namespace

std::string printable(const std::string& untrusted) { return printable(untrusted, "\n"); }
std::string printable_line(const std::string& untrusted) { return printable(untrusted, " "); }
std::string markup(const std::string& untrusted) { return figure::escape_markup(printable(untrusted)); }
std::string markup_line(const std::string& untrusted) { return figure::escape_markup(printable_line(untrusted)); }

std::string unbroken(const std::string& markup) { return "<span allow_breaks=\"false\">" + markup + "</span>"; }

std::string coloured(const std::string& markup, const Colour& c) {
  const auto byte = [](double v) { return static_cast<int>(std::lround(255 * v)); };
  return fmt::format("<span foreground=\"#{:02x}{:02x}{:02x}\">{}</span>", byte(c.r), byte(c.g), byte(c.b), markup);
}

void break_words(PangoLayout* layout) {
  pango_layout_set_wrap(layout, PANGO_WRAP_WORD_CHAR);
  PangoAttrList* const given = pango_layout_get_attributes(layout);
  PangoAttrList* const list = given ? pango_attr_list_copy(given) : pango_attr_list_new();
  pango_attr_list_insert(list, pango_attr_insert_hyphens_new(FALSE));
  pango_layout_set_attributes(layout, list);
  pango_attr_list_unref(list);
}

Lines::Lines(cairo_t* cr, const std::string& markup, const Style& style, double width)
    : text_(std::make_shared<figure::Text>(cr, markup, style.font, width, true)), style_(style) {
  PangoLayout* const layout = text_->layout();
  break_words(layout);
  const std::unique_ptr<PangoLayoutIter, decltype(&pango_layout_iter_free)> at(pango_layout_get_iter(layout), pango_layout_iter_free);
  do {
    PangoRectangle logical;
    pango_layout_iter_get_line_extents(at.get(), nullptr, &logical);
    lines_.push_back({pango_layout_iter_get_line_readonly(at.get()), static_cast<double>(logical.x) / PANGO_SCALE,
                      static_cast<double>(logical.width) / PANGO_SCALE});
  } while (pango_layout_iter_next_line(at.get()));
}

void Lines::draw_line(cairo_t* cr, int line, double x, double y) const {
  // DejaVu rises 0.928 em above its baseline and falls 0.236 em below: this centres it in the pitch.
  const double baseline = style_.pitch / 2 + (0.928 - 0.236) / 2 * style_.font.size;
  const auto& l = lines_[static_cast<std::size_t>(line)];
  set_colour(cr, style_.colour);
  cairo_move_to(cr, x + l.x, y + baseline);
  pango_cairo_show_layout_line(cr, l.line);
}

void Lines::draw(cairo_t* cr, double x, double y) const {
  for (int i = 0; i < count(); ++i) draw_line(cr, i, x, y + i * style_.pitch);
}

double width_of(cairo_t* cr, const std::string& markup, const figure::Font& font) {
  return figure::Text(cr, markup, font, 0, true).extents().width;
}

void rule(cairo_t* cr, double x, double y, double length, double thickness, const Colour& c) {
  set_colour(cr, c);
  cairo_set_line_width(cr, thickness);
  cairo_set_line_cap(cr, CAIRO_LINE_CAP_BUTT);
  cairo_move_to(cr, x, y);
  cairo_line_to(cr, x + length, y);
  cairo_stroke(cr);
}

}  // namespace pmreport::document::pdf
