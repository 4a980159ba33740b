// The paper, and the flow of pieces down its pages. All pages are settled together before anything is drawn: a page's end looks ahead, and
// contents and footers know their numbers.
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
  double height = 0;                                    // [pt]
  double reluctance = 0;                                // of a page to end after it, see pdf_breaks.hpp
  std::function<void(cairo_t*)> draw{};                 // top left corner at the origin, text_width wide; may be empty
  std::function<void(cairo_t*, double)> draw_scaled{};  // instead of `draw` for what may shrink to `least_scale` where a page needs it
  bool keep_with_next = false;                          // on the page of the piece after it
  std::string destination{};                            // a link may lead here; empty: none
  int element = -1;                                     // of the structure, that all of it belongs to; -1: it marks its parts itself
  std::shared_ptr<const Continuation> begins{};         // in force after this piece, until one that ends it
  bool ends = false;
};

// How a table goes over to the next page: what closes it below the text, without height, and what opens it again.
struct Continuation {
  Piece foot, head;
};

struct Placed {
  double y;  // of the top, from the top edge of the paper [pt]
  Piece piece;
  double scale = 1;
};

struct Page {
  std::string section;  // in force where the page begins
  std::vector<Placed> pieces;
  double white = 0;  // at its foot, share of the text's height
};

class Flow {
 public:
  void put(Piece piece);
  void gap(double height);  // white, gone at the top of a page; gaps that meet are one, as large as the largest [pt]
  // What is put from here on is one block, until the next begins. A picture may stand after the blocks that follow it in its section where
  // a page ends better so; it never overtakes another.
  enum class Kind { text, picture, table, evidence };
  void block(Kind kind);
  void section(const std::string& running_title);       // begins one
  void reluctance(double cost) { reluctance_ = cost; }  // of a page to end after any piece that is put from here on

  // Settles the pages; there is at least one. Nothing may be put afterwards.
  const std::vector<Page>& finish();

  // Page of a destination, 1 for the first. Throws std::logic_error when none has that name: Cairo would write a dead link without a word.
  int page_of(const std::string& destination) const;
  void require(const std::string& destination) const { page_of(destination); }

 private:
  struct Waiting {
    Piece piece;
    double gap;  // before it [pt]
    int block, section;
    Kind kind;
    std::shared_ptr<const Continuation> within;  // what a page that begins with it continues
  };
  std::vector<Waiting> waiting_;
  std::vector<std::string> sections_{""};
  double gap_ = 0, reluctance_ = 0;
  int block_ = 0;
  Kind kind_ = Kind::text;
  std::shared_ptr<const Continuation> continuation_;
  std::vector<Page> pages_;
  std::map<std::string, int> destinations_;  // page, 0 as long as it waits
};

}  // namespace pmreport::document::pdf
