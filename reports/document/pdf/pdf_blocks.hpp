// Blocks of the report become pieces in the flow and elements of the structure.
#pragma once

#include <reports/document/names.hpp>
#include <reports/document/numbering.hpp>
#include <reports/document/pdf/pdf_structure.hpp>
#include <reports/document/pdf/pdf_style.hpp>
#include <reports/document/report.hpp>

#include <string>
#include <vector>

namespace pmreport::document::pdf {

struct Composer {
  const Report& report;
  const Names names;
  const Numbering numbering;
  cairo_t* cr;  // what text is measured on and drawn to
  Flow flow{};
  Structure structure{};
  int part = -1;  // element of the structure that what is put belongs to

  int add(const char* role, std::string alternative = {}) { return structure.add(role, part, std::move(alternative)); }
};

// Lines of text that may break over pages, yet never with one line alone before or after the break.
struct Bar {
  Colour colour;
};
struct Setting {
  double indent = 0;
  const Bar* bar = nullptr;
  bool keep_with_next = false;
};
void put_lines(Composer& c, int element, const std::string& markup, const Style& style, const Setting& setting = {});
void put_lines(Composer& c, const std::string& markup, const Style& style, const Setting& setting = {});  // a paragraph of its own

void put_paragraph(Composer& c, const Paragraph& p);
void put_figure(Composer& c, const figure::Figure& f, int number);
void put_gallery(Composer& c, const Gallery& g, int number);
// Where a picture lies that is at most so wide and high, its corner at the origin; and how it is drawn there.
Box picture_box(const Picture& p, double width, double most_height);
void draw_picture(cairo_t* cr, const Picture& p, const Box& box);
void put_proof(Composer& c, const Proof& p);
void put_checks(Composer& c, const std::vector<Check>& checks);

// Rows beyond the first few dozens are left out, with a word about where they are.
void put_table(Composer& c, const Table& t, int number);

// A number and its heading, kept with what follows; links to `destination` lead here.
void put_heading(Composer& c, const std::string& number, const std::string& title, const std::string& destination);
// Within a section (H3), or of the first pages (H2).
void put_subheading(Composer& c, const std::string& title, const char* role = "H3");

// "Source   Wang et al. 2017"; nothing when the value is empty.
void put_field(Composer& c, const std::string& label, const std::string& value, const Style& style = body);

// "Figure 3. caption", as markup.
std::string numbered(const char* kind, int number, const std::string& caption_markup);

// "pass", or "FAIL" so that nobody overlooks it.
std::string verdict_markup(Verdict verdict);

}  // namespace pmreport::document::pdf
