// Parts, holes and sheets of sets that are known beforehand.
#include <tests/scan/sets.hpp>

#include <catch2/catch.hpp>
#include <core/program/evaluate.hpp>
#include <core/scan/components.hpp>
#include <core/scan/field.hpp>

#include <cmath>
#include <numeric>

using namespace sets;
using scan::components;
using scan::Components;

namespace {

using Numbers = std::vector<std::uint64_t>;

std::uint64_t sum(const Numbers& n) { return std::accumulate(n.begin(), n.end(), std::uint64_t{0}); }

}  // namespace

TEST_CASE("a shell is one part with one hole, and two balls are two parts without") {
  const scan::Scan s{{0, 0, 0}, {{0, -1.25, 1.25, 41}, {1, -1.25, 1.25, 41}, {2, -1.25, 1.25, 41}}};
  const scan::GridCounts counts = count_grid(shell(0.5, 1.0), s, {});
  const Components c = components({41, 41, 41}, counts.accepted_at);
  CHECK(c.parts == Numbers{counts.tally.accepted});
  CHECK(c.holes == Numbers{counts.tally.first[1]});  // what lies within the inner sphere

  const program::Program balls = recording::recorded(3, [](const std::vector<Recorded>& q) {
    const Recorded rest = q[1] * q[1] + q[2] * q[2];
    const Recorded one = 0.25 - (q[0] - 0.625) * (q[0] - 0.625) - rest, other = 0.09 - (q[0] + 0.625) * (q[0] + 0.625) - rest;
    return std::vector<Recorded>{1.0 + rest, larger(one, other)};
  });
  const scan::GridCounts two = count_grid({balls, {0, 0}, {}}, s, {});
  const Components parts = components({41, 41, 41}, two.accepted_at);
  REQUIRE(parts.parts.size() == 2);
  CHECK(parts.parts[0] > parts.parts[1]);
  CHECK(sum(parts.parts) == two.tally.accepted);
  CHECK(parts.holes.empty());
}

TEST_CASE("points touch along axes, not across: a hole is shut in, and a bay is not") {
  // Four rows of five.
  const std::vector<std::uint32_t> at{1, 1, 1, 1, 0,  //
                                      1, 0, 1, 2, 0,  //
                                      1, 1, 1, 0, 3,  //
                                      0, 0, 0, 3, 3};
  const Components one = components({4, 5}, at);
  CHECK(one.parts == Numbers{10, 3});
  CHECK(one.holes == Numbers{1, 1});
  const Components two = components({4, 5}, at, 2);
  CHECK(two.parts == Numbers{3, 1});
  CHECK(two.holes.empty());
  // An axis with a single value shuts nothing in and opens nothing.
  CHECK(components({1, 4, 5}, at).holes == one.holes);
  CHECK(components({4, 1, 5}, at).parts == one.parts);
}

TEST_CASE("a sheet ends where the sign changes, and poses without a sign belong to none") {
  const scan::PoseSet set{
      recording::recorded(5, [](const std::vector<Recorded>& q) { return std::vector<Recorded>{4.0 - q[0] * q[0]}; }), {0}, {}};
  const program::Program sign = plane();  // x + y + z + tilt - 0.25
  scan::Scan s{{0, 0, 0, 0, 0}, {{0, -3, 3, 25}, {1, -1, 1, 9}}, {3, 4}, {}};
  for (const double tilt : {-0.5, 0.0, 0.5})
    for (const double turn : {0.0, 1.0}) s.orientations.push_back({tilt, turn});
  scan::GridOptions options;
  options.sign = &sign;
  options.keep_poses = true;
  const scan::GridCounts counts = count_grid(set, s, options);
  // x has 17 values within [-2, 2]; all that is accepted hangs together, and a plane parts it.
  const auto pose = [](std::uint64_t x, std::uint64_t y, std::uint64_t o) { return (x * 9 + y) * 6 + o; };
  const scan::Sheet above = sheet_of({25, 9}, {3, 2}, counts, pose(20, 8, 5));
  CHECK(above.sign == 1);
  CHECK(above.poses == counts.positive);
  CHECK(above.connected == 17u * 9u * 6u);
  const scan::Sheet below = sheet_of({25, 9}, {3, 2}, counts, pose(4, 0, 0));
  CHECK(below.sign == -1);
  CHECK(below.poses == counts.negative);
  CHECK(counts.positive + counts.negative < counts.tally.accepted);
  // x = 0.25, y = 0, tilt 0: on the plane.
  const scan::Sheet on_it = sheet_of({25, 9}, {3, 2}, counts, pose(13, 4, 2));
  CHECK(on_it.sign == 0);
  CHECK(on_it.poses == 0);
  CHECK(on_it.connected == above.connected);
  const scan::Sheet outside = sheet_of({25, 9}, {3, 2}, counts, pose(0, 4, 2));
  CHECK(outside.connected == 0);
}

TEST_CASE("a field has the margins of each point, none but the reach where a pose cannot be assembled, and the least of all") {
  const scan::PoseSet set = three_legs();
  const scan::Scan s{{0, 0.25, 0.75, 0.1, 0.2}, {{2, 2, -1, 7}, {0, -2, 2, 9}}};
  const scan::Field field = sample_field(set, s);
  REQUIRE(field.margins.size() == set.size());
  program::Evaluator<double> evaluator(set.margins);
  const std::vector<double> least = field.least();
  std::size_t refused = 0;
  for (std::size_t k = 0; k < 63; ++k) {
    std::vector<double> q = s.at, m(set.size());
    q[2] = s.points[0].value(k / 9);
    q[0] = s.points[1].value(k % 9);
    evaluator.run(q, m);
    bool inside = true, number = true;
    for (std::size_t i = 0; i < m.size(); ++i) {
      CAPTURE(k, i, m[0]);
      if (i == 0 || m[0] >= 0) {
        CHECK((field.margins[i][k] == m[i] || (std::isnan(m[i]) && std::isnan(field.margins[i][k]))));
        inside = inside && m[i] >= 0;
        number = number && !std::isnan(m[i]);
      } else {
        CHECK(std::isnan(field.margins[i][k]));
      }
    }
    refused += m[0] < 0;
    if (m[0] < 0)
      CHECK(least[k] < 0);
    else if (!number)
      CHECK(std::isnan(least[k]));
    else
      CHECK((least[k] >= 0) == inside);
  }
  CHECK(refused > 5);
  CHECK(refused < 58);
}
