#include <unistd.h>
#include <reports/figure/draw.hpp>

#include <array>
#include <catch2/catch.hpp>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <locale>
#include <memory>
#include <optional>
#include <set>
#include <sstream>

#include <tests/figure/samples.hpp>
#include "reports/figure/surface.hpp"

using namespace pmreport::figure;
using samples::curve;
namespace fs = std::filesystem;

namespace {

class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (fs::temp_directory_path() / "pmreport-figure-XXXXXX").string();
    REQUIRE(mkdtemp(pattern.data()) != nullptr);
    path_ = pattern;
  }
  ~TemporaryFolder() { fs::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  fs::path write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path_ / name, std::ios::binary) << bytes;
    return path_ / name;
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

bool has(const std::string& program) { return std::system(("command -v " + program + " >/dev/null").c_str()) == 0; }

std::string output_of(const std::string& command) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe{popen(command.c_str(), "r"), pclose};
  std::string text;
  std::array<char, 4096> part;
  for (std::size_t n; (n = std::fread(part.data(), 1, part.size(), pipe.get())) > 0;) text.append(part.data(), n);
  return text;
}

// Every id, and every id that is referred to.
std::pair<std::set<std::string>, std::set<std::string>> ids_of(const std::string& svg) {
  std::set<std::string> defined, used;
  const auto collect = [&](const std::string& before, char after, std::set<std::string>& into) {
    for (std::size_t at = svg.find(before); at != std::string::npos; at = svg.find(before, at + 1)) {
      const std::size_t begin = at + before.size();
      into.insert(svg.substr(begin, svg.find(after, begin) - begin));
    }
  };
  collect(" id=\"", '"', defined);
  collect("xlink:href=\"#", '"', used);
  collect("url(#", ')', used);
  return {defined, used};
}

Figure extremes() {
  const auto wild = [](double t) { return t < 2 ? samples::gap : t < 4 ? 1e300 : t < 6 ? -samples::infinite : t < 8 ? 1e12 : -1e308; };
  std::vector<Panel> panels{samples::panel({curve("wild", 100, 10, wild)}),
                            samples::panel({curve("wild", 1000, 10, [=](double t) { return t < 9.9 ? std::sin(t) : wild(t - 5); })}),
                            samples::panel({curve("none", 100, 10, [](double) { return samples::gap; })}),
                            samples::panel({}),
                            samples::panel({{"one", {1}, {1}, 0}}),
                            samples::panel({{"x", {samples::gap, 1e300, -1e300, samples::infinite}, {1, 2, 3, 4}, 250}}),
                            samples::panel({curve("denormal", 100, 10, [](double t) { return 1e-310 * t; })})};
  panels[3].bands = {{samples::gap, 1, Band::Kind::limit}, {-1e300, 1e300, Band::Kind::unreachable}};
  panels[3].lines = {{samples::gap, "never"}, {1e300, "far"}};
  panels[4].title = "<script>alert(\"1\")</script> & \x01\xff 机构";
  return samples::figure(std::move(panels));
}

// Sets the environment of this process for as long as it lives.
class Environment {
 public:
  Environment(const char* zone, const std::optional<std::string>& locale) {
    setenv("TZ", zone, 1);
    tzset();
    if (locale) std::setlocale(LC_ALL, locale->c_str());
  }
  ~Environment() {
    unsetenv("TZ");
    tzset();
    std::setlocale(LC_ALL, "C");
  }
};

// The pen-downs of the one curve of a figure without a legend: subpaths of the only path as wide as a curve.
int strokes_of_curve(const std::string& svg) {
  const std::size_t path = svg.find("stroke-width:1.1;");
  if (path == std::string::npos) return 0;
  const std::size_t begin = svg.find(" d=\"", path) + 4, end = svg.find('"', begin);
  int strokes = 0;
  for (std::size_t i = begin; i < end; ++i) strokes += svg[i] == 'M';
  return strokes;
}

}  // namespace

TEST_CASE("a PDF is sound and its fonts are embedded") {
  const TemporaryFolder folder;
  const std::string pdf = to_pdf(samples::six_panels());
  CHECK(pdf.starts_with("%PDF-"));
  const std::string path = folder.write("figure.pdf", pdf).string();
  if (has("qpdf")) CHECK(std::system(("qpdf --check " + path + " >/dev/null 2>&1").c_str()) == 0);
  if (has("pdfinfo"))
    CHECK(output_of("TZ=UTC pdfinfo -isodates " + path).find("CreationDate:    2000-01-01T00:00:00") != std::string::npos);
  if (has("pdffonts")) {
    std::istringstream lines(output_of("pdffonts " + path));
    std::string line;
    std::getline(lines, line);
    std::getline(lines, line);
    int fonts = 0;
    while (std::getline(lines, line)) {
      CAPTURE(line);
      CHECK(line.find("+DejaVuSans") != std::string::npos);  // a subset
      CHECK(line.find("yes yes yes") != std::string::npos);  // embedded, subset, with Unicode for those who copy and search
      ++fonts;
    }
    CHECK(fonts >= 2);  // regular and bold
  }
}

TEST_CASE("the words of a PDF can be searched") {
  if (!has("pdftotext")) return;
  const TemporaryFolder folder;
  Panel one = samples::panel(
      {curve("l₁", 50, 10, [](double t) { return 30 * std::sin(t); }), curve("θ̇", 50, 10, [](double t) { return -10 * t; })});
  const std::string words = output_of("pdftotext " + folder.write("figure.pdf", to_pdf(samples::figure({one}))).string() + " -");
  CAPTURE(words);
  for (const char* word : {"limb lengths", "time [s]", "limb length [mm]", "l₁", "−50", "10"}) {
    CAPTURE(word);
    CHECK(words.find(word) != std::string::npos);
  }
}

TEST_CASE("the same figure gives the same bytes, wherever and whenever it is drawn") {
  const Figure figure = samples::six_panels();
  const std::string pdf = to_pdf(figure), svg = to_svg(figure);
  CHECK(to_pdf(figure) == pdf);
  CHECK(to_svg(figure) == svg);
  const TemporaryFolder folder;
  // A locale with a decimal comma; made here when the system has none installed.
  const std::string german = (folder.path() / "de_DE.UTF-8").string();
  const bool made = std::system(("localedef -i de_DE -f UTF-8 " + german + " >/dev/null 2>&1").c_str()) == 0;
  if (made) setenv("LOCPATH", folder.path().c_str(), 1);
  for (const char* zone : {"UTC", "Asia/Kolkata", "America/St_Johns"}) {
    const Environment environment(zone, "de_DE.UTF-8");
    CAPTURE(zone, std::localeconv()->decimal_point);
    CHECK(to_pdf(figure) == pdf);
    CHECK(to_svg(figure) == svg);
  }
  unsetenv("LOCPATH");
}

TEST_CASE("an SVG stands in an HTML page beside others") {
  Figure figure = samples::six_panels();
  const std::string svg = to_svg(figure);
  CHECK(svg.starts_with("<svg "));
  CHECK(svg.find("<?xml") == std::string::npos);
  const std::string root = svg.substr(0, svg.find('>'));
  CHECK(root.find("role=\"img\"") != std::string::npos);
  CHECK(root.find("viewBox=\"0 0 493.23 ") != std::string::npos);
  CHECK(root.find("width=\"493.23pt\"") != std::string::npos);
  CHECK(svg.find("<title>limb lengths, ") != std::string::npos);
  CHECK(svg.find("<text") > svg.find("<g class=\"text\" fill=\"#000\" fill-opacity=\"0\""));  // outlines are what is seen

  figure.id = "velocity of limb \"3\"";
  const auto [defined, used] = ids_of(svg);
  const auto [other_defined, other_used] = ids_of(to_svg(figure));
  REQUIRE(!used.empty());
  for (const std::string& id : used) CHECK(defined.count(id) == 1);
  for (const std::string& id : other_used) CHECK(other_defined.count(id) == 1);
  for (const std::string& id : other_defined) CHECK(defined.count(id) == 0);
}

TEST_CASE("gaps are lifted pens in the file") {
  const auto gappy = [](double t) { return (t > 2 && t < 3) || (t > 7 && t < 8) ? samples::gap : std::sin(t); };
  CHECK(strokes_of_curve(to_svg(samples::figure({samples::panel({curve("", 400, 10, gappy)})}))) == 3);
  CHECK(strokes_of_curve(to_svg(samples::figure({samples::panel({curve("", 400, 10, [](double t) { return std::sin(t); })})}))) == 1);
}

TEST_CASE("wild data and wild words give sound files") {
  const TemporaryFolder folder;
  for (const Figure& figure : {extremes(), samples::figure({})}) {
    const std::string svg = to_svg(figure), pdf = to_pdf(figure);
    for (const char* word : {"nan", "NaN", "inf", "<script"}) {
      CAPTURE(word);
      CHECK(svg.find(word) == std::string::npos);
    }
    if (has("qpdf")) CHECK(std::system(("qpdf --check " + folder.write("f.pdf", pdf).string() + " >/dev/null 2>&1").c_str()) == 0);
    if (has("xmllint")) CHECK(std::system(("xmllint --noout " + folder.write("f.svg", svg).string() + " 2>&1").c_str()) == 0);
  }
}

TEST_CASE("no coordinate of an SVG lies off the page") {
  const Figure figure = extremes();
  const Size size = size_of(figure);
  const std::string svg = to_svg(figure);
  int checked = 0;
  // Absolute path commands carry pairs; those of glyphs are small and pass as well, matrices hold for panels inside the page.
  for (std::size_t at = svg.find(" d=\""); at != std::string::npos; at = svg.find(" d=\"", at + 1)) {
    const std::size_t begin = at + 4, end = svg.find('"', begin);
    std::istringstream words(svg.substr(begin, end - begin));
    words.imbue(std::locale::classic());
    for (std::string word; words >> word;) {
      if (std::isalpha(static_cast<unsigned char>(word[0])) != 0) continue;
      const double value = std::stod(word);
      ++checked;
      if (std::abs(value) > std::max(size.width, size.height)) FAIL("coordinate " << word);
    }
  }
  CHECK(checked > 1000);
}

TEST_CASE("twenty thousand samples make no huge file") {
  const Figure figure = samples::figure({samples::panel({curve("noise", 20000, 10, [](double t) { return std::sin(1e5 * t * t); })})});
  CHECK(to_pdf(figure).size() < 60000);
  CHECK(to_svg(figure).size() < 150000);
}
