#include <core/assertion.hpp>
#include <core/mechanics/model/constraint_scale.hpp>

#include <catch2/catch.hpp>
#include <random>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::MatrixXd;

namespace {

MatrixXd random_rows(Eigen::Index rows, Eigen::Index bodies) {
  std::mt19937_64 random(41);
  std::uniform_real_distribution<double> any(-1, 1);
  MatrixXd m(rows, 6 * bodies);
  for (double& x : m.reshaped()) x = any(random);
  return m;
}

}  // namespace

TEST_CASE("rows per length act on rotations times the length as they did on rotations") {
  const double length = 0.2;
  const MatrixXd rows = random_rows(5, 3), scaled = per_length(rows, length);
  Eigen::VectorXd twists = random_rows(1, 3).transpose(), stretched = twists;
  for (int b = 0; b < 3; ++b) stretched.segment<3>(6 * b + 3) *= length;
  CHECK((scaled * stretched - rows * twists).norm() < 1e-14);
}

TEST_CASE("unit rows say the same in any unit of length, and in any size of a row") {
  const MatrixXd rows = random_rows(4, 2), here = unit_rows(rows, 0.2);
  MatrixXd millimetres = rows;  // velocities in mm/s, the length in mm
  for (int b = 0; b < 2; ++b) millimetres.middleCols(6 * b, 3) /= 1000;
  millimetres.row(2) *= 17;
  CHECK((unit_rows(millimetres, 200) - here).cwiseAbs().maxCoeff() < 1e-15);
  CHECK((here.rowwise().norm().array() - 1).abs().maxCoeff() < 1e-15);
}

TEST_CASE("a row of zeros stays one, and spoils no other") {
  MatrixXd rows = random_rows(3, 1);
  rows.row(1).setZero();
  const MatrixXd scaled = unit_rows(rows, 0.5);
  CHECK(scaled.row(1).isZero(0));
  CHECK(scaled.row(2).norm() == Approx(1).epsilon(1e-15));
}

TEST_CASE("rows that are not of whole bodies, and lengths of nothing, are refused") {
  CHECK_THROWS_AS(per_length(MatrixXd::Ones(2, 7), 1), AssertionFailed);
  CHECK_THROWS_AS(per_length(MatrixXd::Ones(2, 6), 0), AssertionFailed);
}
