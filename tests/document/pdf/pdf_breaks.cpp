// Where pages end: the layout's own numbers, on items of which the best order is plain to see, and on whole documents.
#include <reports/document/pdf/pdf_breaks.hpp>
#include <reports/document/pdf/pdf_compose.hpp>
#include <reports/document/write.hpp>
#include <tests/document/pdf/pdf_sample.hpp>
#include <tests/document/pdf/pdf_tools.hpp>
#include <tests/document/sample.hpp>

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <memory>
#include <random>

using namespace pmreport::document;
using namespace pmreport::document::pdf;

namespace {

constexpr double tall = 1000;  // a sheet
constexpr double flow_rounding = 0.02;

// Builds items block after block.
struct Story {
  std::vector<Item> items;
  int blocks = 0, sections = 0;
  Story& section() {
    ++sections;
    return *this;
  }
  Story& text(double height, double reluctance = 0) {
    items.push_back({.height = height, .reluctance = reluctance, .block = ++blocks, .section = sections});
    return *this;
  }
  Story& lines(int n, double height) {
    ++blocks;
    for (int i = 0; i < n; ++i) items.push_back({.height = height, .block = blocks, .section = sections});
    return *this;
  }
  Story& figure(double height) {
    items.push_back({.height = height, .scales = true, .block = ++blocks, .section = sections, .may_move = true});
    return *this;
  }
  Story& rows(int n, double height, double reluctance) {
    ++blocks;
    for (int i = 0; i < n; ++i)
      items.push_back({.height = height,
                       .reluctance = i + 1 < n ? reluctance : 0,
                       .block = blocks,
                       .section = sections,
                       .stands_in = true,
                       .head = i > 0 ? height : 0});
    return *this;
  }
  std::vector<Sheet> sheets() const { return break_pages(items, tall); }
};

std::vector<std::size_t> order_of(const std::vector<Sheet>& sheets) {
  std::vector<std::size_t> all;
  for (const Sheet& s : sheets) all.insert(all.end(), s.items.begin(), s.items.end());
  return all;
}

// Composes a report as its PDF is, without drawing it.
std::vector<Page> pages_of(const Report& r) {
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
      cairo_recording_surface_create(CAIRO_CONTENT_COLOR, nullptr), cairo_surface_destroy);
  const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cr(cairo_create(surface.get()), cairo_destroy);
  Composer c{.report = r, .names = names_of(r), .numbering = numbering_of(r), .cr = cr.get()};
  compose(c, plan_of(c), {});
  return c.flow.finish();
}

}  // namespace

TEST_CASE("a figure a little too high for the rest of its page is made a little smaller") {
  const auto sheets = Story().text(500).figure(550).lines(20, 50).sheets();
  REQUIRE(sheets[0].items.size() == 2);
  CHECK(sheets[0].scale == Approx(500.0 / 550));
  CHECK(sheets[1].scale == 1);
}

TEST_CASE("a figure is never made smaller than it may be") {
  const auto sheets = Story().text(500).figure(600).section().lines(10, 50).sheets();
  CHECK(sheets[0].items.size() == 1);
  CHECK(std::ranges::all_of(sheets, [](const Sheet& s) { return s.scale >= least_scale; }));
}

TEST_CASE("a figure that does not fit lets the table that follows it go first") {
  const auto sheets = Story().text(500).figure(700).text(450).text(300).sheets();
  CHECK(sheets[0].items == std::vector<std::size_t>{0, 2});
  CHECK(sheets[1].items == std::vector<std::size_t>{1, 3});
}

TEST_CASE("gaps open where a page would else be mostly white, and only as far as that") {
  Story s;
  s.text(215).text(215).text(100).section().text(50, never).figure(900);
  for (std::size_t i : {1u, 2u, 3u}) s.items[i].gap = 40;
  const auto sheets = s.sheets();
  REQUIRE(sheets[0].items.size() == 3);
  CHECK(sheets[0].used == Approx((1 - most_white) * tall).margin(flow_rounding));
  CHECK(sheets[0].y[1] == Approx(215 + 40 * (1 + sheets[0].stretch)));
  CHECK(sheets[0].stretch <= most_stretch);
  CHECK(sheets[1].stretch == 0);
}

TEST_CASE("a figure does not slip behind a paragraph to leave its section's introduction alone") {
  Story s;
  s.text(750).section().text(50, never).text(50, parted).figure(600).text(50).text(700);
  CHECK(s.sheets()[0].items == std::vector<std::size_t>{0});
}

TEST_CASE("a table may stand in for a section's first figure, evidence may not") {
  Story by_table;
  by_table.text(500).section().text(50, never).text(50, parted).figure(600).rows(6, 50, split_small).text(700);
  CHECK(by_table.sheets()[0].items.size() == 3 + 6);
  Story by_evidence = by_table;
  for (Item& i : by_evidence.items) i.stands_in = false;
  CHECK(by_evidence.sheets()[0].items == std::vector<std::size_t>{0});

  // The same of a whole document, wherever on its page the section begins.
  Report r = sample::report();
  const Section with_figure = *std::ranges::find_if(r.sections, [](const Section& s) {
    return std::ranges::any_of(s.blocks, [](const Block& b) { return std::holds_alternative<pmreport::figure::Figure>(b); });
  });
  const auto shown =
      std::ranges::find_if(with_figure.blocks, [](const Block& b) { return std::holds_alternative<pmreport::figure::Figure>(b); });
  const Proof proof{{{"it holds", "by two ways", 0, 1, ""}, {"so does this", "by two ways", 0, 1, ""}}};
  for (int lines = 16; lines <= 40; lines += 4) {
    r.sections = {{"before", "", "Before", {}},
                  {"after", "", "After", {Paragraph{{}, "An introduction."}, *shown, Paragraph{{}, "A remark."}, proof}}};
    for (int i = 0; i < lines; ++i) r.sections[0].blocks.push_back(Paragraph{{}, "A line."});
    const auto text = sample::ask("pdftotext -layout {} -", to_pdf(r));
    if (!text) return;
    CAPTURE(lines, *text);
    const std::size_t evidence = text->find("Evidence\n");
    REQUIRE(evidence != std::string::npos);
    CHECK(text->find("Figure 1.") < evidence);
  }
}

TEST_CASE("a figure never leaves its section, and never overtakes another") {
  const auto next = Story().text(500).figure(700).section().text(450).text(300).sheets();
  CHECK(order_of(next) == std::vector<std::size_t>{0, 1, 2, 3});
  const auto two = Story().text(500).figure(700).figure(400).text(450).text(300).sheets();
  const auto order = order_of(two);
  CHECK(std::ranges::find(order, 1u) < std::ranges::find(order, 2u));
  CHECK(two[0].items == std::vector<std::size_t>{0, 3});
}

TEST_CASE("a heading takes its introduction and its first figure along to the next page") {
  Story s;
  s.text(700).section().text(50, never).text(100, parted).figure(600).text(100);
  const auto sheets = s.sheets();
  CHECK(sheets[0].items == std::vector<std::size_t>{0});
  CHECK(sheets[1].items == std::vector<std::size_t>{1, 2, 3, 4});
}

TEST_CASE("a small table stays whole, and a large one is broken where the page ends") {
  const auto small = Story().text(800).rows(6, 50, split_small).text(50).sheets();
  CHECK(small[0].items.size() == 1);
  const auto large = Story().text(500).rows(30, 50, split_large).text(50).sheets();
  CHECK(large[0].items.size() == 11);
  CHECK(large[1].y[0] == Approx(50));  // below the heading that is repeated
}

TEST_CASE("of two ends that are allowed the one is taken that leaves the later page well filled too") {
  // Filled as far as it goes, the first page would leave the second to the fourth item alone.
  const auto sheets = Story().text(350).text(350).text(300).text(400).text(990).sheets();
  for (std::size_t i = 0; i + 1 < sheets.size(); ++i) CHECK(1 - sheets[i].used / tall <= most_white);
}

TEST_CASE("every item stands once, within its page, below the one before, and only what may move has moved") {
  std::mt19937 random(20261201);
  std::uniform_real_distribution<double> height(10, 500), gap(0, 40);
  std::uniform_int_distribution<int> kind(0, 9), run(1, 6);
  for (int round = 0; round < 300; ++round) {
    CAPTURE(round);
    Story s;
    for (int i = 0; i < 30; ++i) {
      const int k = kind(random);
      if (k == 0) s.section();
      if (k < 3)
        s.figure(height(random));
      else if (k < 6)
        s.rows(run(random), 40, k == 4 ? split_small : split_large);
      else
        s.text(height(random), k == 7 ? parted : k == 8 ? never : 0);
    }
    for (Item& i : s.items) i.gap = gap(random);
    const auto sheets = s.sheets();
    std::vector<int> seen(s.items.size(), 0);
    std::size_t last_still = 0, last_figure = 0;
    int section = 0;
    for (const Sheet& sheet : sheets) {
      double bottom = 0;
      for (std::size_t k = 0; k < sheet.items.size(); ++k) {
        const std::size_t i = sheet.items[k];
        const Item& item = s.items[i];
        ++seen[i];
        CHECK(sheet.y[k] >= bottom - flow_rounding);
        bottom = sheet.y[k] + item.height * (item.scales ? sheet.scale : 1);
        CHECK(bottom <= tall + flow_rounding);
        CHECK(item.section >= section);
        section = item.section;
        std::size_t& last = item.may_move ? last_figure : last_still;
        CHECK((i == 0 || i > last || last == 0));
        last = i;
      }
      CHECK(bottom == Approx(sheet.used).margin(flow_rounding));
    }
    CHECK(std::ranges::all_of(seen, [](int n) { return n == 1; }));
  }
}

TEST_CASE("no page of a document but its last is white for more than a third") {
  for (const int detail : {0, 1, 2}) {
    CAPTURE(detail);
    Report r = sample::full_report();
    // Sections as reports have them: an introduction, figures of several heights, a table, evidence.
    for (int i = 0; i < 4 * detail; ++i) {
      Section s{fmt::format("more{}", i), "", fmt::format("More {}", i), {}};
      s.blocks.push_back(Paragraph{Paragraph::Tone::plain, "What this section shows, and on what it rests, in a sentence or two."});
      s.blocks.push_back(sample::plot(fmt::format("plot{}", i), 1 + i % 6, 2));
      s.blocks.push_back(sample::grid(4 + 5 * i, 6));
      s.blocks.push_back(Proof{{{"a claim", "shown in two ways", 0, 1e-9, "m"}, {"another", "", 0, 1e-9, "m"}}});
      r.sections.push_back(std::move(s));
    }
    const auto pages = pages_of(r);
    REQUIRE(pages.size() > 5);
    for (std::size_t p = 0; p + 1 < pages.size(); ++p) {
      CAPTURE(p);
      CHECK(pages[p].white <= most_white);
    }
  }
}

TEST_CASE("a report of twice the pages takes no more than twice the work to break, and a little") {
  // A thousand pages and half as many: of all sorts, of one listing, of one table. The work is the ends of pages that are weighed.
  const auto work_of = [](int kind, int n) {
    Story s;
    if (kind == 0)
      for (int i = 0; i < n; ++i) s.lines(10, 11).figure(330).rows(4, 30, split_small);
    else if (kind == 1)
      s.lines(30 * n, 11);
    else
      s.rows(15 * n, 30, split_large);
    std::size_t weighed = 0;
    CHECK(break_pages(s.items, tall, &weighed).size() > std::size_t(n) / 4);
    CHECK(weighed >= s.items.size() / 100);
    return double(weighed);
  };
  for (const int kind : {0, 1, 2}) {
    CAPTURE(kind);
    CHECK(work_of(kind, 2000) < 2.5 * work_of(kind, 1000));
  }
}
