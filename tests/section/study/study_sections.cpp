// What a study says of a table whose workspace is a rectangle: every number can be worked out by hand.
#include <catch2/catch.hpp>

#include <tests/scenario/trial.hpp>
#include <tests/section/study/cross_table.hpp>

#include <cmath>

using namespace pmreport;
using Catch::Contains;
using cross_table::counted;
using cross_table::Run;
using cross_table::text;

namespace {

bool none_fails(const Run& r) {
  return std::ranges::none_of(r.evidence(), [](const document::Evidence& e) { return e.failed(); });
}

}  // namespace

TEST_CASE("a sweep has a row a variant with its area, and one that cannot be made has the reason") {
  const Run r(text("measure = [\"workspace.volume\", \"workspace.x_high\"]\nsweep = { a = [\"100 mm\", \"600 mm\", 6] }\n"));
  const std::vector<double>&a = r.column("a [m]"), &area = r.column("volume [m^2]");
  REQUIRE(area.size() == 6);
  for (std::size_t k = 0; k < 6; ++k) {
    CHECK(a[k] == Approx(0.1 * static_cast<double>(k + 1)));
    if (k < 5)
      CHECK(area[k] == Approx(counted(a[k]) * counted(0.1)));
    else
      CHECK(std::isnan(area[k]));
  }
  CHECK(r.value("variants") == 6);
  CHECK(r.value("failed") == 1);
  CHECK(r.value("largest_volume") == Approx(counted(0.5) * counted(0.1)));
  CHECK(r.value("smallest_x_high") == Approx(0.1));
  CHECK(r.value("volume_2") == Approx(counted(0.2) * counted(0.1)));
  CHECK_THAT(r.words(), Contains("1 of 6 variants could not be made or judged: a and b together are longer than the frame (1).") &&
                            Contains("may go on beyond the range of x") && Contains("at a = 500 mm") && Contains("at a = 100 mm"));
  REQUIRE(r.figures().size() == 1);
  const figure::Figure f = r.figures()[0];
  REQUIRE(f.panels.size() == 2);
  REQUIRE(f.panels[0].bands.size() == 1);
  CHECK(f.panels[0].bands[0].from == Approx(550));
  CHECK(f.panels[0].bands[0].to == Approx(600));
  CHECK(f.panels[0].series.back().label == "this scenario");
}

TEST_CASE("a sweep over two parameters is a map, and refused corners are gaps in it") {
  const Run r(text("sweep = { a = [\"100 mm\", \"500 mm\", 5], b = [\"200 mm\", \"400 mm\", 3] }\n"));
  const std::vector<figure::Figure> figures = r.figures();
  REQUIRE(figures.size() == 1);
  const auto& map = figures[0].panels.at(0).map;
  REQUIRE(map.has_value());
  REQUIRE(map->x.size() == 5);
  for (std::size_t i = 0; i < 5; ++i) CHECK(map->x[i] == Approx(100 * static_cast<double>(i + 1)));
  REQUIRE(map->values.size() == 15);
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = 0; i < 5; ++i) {
      const double x = 0.1 * static_cast<double>(i + 1), y = 0.2 + 0.1 * static_cast<double>(j);
      if (x + y > 0.6 + 1e-9)
        CHECK(std::isnan(map->values[j * 5 + i]));
      else
        CHECK(map->values[j * 5 + i] == Approx(counted(x) * counted(y)));
    }
  CHECK(r.value("failed") == 6);
}

TEST_CASE("variants that have the same area are not told apart, and say so") {
  const Run r(text("sweep = { a = [\"101 mm\", \"104 mm\", 4] }\n"));
  CHECK_THAT(r.words(), Contains("The area of the workspace is") && Contains("throughout"));
}

TEST_CASE("machines stand side by side, of this mechanism and of other scenarios, each with its own workspace") {
  const trial::Folder folder;
  folder.write("wide.toml", text("sweep = { a = [\"100 mm\", \"200 mm\", 3] }\n"));
  const std::string own = text(
      "measure = [\"workspace.volume\", \"home.condition\"]\nvariants = [{ name = \"as it is\" }, { name = \"longer\", parameters = { a = "
      "\"200 "
      "mm\", look = \"lacquered\" } }, { name = \"geared\", scenario = \"wide.toml\", parameters = { ratio = 4 } }, { name = \"too long\", "
      "parameters = { a = \"600 mm\" } }]\n");
  const Run r(own, folder.write("a.toml", own));
  CHECK(r.value("volume_1") == Approx(counted(0.1) * counted(0.1)));
  CHECK(r.value("volume_2") == Approx(counted(0.2) * counted(0.1)));
  CHECK(r.value("volume_3") == Approx(counted(0.1) * counted(0.1)));
  CHECK(r.value("condition_3") / r.value("condition_1") == Approx(4));
  CHECK(r.value("failed") == 1);
  CHECK_THAT(r.words(), Contains("cross-table, a = 200 mm, look = lacquered") && Contains("(wide.toml)") && Contains("too long") &&
                            Contains("of longer") && Contains("a and b together are longer than the frame"));
  REQUIRE(r.figures().size() == 1);
  CHECK(r.figures()[0].panels.at(0).y.names == std::vector<std::string>{"too long", "geared", "longer", "as it is"});
}

TEST_CASE("the largest table within its frame is square, found on the rim of what can be made") {
  const Run r(
      text("optimise = { maximise = \"workspace.volume\", over = { a = [\"50 mm\", \"550 mm\"], b = [\"50 mm\", \"550 mm\"] }, "
           "evaluations = 200 }\n"));
  // A step less on one side and one more on the other loses a square of a step.
  CHECK(r.value("best_volume") >= counted(0.29) * counted(0.30) - 1e-12);
  CHECK(r.value("best_volume") <= counted(0.30) * counted(0.30) + 1e-12);
  CHECK(r.value("at_a") + r.value("at_b") <= cross_table::frame + 1e-12);
  CHECK(r.value("at_a") == Approx(0.3).margin(0.02));
  CHECK(r.value("gain") == Approx(r.value("best_volume") / (counted(0.1) * counted(0.1)) - 1));
  CHECK(r.value("variants") <= 200);
  CHECK(r.column("feasible").size() == static_cast<std::size_t>(r.value("variants")));
  CHECK_THAT(r.words(), Contains("There is no proof that there is no better one.") && Contains("between its ends"));
}

TEST_CASE("a constraint that binds is told to be active, and the closer look keeps it") {
  const Run r(
      text("optimise = { maximise = \"workspace.y_high\", over = { b = [\"50 mm\", \"450 mm\"] }, subject_to = [{ that = "
           "\"workspace.volume\", below = \"0.0651 m^2\" }], evaluations = 60 }\n"));
  // 0.21 wide, 31 steps high: b from 150 mm to just below 160 mm.
  CHECK(r.value("best_y_high") == Approx(0.15));
  CHECK(r.value("at_b") >= 0.15 - 1e-9);
  CHECK(r.value("at_b") < 0.16);
  CHECK_THAT(r.words(), Contains("area of the workspace ≤ 0.0651 m²") && Contains("active"));
  REQUIRE(r.evidence().size() == 3);
}

TEST_CASE("constraints that nothing keeps leave no best variant, and the nearest is told") {
  const Run r(
      text("optimise = { maximise = \"workspace.volume\", over = { a = [\"50 mm\", \"300 mm\"] }, subject_to = [{ that = "
           "\"workspace.x_high\", above = \"400 mm\" }], evaluations = 40 }\n"));
  CHECK_THAT(r.words(), Contains("None of") && Contains("keeps every constraint; that which comes nearest is told") &&
                            Contains("at its upper end") && Contains("broken"));
  REQUIRE(r.evidence().size() == 1);
  CHECK(r.evidence()[0].verdict() == document::Verdict::not_examined);
  CHECK(std::ranges::none_of(r.result.values, [](const document::Value& v) { return v.name.starts_with("best"); }));
}

TEST_CASE("where no variant can be made the reason is told once, with how many have it") {
  const Run r(text("optimise = { maximise = \"workspace.volume\", over = { a = [\"550 mm\", \"600 mm\"] }, evaluations = 20 }\n"));
  CHECK_THAT(r.words(), Contains("could be judged") && Contains("a and b together are longer than the frame"));
  CHECK(r.value("failed") == r.value("variants"));
}

TEST_CASE("the front between the two reaches is the frame's length shared between them") {
  const Run r(
      text("pareto = { maximise = [\"workspace.x_high\", \"workspace.y_high\"], over = { a = [\"100 mm\", \"500 mm\"], b = [\"100 mm\", "
           "\"500 mm\"] }, points = 5, evaluations = 300 }\n"));
  CHECK(r.value("points") >= 4);
  // Each end lies in a corner of what can be made, and is searched for by a few dozen variants.
  CHECK(r.value("largest_x_high") == Approx(0.5).margin(0.03));
  CHECK(r.value("largest_y_high") == Approx(0.5).margin(0.03));
  const std::vector<figure::Figure> figures = r.figures();
  REQUIRE(figures.size() == 1);
  const std::vector<figure::Series>& series = figures[0].panels.at(0).series;
  const auto front = std::ranges::find_if(series, [](const figure::Series& s) { return s.label == "front"; });
  REQUIRE(front != series.end());
  for (std::size_t k = 0; k < front->x.size(); ++k) {
    CHECK(front->x[k] + front->y[k] <= 600 + 1e-9);
    CHECK(front->x[k] + front->y[k] >= 560);  // four of the grid's steps
  }
  CHECK(none_fails(r));
}

TEST_CASE("a study of the same scenario has the same data every time") {
  const std::string study =
      text("optimise = { maximise = \"workspace.volume\", over = { a = [\"50 mm\", \"550 mm\"] }, evaluations = 30 }\n");
  const Run one(study), other(study);
  CHECK(one.result.data.at(0).columns.size() == other.result.data.at(0).columns.size());
  for (std::size_t i = 0; i < one.result.data[0].columns.size(); ++i)
    CHECK(std::ranges::equal(one.result.data[0].columns[i], other.result.data[0].columns[i],
                             [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); }));
  CHECK(one.words() == other.words());
}
