// The bounds of a box of poses hold for the poses in it, of every mechanism there is.
#include <core/program/intervals/boxes.hpp>
#include <tests/plugins/every_mechanism.hpp>

#include <numeric>

using namespace pmreport;
using namespace pmreport::test;
using program::Bounds;

TEST_CASE("the bounds of a box hold the placement and G of every pose in it") {
  constexpr std::size_t boxes = 40, poses = 5;
  for (const Named& mechanism : every_mechanism()) {
    const mechanics::Machine& machine = *mechanism.machine;
    const program::Program* geometry = machine.program();
    REQUIRE(geometry != nullptr);
    const std::size_t dof = static_cast<std::size_t>(machine.dof()), outputs = geometry->outputs().size();
    constexpr std::uint64_t seed = 31;
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> share(0, 1);
    CAPTURE(mechanism.name, seed);

    std::vector<Bounds> in(dof * boxes), out(outputs * boxes);
    for (std::size_t k = 0; k < boxes; ++k) {
      const double size = std::exp2(-4 - 30 * share(random));
      for (std::size_t i = 0; i < dof; ++i) {
        const Range& box = machine.topology().coordinates[i].box;
        const double low = box.min + (0.3 + 0.4 * share(random)) * (box.max - box.min);
        in[i * boxes + k] = {low, low + size * (box.max - box.min)};
      }
    }
    program::Boxes(*geometry).run(boxes, in.data(), out.data());

    std::size_t held = 0;
    std::vector<double> q(dof), all(outputs);
    for (std::size_t k = 0; k < boxes; ++k)
      for (std::size_t pose = 0; pose < poses; ++pose) {
        for (std::size_t i = 0; i < dof; ++i) {
          const Bounds& b = in[i * boxes + k];
          q[i] = std::clamp(b.low + share(random) * b.width(), b.low, b.high);
        }
        if (machine.place(PM_VALUE, 1, q.data(), all.data()) != PM_OK) continue;
        if (machine.jacobian(PM_VALUE, 1, all.data(), all.data() + machine.layout().size()) != PM_OK) continue;
        for (std::size_t o = 0; o < outputs; ++o) {
          const Bounds& b = out[o * boxes + k];
          // A plugin's sums are rounded, and in another order than the program's: by some 1e-16 of their terms, a few hundred at most.
          const double rounding = 1e-13 * std::max(1.0, std::abs(all[o]));
          if (!b.bounded() || (b.low - rounding <= all[o] && all[o] <= b.high + rounding)) {
            held += b.bounded() ? 1 : 0;
            continue;
          }
          CAPTURE(k, o, b.low, b.high);
          CHECK(b.low <= all[o]);
          CHECK(all[o] <= b.high);
        }
      }
    CHECK(held > boxes * poses * outputs / 2);
  }
}
