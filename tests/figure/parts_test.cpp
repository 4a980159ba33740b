// What a page finds again in the SVG of a figure: its parts as groups, its words as text.
#include <reports/figure/draw.hpp>

#include <catch2/catch.hpp>
#include <regex>

#include <tests/figure/samples.hpp>

using namespace pmreport::figure;
using samples::curve;

namespace {

int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

Figure two_panels() {
  return samples::figure({samples::panel({curve("l₁", 50, 10, [](double t) { return 30 * std::sin(t); }),
                                          curve("l₂", 50, 10, [](double t) { return -10 * t; })}),
                          samples::panel({curve("θ", 50, 2, [](double t) { return t; })})});
}

// What stands in a group from its opening tag to the tag that closes it.
std::string inside(const std::string& svg, const std::string& opening) {
  const std::size_t begin = svg.find(opening);
  if (begin == std::string::npos) return "";
  int depth = 0;
  const std::regex tag("<(/?)g[ >]");
  for (std::sregex_iterator it(svg.begin() + static_cast<std::ptrdiff_t>(begin), svg.end(), tag), end; it != end; ++it) {
    depth += (*it)[1].length() == 0 ? 1 : -1;
    if (depth == 0) return svg.substr(begin, static_cast<std::size_t>(it->position()));
  }
  return "";
}

}  // namespace

TEST_CASE("panels, curves and keys of an SVG are groups that nest") {
  const std::string svg = to_svg(two_panels());
  CHECK(count(svg, "<g class=\"panel\" ") == 2);
  CHECK(count(svg, "<g class=\"curve\" ") == 3);
  CHECK(count(svg, "<g class=\"key\" ") == 3);
  CHECK(count(svg, "<g ") + count(svg, "<g>") == count(svg, "</g>"));
  const std::string panel = inside(svg, "<g class=\"panel\" ");
  CHECK(count(panel, "<g class=\"curve\" ") == 2);
  CHECK(count(panel, "<g class=\"key\" ") == 2);
  const std::string first = inside(panel, "<g class=\"curve\" data-series=\"0\"");
  CHECK(count(first, "stroke-width:1.1") == 1);
  CHECK(contains(first, "rgb(0%,37"));                                              // the first colour of the palette
  CHECK(count(inside(panel, "<g class=\"key\" data-series=\"1\""), "<use ") == 2);  // "l₂" at its curve
}

TEST_CASE("a panel tells its frame and the ranges of its axes") {
  const std::string svg = to_svg(two_panels());
  const std::regex panel("data-frame=\"([0-9.]+) ([0-9.]+) ([0-9.]+) ([0-9.]+)\" data-x=\"0 10\" data-y=\"(\\S+) (\\S+)\"");
  std::smatch m;
  REQUIRE(std::regex_search(svg, m, panel));
  CHECK(std::stod(m[5]) < -100);
  CHECK(std::stod(m[6]) > 30);
  CHECK(std::stod(m[1]) + std::stod(m[3]) < 247);  // [pt] the left half of 174 mm
}

TEST_CASE("no mark of the parts is left in the drawing") {
  const std::string svg = to_svg(two_panels());
  CHECK_FALSE(contains(svg, "L 0.25 0 L 0.25 0.25"));
  CHECK_FALSE(contains(svg, "fill-opacity:0.5;"));
}

TEST_CASE("the words of an SVG can be searched, each where it is drawn") {
  const std::string svg = to_svg(two_panels());
  for (const char* words : {">l₁</text>", ">l₂</text>", ">θ</text>", ">−50</text>"}) {
    CAPTURE(words);
    CHECK(count(svg, words) == 1);
  }
  CHECK(count(svg, ">time [s]</text>") == 2);
  CHECK(std::regex_search(
      svg, std::regex(">\\(a\\)</tspan><tspan textLength=\"[0-9.]+\" lengthAdjust=\"spacingAndGlyphs\">  limb lengths</tspan></text>")));
  CHECK(count(svg, ">limb length [mm]</text>") == 2);
  const std::regex title(
      "<text transform=\"matrix\\(0 -1 1 0 ([0-9.]+) ([0-9.]+)\\)\" font-size=\"7.5\" textLength=\"([0-9.]+)\" "
      "lengthAdjust=\"spacingAndGlyphs\">limb length \\[mm\\]");
  CHECK(std::regex_search(svg, title));
  CHECK(count(svg, "<g class=\"text\" fill=\"#000\" fill-opacity=\"0\"") == 1);
}

TEST_CASE("words of a user stay words in an SVG") {
  Figure f = two_panels();
  f.panels[0].series[0].label = "<g class=\"curve\"> & \x01\xff id=\"x\" url(#y)";
  const std::string svg = to_svg(f);
  CHECK(count(svg, "<g class=\"curve\" ") == 3);
  CHECK_FALSE(contains(svg, "\x01"));
  CHECK(contains(svg, "&lt;g class=&quot;curve&quot;&gt; &amp; "));
}
