#include <core/assertion.hpp>
#include <core/linear/least_norm.hpp>
#include <tests/linear/matrices.hpp>

#include <catch2/catch.hpp>

using namespace pmreport::linear;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

namespace {
constexpr double rounding_of_least_norm = 1e-13;
}

TEST_CASE("of all that solve one equation the answer is the nearest to zero") {
  const VectorXd x = least_norm_solution((MatrixXd(1, 2) << 1, 2).finished(), VectorXd::Constant(1, 5));
  CHECK((x - Vector2d(1, 2)).norm() < rounding_of_least_norm);
}

TEST_CASE("equations that contradict one another are met in the mean") {
  const VectorXd x = least_norm_solution(MatrixXd::Ones(2, 1), Vector2d(1, 3));
  CHECK(x(0) == Approx(2).epsilon(rounding_of_least_norm));
}

TEST_CASE("an answer has nothing in the null space, and its error is across all columns") {
  pmreport::test::Matrices random(14);
  const MatrixXd a = random(9, 4) * random(4, 7);  // of rank 4, in either way short
  const VectorXd b = random(9, 1), x = least_norm_solution(a, b);
  CHECK((a.transpose() * (a * x - b)).norm() < rounding_of_least_norm * 10);
  CHECK((x - least_norm_solution(a, a * x)).norm() < rounding_of_least_norm * 10 * x.norm());
}

TEST_CASE("the tolerance decides whether a weak equation counts") {
  const MatrixXd a = Vector2d(1, 1e-10).asDiagonal();
  CHECK(least_norm_solution(a, Vector2d(1, 1))(1) == Approx(1e10));
  CHECK(least_norm_solution(a, Vector2d(1, 1), rank_tolerance)(1) == 0);
  CHECK(least_norm_solution(a, Vector2d(1, 1), 1e-11)(1) == Approx(1e10));
}

TEST_CASE("a right side of another length is refused") {
  CHECK_THROWS_AS(least_norm_solution(MatrixXd::Ones(2, 2), VectorXd::Ones(3)), pmreport::AssertionFailed);
  CHECK_THROWS_AS(least_norm_solution(MatrixXd::Ones(2, 2), VectorXd::Ones(1), 1e-9), pmreport::AssertionFailed);
}
