// Section `transmission` on a table in two legs (tests/given/two_legs.hpp) that stand 300 mm apart: with leg 2 held the table goes
// round its foot, so that leg 1 transmits the sine of the angle between the legs, and leg 2 likewise.
#include <catch2/catch.hpp>

#include <tests/given/only.hpp>
#include <tests/given/two_legs.hpp>
#include <tests/section/report_words.hpp>
#include <tests/section/whole_report.hpp>

#include <cmath>

using namespace pmreport;
using namespace whole_report;
using Catch::Contains;
using report_words::text_of, report_words::value;

namespace {

constexpr double apart = 0.3;  // [m]

double sine(double x, double y) {
  const double ax = apart - x, ay = -y;
  return std::abs(x * ay - y * ax) / (std::hypot(x, y) * std::hypot(ax, ay));
}

document::Report run(const std::string& motion, const std::string& section) {
  return report_of("title = \"Two legs\"\n[mechanism]\nuse = \"two-legs\"\n" +
                       (motion.empty() ? motion : "[motion]\nduration = \"1 s\"\nsamples = 11\n" + motion) +
                       "[[section]]\nkind = \"transmission\"\n" + section,
                   test::only(test::two_legs()));
}

const figure::Figure& figure_of(const document::Report& r, const std::string& id) {
  for (const auto* f : report_words::pointers<figure::Figure>(section_of(r, "transmission")))
    if (f->id == id) return *f;
  throw std::out_of_range("no figure " + id);
}

}  // namespace

TEST_CASE("along a motion the section tells the worst of each drive, when it is, and how long it is below 0.7") {
  // Between the feet at height y: 0.5 m down to 0.1 m. High up the legs are nearly parallel.
  const auto r = run("x = \"150 mm\"\ny = \"500 mm - 400 mm * t / 1 s\"\n", "");
  const auto& local = column_of(r, "transmission", "local_transmission");
  const auto& pressure = column_of(r, "transmission", "l1_pressure [rad]");
  REQUIRE(local.size() == 11);
  int below = 0;
  for (std::size_t k = 0; k < 11; ++k) {
    const double expected = sine(0.15, 0.5 - 0.04 * static_cast<double>(k));
    CHECK(local[k] == Approx(expected).epsilon(1e-12));
    CHECK(pressure[k] == Approx(std::acos(expected)).epsilon(1e-10));
    below += expected < 0.7 ? 1 : 0;
  }
  const document::Section& s = section_of(r, "transmission");
  CHECK_THAT(text_of(s), Contains("The local transmission index is ") && Contains("at t = 0 s") &&
                             Contains("below 0.7 at " + std::to_string(below) + " of 11 samples"));
  CHECK(value(r, "least_local") == Approx(sine(0.15, 0.5)).epsilon(1e-12));
  CHECK(value(r, "least_output") == Approx(sine(0.15, 0.5)).epsilon(1e-12));
  CHECK(value(r, "least_cosine") == Approx(sine(0.15, 0.5)).epsilon(1e-12));
  CHECK(value(r, "least_input") == Approx(1).epsilon(1e-12));
  const std::vector<std::string> leg = report_words::row_of(s, "The worst of the motion", "l₁");
  CHECK(leg[2] == "0 s");
  report_words::check_proofs(s, 4);
}

TEST_CASE("figures along the motion have the line of 0.7, and a drive that only ever pushes along itself needs none of its input") {
  const auto r = run("x = \"150 mm\"\ny = \"500 mm - 400 mm * t / 1 s\"\n", "");
  const document::Section& s = section_of(r, "transmission");
  const auto panels = panels_of(s);
  CHECK(std::ranges::find(panels, "input transmission") == panels.end());
  const figure::Panel& output = panel_of(s, "output transmission");
  REQUIRE(output.lines.size() == 1);
  CHECK(output.lines[0].y == 0.7);
  const figure::Panel& pressure = panel_of(s, "pressure angles");
  REQUIRE(pressure.lines.size() == 1);
  CHECK(std::cos(pressure.lines[0].y * std::numbers::pi / 180) == Approx(0.7));
}

TEST_CASE("a motion through a singular surface has an index of zero there, and the evidence tells it") {
  // Across the line through both feet, beyond foot 1.
  const auto r = run("x = \"-100 mm\"\ny = \"200 mm * (0.43 - t / 1 s)\"\n", "");
  const document::Section& s = section_of(r, "transmission");
  report_words::check_proofs(s, 4);
  bool judged = false;
  for (const auto* p : report_words::pointers<document::Proof>(s))
    for (const document::Evidence& e : p->lines)
      if (e.claim.find("vanish") != std::string::npos) judged = e.verdict() == document::Verdict::passed && e.value < 1e-9;
  CHECK(judged);
}

TEST_CASE("a map shows the indices that were asked for, with the line of 0.7, and tells least, most and mean") {
  const auto r = run("",
                     "map = { x = [\"50 mm\", \"250 mm\"], y = [\"100 mm\", \"500 mm\"], points = 11, show = [\"l2_output\", "
                     "\"l1_pressure\", \"local_conditioning\"] }\n");
  const figure::Figure& f = figure_of(r, "transmission-map");
  REQUIRE(f.panels.size() == 3);
  REQUIRE(f.panels[0].map);
  CHECK(f.panels[0].map->contour == "0.7");
  CHECK(f.panels[0].map->level == 0.7);
  CHECK(f.panels[1].map->level == Approx(std::acos(0.7) * 180 / std::numbers::pi));
  CHECK(f.panels[1].map->bar.unit == "°");
  CHECK(f.panels[2].map->contour.empty());
  double least = 1, most = 0, sum = 0;
  const auto &x = column_of(r, "transmission-map", "x [m]"), &y = column_of(r, "transmission-map", "y [m]"),
             &output = column_of(r, "transmission-map", "l2_output"), &angle = column_of(r, "transmission-map", "l1_pressure [rad]");
  REQUIRE(output.size() == 121);
  for (std::size_t k = 0; k < 121; ++k) {
    const double expected = sine(x[k], y[k]);
    CHECK(output[k] == Approx(expected).epsilon(1e-11));
    CHECK(f.panels[0].map->values[k] == output[k]);
    CHECK(angle[k] == Approx(std::acos(expected)).epsilon(1e-9));
    least = std::min(least, expected), most = std::max(most, expected), sum += expected;
  }
  CHECK(value(r, "map_min_l2_output") == Approx(least).epsilon(1e-11));
  CHECK(value(r, "map_max_l2_output") == Approx(most).epsilon(1e-11));
  CHECK(value(r, "map_mean_l2_output") == Approx(sum / 121).epsilon(1e-11));
}

TEST_CASE("over a grid each pose that keeps the limits weighs alike") {
  // The legs' strokes end at 1 m; the grid goes beyond.
  const auto r = run("", "grid = { x = [\"3 mm\", \"1203 mm\", 13], y = [\"105 mm\", \"1105 mm\", 11] }\nlimits = [\"strokes\"]\n");
  double sum = 0, least = 1;
  int accepted = 0, good = 0;
  for (int i = 0; i < 13; ++i)
    for (int k = 0; k < 11; ++k) {
      const double x = 0.003 + 1.2 * i / 12, y = 0.105 + 1.0 * k / 10, l1 = std::hypot(x, y), l2 = std::hypot(x - apart, y);
      constexpr double beyond_rounding = 1e-9;
      REQUIRE(std::abs(l1 - 1) > beyond_rounding);
      REQUIRE(std::abs(l2 - 1) > beyond_rounding);
      if (l1 > 1 || l2 > 1) continue;
      ++accepted, sum += sine(x, y), least = std::min(least, sine(x, y)), good += sine(x, y) >= 0.7 ? 1 : 0;
    }
  CHECK(value(r, "poses") == 143);
  CHECK(value(r, "accepted") == accepted);
  CHECK(value(r, "mean_local_transmission") == Approx(sum / accepted).epsilon(1e-11));
  CHECK(value(r, "min_local_transmission") == Approx(least).epsilon(1e-11));
  CHECK(value(r, "good_share") == Approx(double(good) / accepted).epsilon(1e-12));
  CHECK_THAT(text_of(section_of(r, "transmission")), Contains("keep strokes"));
}

TEST_CASE("poses that were asked for are told with the leg that is worst, and one out of reach with a warning") {
  const auto r = run("", "poses = [{ x = \"100 mm\", y = \"250 mm\" }, { x = \"0 mm\", y = \"0 mm\" }]\n");
  CHECK(value(r, "local_transmission_1") == Approx(sine(0.1, 0.25)).epsilon(1e-11));
  CHECK_THAT(text_of(section_of(r, "transmission")), Contains("Pose 2") && Contains("cannot be assembled"));
  CHECK(std::isnan(value(r, "local_transmission_2")));
}

TEST_CASE("a length scales the conditioning alone") {
  const std::string pose = "poses = [{ x = \"100 mm\", y = \"250 mm\" }]\n";
  const auto one = run("", pose), other = run("", pose + "length = \"2 m\"\n");
  CHECK(value(one, "local_transmission_1") == value(other, "local_transmission_1"));
  CHECK_THAT(text_of(section_of(other, "transmission")), Contains("L = 2000 mm"));
}

TEST_CASE("the section says who defined what, and what the indices leave out") {
  const auto r = run("", "poses = [{ x = \"100 mm\", y = \"250 mm\" }]\n");
  const std::string text = text_of(section_of(r, "transmission"));
  for (const char* source :
       {"Chen and Angeles 2007", "Takeda and Funabashi 1995", "Wang, Wu, Liu 2010", "Liu, Chen, Xie 2014", "Brinker, Corves, Takeda"})
    CHECK_THAT(text, Contains(source));
}

TEST_CASE("a workspace may demand a local transmission index, judged pose by pose and said so") {
  const auto limited = [](const std::string& least) {
    return "title = \"Two legs\"\n[mechanism]\nuse = \"two-legs\"\n[[section]]\nkind = \"workspace\"\nmethod = \"grid\"\nlimits = "
           "[\"strokes\"]\n"
           "scan = { x = [\"3 mm\", \"303 mm\", 21], y = [\"105 mm\", \"505 mm\", 21] }\npictures = false\nsafe = false\n"
           "[[section.limit]]\nindex = \"transmission\"\nmin = \"" +
           least + "\"\n";
  };
  const auto r = report_of(limited("0.7"), test::only(test::two_legs()));
  int good = 0;
  for (int i = 0; i < 21; ++i)
    for (int k = 0; k < 21; ++k) good += sine(0.003 + 0.3 * i / 20, 0.105 + 0.4 * k / 20) >= 0.7 ? 1 : 0;
  CHECK(good > 50);
  CHECK(value(r, "accepted") == good);
  CHECK_THROWS_WITH(report_of(limited("1.2"), test::only(test::two_legs())), Contains("expected an index from 0 to 1"));
}

// The sine of the angle at which the feet are seen is at least k between the two circles through both feet on which it is k: of radius
// d / 2k, with centres at d / 2 sqrt(1 / k^2 - 1) above and below the middle (the angle at the circumference).
TEST_CASE("the workspace of good transmission is proved, and is the one between two circles") {
  constexpr double k = 0.7, half = apart / 2, radius = half / k, height = 0.15;
  const auto r = report_of(
      "title = \"Two legs\"\n[mechanism]\nuse = \"two-legs\"\n[[section]]\nkind = \"workspace\"\nlimits = [\"strokes\"]\n"
      "scan = { x = [\"0 mm\", \"300 mm\", 21], y = [\"150 mm\", \"505 mm\", 21] }\npictures = false\n"
      "[[section.limit]]\nindex = \"transmission\"\nmin = 0.7\n",
      test::only(test::two_legs()));
  double exact = 0;
  constexpr int columns = 100'000;
  for (int i = 0; i < columns; ++i) {
    const double x = apart * (i + 0.5) / columns - half, reach = radius * radius - x * x;
    const double middle = half * std::sqrt(1 / (k * k) - 1), upper = middle + std::sqrt(reach), lower = std::sqrt(reach) - middle;
    exact += std::max(0.0, upper - std::max(lower, height)) * apart / columns;
  }
  const double low = value(r, "volume_low"), high = value(r, "volume_high");
  CHECK(low <= exact + 1e-9);
  CHECK(exact - 1e-9 <= high);
  CHECK(high - low < 2e-3 * exact);
  CHECK_THAT(text_of(section_of(r, "workspace")), !Contains("No volume is proved"));
}

TEST_CASE("a check whose bound lies within what is proved of a volume says that the middle decides") {
  const auto checked = [](double bound) {
    return report_of(
        "title = \"Two legs\"\n[mechanism]\nuse = \"two-legs\"\n[[section]]\nkind = \"workspace\"\nlimits = [\"strokes\"]\n"
        "scan = { x = [\"0 mm\", \"300 mm\", 21], y = [\"150 mm\", \"505 mm\", 21] }\npictures = false\ngap = 0.05\n"
        "[[section.limit]]\nindex = \"transmission\"\nmin = 0.7\n[[check]]\nthat = \"workspace.volume\"\nabove = \"" +
            std::to_string(bound) + " m^2\"\n",
        test::only(test::two_legs()));
  };
  const auto first = checked(1e-3);
  const double low = value(first, "volume_low"), high = value(first, "volume_high");
  REQUIRE(high - low > 1e-4);
  CHECK(first.checks.front().passed);
  CHECK_THAT(first.checks.front().message, !Contains("middle"));
  const auto kept = checked(low + 0.25 * (high - low)), broken = checked(low + 0.75 * (high - low)), beyond = checked(high + 0.01);
  CHECK(kept.checks.front().passed);
  CHECK_THAT(kept.checks.front().message, Contains("it lies within ") && Contains("so their middle decides"));
  CHECK_FALSE(broken.checks.front().passed);
  CHECK_THAT(broken.checks.front().message, Contains("which is not above") && Contains("so their middle decides"));
  CHECK_FALSE(beyond.checks.front().passed);
  CHECK_THAT(beyond.checks.front().message, !Contains("middle"));
}
