// The report's logical structure, for readers by ear and for programs: what a heading is, what a cell, and what a figure shows.
//
// Cairo 1.16 knows tags but none of their attributes: no alternative text, no scope of a heading cell. So it marks the content alone, each
// part by a tag that holds no other; the tree of elements is kept here and written into the finished file (pdf_finish.hpp).
#pragma once

#include <reports/document/pdf/pdf_link.hpp>

#include <optional>
#include <string>
#include <vector>

namespace pmreport::document::pdf {

enum class Scope { none, column, row };  // of a heading cell

struct Element {
  const char* role;              // "H1", "P", "Figure" as PDF calls them; a string literal
  int parent;                    // -1: of the document
  std::string alternative = {};  // words instead of a figure, or for a link
  Scope scope = Scope::none;
  std::optional<Box> place = {};  // of a figure on its page, from the top left corner of the paper
};

class Structure {
 public:
  // Elements are told in the order in which they were added, wherever they stand on the paper.
  int add(const char* role, int parent, std::string alternative = {}, Scope scope = Scope::none) {
    elements_.push_back({role, parent, std::move(alternative), scope});
    return static_cast<int>(elements_.size()) - 1;
  }
  const std::vector<Element>& elements() const { return elements_; }
  const std::vector<int>& marked() const { return marked_; }  // elements, in the order in which their contents are drawn
  void mark(int element) { marked_.push_back(element); }
  void place(int element, const Box& on_paper) { elements_.at(static_cast<std::size_t>(element)).place = on_paper; }

 private:
  std::vector<Element> elements_;
  std::vector<int> marked_;
};

// While it lives, what is drawn is content of an element. Marks must not nest. What is drawn outside of all marks is decoration.
class Mark {
 public:
  Mark(cairo_t* cr, Structure& structure, int element) : Mark(cr, structure, element, structure.elements().at(index(element)).role, {}) {}
  static Mark figure(cairo_t* cr, Structure& structure, int element, const Box& box) {
    structure.place(element, on_paper(cr, box));
    return {cr, structure, element};
  }
  // A click into `box` leads to `destination`, a name from `Names` that the flow knows, or to a file beside the report.
  static Mark link(cairo_t* cr, Structure& structure, int element, const std::string& destination, const Box& box) {
    return {cr, structure, element, CAIRO_TAG_LINK, link_to(cr, destination, box)};
  }
  static Mark link_to_file(cairo_t* cr, Structure& structure, int element, const std::string& file, const Box& box) {
    return {cr, structure, element, CAIRO_TAG_LINK, file_link_to(cr, file, box)};
  }

 private:
  static std::size_t index(int element) { return static_cast<std::size_t>(element); }
  Mark(cairo_t* cr, Structure& structure, int element, const char* role, const std::string& attributes) : tag_(cr, role, attributes) {
    structure.mark(element);
  }
  Tag tag_;
};

}  // namespace pmreport::document::pdf
