// The paper, and the flow of pieces down its pages. Pages are settled before anything is drawn, so that contents and footers know their
// numbers.
#pragma once

#include <cairo.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace pmreport::document::pdf {

inline constexpr double mm = 72 / 25.4;  // [pt]
inline constexpr double paper_width = 210 * mm, paper_height = 297 * mm;
inline constexpr double text_left = 18 * mm, text_width = 174 * mm;  // the full width of a figure
inline constexpr double text_top = 25 * mm, text_height = (297 - 25 - 22) * mm;

struct Continuation;

// What never breaks over a page: a line, a row of a table, a figure.
struct Piece {
  double height = 0;                             // [pt]
  std::function<void(cairo_t*)> draw{};          // top left corner at the origin, text_width wide; may be empty
  bool keep_with_next = false;                   // on the page of the piece after it
  std::string destination{};                     // a link may lead here; empty: none
  const char* role = "P";                        // for readers by ear: "H1", "P", "Figure" as PDF calls them; a string literal
  std::shared_ptr<const Continuation> begins{};  // in force after this piece, until one that ends it
  bool ends = false;
};

// How a table goes over to the next page: what closes it below the text, without height, and what opens it again.
struct Continuation {
  Piece foot, head;
};

struct Placed {
  double y;  // of the top, from the top edge of the paper [pt]
  Piece piece;
};

struct Page {
  std::string section;  // in force where the page begins
  std::vector<Placed> pieces;
};

class Flow {
 public:
  void put(Piece piece);
  void gap(double height);  // white, gone at the top of a page [pt]
  void new_page();
  void section(const std::string& running_title) { section_ = running_title; }

  // Sets what is still kept back, and gives the pages; there is at least one. Nothing may be put afterwards.
  const std::vector<Page>& finish();

  // Page of a destination, 1 for the first. Throws std::logic_error when none has that name: Cairo would write a dead link without a word.
  int page_of(const std::string& destination) const;
  void require(const std::string& destination) const { page_of(destination); }

 private:
  void place();
  void break_page();
  bool at_top() const { return y_ <= top_; }

  std::vector<Page> pages_;
  double top_ = 0;           // where this page's own pieces begin, below text_top and what a table repeats [pt]
  double y_ = 0;             // of the next piece, below text_top [pt]
  double gap_ = 0;           // before the next piece [pt]
  std::vector<Piece> kept_;  // waits for the piece that it must stay with
  double gap_before_kept_ = 0;
  std::string section_;
  std::shared_ptr<const Continuation> continuation_;
  std::map<std::string, int> destinations_;
};

}  // namespace pmreport::document::pdf
