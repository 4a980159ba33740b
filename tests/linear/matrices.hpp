// Random matrices, the same on every run.
#pragma once

#include <Eigen/Core>
#include <random>

namespace pmreport::test {

class Matrices {
 public:
  explicit Matrices(std::uint64_t seed) : random_(seed) {}
  Eigen::MatrixXd operator()(Eigen::Index rows, Eigen::Index columns) {
    Eigen::MatrixXd m(rows, columns);
    for (double& x : m.reshaped()) x = std::uniform_real_distribution(-1.0, 1.0)(random_);
    return m;
  }

 private:
  std::mt19937_64 random_;
};

}  // namespace pmreport::test
