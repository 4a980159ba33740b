// Architectures that are singular at every pose, and are told so; sound ones, and ones that are singular at home alone, are not.
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/singularity/singularity.hpp>
#include <tests/plugins/every_mechanism.hpp>
#include <tests/plugins/hexapods.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Vector3d;

namespace {

using Points = std::array<Vector3d, 6>;

Points regular_ring(double radius, const std::array<double, 6>& degrees) {
  Points out;
  for (std::size_t i = 0; i < 6; ++i) out[i] = radius * Vector3d(std::cos(degrees[i] * deg), std::sin(degrees[i] * deg), 0);
  return out;
}
bool is_singular_everywhere(const Points& base, const Points& platform) {
  const auto flat = [](const Points& points) {
    std::vector<double> out;
    for (const Vector3d& p : points) out.insert(out.end(), {p.x(), p.y(), p.z()});
    return out;
  };
  const pm_mechanism& table = test::plugin("gough");
  const Machine machine(table, test::values_with(table, {{"base_points", flat(base)}, {"platform_points", flat(platform)}}));
  return singular_everywhere(machine, characteristic_length(machine));
}

constexpr std::array<double, 6> uneven{-20, 20, 100, 140, 220, 260};

}  // namespace

TEST_CASE("similar hexagons, a leg twice, and corners over the middles of sides are singular at every pose") {
  CHECK(is_singular_everywhere(regular_ring(0.3, uneven), regular_ring(0.2, uneven)));
  Points base = regular_ring(0.3, {-10, 10, 110, 130, 230, 250}), platform = regular_ring(0.2, {-50, 50, 70, 170, 190, 290});
  CHECK_FALSE(is_singular_everywhere(base, platform));
  base[1] = base[0], platform[1] = platform[0];
  CHECK(is_singular_everywhere(base, platform));
  // Base and platform triangles of the same vertices twice each, the platform's over the base's.
  CHECK(is_singular_everywhere(regular_ring(0.3, {0, 0, 120, 120, 240, 240}), regular_ring(0.2, {0, 0, 120, 120, 240, 240})));
}

TEST_CASE("a hexagon that is similar but for a millimetre is regular, if poorly") {
  Points platform = regular_ring(0.2, uneven);
  platform[3] += Vector3d(0.001, 0, 0);
  CHECK_FALSE(is_singular_everywhere(regular_ring(0.3, uneven), platform));
}

TEST_CASE("no mechanism of the house is singular at every pose") {
  for (const auto& [name, machine] : test::every_mechanism()) {
    INFO(name);
    CHECK_FALSE(singular_everywhere(*machine, characteristic_length(*machine)));
  }
}
