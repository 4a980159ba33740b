// The 5PUS-UPU against an independent model (tests/data/5pus-upu.json): the UPU limb with its parasitic rotation, and the paper's gamma =
// 0.
#include <core/mechanics/model/closed_form.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/statics/statics.hpp>
#include <tests/plugins/five_pus_upu.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using nlohmann::json;
using test::check_equal, test::number, test::vector;

namespace {

Machine five_pus_upu_of(const json& c) {
  test::Changes changes = test::model(c["model"]);
  if (c.contains("o6_override")) changes["h6"] = {number(c["o6_override"][2])};
  return Machine(test::five_pus_upu(), test::values_with(test::five_pus_upu(), changes));
}
State five_pus_upu_at(const Machine& machine, const json& c) {
  return test::state_at(machine, vector(c["pose_x_y_z_alpha_beta"]), vector(c["rates"]), vector(c["accels"]));
}
VectorXd row_major(const MatrixXd& m) { return m.transpose().reshaped(); }

VectorXd values_of(const std::vector<Scalar>& all, double Scalar::*part) {
  VectorXd v(static_cast<Eigen::Index>(all.size()));
  for (std::size_t i = 0; i < all.size(); ++i) v(static_cast<Eigen::Index>(i)) = all[i].*part;
  return v;
}

}  // namespace

TEST_CASE("displacement, rates and accelerations of the 5PUS-UPU come out to nine digits") {
  const json file = test::reference("5pus-upu.json");
  REQUIRE(file["cases"].size() == 13);
  for (const json& c : file["cases"]) DYNAMIC_SECTION(c["name"].get<std::string>() << ", " << c["model"].get<std::string>()) {
      const Machine machine = five_pus_upu_of(c);
      const State s = five_pus_upu_at(machine, c);
      const BodyState& platform = s.bodies[static_cast<std::size_t>(machine.topology().platform)];

      REQUIRE(machine.topology().derived[0].name == "gamma");
      check_equal("gamma", s.derived[0].value, number(c["gamma"]), 1.0);
      check_equal("slider heights", values_of(s.actuators, &Scalar::value), vector(c["slider_q"]));
      check_equal("slider rates", values_of(s.actuators, &Scalar::rate), vector(c["slider_qd"]));
      check_equal("slider accelerations", values_of(s.actuators, &Scalar::acceleration), vector(c["slider_qdd"]));
      if (!c.contains("R_rowmajor")) continue;  // the case with U6 above the platform has sliders and gamma alone
      check_equal("rotation", row_major(platform.rotation), vector(c["R_rowmajor"]), 1.0);
      check_equal("balls", test::balls(machine, s), vector(c["S"]));
      check_equal("angular velocity", platform.angular_velocity, vector(c["omega"]));
      check_equal("angular acceleration", platform.angular_acceleration, vector(c["omegadot"]));
    }
}

TEST_CASE("Jacobian, constraint wrench and massless statics of the 5PUS-UPU come out to nine digits") {
  const json file = test::reference("5pus-upu.json");
  for (const json& c : file["cases"]) {
    if (!c.contains("G_5x5_rowmajor")) continue;
    DYNAMIC_SECTION(c["name"].get<std::string>() << ", " << c["model"].get<std::string>()) {
      const Machine machine = five_pus_upu_of(c);
      const State s = five_pus_upu_at(machine, c);
      const VectorXd pose = vector(c["pose_x_y_z_alpha_beta"]);
      const std::span<const double> q{pose.data(), 5};
      check_equal("Eq. (12)", row_major(machine.matrices(q, machine.pose(q)).at(0)), vector(c["G_5x5_rowmajor"]));

      const ClosedForm g = closed_form(machine, s, characteristic_length(machine));
      check_equal("constraint wrench", g.jacobian.row(5).transpose(), vector(c["constraint_wrench_unit"]));

      const Vector6d load = vector(c["wrench"]);
      const VectorXd forces = closed_statics(g, load);
      const json& out = c["static_massless"];
      const double scale = load.lpNorm<Eigen::Infinity>();
      check_equal("slider forces", forces.head(5), vector(out["slider_force"]), scale);
      check_equal("constraint multiplier", forces(5), number(out["constraint_multiplier"]), scale);
      check_equal("wrench of the UPU limb", forces(5) * g.jacobian.row(5).transpose(), vector(out["constraint_limb_wrench_on_platform"]),
                  scale);
      // A slider's force is the share along Z of the axial force of its rod: the rod carries F / n_z, n_z the rise over the length.
      VectorXd axial(5);
      for (int i = 0; i < 5; ++i) axial(i) = forces(i) * g.jacobian.row(i).head(3).norm();
      check_equal("tension of the rods", axial, vector(out["limb_axial_tension"]), scale);
    }
  }
}

TEST_CASE("the 5PUS-UPU declares the bodies of the reference's dynamic model") {
  const json p = test::reference("5pus-upu.json")["parameters"];
  const Machine machine(test::five_pus_upu(), default_values(describe(test::five_pus_upu())));
  const auto axisymmetric = [&](const Body& body, const json& of, double height) {
    INFO(body.name);
    check_equal("mass", body.inertia.mass, number(of["m"]));
    check_equal("centre of mass", body.inertia.centre, Vector3d(0, 0, height));
    const Vector3d diagonal(number(of["It"]), number(of["It"]), number(of["Ia"]));
    CHECK(body.inertia.about_centre.isApprox(MatrixXd(diagonal.asDiagonal()), test::tolerance));
  };
  int rods = 0, sliders = 0, parts = 0;
  for (const Body& body : machine.topology().bodies) {
    CHECK_FALSE(body.slender);
    if (body.name.starts_with("slider")) {
      check_equal("mass of a slider", body.inertia.mass, number(p["slider"]["m"]));
      ++sliders;
    } else if (body.name.starts_with("rod")) {
      axisymmetric(body, p["link"], number(p["link"]["com_from_U"]));
      ++rods;
    } else if (body.name == "leg, lower part") {
      axisymmetric(body, p["upu_lower"], number(p["upu_lower"]["com_from_U6"]));
      ++parts;
    } else if (body.name == "leg, upper part") {
      axisymmetric(body, p["upu_upper"], -number(p["upu_upper"]["com_from_U6p"]));
      ++parts;
    } else if (body.name == "platform") {
      check_equal("mass of the platform", body.inertia.mass, number(p["platform"]["m"]));
      check_equal("centre of mass of the platform", body.inertia.centre, vector(p["platform"]["com"]));
      CHECK(body.inertia.about_centre.isApprox(test::matrix(p["platform"]["I"]), test::tolerance));
      ++parts;
    }
  }
  CHECK(sliders == 5);
  CHECK(rods == 5);
  CHECK(parts == 3);
}
