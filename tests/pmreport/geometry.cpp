// Vectors, matrices and rotations of every scalar.
#include <catch2/catch.hpp>
#include <pmreport/placement.hpp>
#include <pmreport/rotation.hpp>
#include <tests/pmreport/functions.hpp>

using namespace pmreport;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using functions::Random;

namespace {

constexpr int geometry_tries = 50;
constexpr double geometry_rounding = 1e-14;

// The value of any scalar, of lanes that of the first.
double value(double x) { return x; }
double value(long double x) { return double(x); }
double value(const Lanes& x) {
  std::array<double, Lanes::width> all;
  x.store(all.data());
  return all[0];
}
template <class S>
double value(const Jet<S>& x) {
  return value(x.value);
}
template <class S, int M>
double value(const Partials<S, M>& x) {
  return value(x.value);
}
template <class Matrix>
Eigen::MatrixXd values(const Matrix& m) {
  Eigen::MatrixXd out(m.rows(), m.cols());
  for (int i = 0; i < m.rows(); ++i)
    for (int j = 0; j < m.cols(); ++j) out(i, j) = value(m(i, j));
  return out;
}

Vector3d random_vector(Random& random) { return {random.within(-1, 1), random.within(-1, 1), random.within(-1, 1)}; }

}  // namespace

TEMPLATE_TEST_CASE("a constant vector mixes with vectors of every scalar", "", double, long double, Lanes, Jet<double>, Jet<Lanes>,
                   (Partials<double, 5>), (Partials<Lanes, 5>)) {
  using T = TestType;
  Random random(7);
  const Vector3d a = random_vector(random), c = random_vector(random);
  Matrix3d m;
  m << random_vector(random), random_vector(random), random_vector(random);
  const Vector3<T> v = a.cast<T>();
  const Matrix3<T> r = m.cast<T>();
  const auto near = [](const auto& seen, const auto& expected) { return values(seen).isApprox(expected, geometry_rounding); };

  CHECK(near(Vector3<T>(v + c), a + c));
  CHECK(near(Vector3<T>(v - c), a - c));
  CHECK(near(Vector3<T>(c - v), c - a));
  CHECK(near(Vector3<T>(2.0 * v), 2 * a));
  CHECK(near(Vector3<T>(r * c), m * c));
  CHECK(near(Vector3<T>(r * v), m * a));
  CHECK(near(Matrix3<T>(r * r.transpose()), m * m.transpose()));
  CHECK(value(T(v.dot(c))) == Approx(a.dot(c)).epsilon(geometry_rounding));
  CHECK(value(T(c.dot(v))) == Approx(a.dot(c)).epsilon(geometry_rounding));
  CHECK(near(Vector3<T>(v.cross(c.cast<T>())), a.cross(c)));
  CHECK(value(length(v)) == Approx(a.norm()).epsilon(geometry_rounding));
  CHECK(near(unit(v), a.normalized()));
}

TEST_CASE("elementary rotations turn one axis into the next") {
  const double quarter = std::numbers::pi / 2;
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  CHECK((rotation_x(quarter) * y - z).norm() < geometry_rounding);
  CHECK((rotation_x(quarter) * x - x).norm() < geometry_rounding);
  CHECK((rotation_y(quarter) * z - x).norm() < geometry_rounding);
  CHECK((rotation_y(quarter) * y - y).norm() < geometry_rounding);
  CHECK((rotation_z(quarter) * x - y).norm() < geometry_rounding);
  CHECK((rotation_z(quarter) * z - z).norm() < geometry_rounding);
}

TEST_CASE("a rotation is orthonormal and keeps hands right") {
  Random random(8);
  for (int i = 0; i < geometry_tries; ++i) {
    const double a = random.within(-4, 4), b = random.within(-4, 4), c = random.within(-4, 4);
    CAPTURE(a, b, c);
    for (const Matrix3d& r : {rotation_x(a), rotation_y(b), rotation_z(c), rotation_zyx(a, b, c)}) {
      CHECK((r.transpose() * r - Matrix3d::Identity()).norm() < geometry_rounding);
      CHECK(r.determinant() == Approx(1).epsilon(geometry_rounding));
    }
    CHECK((rotation_zyx(a, b, c) - rotation_z(a) * rotation_y(b) * rotation_x(c)).norm() < geometry_rounding);
    const Matrix3d oracle =
        (Eigen::AngleAxisd(a, Vector3d::UnitZ()) * Eigen::AngleAxisd(b, Vector3d::UnitY()) * Eigen::AngleAxisd(c, Vector3d::UnitX()))
            .toRotationMatrix();
    CHECK((rotation_zyx(a, b, c) - oracle).norm() < geometry_rounding);
  }
}

// R' = [w] R, w the angular velocity: of Rz(a) Ry(b) Rx(c) it is a' z + b' Rz y + c' Rz Ry x.
TEST_CASE("the rate of a rotation of jets is its angular velocity") {
  Random random(9);
  for (int i = 0; i < geometry_tries; ++i) {
    const Vector3d angle = random_vector(random), rate = random_vector(random);
    CAPTURE(angle.transpose(), rate.transpose());
    const auto jet = [&](int k) { return Jet<double>(angle(k), rate(k), 0.0); };
    const Matrix3<Jet<double>> r = rotation_zyx(jet(0), jet(1), jet(2));
    Matrix3d derivative;
    for (int row = 0; row < 3; ++row)
      for (int col = 0; col < 3; ++col) derivative(row, col) = r(row, col).rate;
    const Eigen::AngleAxisd z(angle(0), Vector3d::UnitZ()), y(angle(1), Vector3d::UnitY());
    const Vector3d w = rate(0) * Vector3d::UnitZ() + rate(1) * (z * Vector3d::UnitY()) + rate(2) * (z * (y * Vector3d::UnitX()));
    Matrix3d cross;
    cross << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
    CHECK((derivative - cross * values(r)).norm() < geometry_rounding);
  }
}

TEST_CASE("a frame from its x and z axes is right-handed") {
  Random random(10);
  for (int i = 0; i < geometry_tries; ++i) {
    const Vector3d z = random_vector(random).normalized(), x = z.cross(random_vector(random)).normalized();
    const Matrix3d r = frame_xz(x, z);
    CAPTURE(x.transpose(), z.transpose());
    CHECK(r.col(0) == x);
    CHECK(r.col(2) == z);
    CHECK((r.transpose() * r - Matrix3d::Identity()).norm() < geometry_rounding);
    CHECK(r.determinant() == Approx(1).epsilon(geometry_rounding));
  }
}
