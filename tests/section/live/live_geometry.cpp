// The geometry that moves a machine in the page gives there what it gives here.
#include <core/mechanics/model/tangent.hpp>
#include <core/mechanics/statics/statics.hpp>
#include <core/program/evaluate.hpp>
#include <core/program/print_javascript.hpp>
#include <reports/section/front/live_geometry.hpp>
#include <tests/recorded_program/apart.hpp>
#include <tests/recorded_program/in_node.hpp>
#include <tests/section/live/house.hpp>

#include <random>

using namespace pmreport;
using namespace pmreport::section;

namespace {

// Poses in the boxes that the mechanism names, one after the other.
std::vector<double> random_poses(const mechanics::Machine& machine, int count) {
  std::mt19937_64 random(31);
  std::vector<double> out;
  for (int k = 0; k < count; ++k)
    for (const Coordinate& c : machine.topology().coordinates)
      out.push_back(c.box.min + (c.box.max - c.box.min) * static_cast<double>(random() >> 11) * 0x1p-53);
  return out;
}

mechanics::Machine made(const std::string& name) {
  return {house::table_of(name), mechanics::default_values(mechanics::describe(house::table_of(name)))};
}

}  // namespace

// The two machines may differ by what their elementary functions do, a unit of the last place each, carried through the operations
// (apart.hpp); what no such function takes part in must be equal to the last bit.
TEST_CASE("the geometry of every mechanism as JavaScript is that of the program, to the last bit where no elementary function has a part") {
  if (!in_node::here()) return;
  constexpr int poses = 10000;
  for (const std::string& name : house::names()) {
    const mechanics::Machine machine = made(name);
    const std::optional<LiveGeometry> g = live_geometry(machine);
    if (!g) continue;
    const std::vector<double> in = random_poses(machine, poses);
    const std::size_t dof = static_cast<std::size_t>(machine.dof()), outputs = g->program.outputs().size();
    in_node::Functions node;
    node.add(program::print_javascript(g->program), dof, outputs, in);
    const std::vector<double> seen = node.run()[0];
    program::Evaluator<apart::Number> evaluator(g->program);
    std::vector<apart::Number> x(dof), y(outputs);
    std::size_t open = 0, equal = 0, wrong = 0;
    for (std::size_t k = 0; k < poses; ++k) {
      std::copy_n(in.begin() + static_cast<std::ptrdiff_t>(k * dof), dof, x.begin());
      evaluator.run(x, y);
      for (std::size_t o = 0; o < outputs; ++o) {
        open += std::isinf(y[o].off), equal += y[o].off == 0;
        if (apart::allows(y[o], seen[k * outputs + o])) continue;
        UNSCOPED_INFO("output " << o << " of pose " << k << ": " << y[o].value << " within " << y[o].off << ", in JavaScript "
                                << seen[k * outputs + o]);
        if (++wrong > 5) break;
      }
      if (wrong > 5) break;
    }
    CAPTURE(name, open, equal);
    CHECK(wrong == 0);
    CHECK(static_cast<double>(open) < 1e-3 * static_cast<double>(poses * outputs));
    CHECK(equal > poses * 3);
  }
}

TEST_CASE("the geometry tells how actuators, platform and weights move, as the tangent of the motion does") {
  for (const std::string& name : house::names()) {
    const mechanics::Machine machine = made(name);
    const std::optional<LiveGeometry> g = live_geometry(machine);
    if (!g) continue;
    const Eigen::Index m = machine.dof();
    program::Evaluator<double> evaluator(g->program);
    std::vector<double> y(g->program.outputs().size());
    const std::vector<double> poses = random_poses(machine, 20);
    for (std::size_t k = 0; k < 20; ++k) {
      const std::span<const double> x(poses.data() + k * static_cast<std::size_t>(m), static_cast<std::size_t>(m));
      const mechanics::State state = mechanics::state_at_rest(machine, Eigen::Map<const Eigen::VectorXd>(x.data(), m));
      if (state.status != PM_OK) continue;
      const mechanics::Tangent t = mechanics::tangent(machine, state);
      if (!t.by_coordinates) continue;
      evaluator.run(x, y);
      using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
      const Eigen::MatrixXd rates = Eigen::Map<const Rows>(&y[g->rates], m, m), twist = Eigen::Map<const Rows>(&y[g->twist], 6, m),
                            masses = Eigen::Map<const Rows>(&y[g->masses], 3, m);
      const Eigen::MatrixXd platform = t.bodies.middleRows<6>(6 * machine.topology().platform - 6);
      const Eigen::Vector3d gravity(1, -2, 3);
      const Eigen::VectorXd weights = t.bodies.transpose() * mechanics::weights(machine, state, gravity);
      CAPTURE(name, k);
      CHECK((rates - t.actuators).norm() <= 1e-11 * t.actuators.norm());
      CHECK((twist - platform).norm() <= 1e-11 * platform.norm());
      CHECK((masses.transpose() * gravity - weights).norm() <= 1e-11 * (1 + weights.norm()));
    }
  }
}
