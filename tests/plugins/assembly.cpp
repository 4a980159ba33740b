// Every assembly mode of the mechanisms of the papers, and of the platform that has the most.
#include <core/mechanics/assembly/assembly.hpp>

#include <core/mechanics/model/generic_model.hpp>
#include <tests/plugins/hexapods.hpp>

#include <Eigen/Geometry>

using namespace pmreport;
using namespace pmreport::mechanics;
using test::reference;

namespace {

Eigen::VectorXd actuators_at(const Machine& machine, const Eigen::VectorXd& q) {
  const Pose pose = machine.pose({q.data(), static_cast<std::size_t>(q.size())});
  REQUIRE(pose.status == PM_OK);
  return Eigen::Map<const Eigen::VectorXd>(pose.numbers.data() + machine.layout().actuator(0), machine.dof());
}

// Tests are not compiled for speed: the large matrices of the search on the joints are kept for those tests whose matter they are.
AssemblyOptions searching(int joint_starts) {
  AssemblyOptions options;
  options.joint_starts = joint_starts;
  return options;
}

// What holds of every mode of every mechanism; the pose that the actuators are taken from is the first.
void check_modes(const Machine& machine, const AssemblyModes& found, double length) {
  CHECK(found.complete_search());
  for (std::size_t i = 0; i < found.modes.size(); ++i) {
    const AssemblyMode& m = found.modes[i];
    CAPTURE(i, found.words[m.word].name, m.coordinates.transpose());
    CHECK(m.residual < 1e-10);
    CHECK(m.gap < 1e-12);  // of rounding: the bodies are placed in closed form
    CHECK(m.misalignment < 1e-10);
    CHECK(m.pose.status == PM_OK);
    if (i > 0) CHECK(m.distance >= found.modes[i - 1].distance);
    for (std::size_t j = 0; j < i; ++j)
      if (found.modes[j].word == m.word) CHECK(distance(machine, m.pose, found.modes[j].pose, length) > 1e-5 * length);
  }
}

AssemblyModes modes_at(const Machine& machine, const Eigen::VectorXd& q, int joint_starts = 0) {
  AssemblyModes found = find_assembly_modes(machine, actuators_at(machine, q), q, searching(joint_starts));
  check_modes(machine, found, characteristic_length(machine));
  REQUIRE_FALSE(found.modes.empty());
  CHECK(found.modes.front().distance < 1e-7);
  return found;
}

bool among(const Machine& machine, const AssemblyModes& found, const Eigen::VectorXd& q, double tolerance) {
  const Pose pose = machine.pose({q.data(), static_cast<std::size_t>(q.size())});
  if (pose.status != PM_OK) return false;
  return std::any_of(found.modes.begin(), found.modes.end(),
                     [&](const AssemblyMode& m) { return distance(machine, m.pose, pose, characteristic_length(machine)) < tolerance; });
}

}  // namespace

TEST_CASE("Dietmaier's platform has all of its forty real assembly modes, and no more") {
  const test::json& d = reference("dietmaier.json");
  const auto flat = [](const test::json& points) {
    std::vector<double> out;
    for (const auto& p : points)
      for (const auto& x : p) out.push_back(test::number(x));
    return out;
  };
  const pm_mechanism& table = test::plugin("gough");
  const Machine machine(table, test::values_with(table, {{"base_points", flat(d["a"])}, {"platform_points", flat(d["b"])}}));
  const Eigen::VectorXd lengths = test::vector(d["L"]);
  const Eigen::MatrixXd a = test::matrix(d["a"]), b = test::matrix(d["b"]);
  for (const std::uint64_t seed : {1u, 2u}) {
    AssemblyOptions options;
    options.seed = seed;
    const AssemblyModes found = find_assembly_modes(machine, lengths, machine.home(), options);
    CHECK(found.modes.size() == 40);  // the most that a platform of any geometry can have
    check_modes(machine, found, 1);
    for (const AssemblyMode& m : found.modes) {
      const int platform = machine.topology().platform;
      const Eigen::Vector3d p = machine.origin(m.pose, platform);
      const Eigen::Matrix3d r = machine.rotation(m.pose, platform);
      for (int i = 0; i < 6; ++i) {
        const Eigen::Vector3d leg = p + r * b.row(i).transpose() - a.row(i).transpose();
        CHECK(std::abs(leg.norm() - lengths(i)) < 1e-10);
      }
    }
  }
}

TEST_CASE("the modes of the 5PUS-UPU are those of the reference and the ones with the platform turned over") {
  const test::json& f = reference("5pus-upu.json")["forward_assemblies"];
  const pm_mechanism& table = test::plugin("5pus-upu");
  const Machine machine(table, default_values(describe(table)));
  const AssemblyModes found = find_assembly_modes(machine, test::vector(f["q"]), test::vector(f["all"][1]), searching(0));
  check_modes(machine, found, characteristic_length(machine));
  for (const auto& q : f["all"]) {
    CAPTURE(q.dump());
    CHECK(among(machine, found, test::vector(q), 1e-8));  // printed to the last digit; a mode next to another has condition 1e4
  }
  // Those of the reference have the platform's x axis within a right angle of X; six more have it turned beyond.
  int upright = 0, above = 0, upright_above = 0;
  for (const AssemblyMode& m : found.modes) {
    const bool is_upright = machine.rotation(m.pose, machine.topology().platform)(0, 0) > 0;
    upright += is_upright, above += m.word == 0, upright_above += is_upright && m.word == 0;
  }
  CHECK(upright == static_cast<int>(f["all"].size()));
  CHECK(upright_above == static_cast<int>(f["sliders_above"].size()));
  CHECK(found.modes.size() == 16);
  CHECK(above == 10);

  AssemblyOptions own = searching(0);
  own.working_modes = false;
  CHECK(find_assembly_modes(machine, test::vector(f["q"]), test::vector(f["all"][1]), own).modes.size() == 10);
}

TEST_CASE("the P(2PRPU)/PRPS has eight modes in mirror pairs at every reference pose that it reaches") {
  const pm_mechanism& table = test::plugin("p2prpu-prps");
  const Machine machine(table, default_values(describe(table)));
  const test::json& pose = reference("p2prpu-prps.json")["cases"][0]["pose"];
  Eigen::VectorXd table2(5);
  table2 << test::number(pose["x"]), test::number(pose["y"]), test::number(pose["z"]), test::number(pose["alpha"]),
      test::number(pose["beta"]);
  for (const Eigen::VectorXd& q : {Eigen::VectorXd(machine.home()), table2}) {
    const AssemblyModes found = modes_at(machine, q);
    CHECK(found.modes.size() == 8);
    for (const AssemblyMode& m : found.modes) {
      Eigen::VectorXd mirrored = m.coordinates;
      mirrored.tail(3) *= -1;  // (z, alpha, beta)
      CHECK(among(machine, found, mirrored, 1e-8));
    }
  }
  // Close to the pose of Table 2 there is another.
  CHECK(modes_at(machine, table2).modes[1].coordinates(4) == Approx(-41.096 * deg).margin(1e-5));
}

TEST_CASE("Gough's, Stewart's and the parallel-cross mechanisms have their modes in pairs mirrored in the base") {
  const std::vector<std::pair<std::string, std::size_t>> least{{"gough", 8}, {"stewart", 4}, {"cross1", 4}, {"cross2", 4}};
  for (const auto& [name, known] : least) {
    CAPTURE(name);
    const auto machine = test::hexapod(name);
    Eigen::VectorXd q = machine->home();
    q += (Eigen::VectorXd(6) << 0.02, -0.03, 0.01, 0.04, -0.05, 0.03).finished();  // away from symmetry
    const AssemblyModes found = modes_at(*machine, q);
    CHECK(found.modes.size() >= known);
    CHECK(found.modes.size() % 2 == 0);
    for (const AssemblyMode& m : found.modes) {
      Eigen::VectorXd mirrored = m.coordinates;  // S R S with S = diag(1, 1, -1): base and platform are flat
      mirrored(2) *= -1, mirrored(4) *= -1, mirrored(5) *= -1;
      CHECK(among(*machine, found, mirrored, 1e-8));
    }
  }
}

TEST_CASE("every mechanism is among its own assembly modes at home") {
  for (const std::string name : {"4sps-spr", "2q-spr", "delta", "stewart", "parallel-cross"}) {
    CAPTURE(name);
    const pm_mechanism& table = test::plugin(name);
    const Machine machine(table, default_values(describe(table)));
    const AssemblyModes found = modes_at(machine, machine.home());
    CHECK(found.modes.front().within_limits);
    CHECK(found.modes.front().word == 0);
  }
}

TEST_CASE("a delta robot has its hub at either of the two points where three spheres meet") {
  const pm_mechanism& table = test::plugin("delta");
  const Machine machine(table, default_values(describe(table)));
  const AssemblyModes found = modes_at(machine, machine.home());
  // At home the spheres' centres lie on a circle about Z: both points on Z, one below the circle and one above.
  REQUIRE(found.modes.size() == 2);
  for (const AssemblyMode& m : found.modes) CHECK(m.coordinates.head(2).norm() < 1e-9);
  CHECK(std::abs(found.modes[0].coordinates(2) - found.modes[1].coordinates(2)) > 0.1);
}

TEST_CASE("a delta robot all but stretched has both points of its spheres as well, the other one close to where its limbs are folded") {
  const pm_mechanism& table = test::plugin("delta");
  const Machine machine(table, default_values(describe(table)));
  const double base = 0.2, platform = 0.08, arm = 0.524, rod = 1.244;  // its default sizes [m]
  const double stretched = -std::sqrt((arm + rod) * (arm + rod) - (base - platform) * (base - platform));
  for (const double inside : {1e-6, 1e-3}) {
    CAPTURE(inside);
    const Eigen::Vector3d q(0, 0, stretched + inside);
    const Eigen::VectorXd actuators = actuators_at(machine, q);
    const AssemblyModes found = find_assembly_modes(machine, actuators, q, searching(10));
    // All arms alike: the elbows are on a circle about Z, and the spheres about them, moved inwards by the platform's radius, meet on Z.
    const double theta = actuators(0), out = base + arm * std::cos(theta) - platform, level = -arm * std::sin(theta);
    REQUIRE(found.modes.size() == 2);
    CHECK(found.modes[0].coordinates(2) == Approx(level - std::sqrt(rod * rod - out * out)).epsilon(1e-9));
    CHECK(found.modes[1].coordinates(2) == Approx(level + std::sqrt(rod * rod - out * out)).epsilon(1e-9));
    for (const AssemblyMode& m : found.modes) CHECK(m.coordinates.head(2).norm() < 1e-6);
  }
}

TEST_CASE("the hub of a delta robot may also stand turned, each rod still from ball to ball") {
  const pm_mechanism& table = test::plugin("delta");
  const Machine machine(table, default_values(describe(table)));
  const AssemblyModes found = modes_at(machine, machine.home(), 20);
  REQUIRE(found.further.has_value());
  CHECK(found.further->missed == 0);
  CHECK(found.further->seen > 0);
  CHECK_FALSE(found.further->poses.empty());
  const Pose& home = machine.home_pose();
  const int hub = machine.topology().platform;
  for (const FurtherPose& f : found.further->poses) {
    CHECK((f.rotation - Eigen::Matrix3d::Identity()).norm() > 0.1);  // else the coordinates would say it
    // Elbows stay where the motors hold them. A rod's upper ball is at its elbow, the lower one where the hub carries it.
    for (int i = 0; i < static_cast<int>(machine.topology().joints.size()); ++i) {
      const Joint& lower = machine.topology().joints[static_cast<std::size_t>(i)];
      if (lower.b != hub && lower.a != hub) continue;
      const int rod = lower.a == hub ? lower.b : lower.a;
      for (int k = 0; k < static_cast<int>(machine.topology().joints.size()); ++k) {
        const Joint& upper = machine.topology().joints[static_cast<std::size_t>(k)];
        if (k == i || (upper.a != rod && upper.b != rod)) continue;
        const Eigen::Vector3d on_hub = machine.centre(home, i) - machine.origin(home, hub);  // home is not turned
        const double length = (machine.centre(home, i) - machine.centre(home, k)).norm();
        CHECK((f.origin + f.rotation * on_hub - machine.centre(home, k)).norm() == Approx(length).epsilon(1e-9));
      }
    }
  }
}
