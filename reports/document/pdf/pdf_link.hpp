// Cairo's tags: structure, links and where they lead.
//
// Cairo 1.16 writes a PDF that refers to objects it never wrote when a link stands outside all structure, so that one "Document" tag must
// span the drawing of all pages. Only tags that hold no other tag enclose their text for a reader by ear.
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

// While it lives, what is drawn belongs to a link; a click into `box` leads to `destination`, a name from `destination_name` that the flow
// knows.
class Link : Tag {
 public:
  Link(cairo_t* cr, const std::string& destination, const Box& box);
};

// The origin of user space becomes the place that `name` leads to, a little air above it.
void set_destination(cairo_t* cr, const std::string& name);

}  // namespace pmreport::document::pdf
