// CalculiX, asked what is known, before it judges.
#include <tests/judges/calculix_deck.hpp>

#include <catch2/catch.hpp>

#include <Eigen/Geometry>

using Eigen::Vector3d;
using pmreport::judges::CalculixDeck;
using pmreport::judges::Matrix6d;
using pmreport::judges::Vector6d;
namespace judges = pmreport::judges;

namespace {

// CalculiX prints seven digits: 5e-7 of a displacement, and of what is made of several, or stands across the largest, some more. Seen:
// 6e-7 of a compliance, 2.5e-6 with a bearing in every joint of 2q-spr.
constexpr double printed = 5e-6;

// Largest difference of two forms that are not negative, entry (i, j) by what it can be at most, sqrt(A_ii A_jj).
double difference(const Matrix6d& a, const Matrix6d& b) {
  const Vector6d scale = a.diagonal().cwiseSqrt().cwiseInverse();
  return (scale.asDiagonal() * (b - a) * scale.asDiagonal()).cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("a cantilever in CalculiX gives way as Euler and Bernoulli have it, across both of its directions, and twists") {
  const double length = 0.8, bends_x = 1000, bends_y = 3000, axial = 2e7;
  const Vector3d foot(0.1, 0.2, 0.3), n = Vector3d(1, 2, -0.5).normalized(), x = n.unitOrthogonal(), y = n.cross(x);
  for (const double torsion : {2500.0, 700.0}) {  // Poisson's ratio -0.2; and 1.9, which no material has, but a rectangle may seem to
    CalculixDeck deck;
    const int root = deck.add_node(foot);
    int end = root;
    for (int i = 1; i <= 4; ++i) {
      const int next = deck.add_node(foot + n * (0.25 * i * length));
      deck.add_bar(end, next, {axial, torsion, bends_x, bends_y, x});
      end = next;
    }
    for (int k = 0; k < 6; ++k) deck.relate({{root, k, 1}});
    Matrix6d axes = Matrix6d::Zero();
    axes.topLeftCorner<3, 3>() << x, y, n;
    axes.bottomRightCorner<3, 3>() = axes.topLeftCorner<3, 3>();
    std::vector<CalculixDeck::Loads> loads;
    for (int k = 0; k < 6; ++k) loads.push_back({{end, axes.col(k)}});
    const std::vector<judges::Displacements> found = deck.solve(loads, {end});
    Matrix6d expected = Matrix6d::Zero(), seen;
    expected.diagonal() << std::pow(length, 3) / 3 / bends_y, std::pow(length, 3) / 3 / bends_x, length / axial, length / bends_x,
        length / bends_y, length / torsion;
    expected(0, 4) = expected(4, 0) = length * length / 2 / bends_y;
    expected(1, 3) = expected(3, 1) = -length * length / 2 / bends_x;
    for (int k = 0; k < 6; ++k) seen.col(k) = axes.transpose() * found[static_cast<std::size_t>(k)];
    CAPTURE(torsion, seen, expected);
    CHECK(difference(expected, seen) <= printed);
  }
}
