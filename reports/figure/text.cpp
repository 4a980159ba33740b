#include <core/text/text.hpp>
#include <reports/figure/parts.hpp>
#include <reports/figure/text.hpp>

#include <stdexcept>

namespace pmreport::figure {
namespace {

constexpr const char* sans = "DejaVu Sans";
constexpr const char* monospaced = "DejaVu Sans Mono";

struct FreeFont {
  void operator()(PangoFontDescription* p) const { pango_font_description_free(p); }
};
using FontDescription = std::unique_ptr<PangoFontDescription, FreeFont>;

FontDescription describe(const Font& font) {
  FontDescription description{pango_font_description_new()};
  pango_font_description_set_family_static(description.get(), font.mono ? monospaced : sans);
  // An absolute size is free of the screen's resolution: one unit is one point of the page.
  pango_font_description_set_absolute_size(description.get(), font.size * PANGO_SCALE);
  if (font.bold) pango_font_description_set_weight(description.get(), PANGO_WEIGHT_BOLD);
  if (font.italic) pango_font_description_set_style(description.get(), PANGO_STYLE_ITALIC);
  return description;
}

// Fontconfig answers a missing family with another one and says nothing; widths and glyphs would then differ from machine to machine.
bool require_family(PangoContext* context, const char* family) {
  const FontDescription wanted{pango_font_description_new()};
  pango_font_description_set_family_static(wanted.get(), family);
  PangoFont* font = pango_context_load_font(context, wanted.get());
  std::string seen = "no font at all";
  if (font != nullptr) {
    const FontDescription found{pango_font_describe(font)};
    seen = pango_font_description_get_family(found.get());
    g_object_unref(font);
  }
  if (seen != family) {
    throw std::runtime_error(std::string("expected the font \"") + family + "\", saw \"" + seen +
                             "\": install the package fonts-dejavu-core");
  }
  return true;
}

struct FreeOptions {
  void operator()(cairo_font_options_t* p) const { cairo_font_options_destroy(p); }
};

// Nothing of the screen, the desktop's settings or the locale may reach the page.
void detach_from_machine(PangoContext* context) {
  const std::unique_ptr<cairo_font_options_t, FreeOptions> options{cairo_font_options_create()};
  cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
  pango_cairo_context_set_font_options(context, options.get());
  pango_cairo_context_set_resolution(context, 72);
  pango_context_set_round_glyph_positions(context, FALSE);
  pango_context_set_language(context, pango_language_from_string("en"));
  static const bool families_present = require_family(context, sans) && require_family(context, monospaced);
  static_cast<void>(families_present);
}

struct FreeString {
  void operator()(char* p) const { g_free(p); }
};
using OwnedString = std::unique_ptr<char, FreeString>;

// What Cairo draws: it refuses noncharacters, which GLib lets pass.
std::string drawable(const std::string& text) {
  const OwnedString valid{g_utf8_make_valid(text.data(), static_cast<gssize>(text.size()))};
  return without_noncharacters(valid.get());
}

void set_markup(PangoLayout* layout, const char* markup) {
  GError* error = nullptr;
  PangoAttrList* attributes = nullptr;
  char* plain = nullptr;
  if (!pango_parse_markup(markup, -1, 0, &attributes, &plain, nullptr, &error)) {
    const std::string reason = error->message;
    g_error_free(error);
    throw std::invalid_argument("expected Pango markup, saw \"" + std::string(markup) + "\": " + reason);
  }
  pango_layout_set_text(layout, plain, -1);
  pango_layout_set_attributes(layout, attributes);
  pango_attr_list_unref(attributes);
  g_free(plain);
}

}  // namespace

Text::Text(cairo_t* cr, const std::string& text, const Font& font, double width, bool markup)
    : cr_(cr), size_(font.size), layout_(pango_cairo_create_layout(cr)) {
  detach_from_machine(pango_layout_get_context(layout_.get()));
  pango_layout_context_changed(layout_.get());
  const FontDescription description = describe(font);
  pango_layout_set_font_description(layout_.get(), description.get());
  if (width > 0) {
    pango_layout_set_width(layout_.get(), pango_units_from_double(width));
    pango_layout_set_wrap(layout_.get(), PANGO_WRAP_WORD_CHAR);
  }
  const std::string valid = drawable(text);
  if (markup) {
    set_markup(layout_.get(), valid.c_str());
  } else {
    pango_layout_set_text(layout_.get(), valid.c_str(), -1);
  }
}

Extents Text::extents() const {
  PangoRectangle logical;
  pango_layout_get_extents(layout_.get(), nullptr, &logical);
  return {pango_units_to_double(logical.width), pango_units_to_double(logical.height),
          pango_units_to_double(pango_layout_get_baseline(layout_.get()))};
}

int Text::lines() const { return pango_layout_get_line_count(layout_.get()); }

void Text::show(double x, double y) const {
  cairo_move_to(cr_, x, y);
  pango_cairo_show_layout(cr_, layout_.get());
  keep_words(cr_, layout_.get(), size_, x, y);
}

void clear_ground(cairo_t* cr, const Box& box) {
  cairo_set_source_rgba(cr, 1, 1, 1, 0.75);
  cairo_rectangle(cr, box.x - 1, box.y, box.width + 2, box.height);
  cairo_fill(cr);
}

std::string escape_markup(const std::string& plain) {
  const OwnedString escaped{g_markup_escape_text(drawable(plain).c_str(), -1)};
  return escaped.get();
}

std::string as_xml(std::string plain) {
  std::erase_if(plain, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
  return escape_markup(plain);
}

}  // namespace pmreport::figure
