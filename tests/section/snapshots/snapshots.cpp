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
  const auto r = of_gantry(
      "[[section]]\nkind = \"snapshots\"\ntimes = [\"0 s\", \"0.5 s\"]\nviews = [\"isometric\", \"front\"]\noverlay = 0\n" + small);
  const auto pictures = pictures_of(section_of(r, "snapshots"));
  REQUIRE(pictures.size() == 4);
  const char* captions[] = {"Snapshot 1: t = 0 s, isometric view", "Snapshot 2: t = 0 s, front view",
                            "Snapshot 3: t = 0.5 s, isometric view", "Snapshot 4: t = 0.5 s, front view"};
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
  const auto r =
      of_gantry("[[section]]\nkind = \"snapshots\"\ntimes = [\"0 s\", \"1 s\"]\nviews = [\"front\"]\npath = false\noverlay = 0\n" + small);
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
  CHECK_THAT(pictures_of(r.sections[1]).at(0).caption, Catch::StartsWith("Snapshot 2.1: t = 0 s"));
  // One picture of the whole motion is enough.
  CHECK(pictures_of(r.sections[0]).at(1).id == "motion");
  CHECK(pictures_of(r.sections[1]).size() == 1);
}

TEST_CASE("a time at which the mechanism cannot be assembled has a sentence in place of a picture") {
  const auto r = of_stage(", dependent = \"phi\"", "x = \"0 mm\"\ny = \"150 mm * t / 1 s\"\n",
                          "[[section]]\nkind = \"snapshots\"\ntimes = [\"1 s\", \"1.8 s\"]\nviews = [\"front\"]\n" + small);
  const document::Section& s = section_of(r, "snapshots");
  const auto pictures = pictures_of(s);
  REQUIRE(pictures.size() == 2);
  CHECK_THAT(pictures[0].caption, Catch::StartsWith("Snapshot 1: t = 1 s"));
  CHECK_THAT(pictures[1].caption, Catch::StartsWith("The motion, front view: poses at t = 0 s,") && !Contains("1.8 s"));
  CHECK_THAT(report_words::text_of(s),
             Contains("t = 1.8 s: no picture, the mechanism cannot be assembled: ") && Contains("the feeler is too short"));
}

TEST_CASE("the poses of a motion are laid over one another, as many as are asked for, with the times in the caption") {
  const auto caption = [](const std::string& key) {
    const auto r = of_gantry("[[section]]\nkind = \"snapshots\"\nviews = [\"front\"]\n" + key + small);
    const auto pictures = pictures_of(section_of(r, "snapshots"));
    return pictures.size() == 2 ? pictures[1].caption : "";
  };
  // x = 50 mm sin(pi t / s) returns at 1 s and 2 s: the ends of its way lie at 0.5 s and 1.5 s.
  CHECK(caption("overlay = 3\n") ==
        "The motion, front view: poses at t = 0 s, 0.5 s and 1.5 s, the first, to which it returns, solid; the path of the "
        "platform with times along it.");
  CHECK_THAT(caption("overlay = 5\n"), Catch::StartsWith("The motion, front view: poses at t = 0 s, "));
  CHECK(caption("") == caption("overlay = 5\n"));
  CHECK(caption("overlay = 0\n").empty());
}

TEST_CASE("times along a path that have no room are told to be left out") {
  const auto caption = [](const std::string& view, const std::string& more = "") {
    const auto r = of_gantry("[[section]]\nkind = \"snapshots\"\noverlay = 2\nviews = [\"" + view + "\"]\n" + more + small);
    return pictures_of(section_of(r, "snapshots")).at(1).caption;
  };
  // Seen along its way all dots are one.
  CHECK_THAT(caption("side"),
             Catch::Matches(".*with times along it, but for (1 dot that has|[2-9] dots that have) no room for (it|them)\\."));
  CHECK_THAT(caption("side", "labels = false\n"), Catch::EndsWith(" solid."));
}

TEST_CASE("loads are told with their size, and to which scale they are drawn") {
  const auto gallery = [](const std::string& load) {
    const auto r = of_gantry(load + "[[section]]\nkind = \"snapshots\"\nviews = [\"front\"]\noverlay = 0\n" + small);
    return report_words::blocks<document::Gallery>(section_of(r, "snapshots")).at(0).caption;
  };
  CHECK_THAT(gallery("[load]\nforce = [\"0 N\", \"0 N\", \"-40 N * t / 1 s\"]\n"),
             Contains("Forces are drawn to one scale: 80 N is an arrow"));
  CHECK_THAT(gallery(""), !Contains("Forces"));
}

TEST_CASE("a view that nobody names is chosen, and every caption says which it is") {
  const auto r = of_gantry("[[section]]\nkind = \"snapshots\"\ntimes = [\"0 s\", \"0.5 s\"]\noverlay = 0\n" + small);
  const auto pictures = pictures_of(section_of(r, "snapshots"));
  REQUIRE(pictures.size() == 2);
  const auto view = [](const std::string& caption) { return caption.substr(caption.rfind("s, ") + 3); };
  const std::string chosen = view(pictures[0].caption);
  CHECK((chosen == "isometric view" || chosen.starts_with("view from azimuth ")));
  CHECK(view(pictures[1].caption) == chosen);
}
