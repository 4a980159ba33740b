#include <core/assertion.hpp>
#include <core/linear/eigenvalues.hpp>
#include <core/linear/inverses.hpp>
#include <core/linear/square.hpp>
#include <tests/linear/matrices.hpp>

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

using namespace pmreport::linear;
using Eigen::MatrixXd;

namespace {

constexpr double rounding_of_square = 1e-12;  // random matrices of six rows, condition numbers below 100

SmallMatrix two(double a, double b, double c, double d) { return (SmallMatrix(2, 2) << a, b, c, d).finished(); }
SmallVector two(double a, double b) { return (SmallVector(2) << a, b).finished(); }

}  // namespace

TEST_CASE("the determinant is the product of a triangle's diagonal, and changes its sign with two rows") {
  Matrix6d m = pmreport::test::Matrices(15)(6, 6).triangularView<Eigen::Lower>();
  m.diagonal() << 1, 2, -3, 4, 5, 0.5;
  CHECK(determinant(m) == Approx(-60).epsilon(rounding_of_square));
  m.row(1).swap(m.row(4));
  CHECK(determinant(m) == Approx(60).epsilon(rounding_of_square));
}

TEST_CASE("solutions satisfy their equations, of the matrix and of its transpose") {
  pmreport::test::Matrices random(16);
  for (int k = 0; k < 20; ++k) {
    const Matrix6d a = random(6, 6) + 3 * MatrixXd::Identity(6, 6);
    const Vector6d b = random(6, 1);
    CHECK((a * solution(a, b) - b).norm() < rounding_of_square);
    CHECK((a.transpose() * solution_of_transpose(a, b) - b).norm() < rounding_of_square);
    const SmallMatrix small = a;
    CHECK((small * SmallFactors(small).solve(b) - b).norm() < rounding_of_square);
    CHECK((small.transpose() * SmallFactorsOfTranspose(small.transpose()).solve(b) - b).norm() < rounding_of_square);
    CHECK(SmallFactors(small).determinant() == Approx(determinant(a)).epsilon(rounding_of_square));
    CHECK((small * inverse(small) - MatrixXd::Identity(6, 6)).norm() < rounding_of_square);
  }
}

TEST_CASE("a positive definite system is solved, another one refused") {
  const auto x = solution_of_positive_definite(two(1, 0.5, 0.5, 1), two(2, 2.5), 1e-13);
  REQUIRE(x);
  CHECK((*x - two(1, 2)).norm() < rounding_of_square);
  CHECK_FALSE(solution_of_positive_definite(two(1, 1, 1, 1), two(1, 1), 1e-13));    // singular
  CHECK_FALSE(solution_of_positive_definite(two(1, 2, 2, 1), two(1, 1), 1e-13));    // indefinite
  CHECK_FALSE(solution_of_positive_definite(two(1, 0.5, 0.5, 1), two(1, 1), 0.8));  // its pivots are 1 and 3/4
}

TEST_CASE("inverses of many matrices are those of each, whatever the number of them and the order of their rows") {
  pmreport::test::Matrices random(17);
  for (const std::size_t count : {1, 3, 8, 61}) {
    std::vector<Matrix6d> matrices;
    std::vector<double> in(36 * count), out(36 * count);
    for (std::size_t k = 0; k < count; ++k) {
      Matrix6d m = random(6, 6);
      if (k % 2 == 0) m = MatrixXd::Identity(6, 6).rowwise().reverse() + 0.1 * m;  // rows change places
      if (k % 3 == 0) m(0, 0) = 0;
      for (Eigen::Index e = 0; e < 36; ++e) in[static_cast<std::size_t>(e) * count + k] = m(e / 6, e % 6);
      matrices.push_back(m);
    }
    inverses(count, in.data(), out.data());
    for (std::size_t k = 0; k < count; ++k) {
      Matrix6d inverse;
      for (Eigen::Index e = 0; e < 36; ++e) inverse(e / 6, e % 6) = out[static_cast<std::size_t>(e) * count + k];
      // Rounding is multiplied by the condition number.
      const double size = inverse.norm() * matrices[k].norm();
      CHECK((matrices[k] * inverse - MatrixXd::Identity(6, 6)).norm() < 1e-14 * size);
    }
  }
}

TEST_CASE("a matrix without an inverse has no finite one among those of others") {
  std::vector<double> in(72, 0.0), out(72);
  for (std::size_t i = 0; i < 6; ++i) in[2 * 7 * i] = 2.0;  // the first is twice the unit matrix, the second zero
  inverses(2, in.data(), out.data());
  CHECK(out[0] == 0.5);
  CHECK_FALSE(std::isfinite(out[1]));
}

TEST_CASE("a matrix that is not square has no inverse") { CHECK_THROWS_AS(inverse(SmallMatrix::Ones(2, 3)), pmreport::AssertionFailed); }

TEST_CASE("eigenvalues of symmetric matrices worked out by hand, smallest first") {
  Eigen::Matrix3d m;
  m << 2, 1, 0, 1, 2, 0, 0, 0, 5;
  CHECK((symmetric_eigenvalues(m) - Eigen::Vector3d(1, 3, 5)).norm() < rounding_of_square);
  CHECK((symmetric_eigenvalues(two(2, 1, 1, 2)) - two(1, 3)).norm() < rounding_of_square);
}

TEST_CASE("stationary vectors are those at which a quotient of two forms has its extremes") {
  // x^T a x / x^T b x with a = diag(1, 8), b = diag(1, 2): 1 along the first axis, 4 along the second.
  const MatrixXd x = stationary_vectors(Eigen::Vector2d(1, 8).asDiagonal(), Eigen::Vector2d(1, 2).asDiagonal());
  CHECK(std::abs(x(0, 0)) == Approx(1).epsilon(rounding_of_square));
  CHECK(std::abs(x(1, 0)) < rounding_of_square);
  CHECK(std::abs(x(0, 1)) < rounding_of_square);
  CHECK(std::abs(x(1, 1)) == Approx(std::sqrt(0.5)).epsilon(rounding_of_square));
  CHECK_THROWS_AS(stationary_vectors(MatrixXd::Identity(2, 2), MatrixXd::Identity(3, 3)), pmreport::AssertionFailed);
}

TEST_CASE("a broken promise names its place and says what it was") {
  try {
    PMREPORT_ASSERT(1 + 1 == 3, "sums are what they seem");
    FAIL("nothing was thrown");
  } catch (const pmreport::AssertionFailed& e) {
    CHECK(std::string(e.what()).find("sums are what they seem") != std::string::npos);
    CHECK(std::string(e.what()).find("square.cpp:") != std::string::npos);
  }
}

TEST_CASE("the sign of a determinant is told as far as rounding_of_square of the rows lets it be known") {
  pmreport::test::Matrices random(17);
  int told = 0;
  for (int k = 0; k < 50; ++k) {
    const Matrix6d a = random(6, 6);
    const int sign = sign_of_determinant(a);
    CHECK(sign == (determinant(a) > 0 ? 1 : -1));
    told += sign;
    Matrix6d swapped = a;
    swapped.row(0).swap(swapped.row(3));
    CHECK(sign_of_determinant(swapped) == -sign);
    // A row is a wrench over a lever: however short the lever, the wrench is the same.
    Matrix6d stretched = a;
    stretched.row(2) *= 1e12, stretched.row(5) *= 1e-9;
    CHECK(sign_of_determinant(stretched) == sign);

    // Five rows and a combination of them, rounded: a determinant that is rounding has no sign.
    Matrix6d dependent = a;
    dependent.row(4) = 0.3 * a.row(0) - 0.7 * a.row(1) + 0.2 * a.row(2);
    CHECK(sign_of_determinant(dependent) == 0);
    dependent.row(4) += 1e-9 * a.row(4);
    CHECK(sign_of_determinant(dependent) == sign);
  }
  CHECK(std::abs(told) < 50);
  Matrix6d a = random(6, 6);
  a.row(1).setZero();
  CHECK(sign_of_determinant(a) == 0);
  a(1, 3) = std::nan("");
  CHECK(sign_of_determinant(a) == 0);
}
