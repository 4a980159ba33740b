#include <reports/document/pdf/pdf_page.hpp>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace pmreport::document::pdf {

namespace {

// Rounding of sums must not push a line that fits exactly to the next page.
bool fits(double bottom) { return bottom <= text_height + 0.01; }

}  // namespace

// Gaps that meet are one gap, as large as the largest. Between kept pieces they belong to the group: they are pieces without ink, so that a
// group's height is a sum.
void Flow::gap(double height) {
  if (kept_.empty()) {
    gap_ = std::max(gap_, height);
  } else if (!kept_.back().draw) {
    kept_.back().height = std::max(kept_.back().height, height);
  } else {
    kept_.push_back({.height = height, .keep_with_next = true});
  }
}

void Flow::put(Piece piece) {
  const bool last = !piece.keep_with_next;
  if (kept_.empty()) gap_before_kept_ = std::exchange(gap_, 0);
  kept_.push_back(std::move(piece));
  if (last) place();
}

void Flow::place() {
  double height = 0;
  for (const auto& p : kept_) height += p.height;
  if (pages_.empty()) pages_.push_back({section_, {}});
  if (!at_top()) {
    if (!fits(y_ + gap_before_kept_ + height)) {
      break_page();
    } else {
      y_ += gap_before_kept_;
    }
  }
  if (pages_.back().pieces.empty()) pages_.back().section = section_;
  for (auto& p : kept_) {
    // A group higher than a page must break somewhere.
    if (!fits(y_ + p.height) && !at_top()) break_page();
    if (!p.destination.empty() && !destinations_.emplace(p.destination, static_cast<int>(pages_.size())).second) {
      throw std::logic_error("two places of the report are called " + p.destination);
    }
    if (p.begins) continuation_ = p.begins;
    if (p.ends) continuation_.reset();
    const double piece_height = p.height;
    pages_.back().pieces.push_back({text_top + y_, std::move(p)});
    y_ += piece_height;
  }
  kept_.clear();
}

void Flow::break_page() {
  if (continuation_) pages_.back().pieces.push_back({text_top + y_, continuation_->foot});
  pages_.push_back({section_, {}});
  top_ = 0;
  if (continuation_) {
    pages_.back().pieces.push_back({text_top, continuation_->head});
    top_ = continuation_->head.height;
  }
  y_ = top_;
}

void Flow::new_page() {
  if (!kept_.empty()) place();
  gap_ = 0;
  if (!pages_.empty() && !at_top()) break_page();
}

const std::vector<Page>& Flow::finish() {
  if (!kept_.empty()) place();
  if (pages_.empty()) pages_.push_back({section_, {}});
  while (pages_.size() > 1 && pages_.back().pieces.empty()) pages_.pop_back();
  return pages_;
}

int Flow::page_of(const std::string& destination) const {
  const auto found = destinations_.find(destination);
  if (found == destinations_.end()) throw std::logic_error("no place of the report is called " + destination);
  return found->second;
}

}  // namespace pmreport::document::pdf
