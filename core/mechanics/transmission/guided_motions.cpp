#include <core/mechanics/transmission/guided_motions.hpp>

#include <Eigen/LU>

#include <cmath>

namespace pmreport::mechanics {

using Eigen::Index;
using linear::SmallMatrix;

namespace {

bool regular(const SmallMatrix& x, const SmallMatrix& nearly_its_inverse) {
  const SmallMatrix product = x * nearly_its_inverse;
  for (Index i = 0; i < x.rows(); ++i) {
    double rest = 0;
    for (Index k = 0; k < x.rows(); ++k) rest += std::abs(product(i, k) - (i == k ? 1 : 0));
    if (!(rest < 0.5)) return false;
  }
  return true;
}

}  // namespace

std::vector<double> guides_of_motions(const SmallMatrix& a) {
  const Index n = a.rows(), last = n - 1;
  const SmallMatrix unit = SmallMatrix::Identity(n, n);
  SmallMatrix r = unit, s = unit;
  if (a.allFinite()) {
    const Eigen::FullPivLU<SmallMatrix> lu(a);
    const SmallMatrix lower = SmallMatrix(lu.matrixLU().triangularView<Eigen::StrictlyLower>()) + unit;
    SmallMatrix upper = lu.matrixLU().triangularView<Eigen::Upper>();
    upper(last, last) = n > 1 ? upper(last - 1, last - 1) : 1;
    r = lower.triangularView<Eigen::UnitLower>().solve(SmallMatrix(lu.permutationP() * unit));
    s = lu.permutationQ() * SmallMatrix(upper.triangularView<Eigen::Upper>().solve(unit));
    const SmallMatrix to_r = lu.permutationP().inverse() * lower, to_s = upper * SmallMatrix(lu.permutationQ().inverse() * unit);
    if (!(regular(r, to_r) && regular(s, to_s))) r = s = unit;
  }
  std::vector<double> out;
  for (const SmallMatrix* m : {&r, &s})
    for (Index i = 0; i < n; ++i)
      for (Index k = 0; k < n; ++k) out.push_back((*m)(i, k));
  return out;
}

// Gauss and Jordan on [M R] without its last pivot: above are B^-1 b and B^-1 y1, in the last row s and z.
std::vector<std::vector<Recorded>> guided_motions(const std::vector<Recorded>& a, const std::vector<Recorded>& guides, std::size_t n) {
  using Rows = std::vector<std::vector<Recorded>>;
  const auto rows = [n](const std::vector<Recorded>& from, std::size_t first) {
    Rows out(n);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 0; k < n; ++k) out[i].push_back(from[first + i * n + k]);
    return out;
  };
  const auto product = [n](const Rows& x, const Rows& y) {
    Rows out(n, std::vector<Recorded>(n, Recorded(0.0)));
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 0; k < n; ++k)
        for (std::size_t j = 0; j < n; ++j) out[i][k] += x[i][j] * y[j][k];
    return out;
  };
  const Rows r = rows(guides, 0), s = rows(guides, n * n);
  Rows m = product(product(r, rows(a, 0)), s);
  for (std::size_t i = 0; i < n; ++i) m[i].insert(m[i].end(), r[i].begin(), r[i].end());
  const std::size_t last = n - 1;
  for (std::size_t pivot = 0; pivot < last; ++pivot) {
    const Recorded by = 1.0 / m[pivot][pivot];
    for (std::size_t k = pivot + 1; k < 2 * n; ++k) m[pivot][k] *= by;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = pivot + 1; k < 2 * n && i != pivot; ++k) m[i][k] -= m[i][pivot] * m[pivot][k];
  }
  std::vector<std::vector<Recorded>> out(n, std::vector<Recorded>(n, Recorded(0.0)));
  for (std::size_t i = 0; i < n; ++i) {
    const Recorded z = m[last][n + i];
    for (std::size_t k = 0; k < n; ++k) {
      const Recorded w = k == last ? z : m[last][last] * m[k][n + i] - z * m[k][last];
      for (std::size_t c = 0; c < n; ++c) out[i][c] += s[c][k] * w;
    }
  }
  return out;
}

}  // namespace pmreport::mechanics
