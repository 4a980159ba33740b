#include <reports/figure/parts.hpp>

#include <fmt/format.h>

#include <memory>
#include <stdexcept>

#include <reports/figure/text.hpp>

namespace pmreport::figure {
namespace {

const cairo_user_data_key_t key{};

Parts* parts_of(cairo_t* cr) { return static_cast<Parts*>(cairo_get_user_data(cr, &key)); }

// Cairo has no way to put a word of ours into its SVG: what it draws there is a small square that nothing else looks like, and its path is
// replaced afterwards. It is not opaque, for what a later opaque shape covers Cairo may leave out.
constexpr double side = 0.25;  // [pt] at the top left corner of the page
constexpr std::string_view square = " d=\"M 0 0 L 0.25 0 L 0.25 0.25 L 0 0.25 Z M 0 0 \"";

std::string number(double value) {
  std::string text = fmt::format("{:.2f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string length(int pango_units) {
  return fmt::format("textLength=\"{}\" lengthAdjust=\"spacingAndGlyphs\"", number(pango_units_to_double(pango_units)));
}

// A stretch of a line in one font.
struct Run {
  std::size_t begin, length;  // [bytes] of the layout's text
  int width;                  // [Pango units]
  bool bold;
};

// In the order of reading; none of a line that is not read from left to right throughout, or that ends in an ellipsis of Pango's.
std::vector<Run> runs_of(const PangoLayoutLine* line) {
  std::vector<Run> runs;
  for (const GSList* at = line->runs; at != nullptr; at = at->next) {
    const auto* run = static_cast<const PangoGlyphItem*>(at->data);
    const PangoItem& item = *run->item;
    if (item.analysis.level % 2 != 0 || (item.analysis.flags & PANGO_ANALYSIS_FLAG_IS_ELLIPSIS) != 0) return {};
    PangoFontDescription* font = pango_font_describe(item.analysis.font);
    const bool bold = pango_font_description_get_weight(font) >= PANGO_WEIGHT_BOLD;
    pango_font_description_free(font);
    const int width = pango_glyph_string_get_width(run->glyphs);
    if (!runs.empty() && runs.back().bold == bold)
      runs.back().length += static_cast<std::size_t>(item.length), runs.back().width += width;
    else
      runs.push_back({static_cast<std::size_t>(item.offset), static_cast<std::size_t>(item.length), width, bold});
  }
  return runs;
}

struct FreeIterator {
  void operator()(PangoLayoutIter* p) const { pango_layout_iter_free(p); }
};

}  // namespace

Parts::Parts(cairo_t* cr) : cr_(cr) { cairo_set_user_data(cr, &key, this, nullptr); }
Parts::~Parts() { cairo_set_user_data(cr_, &key, nullptr, nullptr); }

void Parts::mark(std::string tag) {
  tags_.push_back(std::move(tag));
  cairo_save(cr_);
  cairo_identity_matrix(cr_);
  cairo_new_path(cr_);
  cairo_rectangle(cr_, 0, 0, side, side);
  cairo_set_source_rgba(cr_, 0, 0, 0, 0.5);
  cairo_fill(cr_);
  cairo_restore(cr_);
}

std::string Parts::put_into(const std::string& svg) const {
  std::string out;
  out.reserve(svg.size() + words_.size());
  std::size_t copied = 0, next = 0;
  for (std::size_t at = svg.find(square); at != std::string::npos; at = svg.find(square, at + 1)) {
    const std::size_t begin = svg.rfind('<', at), end = svg.find("/>", at);
    if (next == tags_.size() || end == std::string::npos) break;
    out.append(svg, copied, begin - copied).append(tags_[next++]);
    copied = end + 2;
  }
  const std::size_t close = svg.rfind("</svg>");
  if (next != tags_.size() || close == std::string::npos)
    throw std::runtime_error(fmt::format("this version of Cairo writes SVG in another way: expected {} marks, saw {}", tags_.size(), next));
  out.append(svg, copied, close - copied);
  if (!words_.empty())
    out.append("<g class=\"text\" fill=\"#000\" fill-opacity=\"0\" font-family=\"DejaVu Sans, Verdana, sans-serif\">\n")
        .append(words_)
        .append("</g>\n");
  return out.append(svg, close);
}

void begin_part(cairo_t* cr, std::string_view attributes) {
  if (Parts* parts = parts_of(cr)) parts->mark(fmt::format("<g {}>", attributes));
}

void end_part(cairo_t* cr) {
  if (Parts* parts = parts_of(cr)) parts->mark("</g>");
}

// A line of the layout is a text of the width that Pango gave it: where another font stands in for DejaVu, it is stretched to fit.
void keep_words(cairo_t* cr, PangoLayout* layout, double size, double x, double y) {
  Parts* parts = parts_of(cr);
  if (!parts) return;
  cairo_matrix_t page;
  cairo_get_matrix(cr, &page);
  const std::string all = pango_layout_get_text(layout);
  const std::unique_ptr<PangoLayoutIter, FreeIterator> iterator{pango_layout_get_iter(layout)};
  do {
    const PangoLayoutLine* line = pango_layout_iter_get_line_readonly(iterator.get());
    PangoRectangle logical;
    pango_layout_iter_get_line_extents(iterator.get(), nullptr, &logical);
    if (line->length == 0 || logical.width == 0) continue;
    double left = x + pango_units_to_double(logical.x),
           baseline = y + pango_units_to_double(pango_layout_iter_get_baseline(iterator.get()));
    cairo_matrix_transform_point(&page, &left, &baseline);
    const bool level = page.xy == 0 && page.yx == 0;
    const std::string place = level ? fmt::format("x=\"{}\" y=\"{}\"", number(left), number(baseline))
                                    : fmt::format("transform=\"matrix({} {} {} {} {} {})\"", number(page.xx), number(page.yx),
                                                  number(page.xy), number(page.yy), number(left), number(baseline));
    const std::string font = fmt::format("font-size=\"{}\"", number(size));
    if (const std::vector<Run> runs = runs_of(line); runs.size() > 1) {
      parts->words_ += fmt::format("<text {} {} xml:space=\"preserve\">", place, font);
      for (const Run& run : runs)
        parts->words_ += fmt::format("<tspan{} {}>{}</tspan>", run.bold ? " font-weight=\"bold\"" : "", length(run.width),
                                     as_xml(all.substr(run.begin, run.length)));
      parts->words_ += "</text>\n";
    } else {
      const std::string words = all.substr(static_cast<std::size_t>(line->start_index), static_cast<std::size_t>(line->length));
      parts->words_ += fmt::format("<text {} {} {}>{}</text>\n", place, font, length(logical.width), as_xml(words));
    }
  } while (pango_layout_iter_next_line(iterator.get()));
}

}  // namespace pmreport::figure
