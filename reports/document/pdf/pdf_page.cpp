#include <reports/document/pdf/pdf_breaks.hpp>
#include <reports/document/pdf/pdf_page.hpp>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace pmreport::document::pdf {

void Flow::gap(double height) { gap_ = std::max(gap_, height); }

void Flow::block(Kind kind) {
  ++block_;
  kind_ = kind;
}

void Flow::section(const std::string& running_title) {
  sections_.push_back(running_title);
  block(Kind::text);
}

void Flow::put(Piece piece) {
  if (!piece.destination.empty() && !destinations_.emplace(piece.destination, 0).second)
    throw std::logic_error("two places of the report are called " + piece.destination);
  piece.reluctance = piece.keep_with_next ? never : piece.reluctance + reluctance_;
  const int section = static_cast<int>(sections_.size()) - 1;
  waiting_.push_back({std::move(piece), std::exchange(gap_, 0), block_, section, kind_, continuation_});
  const Piece& put = waiting_.back().piece;
  if (put.begins) continuation_ = put.begins;
  if (put.ends) continuation_.reset();
}

const std::vector<Page>& Flow::finish() {
  std::vector<Item> items;
  for (const Waiting& w : waiting_) {
    items.push_back({.height = w.piece.height,
                     .scales = static_cast<bool>(w.piece.draw_scaled),
                     .gap = w.gap,
                     .reluctance = w.piece.reluctance,
                     .block = w.block,
                     .section = w.section,
                     .may_move = w.kind == Kind::picture,
                     .stands_in = w.kind == Kind::table,
                     .head = w.within ? w.within->head.height : 0});
  }
  for (const Sheet& sheet : break_pages(items, text_height)) {
    const Waiting& first = waiting_[sheet.items.front()];
    // A table that goes on is closed where the page before ends.
    if (first.within) {
      Page& before = pages_.back();
      const Placed& last = before.pieces.back();
      before.pieces.push_back({last.y + last.piece.height * last.scale, first.within->foot});
    }
    Page& page = pages_.emplace_back(sections_[static_cast<std::size_t>(first.section)]);
    page.white = std::max(0.0, 1 - sheet.used / text_height);
    if (first.within) page.pieces.push_back({text_top, first.within->head});
    for (std::size_t k = 0; k < sheet.items.size(); ++k) {
      Piece& piece = waiting_[sheet.items[k]].piece;
      if (!piece.destination.empty()) destinations_[piece.destination] = static_cast<int>(pages_.size());
      const double scale = piece.draw_scaled ? sheet.scale : 1;
      page.pieces.push_back({text_top + sheet.y[k], std::move(piece), scale});
    }
  }
  waiting_.clear();
  if (pages_.empty()) pages_.push_back({sections_.back(), {}});
  return pages_;
}

int Flow::page_of(const std::string& destination) const {
  const auto found = destinations_.find(destination);
  if (found == destinations_.end()) throw std::logic_error("no place of the report is called " + destination);
  return found->second;
}

}  // namespace pmreport::document::pdf
