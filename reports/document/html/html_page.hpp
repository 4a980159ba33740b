// The parts of report.html, each written in its own file.
#pragma once

#include <reports/document/html/html_writer.hpp>
#include <reports/document/names.hpp>
#include <reports/document/numbering.hpp>
#include <reports/document/write.hpp>

#include <map>
#include <string>
#include <vector>

namespace pmreport::document {

using Glyphs = std::map<std::string, std::string>;  // outlines in SVG, and the id that each has in the page

struct Page {
  const Report& report;
  const Names& names;
  const std::vector<std::string>& drawings;  // SVG of each figure, in order
  const Numbering numbering = numbering_of(report);
  HtmlWriter html = {};
  std::size_t figure = 0, picture = 0;  // how many are written
  Glyphs glyphs = {};
};

// `number`: the block's among figures or tables; 0: it has none.
void write_block(Page& page, const Section& section, const Block& block, int number);
void write_number(Page& page, const std::string& number);  // before a heading that has one
void write_paragraph(Page& page, const Paragraph& paragraph);
void write_picture(Page& page, const Picture& picture, int most_pixels,
                   const std::string& label = {});  // in width; the file beside the report has all
void write_front(Page& page);

// The box in which a wide thing moves sideways on a narrow screen; the keyboard reaches it too.
template <class Inside>
void write_scroll_box(Page& page, std::string_view label, Inside inside) {
  page.html.element("div", {{"class", "scroll"}, {"role", "group"}, {"aria-label", label}, {"tabindex", "0"}}, inside);
}

void write_result(Page& page, Verdict verdict);  // a symbol, a word and, last, a colour

// The page with drawings that exist already; names and drawings in the report's order.
std::string to_html(const Report& r, const Names& names, const std::vector<std::string>& drawings);

// Of an SVG file the part that stands inside HTML. Styles become presentation attributes: a page shown under a policy that forbids inline
// styles, as Jenkins does by default, would draw every curve as a black blot. Its role and title are left out: what stands around it has
// them, and a title would pop up wherever a pointer rests.
std::string inline_svg(const std::string& svg);
// Glyphs that an earlier drawing of the page has, as `shared` tells, are taken from there; its own are added.
std::string inline_svg(const std::string& svg, Glyphs& shared);

extern const char* const html_style;
extern const char* const html_theme;   // more style
extern const char* const html_script;  // report.js, without which the page is whole as well

}  // namespace pmreport::document
