// The distance of segments against a search, and which limbs of a mechanism are lines.
#include <catch2/catch.hpp>
#include <core/mechanics/workspace/segments.hpp>
#include <tests/mechanics/mechanisms.hpp>

#include <cmath>
#include <random>

namespace pmreport::mechanics {

namespace {

// The least distance over a grid of points of both, made finer around the best: good to some 1e-6.
double searched(const Eigen::Vector3d& p, const Eigen::Vector3d& p_end, const Eigen::Vector3d& q, const Eigen::Vector3d& q_end) {
  double best = INFINITY, s_best = 0.5, t_best = 0.5, width = 0.5;
  for (int round = 0; round < 12; ++round, width *= 0.35) {
    const double s_middle = s_best, t_middle = t_best;
    for (int i = -10; i <= 10; ++i)
      for (int k = -10; k <= 10; ++k) {
        const double s = std::clamp(s_middle + width * i / 10, 0.0, 1.0), t = std::clamp(t_middle + width * k / 10, 0.0, 1.0);
        const double d = (p + s * (p_end - p) - q - t * (q_end - q)).norm();
        if (d < best) best = d, s_best = s, t_best = t;
      }
  }
  return best;
}

}  // namespace

TEST_CASE("the distance of two segments is the least that a search finds") {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto point = [&] { return Eigen::Vector3d(number(random), number(random), number(random)); };
  for (int i = 0; i < 60; ++i) {
    const Eigen::Vector3d p = point(), q = point(), d = point();
    const Eigen::Vector3d p_end = point();
    // One in four is parallel to the other.
    const Eigen::Vector3d q_end = i % 4 == 0 ? Eigen::Vector3d(q + 0.7 * (p_end - p)) : Eigen::Vector3d(q + d);
    CAPTURE(i, p.transpose(), p_end.transpose(), q.transpose(), q_end.transpose());
    CHECK(std::sqrt(squared_distance<double>(p, p_end, q, q_end)) == Approx(searched(p, p_end, q, q_end)).margin(2e-5));
  }
}

TEST_CASE("a telescopic leg is a line from its foot to the platform, and legs that meet are no pair") {
  const Machine machine = test::make_hexapod(test::BaseJoint::universal);
  for (int limb = 1; limb <= 6; ++limb) {
    const std::optional<LimbLine> line = limb_line(machine, limb);
    REQUIRE(line);
    const auto& joints = machine.topology().joints;
    const Joint &from = joints[static_cast<std::size_t>(line->from)], &to = joints[static_cast<std::size_t>(line->to)];
    CHECK((from.a == 0 || from.b == 0));
    CHECK((to.a == machine.topology().platform || to.b == machine.topology().platform));
    CHECK(line->low == line->from);
    CHECK(line->high == line->to);
  }
  std::string why;
  CHECK_FALSE(limb_line(machine, 7, &why));
  CHECK(why == "does not exist");
  CHECK_FALSE(adjacent(machine, *limb_line(machine, 1), *limb_line(machine, 2)));
  CHECK(adjacent(machine, *limb_line(machine, 1), *limb_line(machine, 1)));
  CHECK(pairs_of(machine, {{1, 2, 3, 4, 5, 6}, {}, false}).size() == 15);
  CHECK(pairs_of(machine, {{1, 2}, {3, 4, 5}, false}).size() == 6);
}

}  // namespace pmreport::mechanics
