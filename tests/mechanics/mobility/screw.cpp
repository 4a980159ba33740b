#include <core/mechanics/mobility/wrench_system.hpp>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace pmreport::mechanics;
using Eigen::MatrixXd;
using Eigen::Vector3d;

namespace {

constexpr double rounding = 1e-12;  // lengths and forces of about 1, a few operations each

struct Dice {
  std::mt19937_64 random{31};
  std::uniform_real_distribution<double> symmetric{-1, 1};
  Vector3d vector() { return {symmetric(random), symmetric(random), symmetric(random)}; }
  MatrixXd matrix(int rows, int columns) {
    MatrixXd m(rows, columns);
    for (int i = 0; i < m.size(); ++i) m(i) = symmetric(random);
    return m;
  }
};

Vector6d wrench(const Vector3d& force, const Vector3d& moment) { return (Vector6d() << force, moment).finished(); }

// Forces along the columns through a point, as wrenches about the base's origin.
ScrewSystem forces_through(const Vector3d& point, const MatrixXd& directions) {
  ScrewSystem s;
  s.basis.resize(6, directions.cols());
  for (Eigen::Index k = 0; k < directions.cols(); ++k) {
    const Vector3d f = directions.col(k);
    s.basis.col(k) = wrench(f, point.cross(f));
  }
  return s;
}

bool spans(const std::vector<NamedWrench>& basis, const ScrewSystem& system) {
  ScrewSystem s = system;
  s.basis.resize(6, static_cast<Eigen::Index>(basis.size()));
  for (std::size_t k = 0; k < basis.size(); ++k) s.basis.col(static_cast<Eigen::Index>(k)) = basis[k].wrench;
  return s.dimension() == system.dimension() && outside(system, s, 1) < 1e-9 && outside(s, system, 1) < 1e-9;
}

}  // namespace

TEST_CASE("a wrench is put together from a force along a line and a couple about it, and taken apart again") {
  Dice dice;
  for (int k = 0; k < 100; ++k) {
    const Vector3d point = dice.vector(), along = dice.vector().normalized(), origin = dice.vector();
    const double force = 1 + dice.symmetric(dice.random), pitch = k % 3 == 0 ? 0 : dice.symmetric(dice.random);
    const Screw s = screw_of_wrench(wrench(force * along, (point - origin).cross(force * along) + pitch * force * along), origin, 1);
    CAPTURE(k, pitch);
    CHECK(s.parallel(along));
    CHECK(s.distance(point) < 1e-9);  // forces down to 0.01 divide rounding
    CHECK(s.pitch == Approx(pitch).margin(1e-9));
    CHECK(s.is_line() == (pitch == 0));
  }
}

TEST_CASE("a couple and a translation have a direction and no axis") {
  const Screw couple = screw_of_wrench(wrench(Vector3d::Zero(), {0, -3, 0}), {1, 2, 3}, 0.1);
  CHECK(couple.is_free());
  CHECK((couple.direction - Vector3d::UnitY()).norm() < rounding);
  CHECK_FALSE(couple.passes({1, 2, 3}, 0.1));
  const Screw translation = screw_of_twist(wrench({0, 0, -2}, Vector3d::Zero()), {1, 2, 3}, 0.1);
  CHECK(translation.is_free());
  CHECK((translation.direction - Vector3d::UnitZ()).norm() < rounding);
}

TEST_CASE("points on the axis of a twist move along it, by the pitch for every radian") {
  Dice dice;
  for (int k = 0; k < 50; ++k) {
    const Vector3d origin = dice.vector(), v = dice.vector(), w = dice.vector();
    const Screw s = screw_of_twist(wrench(v, w), origin, 1);
    const Vector3d there = v + w.cross(s.point + 0.7 * s.direction - origin);
    CHECK((there - s.pitch * w).norm() < 1e-10);
  }
}

TEST_CASE("a plane is spanned by the base axes that lie in it") {
  Dice dice;
  const Vector3d slanted = Vector3d(0.6, 0.8, 0);
  MatrixXd plane(3, 2);
  plane << slanted, Vector3d::UnitZ();
  for (int k = 0; k < 20; ++k) {
    const MatrixXd a = aligned(plane * dice.matrix(2, 2));  // any basis of the plane
    REQUIRE(a.cols() == 2);
    CHECK((a.col(0) - Vector3d::UnitZ()).norm() < 1e-9);
    CHECK((a.col(1) - slanted).norm() < 1e-9);
  }
  CHECK(aligned(dice.matrix(3, 3)).isIdentity(1e-9));
}

TEST_CASE("what a hinge lets a body do and what it holds it against do no work on one another") {
  // A hinge along Z through (1, 0, 0): one rotation. Against it: three forces through the hinge and two couples across it.
  const Vector3d hinge(1, 0, 0);
  const ScrewSystem motion{Vector3d::Zero(), wrench(hinge.cross(Vector3d::UnitZ()), Vector3d::UnitZ())};
  const ScrewSystem held = reciprocal(motion, 0.3);
  REQUIRE(held.dimension() == 5);
  CHECK((held.basis.transpose() * motion.basis).norm() < rounding);
  const std::vector<NamedWrench> told = readable_basis(held, {{7, hinge}}, 0.3);
  REQUIRE(told.size() == 5);
  CHECK(spans(told, held));
  for (std::size_t k = 0; k < 5; ++k) {
    CHECK(told[k].screw.is_free() == (k < 2));
    CHECK(std::abs(told[k].screw.direction.cwiseAbs().maxCoeff() - 1) < 1e-9);  // along base axes all of them
    CHECK(told[k].joint == (k < 2 ? -1 : 7));
  }
}

TEST_CASE("a basis goes through the landmark of most forces") {
  // Two forces through p, one through q; the line pq is not in the plane of the two.
  const Vector3d p(0.2, 0.1, 0.4), q(-0.3, 0.5, 0);
  ScrewSystem all = forces_through(p, Eigen::MatrixXd::Identity(3, 2));
  all.basis.conservativeResize(6, 3);
  all.basis.col(2) = forces_through(q, Vector3d::UnitZ()).basis;
  const std::vector<NamedWrench> told = readable_basis(all, {{0, q}, {1, p}}, 0.5);
  REQUIRE(told.size() == 3);
  CHECK(spans(told, all));
  CHECK(told[0].joint == 1);
  CHECK(told[1].joint == 1);
  CHECK(told[2].joint == 0);
  for (const NamedWrench& w : told) CHECK(w.screw.is_line());
}

TEST_CASE("a couple hidden in forces is found: two parallel forces are one force and one couple") {
  ScrewSystem pair = forces_through({0, 0.1, 0}, Vector3d::UnitZ());
  pair.basis.conservativeResize(6, 2);
  pair.basis.col(1) = forces_through({0, -0.2, 0}, Vector3d::UnitZ()).basis;
  const std::vector<NamedWrench> told = readable_basis(pair, {}, 1);
  REQUIRE(told.size() == 2);
  CHECK(told[0].screw.is_free());
  CHECK((told[0].screw.direction - Vector3d::UnitX()).norm() < 1e-9);
  CHECK(told[1].screw.is_line());
  CHECK(told[1].screw.parallel(Vector3d::UnitZ()));
}

TEST_CASE("two skew forces have the principal screws of their cylindroid") {
  // Forces along X at height h/2 and along Y at -h/2 (Hunt 1978): the principal screws lie at 45 degrees through the middle, with pitches
  // -h/2 and h/2.
  constexpr double h = 0.3;
  ScrewSystem pair = forces_through({0, 0, h / 2}, Vector3d::UnitX());
  pair.basis.conservativeResize(6, 2);
  pair.basis.col(1) = forces_through({0, 0, -h / 2}, Vector3d::UnitY()).basis;
  const std::vector<NamedWrench> told = readable_basis(pair, {}, 1);
  REQUIRE(told.size() == 2);
  CHECK(spans(told, pair));
  for (const NamedWrench& w : told) {
    CHECK(std::abs(w.screw.pitch) == Approx(h / 2).epsilon(1e-9));
    CHECK(w.screw.distance(Vector3d::Zero()) < 1e-9);
    CHECK(std::abs(w.screw.direction.x()) == Approx(std::sqrt(0.5)).epsilon(1e-9));
    CHECK(w.screw.direction.z() == Approx(0).margin(1e-9));
  }
  CHECK(told[0].screw.pitch * told[1].screw.pitch < 0);
}
