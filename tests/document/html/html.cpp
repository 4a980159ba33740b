// report.html: its structure, and that it holds nothing but what was meant.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <regex>
#include <reports/document/html/html_page.hpp>
#include <reports/document/narrowed.hpp>
#include <reports/document/write.hpp>
#include <set>

#include <tests/document/sample.hpp>

using namespace pmreport;
using namespace pmreport::document;
using sample::contains;
using sample::count;

namespace {

// Values of an attribute in order, found by text alone.
std::vector<std::string> attribute(const std::string& html, const std::string& name) {
  std::vector<std::string> values;
  const std::string opening = " " + name + "=\"";
  for (std::size_t at = html.find(opening); at != std::string::npos; at = html.find(opening, at)) {
    at += opening.size();
    values.push_back(html.substr(at, html.find('"', at) - at));
  }
  return values;
}

Proof& first_proof(Report& r) { return std::get<Proof>(r.sections[0].blocks.back()); }

}  // namespace

TEST_CASE("the page has its landmarks, a title, a language and a width for phones") {
  const std::string html = to_html(sample::report());
  CHECK(html.starts_with("<!DOCTYPE html>\n<html lang=\"en\">"));
  CHECK(contains(html, "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"));
  CHECK(contains(html, "<title>4SPS-SPR: kinematics and statics</title>"));
  for (const std::string tag : {"<header>", "<nav ", "<main>", "<h1>"}) {
    CAPTURE(tag);
    CHECK(count(html, tag) == 1);
  }
  CHECK(count(html, "<section ") == 6);  // summary, checks, two of the report's, scenario, provenance
  CHECK(count(html, "<caption>") == 4);
  CHECK(count(html, "<svg ") == 2 + 2);  // two figures, and the bars of two key numbers that have a limit
  CHECK(count(html, "<img ") == 2);
}

TEST_CASE("files for other programs are listed with a link, what they hold and their size") {
  Report r = sample::report();
  CHECK(!contains(to_html(r), "id=\"files\""));
  r.files = {{"data/mesh.stl", "boundary <of> the workspace", std::string(1234567, 'x')}};
  const std::string html = to_html(r);
  CHECK(count(html, "<section id=\"files\"") == 1);
  CHECK(count(html, "href=\"#files\"") == 1);
  CHECK(contains(html, "<a href=\"data/mesh.stl\">data/mesh.stl</a>"));
  CHECK(contains(html, "boundary &lt;of&gt; the workspace"));
  CHECK(contains(html, "1.2 MB"));
}

TEST_CASE("every opened element is closed, in order") {
  Report r = sample::report();
  r.files = {{"data/mesh.stl", "boundary", "x"}};
  const std::string html = to_html(r);
  const std::set<std::string> without_content{"meta", "link", "img"};
  std::vector<std::string> open;
  const std::regex tag("<(/?)([a-zA-Z][a-zA-Z0-9]*)[^>]*?(/?)>");
  for (std::sregex_iterator it(html.begin(), html.end(), tag); it != std::sregex_iterator(); ++it) {
    const std::string name = (*it)[2];
    if (without_content.contains(name) || (*it)[3].length() > 0) continue;
    if ((*it)[1].length() == 0) {
      open.push_back(name);
      continue;
    }
    REQUIRE_FALSE(open.empty());
    REQUIRE(open.back() == name);
    open.pop_back();
  }
  CHECK(open.empty());
}

TEST_CASE("the page needs no network") {
  const std::string html = to_html(sample::report());
  for (std::size_t link = 0; (link = html.find("<link", link)) != std::string::npos; ++link)
    CHECK_THAT(html.substr(link, 60), Catch::StartsWith("<link rel=\"icon\" href=\"data:image/svg+xml,"));
  CHECK_FALSE(contains(html, "@import"));
  CHECK_FALSE(contains(html, "url(http"));
  for (const std::string& source : attribute(html, "src")) CHECK(source.starts_with("data:image/png;base64,"));
  for (const std::string& link : attribute(html, "href")) {
    CAPTURE(link);
    CHECK_FALSE(contains(link, "//"));
  }
}

TEST_CASE("ids are unique and every link inside the page arrives") {
  Report r = sample::report();
  r.sections[1].id = "displacement";  // twice the same, and figures too
  std::get<figure::Figure>(r.sections[1].blocks[0]).id = "displacement";
  r.sections[1].title = "summary";
  const std::string html = to_html(r);
  std::set<std::string> ids;
  for (const std::string& id : attribute(html, "id")) {
    CAPTURE(id);
    CHECK(ids.insert(id).second);
  }
  for (const char* name : {"href", "xlink:href"}) {
    for (const std::string& link : attribute(html, name)) {
      CAPTURE(link);
      if (link.starts_with("#")) CHECK(ids.contains(link.substr(1)));
    }
  }
}

TEST_CASE("a script typed anywhere is shown as text") {
  const std::string evil = "<script>alert(1)</script>\"'><img src=x onerror=alert(1)>";
  Report r = sample::report();
  r.title = r.author = r.description = r.mechanism_title = r.source = r.scenario_text = evil;
  r.summary[0].text = r.sections[0].title = r.sections[0].id = evil;
  std::get<figure::Figure>(r.sections[0].blocks[1]).caption = evil;
  auto& table = std::get<Table>(r.sections[0].blocks[2]);
  table.caption = table.headings[0] = table.rows[0][0] = evil;
  first_proof(r).lines[0].claim = first_proof(r).lines[0].how = first_proof(r).lines[0].unit = evil;
  auto& gallery = std::get<Gallery>(r.sections[1].blocks[1]);
  gallery.caption = gallery.pictures[0].caption = gallery.pictures[0].id = evil;
  r.checks[0].name = r.checks[0].measured = r.checks[0].limit = r.checks[0].message = evil;
  r.provenance = {evil, evil, evil, evil, evil, evil};
  const std::string html = to_html(r);
  CHECK(count(html, "<script") == count(to_html(sample::report()), "<script"));
  CHECK_FALSE(contains(html, "<script>"));
  CHECK_FALSE(contains(html, "<img src=x"));
  CHECK(contains(html, "<title>&lt;script&gt;alert(1)&lt;/script&gt;"));
  CHECK(count(html, "<img ") == 2);
}

TEST_CASE("a passing report says so with its counts") {
  const std::string html = to_html(sample::report());
  CHECK(contains(html, "<h2>✓ Passed</h2>"));
  CHECK(contains(html, "<dt>1 check</dt>"));
  CHECK(contains(html, "<dt>4 lines of evidence</dt>"));
  CHECK(contains(html, "<li class=\"state passed\">1 passed</li>"));
  CHECK(contains(html, "<li class=\"state passed\">4 passed</li>"));
  CHECK(count(html, "<li class=\"state ") == 2);
  CHECK_FALSE(contains(html, "✗"));
}

TEST_CASE("a failing report names what failed, with a link to it, in words as well as in colour") {
  Report r = sample::report();
  first_proof(r).lines[0].value = std::numeric_limits<double>::quiet_NaN();
  r.checks.push_back({"min(stroke_margin) > 0 mm", "-12.4 mm", "0 mm", -0.0124, 0, "m", false, "t = 3.62 s: limb 3 is too long", 12});
  const std::string html = to_html(r);
  CHECK(contains(html, "<h2>✗ Failed</h2>"));
  CHECK(contains(html, "<li class=\"state failed\">1 failed</li>"));
  CHECK(contains(html, "<li class=\"state error\">1 error</li>"));
  CHECK(contains(html,
                 "<a href=\"#checks\">min(stroke_margin) &gt; 0 mm</a></div>\n<div class=\"how\">t = 3.62 s: limb 3 is too long</div>"));
  CHECK(contains(html, "<a href=\"#displacement\">Displacement: loop closure: every joint meets</a>"));
  CHECK(count(html, "✗ failed") == 1);
  CHECK(count(html, "✗ error") == 1);
  CHECK(contains(html, "<a href=\"#line-12\">line 12</a>"));
}

TEST_CASE("evidence shows its value and tolerance as a reader writes them") {
  const std::string html = to_html(sample::report());
  CHECK(contains(html, "<td class=\"number\">2.1 × 10⁻¹⁶ m</td>"));
  CHECK(contains(html, "<td class=\"number\">1 × 10⁻⁹ m</td>"));
}

TEST_CASE("the first page has key numbers with bars, findings by their weight, and what was not asked") {
  const std::string html = to_html(sample::report());
  CHECK(contains(html, "<svg class=\"bar broken\""));
  CHECK(contains(html, "<svg class=\"bar well\""));
  CHECK(contains(html, "<strong>107 %</strong>"));
  CHECK(contains(html, "<a href=\"#statics\">Largest force of an actuator</a>"));
  CHECK(html.find("limb 3 needs 812.4 mm") < html.rfind("1 does not."));
  CHECK(html.rfind("1 does not.") < html.find("0.82 at least"));
  CHECK(count(html, "1 does not.") == 2);  // beside the verdict too
  CHECK(contains(html, "<a href=\"#displacement\">1 Displacement</a>"));
  CHECK(contains(html, "Not asked of this report: dynamics and workspace."));
  CHECK(contains(html, "Bodies are rigid and keep their declared sizes."));
}

TEST_CASE("faults come before what was asked") {
  const std::string html = to_html(sample::report());
  CHECK(html.find("limb 3 needs 812.4 mm") < html.find("The limbs work between"));
}

TEST_CASE("a figure stands with its number, caption, files and data") {
  const std::string html = to_html(sample::report());
  CHECK(contains(html, "<figure id=\"figure-displacement\" class=\"plot full\">"));
  CHECK(contains(html, "<figure id=\"figure-statics\" class=\"plot column\">"));
  for (const std::string file : {"figures/displacement.pdf", "figures/displacement.svg", "data/displacement.csv", "report.pdf",
                                 "results.json", "snapshots/pose-0.png"}) {
    CAPTURE(file);
    CHECK(contains(html, "href=\"" + file + "\""));
  }
  CHECK(contains(html, "<strong>Figure 2.</strong>"));
}

TEST_CASE("a picture in the page is the picture of the report") {
  const Report r = sample::report();
  const auto& picture = std::get<Gallery>(r.sections[1].blocks[1]).pictures[0];
  const sample::Folder folder;
  const std::string source = attribute(to_html(r), "src").front();
  sample::put(folder / "code", source.substr(source.find(',') + 1));
  REQUIRE(std::system(("base64 -d " + (folder / "code").string() + " > " + (folder / "png").string()).c_str()) == 0);
  const Surface there = decoded(sample::bytes_of(folder / "png"), picture.width), here = decoded(picture.png, picture.width);
  REQUIRE(there);
  const int rows = cairo_image_surface_get_height(here.get()), stride = cairo_image_surface_get_stride(here.get());
  REQUIRE(cairo_image_surface_get_height(there.get()) == rows);
  REQUIRE(cairo_image_surface_get_stride(there.get()) == stride);
  CHECK(std::memcmp(cairo_image_surface_get_data(there.get()), cairo_image_surface_get_data(here.get()),
                    static_cast<std::size_t>(rows * stride)) == 0);
}

TEST_CASE("the scenario is in the page line by line") {
  Report r = sample::report();
  r.scenario_text = "a = 1\n\n  b = \"<2>\"";
  const std::string html = to_html(r);
  CHECK(contains(html,
                 "<pre><span id=\"line-1\" class=\"line\">a = 1</span>\n<span id=\"line-2\" class=\"line\"></span>\n"
                 "<span id=\"line-3\" class=\"line\">  b = &quot;&lt;2&gt;&quot;</span>\n</pre>"));
}

TEST_CASE("a drawing keeps its look where inline styles are forbidden") {
  CHECK(inline_svg("<?xml version=\"1.0\"?>\n<svg width=\"1\"><path style=\" stroke:none;fill-rule:nonzero;fill:rgb(0%,1%,2%);\" d=\"M 0 "
                   "0\"/></svg>") ==
        "<svg width=\"1\"><path stroke=\"none\" fill-rule=\"nonzero\" fill=\"rgb(0%,1%,2%)\" d=\"M 0 0\"/></svg>");
  CHECK_FALSE(contains(to_html(sample::report()), " style=\""));
}

TEST_CASE("a glyph stands once in a page, whatever the number of drawings that use it") {
  const std::string first =
                        "<svg><defs>\n<symbol overflow=\"visible\" id=\"f-a-1\">\n<path d=\"M 0 0\"/>\n</symbol>\n</defs>"
                        "<use xlink:href=\"#f-a-1\"/></svg>",
                    second =
                        "<svg><defs>\n<symbol overflow=\"visible\" id=\"f-b-1\">\n<path d=\"M 1 0\"/>\n</symbol>\n"
                        "<symbol overflow=\"visible\" id=\"f-b-11\">\n<path d=\"M 0 0\"/>\n</symbol>\n</defs>"
                        "<use xlink:href=\"#f-b-1\"/><use xlink:href=\"#f-b-11\"/></svg>";
  Glyphs shared;
  CHECK(inline_svg(first, shared) == first);
  CHECK(inline_svg(second, shared) ==
        "<svg><defs>\n<symbol overflow=\"visible\" id=\"f-b-1\">\n<path d=\"M 1 0\"/>\n</symbol>\n</defs>"
        "<use xlink:href=\"#f-b-1\"/><use xlink:href=\"#f-a-1\"/></svg>");
  CHECK(inline_svg(second) == second);

  const std::string html = to_html(sample::report());
  const std::vector<std::string> ids = attribute(html, "id");
  std::set<std::string> outlines;
  int glyphs = 0;
  constexpr std::string_view opening = "<symbol ", closing = "</symbol>";
  for (std::size_t at = html.find(opening); at != std::string::npos; at = html.find(opening, at + 1), ++glyphs)
    outlines.insert(html.substr(html.find('>', at), html.find(closing, at) - html.find('>', at)));
  CHECK(glyphs > 20);
  CHECK(outlines.size() == static_cast<std::size_t>(glyphs));
  const std::set<std::string> defined(ids.begin(), ids.end());
  CHECK(defined.size() == ids.size());
  const std::vector<std::string> used = attribute(html, "xlink:href");
  CHECK(used.size() > 100);
  for (const std::string& use : used) {
    CAPTURE(use);
    CHECK((use.starts_with("data:") || defined.contains(use.substr(1))));
  }
}

TEST_CASE("an empty report is a page too") {
  const std::string html = to_html(Report{});
  CHECK(contains(html, "<h2>Nothing to check</h2>"));
  CHECK(contains(html, "<dt>No checks</dt>"));
  CHECK(html.ends_with("</html>\n"));
}
