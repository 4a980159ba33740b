#include <core/linear/scaled_inverse.hpp>
#include <tests/linear/matrices.hpp>

#include <Eigen/SVD>
#include <catch2/catch.hpp>

using namespace pmreport::linear;
using Eigen::Index;
using Eigen::MatrixXd;

namespace {
constexpr double rounding_of_scaled_inverse = 1e-12;  // random matrices of up to six rows, condition numbers below 1000
}

TEST_CASE("a matrix times its scaled inverse is the scale along the diagonal") {
  pmreport::test::Matrices random(31);
  for (Index n = 1; n <= 6; ++n)
    for (int k = 0; k < 20; ++k) {
      const SmallMatrix a = random(n, n);
      const ScaledInverse t = scaled_inverse(a);
      REQUIRE(t.scale != 0);
      CHECK((a * t.columns - t.scale * MatrixXd::Identity(n, n)).norm() < rounding_of_scaled_inverse);
    }
}

TEST_CASE("of a matrix without an inverse the scale is zero and the columns point to the null vector") {
  pmreport::test::Matrices random(32);
  for (Index n = 2; n <= 6; ++n) {
    SmallMatrix a = random(n, n);
    const Eigen::VectorXd null = random(n, 1).col(0).normalized();
    a = (a - a * null * null.transpose()).eval();
    const ScaledInverse t = scaled_inverse(a);
    CHECK(std::abs(t.scale) < rounding_of_scaled_inverse);
    for (Index i = 0; i < n; ++i) {
      const Eigen::VectorXd column = t.columns.col(i);
      REQUIRE(column.norm() > 1e-3);
      CHECK((column - column.dot(null) * null).norm() < rounding_of_scaled_inverse * column.norm());
    }
  }
  const SmallMatrix twice = (SmallMatrix(2, 2) << 1, 2, 2, 4).finished();  // singular without any rounding
  CHECK(scaled_inverse(twice).scale == 0);
  CHECK((twice * scaled_inverse(twice).columns).norm() == 0);
  CHECK(scaled_inverse(twice).columns.norm() > 0.5);
}

TEST_CASE("where the rank falls by more than one nothing is left of the scaled inverse") {
  CHECK(scaled_inverse(SmallMatrix::Zero(3, 3)).columns.norm() == 0);
  const SmallMatrix row = SmallMatrix::Ones(3, 3);
  CHECK(scaled_inverse(row).columns.norm() == 0);
  CHECK(scaled_inverse(SmallMatrix::Zero(1, 1)).scale == 0);
}
