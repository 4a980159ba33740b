// Gough's platforms that are singular at every pose: their assembly modes are curves and surfaces of poses, not points.
#include <core/mechanics/assembly/assembly.hpp>

#include <core/numbers.hpp>
#include <tests/plugins/hexapods.hpp>

#include <Eigen/Geometry>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Vector3d;
using Points = std::array<Vector3d, 6>;

namespace {

Points ring(double radius, const std::array<double, 6>& degrees) {
  Points out;
  for (std::size_t i = 0; i < 6; ++i) out[i] = radius * Vector3d(std::cos(degrees[i] * deg), std::sin(degrees[i] * deg), 0);
  return out;
}

struct Platform {
  Points base, platform;

  Machine machine() const {
    const auto flat = [](const Points& points) {
      std::vector<double> out;
      for (const Vector3d& p : points) out.insert(out.end(), {p.x(), p.y(), p.z()});
      return out;
    };
    const pm_mechanism& table = test::plugin("gough");
    return Machine(table, test::values_with(
                              table, {{"base_points", flat(base)}, {"platform_points", flat(platform)}, {"home_position", {0, 0, 0.6}}}));
  }
  // |p + R b - a|, R = Rz(alpha) Rx(beta) Ry(gamma).
  Eigen::VectorXd lengths(const Eigen::VectorXd& q) const {
    const Eigen::Matrix3d r = (Eigen::AngleAxisd(q(3), Vector3d::UnitZ()) * Eigen::AngleAxisd(q(4), Vector3d::UnitX()) *
                               Eigen::AngleAxisd(q(5), Vector3d::UnitY()))
                                  .toRotationMatrix();
    Eigen::VectorXd l(6);
    for (Eigen::Index i = 0; i < 6; ++i)
      l(i) = (q.head<3>() + r * platform[static_cast<std::size_t>(i)] - base[static_cast<std::size_t>(i)]).norm();
    return l;
  }
};

// What holds of every continuum: its poses have the lengths, and lie on both sides of nothing: they are apart, and no isolated mode is
// told.
AssemblyModes continua_at(const Platform& p, const Eigen::VectorXd& q) {
  const Machine machine = p.machine();
  const Eigen::VectorXd lengths = p.lengths(q);
  AssemblyOptions shortly;  // every arrival is held against the continua known: that is dear
  shortly.quiet_arrivals = 25;
  AssemblyModes found = find_assembly_modes(machine, lengths, q, shortly);
  CHECK(found.modes.empty());
  REQUIRE_FALSE(found.continua.empty());
  CHECK(found.ended == AssemblyModes::Ended::quiet);
  CHECK(found.continua.front().distance < 1e-9);
  for (const ModeContinuum& c : found.continua) {
    CHECK(c.residual < 1e-10);
    CHECK(c.extent > 0.1);
    for (const Eigen::VectorXd& pose : c.coordinates) CHECK((p.lengths(pose) - lengths).lpNorm<Eigen::Infinity>() < 1e-10);
  }
  return found;
}

// The similar hexagons of the same six directions: leg i goes from corner i to corner i.
Platform similar() {
  const std::array<double, 6> corners{-170, -130, -50, -10, 70, 110};
  return {ring(0.3, corners), ring(0.2, corners)};
}

const Eigen::VectorXd aside = (Eigen::VectorXd(6) << 0.03, -0.02, 0.6, 0.1, -0.07, 0.05).finished();

}  // namespace

TEST_CASE("similar hexagons have two closed curves of poses, one above the base and one below, and no isolated mode") {
  for (const Eigen::VectorXd& q : {aside, Eigen::VectorXd((Eigen::VectorXd(6) << 0.04, 0, 0.9, 0.14, 0.07, 0).finished())}) {
    const AssemblyModes found = continua_at(similar(), q);
    REQUIRE(found.continua.size() == 2);
    for (std::size_t k = 0; k < 2; ++k) {
      const ModeContinuum& c = found.continua[k];
      CHECK(c.dimension == 1);
      CHECK(c.closed);
      CHECK(c.whole);
      for (const Eigen::VectorXd& pose : c.coordinates) CHECK((k == 0) == (pose(2) > 0));
    }
  }
}

TEST_CASE("similar hexagons on six equal legs turn about their common axis all the way round") {
  // With corners on circles of radii a and b, all legs equal: the six lengths squared are a quadratic form on the circle, whose parts in
  // 2 phi vanish for R = Rz(alpha) alone, and those in phi for p on the axis. What is left is z^2 = l^2 - a^2 - b^2 + 2 a b cos(alpha).
  Eigen::VectorXd q = Eigen::VectorXd::Zero(6);
  q(2) = 0.6;
  const AssemblyModes found = continua_at(similar(), q);
  REQUIRE(found.continua.size() == 2);
  const double l2 = 0.6 * 0.6 + 0.1 * 0.1;
  for (const ModeContinuum& c : found.continua) {
    CHECK(c.dimension == 1);  // although three directions leave the lengths alone to first order
    CHECK(c.closed);
    for (const Eigen::VectorXd& pose : c.coordinates) {
      // Off the axis the lengths change by the square: poses are exact to the root of 1e-10.
      CHECK(pose.head<2>().norm() < 1e-5);
      CHECK(pose(2) * pose(2) == Approx(l2 - 0.3 * 0.3 - 0.2 * 0.2 + 2 * 0.3 * 0.2 * std::cos(pose(3))).margin(1e-5));
    }
    const auto [low, high] = std::ranges::minmax(c.coordinates, {}, [](const Eigen::VectorXd& pose) { return pose(3); });
    CHECK(high(3) - low(3) > 2 * pi - 0.3);  // steps are a tenth at most, and the last may fall short by as much again
  }
}

TEST_CASE("a leg that stands twice leaves the platform a curve of poses, two of them a surface") {
  Platform p{ring(0.5, {15, 105, 135, 225, 255, 345}), ring(0.25, {45, 75, 165, 195, 285, 315})};
  CHECK(find_assembly_modes(p.machine(), p.lengths(aside), aside).continua.empty());
  p.base[5] = p.base[4], p.platform[5] = p.platform[4];
  for (const ModeContinuum& c : continua_at(p, aside).continua) CHECK(c.dimension == 1);
  p.base[3] = p.base[2], p.platform[3] = p.platform[2];
  for (const ModeContinuum& c : continua_at(p, aside).continua) CHECK(c.dimension == 2);
}

TEST_CASE("triangles joined from corners to middles of sides leave the platform curves of poses") {
  const auto triangles = [](double radius) {
    Points out = ring(radius, {0, 120, 240, 60, 180, 300});
    for (std::size_t i = 3; i < 6; ++i) out[i] *= 0.5;  // the middles of the sides
    return out;
  };
  Platform p{triangles(0.5), triangles(0.25)};
  std::rotate(p.platform.begin(), p.platform.begin() + 3, p.platform.end());        // corners to middles
  std::rotate(p.platform.begin(), p.platform.begin() + 1, p.platform.begin() + 3);  // of the opposite side
  std::rotate(p.platform.begin() + 3, p.platform.begin() + 5, p.platform.end());
  for (const ModeContinuum& c : continua_at(p, aside).continua) CHECK(c.dimension == 1);
}
