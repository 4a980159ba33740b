#include <core/linear/singular_values.hpp>
#include <tests/linear/matrices.hpp>

#include <catch2/catch.hpp>
#include <cmath>

using namespace pmreport::linear;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

namespace {

constexpr double rounding_of_singular_values = 1e-13;

// m^T m = (25 20; 20 25): singular values 3 sqrt(5) and sqrt(5), with (1, 1) and (1, -1) on the right, (1, 3) and (3, -1) on the left.
MatrixXd known() { return (MatrixXd(2, 2) << 3, 0, 4, 5).finished(); }

double along(const VectorXd& unit, const VectorXd& direction) { return std::abs(unit.dot(direction.normalized())); }

// 1 on the diagonal, -1 right of it: no column is small, but the inverse has 2^(n - 2) in its corner.
MatrixXd deceptive(Eigen::Index n) {
  MatrixXd m = MatrixXd::Identity(n, n);
  for (Eigen::Index r = 0; r < n; ++r) m.row(r).tail(n - r - 1).setConstant(-1);
  return m;
}

}  // namespace

TEST_CASE("singular values of a matrix worked out by hand") {
  const VectorXd s = singular_values(known());
  REQUIRE(s.size() == 2);
  CHECK(s(0) == Approx(3 * std::sqrt(5)).epsilon(rounding_of_singular_values));
  CHECK(s(1) == Approx(std::sqrt(5)).epsilon(rounding_of_singular_values));
  CHECK(singular_values(MatrixXd(known().leftCols(1))).size() == 1);
}

TEST_CASE("the same in a matrix of six rows, and the directions that are stretched most and least") {
  Matrix6d m = Matrix6d::Identity() * 3;
  m.topLeftCorner<2, 2>() = known();
  const Vector6d s = singular_values(m);
  CHECK(s(0) == Approx(3 * std::sqrt(5)).epsilon(rounding_of_singular_values));
  CHECK(s(5) == Approx(std::sqrt(5)).epsilon(rounding_of_singular_values));
  const RightSingular right = right_singular(m);
  CHECK((right.values - s).norm() < rounding_of_singular_values);
  CHECK(along(right.vectors.col(0).head(2), Vector2d(1, 1)) == Approx(1).epsilon(rounding_of_singular_values));
  CHECK(along(right.vectors.col(5).head(2), Vector2d(1, -1)) == Approx(1).epsilon(rounding_of_singular_values));
}

TEST_CASE("left singular vectors are where the stretched directions go") {
  const LeftSingular left = left_singular(known());
  CHECK(left.values(0) == Approx(3 * std::sqrt(5)).epsilon(rounding_of_singular_values));
  CHECK(along(left.vectors.col(0), Vector2d(1, 3)) == Approx(1).epsilon(rounding_of_singular_values));
  CHECK(along(left.vectors.col(1), Vector2d(3, -1)) == Approx(1).epsilon(rounding_of_singular_values));
}

TEST_CASE("rank by singular values knows a matrix near to a singular one though no column of it is small") {
  CHECK(rank_by_singular_values(deceptive(20)) == 20);  // least singular value above 1e-6
  CHECK(rank_by_singular_values(deceptive(40)) == 39);  // below 2^-38
  CHECK(rank_by_singular_values(Vector2d(1e-5, 1e-13).asDiagonal().toDenseMatrix()) == 2);
  CHECK(rank_by_singular_values(Vector2d(1e-5, 1e-15).asDiagonal().toDenseMatrix()) == 1);
}

TEST_CASE("unit rows that are equal but for a ten-billionth hold one motion, not two") {
  MatrixXd rows(2, 4);
  rows.row(0) << 1, 0, 0, 0;
  rows.row(1) << 1, 1e-10, 0, 0;
  const MatrixXd free = null_space_by_singular_values(rows);
  REQUIRE(free.cols() == 3);
  CHECK((rows * free).cwiseAbs().maxCoeff() < 2e-10);
  CHECK((free.transpose() * free - MatrixXd::Identity(3, 3)).norm() < rounding_of_singular_values);
  rows(1, 1) = 1e-8;
  CHECK(null_space_by_singular_values(rows).cols() == 2);
}

TEST_CASE("both ways to the rank agree on matrices that are clearly of it") {
  pmreport::test::Matrices random(13);
  for (int r = 1; r <= 5; ++r) CHECK(rank_by_singular_values(random(8, r) * random(r, 6)) == r);
}
