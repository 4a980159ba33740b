// Section `snapshots`: a picture for each time and view, all in one frame, and none of what cannot be assembled.
#include <catch2/catch.hpp>

#include <tests/section/report_words.hpp>
#include <tests/section/whole_report.hpp>

using namespace pmreport;
using namespace whole_report;
using Catch::Contains;

namespace {

const std::string small = "size = [80, 64]\n";

std::vector<document::Picture> pictures_of(const document::Section& s) {
  std::vector<document::Picture> out;
  for (const auto* g : report_words::pointers<document::Gallery>(s)) out.insert(out.end(), g->pictures.begin(), g->pictures.end());
  return out;
}

// Width and height in the header of a PNG, eight bytes of signature and eight of the first chunk's head before them.
int number_at(const std::string& png, std::size_t at) {
  int out = 0;
  for (std::size_t i = 0; i < 4; ++i) out = out * 256 + static_cast<unsigned char>(png.at(at + i));
  return out;
}

}  // namespace

TEST_CASE("there is a picture of every time in every view, of the size asked for") {
  const auto r = of_gantry("[[section]]\nkind = \"snapshots\"\ntimes = [\"0 s\", \"0.5 s\"]\nviews = [\"isometric\", \"front\"]\n" + small);
  const auto pictures = pictures_of(section_of(r, "snapshots"));
  REQUIRE(pictures.size() == 4);
  const char* captions[] = {"t = 0 s, isometric view", "t = 0 s, front view", "t = 0.5 s, isometric view", "t = 0.5 s, front view"};
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(pictures[i].caption == captions[i]);
    CHECK(pictures[i].id == "snapshot-" + std::to_string(i + 1));
    REQUIRE(pictures[i].png.size() > 24);
    CHECK(pictures[i].png.starts_with("\x89PNG"));
    CHECK(number_at(pictures[i].png, 16) == 80);
    CHECK(number_at(pictures[i].png, 20) == 64);
  }
  CHECK(pictures[1].png != pictures[3].png);  // the gantry has moved
}

TEST_CASE("pictures of one pose in one view are the same: the camera is framed over the whole motion") {
  const auto r = of_gantry("[[section]]\nkind = \"snapshots\"\ntimes = [\"0 s\", \"1 s\"]\nviews = [\"front\"]\npath = false\n" + small);
  const auto pictures = pictures_of(section_of(r, "snapshots"));
  REQUIRE(pictures.size() == 2);
  // x is zero at both times, to the last digits of the sine.
  CHECK(pictures[0].png == pictures[1].png);
}

TEST_CASE("a second section of snapshots numbers itself and its pictures") {
  const std::string one = "[[section]]\nkind = \"snapshots\"\ntimes = [\"0 s\"]\nviews = [\"front\"]\n" + small;
  const auto r = of_gantry(one + one);
  CHECK(ids(r) == std::vector<std::string>{"snapshots", "snapshots2", "every-instant"});
  CHECK(pictures_of(r.sections[0]).at(0).id == "snapshot-1");
  CHECK(pictures_of(r.sections[1]).at(0).id == "snapshot2-1");
}

TEST_CASE("a time at which the mechanism cannot be assembled has a sentence in place of a picture") {
  const auto r = of_stage(", dependent = \"phi\"", "x = \"0 mm\"\ny = \"150 mm * t / 1 s\"\n",
                          "[[section]]\nkind = \"snapshots\"\ntimes = [\"1 s\", \"1.8 s\"]\nviews = [\"front\"]\n" + small);
  const document::Section& s = section_of(r, "snapshots");
  CHECK(pictures_of(s).size() == 1);
  CHECK_THAT(report_words::text_of(s),
             Contains("t = 1.8 s: no picture, the mechanism cannot be assembled: ") && Contains("the feeler is too short"));
}
