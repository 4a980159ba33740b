// Motions with one actuator alone, by guides: of matrices whose inverse is known, and of those that have none.
#include <core/linear/square.hpp>
#include <core/mechanics/transmission/guided_motions.hpp>
#include <core/program/evaluate.hpp>
#include <core/program/recorder.hpp>

#include <catch2/catch.hpp>

#include <random>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Index;
using linear::SmallMatrix, linear::SmallVector;

namespace {

// u_i as columns.
SmallMatrix motions(const SmallMatrix& a, const std::vector<double>& guides) {
  const auto n = static_cast<std::size_t>(a.rows());
  program::Recorder r(static_cast<int>(n * n + guides.size()));
  std::vector<Recorded> entries, guide, outputs;
  std::vector<double> in;
  for (std::size_t e = 0; e < n * n; ++e) {
    entries.push_back(r.input(static_cast<int>(e)));
    in.push_back(a(static_cast<Index>(e / n), static_cast<Index>(e % n)));
  }
  for (std::size_t g = 0; g < guides.size(); ++g) guide.push_back(r.input(static_cast<int>(n * n + g)));
  in.insert(in.end(), guides.begin(), guides.end());
  for (const auto& u : guided_motions(entries, guide, n)) outputs.insert(outputs.end(), u.begin(), u.end());
  std::vector<double> out(outputs.size());
  program::Evaluator<double>(r.finish(outputs)).run(in, out);
  return Eigen::Map<const Eigen::MatrixXd>(out.data(), a.rows(), a.rows());
}

SmallMatrix random_matrix(Index n, std::mt19937_64& random) {
  std::uniform_real_distribution<double> entry(-1, 1);
  return SmallMatrix::NullaryExpr(n, n, [&] { return entry(random); });
}

}  // namespace

TEST_CASE("each motion moves its own actuator alone, whatever matrix the guides were chosen for") {
  std::mt19937_64 random(5);
  for (Index n = 1; n <= 6; ++n)
    for (int trial = 0; trial < 20; ++trial) {
      const SmallMatrix a = random_matrix(n, random), other = a + 0.05 * random_matrix(n, random);
      const SmallMatrix moved = a * motions(a, guides_of_motions(other));
      for (Index i = 0; i < n; ++i)
        for (Index k = 0; k < n; ++k)
          if (i != k) CHECK(std::abs(moved(i, k)) <= 1e-9 * std::abs(moved(k, k)));
    }
}

TEST_CASE("where the matrix is singular every motion is its null vector, and not lost") {
  std::mt19937_64 random(7);
  for (Index n = 2; n <= 6; ++n) {
    SmallMatrix a = random_matrix(n, random);
    a.row(n / 2) = a.topRows(n / 2).colwise().sum() - 2 * a.bottomRows(n - n / 2 - 1).colwise().sum();
    const SmallMatrix u = motions(a, guides_of_motions(a));
    for (Index i = 0; i < n; ++i) {
      CHECK(u.col(i).norm() > 1e-3);
      CHECK((a * u.col(i)).norm() <= 1e-12 * u.col(i).norm());
    }
  }
}

TEST_CASE("guides are regular, of matrices that are no numbers and of zero too") {
  for (const double entry : {0.0, 1.0, std::nan(""), std::numeric_limits<double>::infinity(), 1e300, 1e-300}) {
    const std::vector<double> guides = guides_of_motions(SmallMatrix::Constant(3, 3, entry));
    REQUIRE(guides.size() == guides_of_motions(std::size_t{3}));
    for (const std::size_t first : {std::size_t{0}, std::size_t{9}}) {
      const SmallMatrix m = Eigen::Map<const Eigen::Matrix3d>(guides.data() + first);
      CHECK(m.allFinite());
      CHECK(linear::SmallFactors(m).determinant() != 0);
    }
  }
}
