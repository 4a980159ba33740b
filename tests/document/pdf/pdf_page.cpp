// How pieces flow down the pages, and how tables find their widths.
#include <reports/document/pdf/pdf_page.hpp>
#include <reports/document/pdf/pdf_table.hpp>

#include <catch2/catch.hpp>

#include <numeric>
#include <random>
#include <stdexcept>

using namespace pmreport::document::pdf;

namespace {

constexpr double tenth = text_height / 10;
constexpr double rounding = 0.02;  // [pt]; twice what the flow allows, and less than anyone sees

Piece piece(double height, bool keep = false, const std::string& destination = "") {
  return {.height = height, .draw = [](cairo_t*) {}, .keep_with_next = keep, .destination = destination};
}

void fill(Flow& flow, int tenths) {
  for (int i = 0; i < tenths; ++i) flow.put(piece(tenth));
}

}  // namespace

TEST_CASE("what does not fit goes to the next page") {
  Flow flow;
  fill(flow, 9);
  flow.put(piece(1.5 * tenth));
  const auto& pages = flow.finish();
  REQUIRE(pages.size() == 2);
  CHECK(pages[0].pieces.size() == 9);
  CHECK(pages[1].pieces.size() == 1);
  CHECK(pages[1].pieces[0].y == Approx(text_top));
}

TEST_CASE("a heading is never the last on a page") {
  Flow flow;
  fill(flow, 9);
  flow.put(piece(0.5 * tenth, true, "heading"));
  flow.gap(0.3 * tenth);
  flow.put(piece(tenth));
  CHECK(flow.finish().size() == 2);
  CHECK(flow.page_of("heading") == 2);
}

TEST_CASE("gaps that meet are one gap, and there is none at the top of a page") {
  Flow flow;
  flow.gap(50);
  flow.put(piece(100));
  flow.gap(10);
  flow.gap(30);
  flow.gap(20);
  flow.put(piece(100));
  const auto& page = flow.finish().front();
  CHECK(page.pieces[0].y == Approx(text_top));
  CHECK(page.pieces[1].y == Approx(text_top + 130));
}

TEST_CASE("pieces never overlap, never leave the page, keep their order and stay with their next") {
  std::mt19937 random(20240611);
  std::uniform_real_distribution<double> height(1, 0.3 * text_height), space(0, 40);
  std::bernoulli_distribution keep(0.3);
  for (int round = 0; round < 200; ++round) {
    CAPTURE(round);
    Flow flow;
    std::vector<bool> kept;
    double group = 0;
    for (int i = 0; i < 40; ++i) {
      const double h = height(random);
      // A group above a page's height may break, which is not what is tested here.
      const bool stays = keep(random) && group + h + 0.3 * text_height < text_height;
      group = stays ? group + h : 0;
      kept.push_back(stays);
      if (!stays || i == 0) flow.gap(space(random));
      flow.put(piece(h, stays, "p" + std::to_string(i)));
    }
    const auto& pages = flow.finish();
    int next = 0;
    for (std::size_t p = 0; p < pages.size(); ++p) {
      double bottom = text_top;
      for (const auto& placed : pages[p].pieces) {
        CHECK(placed.y >= bottom - rounding);
        bottom = placed.y + placed.piece.height;
        CHECK(bottom <= text_top + text_height + rounding);
        if (!placed.piece.destination.empty()) {
          CHECK(placed.piece.destination == "p" + std::to_string(next));
          CHECK(flow.page_of(placed.piece.destination) == static_cast<int>(p) + 1);
          ++next;
        }
      }
    }
    CHECK(next == 40);
    for (int i = 0; i + 1 < 40; ++i) {
      if (kept[static_cast<std::size_t>(i)]) CHECK(flow.page_of("p" + std::to_string(i)) == flow.page_of("p" + std::to_string(i + 1)));
    }
  }
}

TEST_CASE("a table that goes over a page is closed below and opened again above") {
  Flow flow;
  Continuation over{piece(0), piece(2 * tenth)};
  constexpr int foot = 7, head = 8;
  over.foot.element = foot;
  over.head.element = head;
  Piece first = piece(tenth);
  first.begins = std::make_shared<const Continuation>(over);
  flow.put(first);
  fill(flow, 12);
  Piece last = piece(tenth);
  last.ends = true;
  flow.put(last);
  fill(flow, 10);
  const auto& pages = flow.finish();
  REQUIRE(pages.size() == 3);
  CHECK(pages[0].pieces.back().piece.element == foot);
  CHECK(pages[0].pieces.back().y == Approx(text_top + text_height));
  CHECK(pages[1].pieces.front().piece.element == head);
  CHECK(pages[1].pieces[1].y == Approx(text_top + 2 * tenth));
  CHECK(pages[2].pieces.front().piece.element != head);
}

TEST_CASE("a piece higher than a page has a page of its own, and the flow goes on") {
  Flow flow;
  fill(flow, 1);
  flow.put(piece(3 * text_height));
  fill(flow, 1);
  CHECK(flow.finish().size() == 3);
}

TEST_CASE("a page carries the section that its first line belongs to") {
  Flow flow;
  flow.put(piece(10 * tenth));
  flow.section("one");
  fill(flow, 9);
  flow.section("two");
  fill(flow, 2);
  const auto& pages = flow.finish();
  REQUIRE(pages.size() == 3);
  CHECK(pages[0].section.empty());
  CHECK(pages[1].section == "one");
  CHECK(pages[2].section == "two");
}

TEST_CASE("a link to nowhere and a name used twice are errors, for Cairo would not tell") {
  Flow flow;
  flow.put(piece(1, false, "here"));
  CHECK_THROWS_AS(flow.page_of("there"), std::logic_error);
  CHECK_THROWS_AS(flow.put(piece(1, false, "here")), std::logic_error);
}

TEST_CASE("a table that fits keeps its size of type and its natural widths") {
  const Fit fit = fit_columns({100, 50}, {60, 50}, 200, 8.5, 6.5);
  CHECK(fit.size == 8.5);
  CHECK(fit.width == std::vector<double>{100, 50});
}

TEST_CASE("a table too wide wraps between words first, then takes smaller type, then breaks words") {
  const Fit wrapped = fit_columns({300, 50}, {100, 50}, 200, 8.5, 6.5);
  CHECK(wrapped.size == 8.5);
  CHECK(wrapped.width[0] == Approx(150));
  CHECK(wrapped.width[1] == Approx(50));
  const Fit smaller = fit_columns({300, 100}, {120, 100}, 200, 8.5, 6.5);
  CHECK(smaller.size == 7.5);
  const Fit broken = fit_columns({900, 100}, {900, 100}, 200, 8.5, 6.5);
  CHECK(broken.size == 6.5);
  CHECK(broken.width[1] == Approx(100 * 6.5 / 8.5));
}

TEST_CASE("a table never takes more than the width there is") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> width(0, 200), part(0, 1);
  std::uniform_int_distribution<int> columns(1, 24);
  for (int round = 0; round < 1000; ++round) {
    CAPTURE(round);
    std::vector<double> natural, tight;
    for (int j = columns(random); j > 0; --j) {
      natural.push_back(width(random));
      tight.push_back(natural.back() * part(random));
    }
    const Fit fit = fit_columns(natural, tight, 490, 8.5, 6.5);
    CHECK(std::accumulate(fit.width.begin(), fit.width.end(), 0.0) <= 490 + rounding);
    CHECK(fit.size >= 6.5);
    for (const double w : fit.width) CHECK(w >= 0);
  }
}
