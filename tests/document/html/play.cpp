// What report.html has for those who play with it and for those who cannot see it: scripts, curves as data, figures in words.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <reports/document/html/figure_words.hpp>
#include <reports/document/html/html_page.hpp>
#include <reports/document/html/series_data.hpp>
#include <reports/document/write.hpp>

#include <tests/document/sample.hpp>

using namespace pmreport;
using namespace pmreport::document;
using nlohmann::json;
using sample::contains;
using sample::count;

namespace {

constexpr double gap = std::numeric_limits<double>::quiet_NaN();

figure::Panel against_time(std::vector<figure::Series> series) {
  return {"limb lengths", {"time", "s"}, {"limb length", "mm"}, std::move(series), {}, {}};
}

figure::Figure figure_of(std::vector<figure::Panel> panels) {
  figure::Figure f;
  f.panels = std::move(panels);
  return f;
}

figure::Series wave(int samples, double uneven = 0) {
  figure::Series s{"l₁", {}, {}};
  for (int i = 0; i < samples; ++i) {
    const double t = 2.0 * i / (samples - 1);
    s.x.push_back(t + uneven * t * (2 - t));
    s.y.push_back(700 + 100 * std::sin(2 * std::numbers::pi * s.x.back()));
  }
  return s;
}

// As the script reads them.
std::vector<double> times(const json& x) {
  if (x.is_array()) return x.get<std::vector<double>>();
  std::vector<double> all;
  const int n = x["n"];
  for (int i = 0; i < n; ++i) all.push_back(x["from"].get<double>() + (x["to"].get<double>() - x["from"].get<double>()) * i / (n - 1));
  return all;
}

std::vector<double> values(const json& panel, const json& series) {
  std::vector<double> all;
  double steps = 0;
  for (const json& y : series["y"])
    all.push_back(y.is_null() ? gap : panel["low"].get<double>() + panel["step"].get<double>() * (steps += y.get<double>()));
  return all;
}

double between(const std::vector<double>& x, const std::vector<double>& y, double at) {
  const std::size_t i = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end() - 1, at) - x.begin());
  return y[i - 1] + (y[i] - y[i - 1]) * (at - x[i - 1]) / (x[i] - x[i - 1]);
}

}  // namespace

TEST_CASE("small multiples have the time of all plots, and the names of their rows and columns for what is read at it") {
  figure::Figure f = figure_of({against_time({wave(21)}), against_time({wave(21)})});
  for (figure::Panel& p : f.panels) p.x = {"t", "s"}, p.title = "a title";
  f.multiples = figure::Multiples{{"l₁"}, {"length", "<speed>"}};
  const std::string text = series_data(f);
  CHECK_FALSE(contains(text, "<"));
  const json data = json::parse(text);
  CHECK(data["rows"] == json{"l₁"});
  CHECK(data["columns"] == json{"length", "<speed>"});
  REQUIRE(data["panels"].size() == 2);
  for (const json& panel : data["panels"]) {
    CHECK(panel["time"] == true);
    CHECK(panel["name"] == "a title");
    CHECK(panel["series"][0]["y"].size() > 10);
  }
}

TEST_CASE("the page carries one script, and it is ours") {
  const std::string html = to_html(sample::report());
  CHECK(count(html, "<script type=\"module\">") == 1);
  CHECK(count(html, "<script type=\"application/json\">") == 2);
  CHECK(count(html, "<script") == 3);
  const std::string script = html_script;
  for (const char* word : {"fetch", "import", "XMLHttpRequest", "eval", "innerHTML", "</script", "<!--"}) {
    CAPTURE(word);
    CHECK_FALSE(contains(script, word));
  }
}

TEST_CASE("the functions of the script pass their own tests") {
  if (std::system("command -v node >/dev/null") != 0) {
    WARN("node is not here: the script of report.html was not tested");
    return;
  }
  CHECK(std::system("node --test " SOURCE "/tests/document/html/report_test.js") == 0);
}

TEST_CASE("a curve against time is data with times in common, gaps and a step fine enough for the last digit shown") {
  figure::Series broken = wave(201);
  broken.label = "l₂";
  broken.y[100] = gap;
  const json data = json::parse(series_data(figure_of({against_time({wave(201), broken})})));
  REQUIRE(data["x"].size() == 1);
  const json& panel = data["panels"][0];
  CHECK(panel["time"] == true);
  CHECK(panel["unit"] == "mm");
  CHECK(panel["series"][1]["label"] == "l₂");
  const std::vector<double> x = times(data["x"][0]), first = values(panel, panel["series"][0]), second = values(panel, panel["series"][1]);
  REQUIRE(x.size() == 201);
  REQUIRE(first.size() == 201);
  for (std::size_t i = 0; i < x.size(); ++i) {
    CHECK(x[i] == Approx(wave(201).x[i]).margin(1e-9));
    CHECK(std::abs(first[i] - wave(201).y[i]) < 210.0 / 20000);  // half a step of an axis that is a little longer than 200 mm
    CHECK(std::isnan(second[i]) == (i == 100));
  }
  CHECK(second[150] == first[150]);
}

TEST_CASE("a long curve is data of some hundred samples that run within a pen's width of all") {
  const figure::Series all = wave(20001, 0.2);
  const json data = json::parse(series_data(figure_of({against_time({all})})));
  const json& panel = data["panels"][0];
  const std::vector<double> x = times(data["x"][0]), y = values(panel, panel["series"][0]);
  CHECK(x.size() <= 401);
  REQUIRE(x.size() == y.size());
  for (std::size_t i = 0; i < all.x.size(); i += 97) CHECK(std::abs(between(x, y, all.x[i]) - all.y[i]) < 200 * 1.1 / 100);
}

TEST_CASE("what a user called a curve cannot end the data of its figure") {
  figure::Series evil = wave(3);
  evil.label = "</script><script>alert(1)</script>\xff";
  const std::string data = series_data(figure_of({against_time({evil})}));
  CHECK_FALSE(contains(data, "<"));
  CHECK(contains(json::parse(data)["panels"][0]["series"][0]["label"].get<std::string>(), "</script><script>alert(1)"));
}

TEST_CASE("a figure without curves has no data for the script") { CHECK(series_data(figure_of({against_time({})})).empty()); }

TEST_CASE("a value beyond all drawing is a gap of the data, and constant curves have a step") {
  const json data = json::parse(
      series_data(figure_of({against_time({{"l₁", {0, 1, 2, 3}, {1, 1e300, -HUGE_VAL, 1}}}), against_time({{"c", {0, 1}, {5, 5}}})})));
  const json& panel = data["panels"][1];
  CHECK(values(panel, panel["series"][0])[1] == Approx(5).epsilon(1e-4));
  CHECK(data["panels"][0]["series"][0]["y"].size() == 4);
  CHECK(data["panels"][0]["series"][0]["y"][2].is_null());
}

TEST_CASE("curves of panels that are alike are called as in the one legend") {
  figure::Series load{"load", {0, 1}, {1, 2}, 3}, again{"", {0, 1}, {3, 4}, 3}, other{"", {0, 1}, {3, 4}, 4};
  const figure::Figure f = figure_of({against_time({load}), against_time({again, other})});
  CHECK(curve_name(f, 1, 0) == "load");
  CHECK(curve_name(f, 1, 1).empty());
  CHECK(contains(series_data(f), "\"label\":\"load\""));
  CHECK(words_of(f)[1].lines ==
        std::vector<std::string>{"load: from 3 mm (at 0 s) to 4 mm (at 1 s)", "curve 2: from 3 mm (at 0 s) to 4 mm (at 1 s)"});
}

TEST_CASE("a figure is told in words with the ranges of its curves, its shadings and its limits") {
  figure::Panel panel = against_time({{"l₁", {0, 1, 2}, {812.44, -7.5, 900}}, {"l₂", {0, 1, 2}, {1, gap, 1}}, {"l₃", {0, 1}, {gap, gap}}});
  panel.bands = {{0.5, 0.7, figure::Band::Kind::limit}, {1, 1.5, figure::Band::Kind::limit}};
  panel.lines = {{950, "stroke ends"}};
  const auto words = words_of(figure_of({panel, panel}));
  REQUIRE(words.size() == 2);
  CHECK(words[0].heading == "(a) limb lengths: limb length [mm] against time [s], from 0 to 2");
  CHECK(words[1].heading.starts_with("(b) "));
  CHECK(words[0].lines == std::vector<std::string>{"l₁: from −7.5 mm (at 1 s) to 900 mm (at 2 s)", "l₂: 1 mm throughout, with gaps",
                                                   "l₃: no data", "shaded, limit broken: 2 stretches between 0.5 s and 1.5 s",
                                                   "stroke ends: at 950 mm"});
}

TEST_CASE("maps, classes, rows and dots are told in words too") {
  figure::Panel map = against_time({});
  map.map = figure::ColourMap{{0, 1}, {0, 1}, {-1, 2, gap, 0.5}, {"det G", ""}, "det G = 0"};
  CHECK(words_of(figure_of({map}))[0].lines ==
        std::vector<std::string>{"colours: det G from −1 to 2", "a contour where det G = 0", "out of reach: 25 % of the map"});
  map.map->scale = figure::ColourMap::Scale::classes;
  map.map->classes = {"free", "near a limit"};
  map.map->values = {0, 0, 1, gap};
  CHECK(words_of(figure_of({map}))[0].lines ==
        std::vector<std::string>{"free: 50 % of the map", "near a limit: 25 % of the map", "out of reach: 25 % of the map"});
  figure::Panel rows = against_time({{"held", {0, 1, 2}, {1, 1, 0}}});
  rows.y.names = {"stroke", "angle"};
  CHECK(words_of(figure_of({rows}))[0].lines == std::vector<std::string>{"held: stroke: at 2 s; angle: between 0 s and 1 s"});
  figure::Series dots{"found", {0, 1}, {3, 4}};
  dots.points = true;
  CHECK(words_of(figure_of({against_time({dots})}))[0].lines ==
        std::vector<std::string>{"found: 2 points, from 3 mm (at 0 s) to 4 mm (at 1 s)"});
}

TEST_CASE("a figure of the page has a short name and its words") {
  const std::string html = to_html(sample::report());
  CHECK(count(html, "<details class=\"words-of-figure\">") == 2);
  CHECK(count(html, "role=\"img\" aria-label=\"Plot of ") == 2);
  CHECK(count(html, "role=\"img\"") == 2);  // once a figure, not on the drawing again
  CHECK(html.find("<script type=\"application/json\">") < html.find("<figcaption>"));
}

TEST_CASE("a drawing inside the page leaves its role and title to what stands around it") {
  CHECK(inline_svg("<svg width=\"1\" role=\"img\">\n<title>a &lt;b></title>\n<path d=\"M 0 0\"/></svg>") ==
        "<svg width=\"1\">\n<path d=\"M 0 0\"/></svg>");
}

TEST_CASE("an empty heading of a table is a cell") {
  Report r = sample::report();
  auto& table = std::get<Table>(r.sections[0].blocks[2]);
  table.headings[0] = "";
  table.rows[0][0] = "";
  const std::string html = to_html(r);
  CHECK_FALSE(contains(html, "<th scope=\"col\" class=\"words\"></th>"));
  CHECK_FALSE(contains(html, "<th scope=\"row\" class=\"words\"></th>"));
  CHECK(count(html, "<td class=\"words\"></td>") == 2);
}
