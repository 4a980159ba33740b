// Cairo's tags: marks of content, links and where they lead.
//
// Cairo 1.16 writes a PDF that refers to objects it never wrote when a link stands outside all structure, so that one "Document" tag must
// span the drawing of all pages. Only tags that hold no other tag enclose their content.
#pragma once

#include <cairo.h>

#include <string>

namespace pmreport::document::pdf {

// Tags must nest and close, also when drawing throws.
class Tag {
 public:
  Tag(cairo_t* cr, const char* name, const std::string& attributes = {}) : cr_(cr), name_(name) {
    cairo_tag_begin(cr, name, attributes.c_str());
  }
  ~Tag() { cairo_tag_end(cr_, name_); }
  Tag(const Tag&) = delete;
  Tag& operator=(const Tag&) = delete;

 private:
  cairo_t* cr_;
  const char* name_;
};

struct Box {
  double x, y, width, height;  // user space [pt]
};

Box on_paper(cairo_t* cr, const Box& box);  // from the top left corner of the paper [pt]

// Attributes of a link by which a click into `box` leads to a named destination, or to a file beside the report.
std::string link_to(cairo_t* cr, const std::string& destination, const Box& box);
std::string file_link_to(cairo_t* cr, const std::string& file, const Box& box);

// The origin of user space becomes the place that `name` leads to, a little air above it.
void set_destination(cairo_t* cr, const std::string& name);

}  // namespace pmreport::document::pdf
