// The machine in 3D in report.html: its model stands in the page, once, packed, and no larger than is sensible.
#include <zlib.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <random>
#include <reports/document/html/html_view.hpp>
#include <reports/document/write.hpp>

#include <tests/document/sample.hpp>

using namespace pmreport;
using namespace pmreport::document;
using sample::contains;
using sample::count;

namespace {

Report report_with(std::string model) {
  Report r = sample::report();
  r.files = {{"data/other.stl", "something else", "solid"}, {"data/model.glb", "the machine", std::move(model)}};
  return r;
}

// As RFC 4648 has it, six bits a character.
std::string decoded(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  unsigned bits = 0, held = 0;
  for (const char c : text) {
    if (c == '=') break;
    const std::size_t digit = digits.find(c);
    REQUIRE(digit != std::string::npos);
    held = held << 6 | static_cast<unsigned>(digit), bits += 6;
    if (bits >= 8) bits -= 8, out += static_cast<char>(held >> bits & 0xff);
  }
  return out;
}

std::string unpacked(std::string packed, std::size_t size) {
  std::string out(size, '\0');
  z_stream stream{};
  constexpr int window = 15, gzip_alone = 16;
  REQUIRE(inflateInit2(&stream, window + gzip_alone) == Z_OK);
  stream.next_in = reinterpret_cast<Bytef*>(packed.data()), stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data()), stream.avail_out = static_cast<uInt>(out.size());
  CHECK(inflate(&stream, Z_FINISH) == Z_STREAM_END);
  CHECK(stream.avail_out == 0);
  CHECK(stream.avail_in == 0);
  inflateEnd(&stream);
  return out;
}

std::string noise(std::size_t size) {
  std::mt19937 random(7);
  std::string out(size, '\0');
  for (char& c : out) c = static_cast<char>(random());
  return out;
}

constexpr const char* opening = "<script type=\"model/gltf-binary\" id=\"machine-model\" data-coding=\"gzip, base64\">";

}  // namespace

TEST_CASE("the model stands in the page once, and is unpacked to the bytes of its file") {
  const std::string model = "glTF </script> & what else may come" + noise(5000) + std::string(20000, '\0');
  const std::string html = to_html(report_with(model));
  REQUIRE(count(html, opening) == 1);
  CHECK(count(html, " id=\"machine-model\"") == 1);
  const std::size_t from = html.find(opening) + std::string(opening).size(), end = html.find("</script>", from);
  const std::string text = html.substr(from, end - from);
  CHECK(text.size() < 9000);  // 20000 zeros are next to nothing
  CHECK(unpacked(decoded(text), model.size()) == model);
}

TEST_CASE("the view is hidden until the script shows it, and stands below the first page") {
  const std::string html = to_html(report_with("glTF"));
  CHECK(contains(html, "<section id=\"machine-view\" aria-labelledby=\"machine-view-title\" hidden>"));
  CHECK(html.find("id=\"machine-view\"") > html.find("id=\"summary\""));
  CHECK(html.find("id=\"machine-view\"") < html.find("id=\"checks\""));
  CHECK(contains(html_view_style, "@media print { #machine-view"));
  CHECK(count(html, "style=\"") == 0);
}

TEST_CASE("a report without a model has no view, nor has one with a model that is too large for a page") {
  CHECK(model_in_page(sample::report()).empty());
  CHECK_FALSE(contains(to_html(sample::report()), "id=\"machine-view\""));
  CHECK_FALSE(model_in_page(report_with(noise(440'000))).empty());
  CHECK(model_in_page(report_with(noise(460'000))).empty());  // base64 makes four bytes of three
  CHECK_FALSE(contains(to_html(report_with(noise(460'000))), "id=\"machine-view\""));
}

TEST_CASE("two pages with the same model are the same to the byte") {
  const Report r = report_with(noise(5000));
  CHECK(to_html(r) == to_html(r));
  CHECK(decoded(model_in_page(r)).substr(4, 4) == std::string(4, '\0'));  // gzip's time of making
}

TEST_CASE("the functions of the view pass their own tests") {
  if (std::system("command -v node >/dev/null") != 0) {
    WARN("node is not here: the 3D view of report.html was not tested");
    return;
  }
  CHECK(std::system("node --test " SOURCE "/tests/document/html/view_test.js") == 0);
}
