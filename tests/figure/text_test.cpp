#include "reports/figure/text.hpp"

#include <catch2/catch.hpp>
#include <cstring>
#include <stdexcept>

#include "reports/figure/surface.hpp"

using namespace pmreport::figure;

namespace {

// The families that Pango really used, run by run.
bool all_dejavu(const Text& text) {
  PangoLayoutIter* iterator = pango_layout_get_iter(text.layout());
  bool all = true;
  do {
    const PangoLayoutRun* run = pango_layout_iter_get_run_readonly(iterator);
    if (run == nullptr) continue;
    PangoFontDescription* description = pango_font_describe(run->item->analysis.font);
    all = all && std::strncmp(pango_font_description_get_family(description), "DejaVu Sans", 11) == 0;
    pango_font_description_free(description);
  } while (pango_layout_iter_next_run(iterator));
  pango_layout_iter_free(iterator);
  return all;
}

}  // namespace

TEST_CASE("every sign that a figure uses comes from DejaVu") {
  const Context cr = measuring_context();
  const std::string signs = "l₁ l̇₂ l̈₃ F₄ θ̇ αβγ ψ κ J⁻¹ ≤ ∑ √ ∂ − × · ° … ▲ ▼ 10⁰¹²³⁴⁵⁶⁷⁸⁹ [kN·mm/rad] ä ö ü ß é";
  for (const Font& font : {Font{}, Font{.bold = true}, Font{.mono = true}, Font{.mono = true, .italic = true}, Font{.italic = true}}) {
    CAPTURE(font.bold, font.mono, font.italic);
    const Text text(cr.get(), signs, font);
    CHECK(all_dejavu(text));
    CHECK(pango_layout_get_unknown_glyphs_count(text.layout()) == 0);
  }
}

TEST_CASE("a size is in points of the page") {
  const Context cr = measuring_context();
  // The digit 0 of DejaVu Sans is 1303/2048 em wide.
  CHECK(Text(cr.get(), "0000000000", {.size = 10}).extents().width == Approx(10 * 10 * 1303.0 / 2048).margin(0.05));
  CHECK(Text(cr.get(), "0", {.size = 16}).extents().height == Approx(2 * Text(cr.get(), "0", {.size = 8}).extents().height).margin(0.01));
  const Extents size = Text(cr.get(), "0", {.size = 10}).extents();
  CHECK(size.baseline > 0.5 * size.height);
  CHECK(size.baseline < size.height);
}

TEST_CASE("text wraps at its width") {
  const Context cr = measuring_context();
  const std::string sentence = "limb 3 needs 812.4 mm, its stroke ends at 800.0 mm";
  CHECK(Text(cr.get(), sentence, {}).lines() == 1);
  const Text wrapped(cr.get(), sentence, {}, 90);
  CHECK(wrapped.lines() >= 3);
  CHECK(wrapped.extents().width <= 90);
}

TEST_CASE("markup is read when asked for and escaped otherwise") {
  const Context cr = measuring_context();
  const std::string title = "a < b & \"c\"";
  CHECK(Text(cr.get(), title, {}).extents().width == Approx(Text(cr.get(), escape_markup(title), {}, 0, true).extents().width));
  CHECK(Text(cr.get(), "<b>mm</b>", {}, 0, true).extents().width < Text(cr.get(), "<b>mm</b>", {}).extents().width);
  CHECK_THROWS_AS(Text(cr.get(), "<b>mm", {}, 0, true), std::invalid_argument);
}

TEST_CASE("bytes that are no UTF-8 are shown as replacement signs") {
  const Context cr = measuring_context();
  CHECK(Text(cr.get(), "l\xff\xfe", {}).extents().width == Approx(Text(cr.get(), "l\uFFFD\uFFFD", {}).extents().width));
  CHECK(escape_markup("\xff<") == "\uFFFD&lt;");
}
