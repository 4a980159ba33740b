// Margins against the limits that they stand for.
#include <catch2/catch.hpp>
#include <core/mechanics/workspace/margin_recorder.hpp>
#include <core/numbers.hpp>
#include <core/program/evaluate.hpp>

#include <array>
#include <cmath>
#include <map>
#include <random>

namespace pmreport::mechanics {

namespace {

// Margins of one number v of two inputs, as `record` makes it.
template <class Record>
PoseMargins margins_of(double min, double max, Record record) {
  program::Recorder start(2);
  const Recorded x = start.input(0), y = start.input(1);
  const std::array outputs{Recorded(1.0), record(x, y)};
  const program::Program program = start.finish(outputs);
  program::Recorder recorder(program);
  PoseMargins out;
  MarginRecorder margins(recorder, program, out);
  margins.add_reach();
  margins.add_output({PoseLimit::Group::values, "v", "", "", min, max}, 1);
  out.program = recorder.finish(margins.outputs);
  return out;
}

// What each margin says at (x, y): by its name, whether it is kept.
std::map<std::string, bool> kept(const PoseMargins& margins, double x, double y) {
  program::Evaluator<double> evaluator(margins.program);
  std::vector<double> values(margins.margins.size());
  evaluator.run(std::array{x, y}, values);
  std::map<std::string, bool> out;
  for (std::size_t m = 0; m < values.size(); ++m) out[margins.margins[m].name] = values[m] >= 0;
  return out;
}

// Every margin agrees with its end of the limit at random inputs, but where the value lies within `near` of it.
template <class Record, class Value>
void check(double min, double max, double reach, Record record, Value value) {
  CAPTURE(min, max);
  const PoseMargins margins = margins_of(min, max, record);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> number(-reach, reach);
  int below = 0, above = 0, within = 0;
  for (int i = 0; i < 2000; ++i) {
    const double x = number(random), y = number(random), v = value(x, y);
    if (std::isnan(v) || std::abs(v - min) < 1e-9 || std::abs(v - max) < 1e-9) continue;
    CAPTURE(x, y, v);
    const auto is = kept(margins, x, y);
    if (is.contains("v<")) CHECK(is.at("v<") == (v >= min));
    if (is.contains("v>")) CHECK(is.at("v>") == (v <= max));
    below += v<min, above += v> max, within += v >= min && v <= max;
    if (v < min) REQUIRE(is.contains("v<"));
    if (v > max) REQUIRE(is.contains("v>"));
  }
  CHECK(within > 0);
}

}  // namespace

TEST_CASE("an angle keeps its limits by sine and cosine on every side of zero") {
  const auto record = [](const Recorded& x, const Recorded& y) { return atan2(y, x); };
  const auto value = [](double x, double y) { return std::atan2(y, x); };
  for (const auto& [min, max] : {std::pair{-1.0, 0.7}, {0.3, 2.5}, {-2.9, -0.2}, {-3.0, 3.0}, {0.0, 1.0}, {-1.0, 0.0}, {-2.0, 2.9}})
    check(min, max, 2, record, value);
}

TEST_CASE("the angle of a joint that counts the other way keeps its limits too") {
  for (const auto& [min, max] : {std::pair{-1.0, 0.7}, {0.3, 2.5}, {-2.9, -0.2}})
    check(
        min, max, 2, [](const Recorded& x, const Recorded& y) { return -atan2(y, x); },
        [](double x, double y) { return -std::atan2(y, x); });
}

TEST_CASE("an angle that counts from elsewhere keeps its limits by sine and cosine") {
  const auto angle = [](double x, double y) { return pi / 2 - std::atan2(y, x); };
  for (const auto& [min, max] : {std::pair{-0.7, 1.3}, {0.4, 2.0}, {1.6, 3.0}}) {
    const auto record = [](const Recorded& x, const Recorded& y) { return pi / 2 - atan2(y, x); };
    check(min, max, 2, record, angle);
    const PoseMargins margins = margins_of(min, max, record);
    for (const program::Step& s : margins.program.steps()) CHECK(s.operation != program::Operation::atan2);
  }
  // Beyond half a turn the angle itself is looked at.
  check(
      -2.0, 4.0, 2, [](const Recorded& x, const Recorded& y) { return pi / 2 - atan2(y, x); }, angle);
}

TEST_CASE("a length keeps its limits by its square") {
  const auto record = [](const Recorded& x, const Recorded& y) { return sqrt(x * x + y * y); };
  const auto value = [](double x, double y) { return std::hypot(x, y); };
  check(0.4, 1.1, 2, record, value);
  check(-1.0, 1.1, 2, record, value);  // no length is below zero
  const PoseMargins margins = margins_of(0.4, 1.1, record);
  for (const program::Step& s : margins.program.steps()) CHECK(s.operation != program::Operation::sqrt);
}

TEST_CASE("an angle between directions keeps its limits by its cosine") {
  const auto record = [](const Recorded& x, const Recorded& y) { return acos(x / sqrt(x * x + y * y + 1.0)); };
  const auto value = [](double x, double y) { return std::acos(x / std::sqrt(x * x + y * y + 1)); };
  check(0.5, 2.2, 2, record, value);
  check(0.0, pi / 2, 2, record, value);
}

TEST_CASE("any other number keeps its limits as it stands") {
  check(
      -0.3, 0.5, 2, [](const Recorded& x, const Recorded& y) { return x * y + sin(x); },
      [](double x, double y) { return x * y + std::sin(x); });
}

TEST_CASE("an end that is open makes no margin") {
  const auto record = [](const Recorded& x, const Recorded& y) { return x + y; };
  CHECK(margins_of(-open_end, 1, record).margins.size() == 2);
  CHECK(margins_of(1, open_end, record).margins.size() == 2);
  CHECK(margins_of(0, 1, record).margins.size() == 3);
}

}  // namespace pmreport::mechanics
