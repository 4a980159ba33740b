// Indices of transmission: tests/data/transmission.json, computed from positions in 50 digits, and what the literature says of them.
#include <core/mechanics/model/random_poses.hpp>
#include <core/mechanics/transmission/transmission.hpp>
#include <tests/plugins/every_mechanism.hpp>
#include <tests/plugins/hexapods.hpp>
#include <tests/plugins/p2prpu_prps.hpp>

#include <Eigen/Geometry>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::AngleAxisd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using nlohmann::json;
using test::check_equal;

namespace {

std::unique_ptr<Machine> transmitting_machine_of(const json& c) {
  const pm_mechanism& table = test::plugin(c["mechanism"]);
  std::map<std::string, std::vector<double>> changes;
  for (const auto& [name, value] : c["parameters"].items()) {
    if (value.is_array())
      changes[name] = value.get<std::vector<double>>();
    else
      changes[name] = {value.is_string() ? test::choice(table, name, value) : value.get<double>()};
  }
  return std::make_unique<Machine>(table, test::values_with(table, changes));
}

TransmissionIndices indices(const Transmission& t, const VectorXd& q) {
  const auto out = t.at({q.data(), static_cast<std::size_t>(q.size())});
  REQUIRE(out);
  return *out;
}

void check_transmission(const json& c) {
  CAPTURE(c["id"].get<std::string>());
  const auto m = transmitting_machine_of(c);
  const json& e = c["expected"];
  const double length = e.contains("characteristic_length") ? e["characteristic_length"].get<double>() : 0;
  const Transmission t(*m, length);
  VectorXd q(m->dof());
  for (int i = 0; i < m->dof(); ++i) q(i) = c["pose"][m->topology().coordinates[static_cast<std::size_t>(i)].name];
  const TransmissionIndices at = indices(t, q);

  for (std::size_t i = 0; i < e["actuators"].size(); ++i) {
    const json& expected = e["actuators"][i];
    const auto& seen = at.actuators[i];
    CAPTURE(expected["actuator"].get<std::string>());
    check_equal("output twist", seen.twist, test::vector(expected["output_twist"]));
    const Vector3d force = test::vector3(expected["force_direction"]);
    check_equal("force", seen.force.dot(force) < 0 ? VectorXd(-seen.force) : VectorXd(seen.force), force);
    check_equal("velocity", seen.velocity, test::vector(expected["point_velocity"]));
    check_equal("cosine", seen.cosine, expected["cosine"], 1);
    if (!expected.contains("output_transmission")) continue;
    check_equal("output", seen.output, expected["output_transmission"], 1);
    check_equal("input", seen.input, expected["input_transmission"], 1);
  }
  if (e.contains("local_transmission_index"))
    check_equal("local", at.local, e["local_transmission_index"], 1);
  else
    CHECK(std::isnan(at.local));
  check_equal("condition", at.condition, e.contains("condition") ? e["condition"] : e["condition_translation"]);
  if (e.contains("condition")) {
    check_equal("conditioning", at.conditioning, e["local_conditioning_index"]);
    check_equal("manipulability", at.manipulability, e["manipulability"]);
  }
  if (!e.contains("constraint_transmission")) return;
  for (std::size_t k = 0; k < e["constraint_transmission"].size(); ++k)
    check_equal("constraint", at.constraints[k], e["constraint_transmission"][k], 1);
}

// The indices that a machine has, one after the other.
VectorXd all_of(const Transmission& t, const VectorXd& q) {
  const TransmissionIndices at = indices(t, q);
  std::vector<double> out;
  for (int i = 0; i < t.machine().dof(); ++i) {
    const auto& a = at.actuators[static_cast<std::size_t>(i)];
    if (t.has_pressure(i)) out.push_back(a.cosine);
    if (t.has_output(i)) out.insert(out.end(), {a.output, a.input});
  }
  for (int k = 0; k < 6 - t.machine().dof(); ++k)
    if (t.has_constraint(k)) out.push_back(at.constraints[static_cast<std::size_t>(k)]);
  out.push_back(at.conditioning);
  return Eigen::Map<VectorXd>(out.data(), static_cast<Eigen::Index>(out.size()));
}

const pm_mechanism& gough() { return test::plugin("gough"); }

// Feet and heads of a hexapod, moved by a rotation and a shift, scaled, and in another order.
struct DrivenPoints {
  std::vector<Vector3d> a, b;
  std::unique_ptr<Machine> machine(double scale = 1, const Eigen::Matrix3d& of_base = Eigen::Matrix3d::Identity(),
                                   const Vector3d& shift = Vector3d::Zero(), const std::vector<std::size_t>& order = {0, 1, 2, 3, 4, 5},
                                   const Vector3d& home = {0, 0, 0.9}) const {
    std::vector<double> feet, heads;
    for (const std::size_t i : order)
      for (int k = 0; k < 3; ++k) feet.push_back(scale * (of_base * a[i] + shift)(k)), heads.push_back(scale * b[i](k));
    const Vector3d at = scale * (of_base * home + shift);
    return std::make_unique<Machine>(gough(), test::values_with(gough(), {{"base_points", feet},
                                                                          {"platform_points", heads},
                                                                          {"home_position", {at.x(), at.y(), at.z()}},
                                                                          {"stroke_min", {0.1 * scale}},
                                                                          {"stroke_max", {100}}}));
  }
};
DrivenPoints irregular() {
  DrivenPoints p;
  for (int i = 0; i < 6; ++i) {
    const double at = (60 * i + 7 * i * i) * deg, on = (60 * i + (i % 2 == 0 ? 40 : -35)) * deg;
    p.a.emplace_back(0.4 * std::cos(at), 0.35 * std::sin(at), 0.02 * i);
    p.b.emplace_back(0.2 * std::cos(on), 0.22 * std::sin(on), 0.01 * i);
  }
  return p;
}

}  // namespace

TEST_CASE("indices of transmission equal those from moved actuators in 50 digits") {
  int poses = 0;
  for (const json& c : test::reference("transmission.json")["cases"])
    if (c["kind"] == "pose") check_transmission(c), ++poses;
  CHECK(poses == 11);
}

TEST_CASE("the cubic hexapod transmits 2 over the root of 5 at its centre, at pressure angles of 26.565 degrees") {
  // Legs along the edges of a cube that stands on a corner: feet and heads are its other corners, at a third and two thirds of its height.
  const double height = 0.1, edge = height * std::sqrt(3.0), radius = edge * std::sqrt(2.0 / 3);
  std::vector<double> feet, heads;
  for (int i = 0; i < 3; ++i)
    for (const int side : {-1, 1}) {
      const double low = 120 * i * deg, high = low + side * 60 * deg;
      feet.insert(feet.end(), {radius * std::cos(low), radius * std::sin(low), 0});
      heads.insert(heads.end(), {radius * std::cos(high), radius * std::sin(high), height / 2});
    }
  const Machine m(gough(), test::values_with(gough(), {{"base_points", feet},
                                                       {"platform_points", heads},
                                                       {"home_position", {0, 0, height / 2}},
                                                       {"stroke_min", {0.01}},
                                                       {"stroke_max", {1}}}));
  const TransmissionIndices at = indices(Transmission(m), m.home());
  for (const auto& leg : at.actuators) {
    CHECK(leg.output == Approx(2 / std::sqrt(5.0)).epsilon(1e-12));
    CHECK(std::acos(leg.cosine) / deg == Approx(26.565).margin(5e-4));
    CHECK(leg.input == Approx(1).epsilon(1e-14));
  }
  CHECK(at.local == Approx(2 / std::sqrt(5.0)).epsilon(1e-12));
}

TEST_CASE("at zero tilt the limbs of the P(2PRPU)/PRPS transmit z over their lengths, and their maps are as the paper says") {
  const Machine m(test::p2prpu_prps(), default_values(describe(test::p2prpu_prps())));
  const Transmission t(m);
  const auto mu = [&](double x, double y, double z) {
    const TransmissionIndices at = indices(t, (VectorXd(5) << x, y, z, 0, 0).finished());
    return Vector3d(at.actuators[2].output, at.actuators[3].output, at.actuators[4].output);
  };
  const int l1 = m.layout().actuator(2) != 0 ? static_cast<int>(m.layout().actuator(2)) : -1;
  for (const double x : {0.6, 0.8, 1.1})
    for (const double y : {-0.5, -0.1, 0.0, 0.3}) {
      const double z = 1.15;
      const VectorXd q = (VectorXd(5) << x, y, z, 0, 0).finished();
      const Pose pose = m.pose({q.data(), 5});
      const Vector3d here = mu(x, y, z);
      for (int i = 0; i < 3; ++i) CHECK(here(i) == Approx(z / pose.numbers[static_cast<std::size_t>(l1 + i)]).epsilon(1e-12));
      const Vector3d mirrored = mu(x, -y, z);
      CHECK(here(0) == Approx(mirrored(0)).epsilon(1e-12));  // of limb 1 the mirror image is itself, and y does not matter at all
      CHECK(here(0) == Approx(mu(x, 0.42, z)(0)).epsilon(1e-12));
      CHECK(here(1) == Approx(mirrored(2)).epsilon(1e-12));
      CHECK(mu(x + 0.05, y, z)(0) < here(0) - 1e-4);
    }
}

TEST_CASE("the P(2PRPU)/PRPS reads the paper's index of its limbs, which is their output transmission at every pose") {
  const Machine m(test::p2prpu_prps(), default_values(describe(test::p2prpu_prps())));
  const Transmission t(m);
  for (const VectorXd& q : random_poses(m, 20, 9)) {
    const TransmissionIndices at = indices(t, q);
    for (int i = 0; i < 3; ++i)
      CHECK(at.actuators[static_cast<std::size_t>(2 + i)].output ==
            Approx(test::reading(m, q, "mu" + std::to_string(i + 1))).epsilon(1e-11));
  }
}

TEST_CASE("pressure angles of the four mechanisms of six degrees of freedom are those of their own model, at home and elsewhere") {
  // [rad], of the model that made parallel-cross.json.
  const struct {
    const char* name;
    std::array<double, 6> pose, angles;
  } cases[] = {
      {"gough",
       {0.0, 0.0, 0.95, 0.0, 0.0, 0.0},
       {1.219910664118132, 1.219910664118132, 1.219910664118132, 1.219910664118132, 1.219910664118132, 1.219910664118132}},
      {"gough",
       {0.1, -0.05, 0.9, 0.2, -0.15, 0.1},
       {1.2114765116030342, 1.2210054864996067, 1.214421610541845, 1.1916600457261128, 1.1944574919344109, 1.204479238328449}},
      {"stewart",
       {0.0, 0.0, 0.95, 0.0, 0.0, 0.0},
       {0.10444818901051646, 0.10444818901051646, 0.10444818901051646, 0.5866230407034159, 0.5866230407034158, 0.5866230407034159}},
      {"stewart",
       {0.1, -0.05, 0.9, 0.2, -0.15, 0.1},
       {0.13666148086759192, 0.06023288338235089, 0.28116288207537016, 0.43013834247392535, 0.5018572435978507, 0.42505819367744985}},
      {"cross1",
       {0.0, 0.0, 0.95, 0.0, 0.0, 0.0},
       {0.14181429825910005, 0.14181429825910005, 0.14181429825910005, 0.9656184410956694, 0.9656184410956693, 0.9656184410956694}},
      {"cross1",
       {0.1, -0.05, 0.9, 0.2, -0.15, 0.1},
       {0.144916615090861, 0.10820297239427516, 0.592680273677635, 1.157236191966071, 1.0936521014586118, 1.1486770912271633}},
      {"cross2",
       {0.0, 0.0, 0.95, 0.0, 0.0, 0.0},
       {0.24385398713524392, 0.24385398713524392, 0.24385398713524392, 1.1531204536598962, 1.153120453659896, 1.1531204536598962}},
      {"cross2",
       {0.1, -0.05, 0.9, 0.2, -0.15, 0.1},
       {0.6797626470733367, 0.09969751718792025, 1.4067562601291534, 1.517892732236016, 1.525772051993539, 1.530857571371746}}};
  for (const auto& c : cases) {
    CAPTURE(c.name);
    const auto m = test::hexapod(c.name);
    const TransmissionIndices at = indices(Transmission(*m), Eigen::Map<const VectorXd>(c.pose.data(), 6));
    for (std::size_t i = 0; i < 6; ++i) check_equal("angle", std::acos(at.actuators[i].cosine), c.angles[i], 1);
  }
}

TEST_CASE("indices depend neither on the frame nor on the unit of length nor on the order of the limbs") {
  const DrivenPoints p = irregular();
  const auto m = p.machine();
  const Transmission t(*m);
  const VectorXd q = (VectorXd(6) << 0.05, -0.04, 0.95, 0.1, -0.08, 0.12).finished();
  const VectorXd here = all_of(t, q);
  REQUIRE(here.size() == 19);

  const auto larger = p.machine(100);
  VectorXd q_larger = q;
  q_larger.head<3>() *= 100;
  check_equal("unit", all_of(Transmission(*larger), q_larger), here, 1);

  const std::vector<std::size_t> order{3, 5, 0, 1, 4, 2};
  const VectorXd reordered = all_of(Transmission(*p.machine(1, Eigen::Matrix3d::Identity(), Vector3d::Zero(), order)), q);
  for (std::size_t i = 0; i < 6; ++i)
    for (int k = 0; k < 3; ++k)
      CHECK(reordered(3 * static_cast<int>(i) + k) == Approx(here(3 * static_cast<int>(order[i]) + k)).epsilon(1e-10));
  CHECK(reordered(18) == Approx(here(18)).epsilon(1e-10));

  // The base turned about Z, which adds to alpha, and shifted.
  const Eigen::Matrix3d turn = AngleAxisd(0.7, Vector3d::UnitZ()).toRotationMatrix();
  const Vector3d shift(0.3, -0.2, 0.1);
  VectorXd q_moved = q;
  q_moved.head<3>() = turn * q.head<3>() + shift;
  q_moved(3) += 0.7;
  check_equal("frame", all_of(Transmission(*p.machine(1, turn, shift)), q_moved), here, 1);
}

TEST_CASE("on a singular surface every index of output is zero to rounding") {
  // Gough's platform at a yaw of 90 degrees: all six legs take part.
  const auto m = test::hexapod("gough");
  VectorXd q = m->home();
  q(3) = 90 * deg;
  const TransmissionIndices at = indices(Transmission(*m), q);
  for (const auto& leg : at.actuators) {
    CHECK(leg.output < 1e-13);
    CHECK(leg.cosine < 1e-13);
  }
  CHECK(at.local < 1e-13);
  CHECK(at.conditioning < 1e-13);
}

TEST_CASE("where the angles are a singular chart the indices go on as if nothing were") {
  int compared = 0;
  for (const char* name : {"gough", "stewart", "cross1", "cross2"}) {
    CAPTURE(name);
    const auto m = test::hexapod(name);
    const Transmission t(*m);
    // Rx by 90 degrees between Rz and Ry: they turn about one axis. Near it the chart is poor, and not singular.
    VectorXd q = m->home(), near = q;
    q(4) = 90 * deg, near(4) = 90 * deg - 1e-3;
    const auto there = t.at({q.data(), 6}), beside = t.at({near.data(), 6});
    if (!there || !beside) continue;
    VectorXd further = near;
    further(4) = 90 * deg - 2e-3;
    const VectorXd a = all_of(t, q), b = all_of(t, near), c = all_of(t, further);
    // Beside it, linear to the square of the step.
    CHECK((a - (2 * b - c)).lpNorm<Eigen::Infinity>() < 1e-4);
    ++compared;
  }
  CHECK(compared >= 2);
}

TEST_CASE("every mechanism tells of each drive an index or why it has none") {
  for (const auto& [name, machine] : test::every_mechanism()) {
    CAPTURE(name);
    const Transmission t(*machine);
    for (const VectorXd& q : random_poses(*machine, 10, 17)) {
      const auto at = t.at({q.data(), static_cast<std::size_t>(q.size())});
      if (!at) continue;
      for (int i = 0; i < machine->dof(); ++i) {
        const auto& a = at->actuators[static_cast<std::size_t>(i)];
        CHECK(std::isfinite(a.cosine) == t.has_pressure(i));
        CHECK(std::isfinite(a.output) == t.has_output(i));
        CHECK(std::isfinite(a.input) == t.has_output(i));
        if (t.has_output(i)) {
          CHECK(a.output >= 0);
          CHECK(a.output <= 1);
        }
      }
      CHECK(std::isfinite(at->local) == t.has_local());
      for (int k = 0; k < 6 - machine->dof(); ++k)
        CHECK(std::isfinite(at->constraints[static_cast<std::size_t>(k)]) == t.has_constraint(k));
    }
  }
}
