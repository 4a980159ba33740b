#include <core/linear/subspace.hpp>
#include <tests/linear/matrices.hpp>

#include <catch2/catch.hpp>

using namespace pmreport::linear;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {
constexpr double rounding_of_subspace = 1e-13;  // matrices of ten rows with numbers of about 1
}

TEST_CASE("null space and column space of a matrix of known rank") {
  pmreport::test::Matrices random(11);
  for (int r = 1; r <= 5; ++r) {
    const MatrixXd m = random(9, r) * random(r, 7), null = null_space(m), columns = column_space(m);
    CAPTURE(r);
    CHECK(rank(m) == r);
    CHECK(rank(m.transpose()) == r);
    REQUIRE(null.cols() == 7 - r);
    REQUIRE(columns.cols() == r);
    CHECK((m * null).norm() < rounding_of_subspace * m.norm());
    CHECK((null.transpose() * null - MatrixXd::Identity(7 - r, 7 - r)).norm() < rounding_of_subspace);
    CHECK((columns.transpose() * columns - MatrixXd::Identity(r, r)).norm() < rounding_of_subspace);
    CHECK((m - columns * columns.transpose() * m).norm() < rounding_of_subspace * m.norm());
  }
}

TEST_CASE("matrices without rows, or columns, hold nothing and span nothing") {
  CHECK(rank(MatrixXd(0, 3)) == 0);
  CHECK(null_space(MatrixXd(0, 3)).isIdentity());
  CHECK(column_space(MatrixXd(6, 0)).cols() == 0);
  CHECK(column_space(MatrixXd(6, 0)).rows() == 6);
  CHECK(pivots(MatrixXd(0, 3)).size() == 0);
}

TEST_CASE("a pivot counts above a billionth of the largest, and not below") {
  CHECK(rank(Vector2d(1, 1.1 * rank_tolerance).asDiagonal().toDenseMatrix()) == 2);
  CHECK(rank(Vector2d(1, 0.9 * rank_tolerance).asDiagonal().toDenseMatrix()) == 1);
  // Whatever the unit is in which all of it is measured.
  CHECK(rank(Vector2d(1e6, 1.1e6 * rank_tolerance).asDiagonal().toDenseMatrix()) == 2);
  CHECK(rank(Vector2d(1e-6, 0.9e-6 * rank_tolerance).asDiagonal().toDenseMatrix()) == 1);
}

TEST_CASE("where a size is named, a matrix that is nothing but rounding_of_subspace has rank 0") {
  const MatrixXd dust = Vector2d(3e-14, -2e-14).asDiagonal();
  CHECK(rank(dust) == 2);
  CHECK(rank(dust, 1) == 0);
  CHECK(null_space(dust, 1).cols() == 2);
  CHECK(column_space(dust, 1).cols() == 0);
}

TEST_CASE("pivots are the lengths of columns across those before, longest first") {
  MatrixXd m(3, 2);
  m << 3, 4, 0, 3, 0, 0;  // the longer column (4, 3) first; across it (3, 0) has 9/5 left
  const Eigen::VectorXd p = pivots(m);
  REQUIRE(p.size() == 2);
  CHECK(p(0) == Approx(5).epsilon(rounding_of_subspace));
  CHECK(p(1) == Approx(1.8).epsilon(rounding_of_subspace));
}

TEST_CASE("each of the orthonormal columns lies in what the given ones span up to it") {
  pmreport::test::Matrices random(12);
  const MatrixXd given = random(8, 3), q = orthonormalised(given);
  CHECK((q.transpose() * q - MatrixXd::Identity(3, 3)).norm() < rounding_of_subspace);
  for (int k = 1; k <= 3; ++k)
    CHECK((given.leftCols(k) - q.leftCols(k) * (q.leftCols(k).transpose() * given.leftCols(k))).norm() < rounding_of_subspace);
}
