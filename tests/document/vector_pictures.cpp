// Pictures that are there as vectors too.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <tests/document/pdf/pdf_tools.hpp>
#include <tests/document/sample.hpp>

#include <reports/document/names.hpp>
#include <reports/document/pdf/pdf_finish.hpp>
#include <reports/document/write.hpp>
#include <reports/figure/surface.hpp>

using namespace pmreport::document;
using sample::contains;

namespace {

constexpr const char* drawn =
    "<svg width=\"10pt\" height=\"5pt\" viewBox=\"0 0 10 5\" role=\"img\">\n<title>t</title>\n<path style=\"fill:none\"/></svg>\n";

// Each bar with a shading of its own, as those of a machine have.
std::string shaded_bars() {
  return pmreport::figure::written_pdf(
      {100, 100},
      [](cairo_t* cr) {
        for (int k = 0; k < 100; ++k) {
          cairo_pattern_t* across = cairo_pattern_create_linear(0, k, 0, k + 1);
          for (const double at : {0.0, 0.3, 0.65, 1.0}) cairo_pattern_add_color_stop_rgb(across, at, 0.01 * k, at * at, 1 - 0.005 * k);
          cairo_set_source(cr, across);
          cairo_pattern_destroy(across);
          cairo_rectangle(cr, 0.5 * k, k, 50, 1);
          cairo_fill(cr);
        }
      },
      "bars");
}

// The sample, its first snapshot with vectors.
Report with_vectors() {
  Report r = sample::report();
  for (Section& s : r.sections)
    for (Block& b : s.blocks)
      if (auto* g = std::get_if<Gallery>(&b)) {
        g->pictures[0].pdf = shaded_bars();
        g->pictures[0].svg = drawn;
        return r;
      }
  FAIL("the sample has no pictures");
  return r;
}

Picture& first_picture(Report& r) {
  for (Section& s : r.sections)
    for (Block& b : s.blocks)
      if (auto* g = std::get_if<Gallery>(&b)) return g->pictures[0];
  throw std::logic_error("the sample has no pictures");
}

}  // namespace

TEST_CASE("a picture's vectors are written beside its PNG, listed, and linked below it") {
  const Report r = with_vectors();
  const sample::Folder folder;
  write(r, folder / "report");
  CHECK(sample::bytes_of(folder / "report/snapshots/pose-0.pdf") == pdf::packed(shaded_bars()));
  CHECK(sample::bytes_of(folder / "report/snapshots/pose-0.svg") == drawn);
  const auto json = nlohmann::json::parse(to_json(r));
  const auto files = json["files"].get<std::vector<std::string>>();
  for (const char* name : {"snapshots/pose-0.pdf", "snapshots/pose-0.svg"}) {
    CAPTURE(name);
    CHECK(std::find(files.begin(), files.end(), name) != files.end());
    CHECK(contains(to_html(r), std::string("href=\"") + name + "\""));
  }
  CHECK(json["snapshots"][0]["pdf"] == "snapshots/pose-0.pdf");
  CHECK(json["snapshots"][0]["svg"] == "snapshots/pose-0.svg");
  CHECK_FALSE(json["snapshots"][1].contains("pdf"));
  CHECK_FALSE(contains(to_html(r), "pose-5.pdf"));
}

TEST_CASE("a picture's PDF is packed to two thirds and looks the same") {
  const std::string drawn = shaded_bars(), packed = pdf::packed(drawn);
  CHECK(3 * packed.size() < 2 * drawn.size());
  CHECK(pdf::packed(drawn) == packed);
  const auto seen = [](const std::string& of) { return sample::ask("pdftoppm -r 144 {} 2>&1 | sha256sum", of); };
  CHECK(seen(packed) == seen(drawn));
  CHECK_THROWS_AS(pdf::packed("%PDF-of-a-picture"), OutputError);
}

TEST_CASE("a line drawing stands in the page and in the PDF as vectors, other pictures as pixels") {
  Report r = with_vectors();
  const std::string as_pixels = to_html(r);
  CHECK_FALSE(contains(as_pixels, "<path fill=\"none\"/>"));
  int asked = 0;
  double width = 0;
  first_picture(r).as_lines = [&](cairo_t*, double w) { ++asked, width = w; };
  const std::string html = to_html(r);
  CHECK(contains(html, "<path fill=\"none\"/>"));
  CHECK(contains(html, "<div class=\"lines\" role=\"img\" aria-label=\""));
  CHECK(html.find("<img") != std::string::npos);  // the second picture
  const std::string pdf = to_pdf(r);
  CHECK(asked > 0);
  CHECK(width > 100);
}
