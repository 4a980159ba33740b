// The constraints of all bodies, limb by limb, against all of them at once.
#include <core/linear/singular_values.hpp>
#include <core/mechanics/model/closed_form.hpp>
#include <core/mechanics/model/constraint_scale.hpp>
#include <core/mechanics/model/random_poses.hpp>
#include <core/mechanics/singularity/body_freedoms.hpp>
#include <core/numbers.hpp>
#include <tests/plugins/every_mechanism.hpp>
#include <tests/plugins/par4.hpp>

#include <Eigen/SVD>

using namespace pmreport;
using namespace pmreport::mechanics;

namespace {

// Motions of all bodies with the actuators locked, by singular values: as many as the idle freedoms, where nothing is lost.
Eigen::Index freedoms(const Machine& machine, const State& s, bool locked) {
  const GenericModel model = generic_model(machine, s);
  const double length = characteristic_length(machine);
  Eigen::MatrixXd all(model.constraints.rows() + (locked ? model.actuation.rows() : 0), model.constraints.cols());
  all.topRows(model.constraints.rows()) = model.constraints;
  if (locked) all.bottomRows(model.actuation.rows()) = model.actuation;
  return linear::null_space_by_singular_values(unit_rows(all, length)).cols();
}

}  // namespace

TEST_CASE("at regular poses no margin vanishes, and the constraints of all bodies leave the idle freedoms alone") {
  for (const auto& [name, machine] : test::every_mechanism()) {
    INFO(name);
    const BodyFreedoms bodies(*machine);
    for (const Eigen::VectorXd& q : random_poses(*machine, 5, 3)) {
      const State s = state_at_rest(*machine, q);
      REQUIRE(freedoms(*machine, s, true) == machine->topology().idle);
      REQUIRE(freedoms(*machine, s, false) == machine->topology().idle + machine->dof());
      for (const double margin : bodies.at(s)) CHECK(margin > 1e-4);
    }
  }
}

TEST_CASE("where the plate of a Par4 is flat the bodies' margin vanishes, with all actuators locked alone, and det G is regular") {
  const pm_mechanism& table = test::par4();
  const Machine machine(table, test::values_with(table, {{"plate_angle", {60 * deg}}}));
  const BodyFreedoms bodies(machine);
  const double length = characteristic_length(machine);
  double before = 1;
  for (const double left : {1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 0.0}) {
    INFO(left << " rad before the plate is flat");
    const State s = test::par4_at(machine, {machine.home()(0), machine.home()(1), -0.75, 60 * deg - left});
    const BodyFreedoms::Margins m = bodies.at(s);
    CHECK(m[BodyFreedoms::locked] < before);
    CHECK(m[BodyFreedoms::limb] > 0.1 * bodies.at_home()[BodyFreedoms::limb]);
    CHECK(m[BodyFreedoms::limb_locked] > 0.1 * bodies.at_home()[BodyFreedoms::limb_locked]);
    CHECK(closed_form(machine, s, length).side != 0);
    before = m[BodyFreedoms::locked] + 1e-15;
    if (left > 0) continue;
    CHECK(m[BodyFreedoms::locked] < 1e-12);
    CHECK(freedoms(machine, s, true) == machine.topology().idle + 1);
  }
}
