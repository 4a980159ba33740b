#include <tests/plugins/hexapods.hpp>

namespace pmreport::test {

std::unique_ptr<Machine> hexapod(const std::string& name) {
  const bool cross = name == "cross1" || name == "cross2";
  const pm_mechanism& table = plugin(cross ? "parallel-cross" : name);
  std::map<std::string, std::vector<double>> changes;
  if (cross) changes["variant"] = {choice(table, "variant", name == "cross1" ? "inner" : "outer")};
  return std::make_unique<Machine>(table, values_with(table, changes));
}

double det_at_yaw(const Machine& machine, double alpha) {
  Eigen::VectorXd q = machine.home();
  q(3) = alpha;
  const mechanics::Pose pose = machine.pose({q.data(), 6});
  Eigen::Matrix<double, 6, 6, Eigen::RowMajor> g;
  machine.jacobian(PM_VALUE, 1, pose.numbers.data(), g.data());
  return g.determinant();
}

double singular_yaw(const Machine& machine, double low, double high) {
  const bool sign = det_at_yaw(machine, low * deg) > 0;
  REQUIRE(sign != (det_at_yaw(machine, high * deg) > 0));
  for (int k = 0; k < 100; ++k) {
    const double middle = 0.5 * (low + high);
    ((det_at_yaw(machine, middle * deg) > 0) == sign ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

void check_matrix(const char* what, const Eigen::MatrixXd& seen, const Eigen::MatrixXd& expected) {
  REQUIRE(seen.rows() == expected.rows());
  for (Eigen::Index r = 0; r < seen.rows(); ++r)
    check_equal(what, seen.row(r).transpose(), expected.row(r).transpose(), expected.row(r).lpNorm<Eigen::Infinity>());
}

void check_centres(const mechanics::State& s, const Machine& machine, const std::string& letter, const json& points, std::size_t first) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string name = letter + std::to_string((i + first) % points.size() + 1);
    check_equal(name.c_str(), s.joints[static_cast<std::size_t>(joint_named(machine, name))].centre, vector(points[i]));
  }
}

std::size_t first_head(const json& c) { return c["mechanism"] == "stewart" ? 0 : 1; }

mechanics::State state_of(const Machine& machine, const json& c) {
  const Eigen::VectorXd q = vector(c["pose"]), rates = vector(c["euler_rates"]), accelerations = vector(c["euler_acc"]);
  mechanics::State s;
  mechanics::evaluate(machine, q.data(), rates.data(), accelerations.data(), s);
  REQUIRE(s.status == PM_OK);
  return s;
}

void check_case(const json& c) {
  const std::unique_ptr<Machine> machine = hexapod(c["mechanism"]);
  const mechanics::State s = state_of(*machine, c);
  const mechanics::BodyState& platform = s.bodies[static_cast<std::size_t>(machine->topology().platform)];

  check_matrix("R", platform.rotation, matrix(c["R"]));
  check_centres(s, *machine, "A", c["A_points"]);
  check_centres(s, *machine, "B", c["B_points"]);
  check_centres(s, *machine, "C", c["C_points"]);
  check_centres(s, *machine, "D", c["D_points"], first_head(c));
  check_equal("twist", platform.twist(), vector(c["twist"]));

  Eigen::VectorXd lengths(6);
  for (int i = 0; i < 6; ++i) lengths(i) = s.actuators[static_cast<std::size_t>(i)].value;
  check_equal("lengths", lengths, vector(c["q"]));
  check_equal("rates", mechanics::actuator_rates(s), vector(c["qdot"]));
  check_equal("accelerations", mechanics::actuator_accelerations(s), vector(c["qddot"]));

  const Eigen::VectorXd q = vector(c["pose"]);
  const std::vector<Eigen::MatrixXd> source = machine->matrices({q.data(), 6}, machine->pose({q.data(), 6}));
  REQUIRE(source.size() == 3);
  check_matrix("A", source[0], matrix(c["A"]));
  check_matrix("B", source[1], matrix(c["B"]));
  check_equal("det A", source[0].determinant(), number(c["detA"]));
  check_equal("det B", source[1].determinant(), number(c["detB"]));
  check_equal("D X'", source[2] * vector(c["euler_rates"]), vector(c["twist"]));

  const mechanics::ClosedForm g = mechanics::closed_form(*machine, s, 1.0);  // 1 m: metres and radians side by side, as in the reference
  check_matrix("G", g.jacobian, matrix(c["Jinv"]));
  check_equal("det G", g.determinant, number(c["detJinv"]));
  check_equal("condition", g.condition, number(c["cond_Jinv"]));
  check_equal("massless statics", mechanics::closed_statics(g, vector(c["static_wrench_on_platform"])), vector(c["static_tau_balance"]));
}

void check_cases(const std::string& mechanism) {
  const json file = reference("parallel-cross.json");
  int seen = 0;
  for (const json& c : file["cases"])
    if (c["mechanism"] == mechanism) {
      CAPTURE(c["id"]);
      check_case(c);
      ++seen;
    }
  CHECK(seen == 2);
}

void check_cylinder(const Body& body, const json& solid, double low, double high) {
  CAPTURE(body.name);
  const double m = number(solid["m"]), r = number(solid["r"]), length = high - low;
  const double mean_xx = r * r / 4, mean_zz = length * length / 12;
  check_equal("mass", body.inertia.mass, m);
  check_equal("centre of mass", body.inertia.centre, Eigen::Vector3d(0, 0, (low + high) / 2), length);
  check_equal("inertia", body.inertia.about_centre.diagonal(), m * Eigen::Vector3d(mean_xx + mean_zz, mean_xx + mean_zz, 2 * mean_xx));
  CHECK(body.inertia.about_centre.isDiagonal());
}

const Body& body_named(const Machine& machine, const std::string& name) {
  for (const Body& b : machine.topology().bodies)
    if (b.name == name) return b;
  throw std::out_of_range("no body is called " + name);
}

const mechanics::BodyState& body_state(const Machine& machine, const mechanics::State& s, const std::string& name) {
  return s.bodies[static_cast<std::size_t>(&body_named(machine, name) - machine.topology().bodies.data())];
}

double angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

std::string refusal(const std::string& name, const std::map<std::string, std::vector<double>>& changes) {
  const pm_mechanism& table = plugin(name);
  try {
    const Machine machine(table, values_with(table, changes));
  } catch (const mechanics::MechanismError& e) {
    CHECK(e.status == PM_BAD_ARGUMENT);
    return e.what();
  }
  return "accepted";
}

void check_spins(const json& c, const json& on_leg) {
  const std::unique_ptr<Machine> machine = hexapod(c["mechanism"]);
  const mechanics::State s = state_of(*machine, c);
  const auto check = [&](const std::string& kind, std::size_t number, const Eigen::Vector3d& e2, const Eigen::Vector3d& u) {
    for (const char* part : {" cylinder ", " rod "}) {
      const mechanics::BodyState& body = body_state(*machine, s, kind + part + std::to_string(number));
      check_equal("x axis", body.rotation.col(0), e2);
      check_equal("z axis", body.rotation.col(2), u);
    }
  };
  Eigen::Matrix3d leg[3];  // u, e2, u x e2
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d a = vector(c["A_points"][i]), b = vector(c["B_points"][i]), u = (b - a).normalized();
    const Eigen::Vector3d e1 = matrix(c["R"]) * Eigen::Vector3d::UnitZ().cross(a).normalized();  // b_i and A_i have the same azimuth
    const Eigen::Vector3d e2 = e1.cross(u).normalized();
    leg[i] << u, e2, u.cross(e2);
    check("leg", i + 1, e2, u);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d f = (Eigen::Vector3d(vector(c["D_points"][i])) - vector3(c["C_points"][i])).normalized();
    check("cross", i + 4, (leg[(i + first_head(c)) % 3] * Eigen::Vector3d(vector(on_leg[i]))).cross(f).normalized(), f);
  }
}

}  // namespace pmreport::test
