// Sections `dynamics` and `drives`, and the run behind them. The mechanism is a lift with a disc on it that a motor turns: its forces can
// be worked out by hand.
#include <catch2/catch.hpp>

#include <core/analysis/samples/smooth_rate.hpp>
#include <core/analysis/study/drive_balance.hpp>
#include <core/analysis/study/motion_work.hpp>
#include <reports/section/drives/drives.hpp>
#include <reports/section/dynamics/dynamics.hpp>
#include <reports/section/dynamics/dynamics_words.hpp>
#include <reports/section/dynamics/energy.hpp>
#include <reports/section/kinds.hpp>
#include <tests/given/only.hpp>
#include <tests/scenario/trial.hpp>
#include <tests/section/report_words.hpp>

#include <cmath>
#include <numbers>

using namespace pmreport;
using analysis::ColumnId;
using std::numbers::pi;

namespace {

constexpr double car_mass = 3, disc_mass = 2, disc_radius = 0.1;

// The lift raises the car along Z (height z, force against the weights), the motor turns the disc on it about Z (angle phi).
class Lift : public Mechanism<2> {
 public:
  static constexpr const char *name = "lift", *title = "lift with a turntable", *source = "this test";
  static constexpr std::array<Parameter, 0> parameters{};
  explicit Lift(const Parameters&) {}
  Topology topology() const {
    Topology t;
    t.coordinates = {{"z", "height", "m", 0, {-0.1, 0.1}}, {"phi", "turn", "rad", 0, {-1, 1}}};
    t.add(Body{"car 1", 1, false, Inertia::axisymmetric(car_mass, 0, 0.01, 0.01)});
    t.platform = t.add(Body{"disc", 0, false, Inertia::solid_cylinder(disc_mass, 0.02, disc_radius, 0)});
    t.add(Joint{"P", JointKind::prismatic, 0, 1, {}});
    t.add(Joint{"R", JointKind::revolute, 1, 2, {}});
    t.add(Actuator{"q", "lift", "m", 0, {-5, 5}});
    t.add(Actuator{"psi", "turn", "rad", 1, {-100, 100}});
    for (const char* n : {"c1", "c2", "c3", "c4"}) t.constraints.push_back({n, n, "N"});
    return t;
  }
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> origin(T(0.0), T(0.0), q[0]);
    at.body(1, origin, Matrix3<T>(Matrix3<T>::Identity()));
    at.body(2, origin, rotation_z(q[1]));
    at.joint(0, origin, Eigen::Vector3d::UnitZ().cast<T>());
    at.joint(1, origin, Eigen::Vector3d::UnitZ().cast<T>());
    at.actuator(0, q[0]);
    at.actuator(1, q[1]);
  }
  template <class T>
  Matrix6<T> jacobian(const Placement<T>&) const {
    Matrix6<T> g = Matrix6<T>::Constant(T(0.0));
    for (const auto& [row, column] : {std::pair{0, 2}, {1, 5}, {2, 0}, {3, 1}, {4, 3}, {5, 4}}) g(row, column) = T(1.0);
    return g;
  }
};

scenario::MechanismSource lift() { return test::only<Lift>(); }

struct Run {
  explicit Run(const std::string& text)
      : loaded(scenario::load_text(text, "a.toml", lift(), section::kinds())),
        analysis(loaded.scenario, loaded.trajectory, *loaded.machine, analysis::asked_by(loaded.scenario), {}) {}
  double at(const std::string& column, int sample) const {
    return analysis.column(ColumnId::named(column))[static_cast<std::size_t>(sample)];
  }
  scenario::Loaded loaded;
  section::Analysis analysis;
};

// Up and down once, the disc to and fro twice, with a load of 7 N downwards and 0.5 N m against phi. `more` goes to its end.
std::string circuit(const std::string& more, int samples = 201) {
  return R"toml(title = "Lift"
[mechanism]
use = "lift"
[motion]
duration = "2 s"
samples = )toml" +
         std::to_string(samples) + R"toml(
z = "0.2 m * sin(pi*t/1 s)"
phi = "1.5 rad * sin(2*pi*t/1 s)"
[load]
force = ["0 N", "0 N", "-7 N"]
moment = ["0 N*m", "0 N*m", "-0.5 N*m"]
gravity = ["0 m/s^2", "0 m/s^2", "-9.81 m/s^2"]
)toml" + more;
}
const std::string dynamics = "[[section]]\nkind = \"dynamics\"\n", drives = "[[section]]\nkind = \"drives\"\n";
constexpr double rounding = 1e-12;

section::DynamicsOptions request(const std::vector<double>& equations = {}) {
  section::DynamicsOptions r;
  r.equations = equations;
  return r;
}

using report_words::blocks, report_words::proved, report_words::value;

}  // namespace

TEST_CASE("a lift carries load, weights and inertia, and each has its own column") {
  const Run r(circuit(dynamics));
  for (const int k : {0, 13, 50, 120}) {
    CAPTURE(k);
    const double t = 0.01 * k, a = -0.2 * pi * pi * std::sin(pi * t), v = 0.2 * pi * std::cos(pi * t);
    const double force = 7 + 5 * 9.81 + 5 * a, spin = -1.5 * 4 * pi * pi * std::sin(2 * pi * t), turn = 3 * pi * std::cos(2 * pi * t);
    CHECK(r.at("q_load_force", k) == Approx(7).epsilon(rounding));
    CHECK(r.at("q_gravity_force", k) == Approx(5 * 9.81).epsilon(rounding));
    CHECK(r.at("q_inertia_force", k) == Approx(5 * a).margin(1e-10));
    CHECK(r.at("q_dynamic_force", k) == Approx(force).epsilon(rounding));
    CHECK(r.at("psi_dynamic_force", k) == Approx(0.5 + 0.01 * spin).margin(1e-10));
    CHECK(r.at("q_power", k) == Approx(force * v).margin(1e-10));
    CHECK(r.at("load_power", k) == Approx(-7 * v - 0.5 * turn).margin(1e-10));
    CHECK(r.at("kinetic_energy", k) == Approx(2.5 * v * v + 0.005 * turn * turn).margin(1e-10));
    CHECK(r.at("potential_energy", k) == Approx(5 * 9.81 * 0.2 * std::sin(pi * t)).margin(1e-10));
  }
}

TEST_CASE("forces in motion take memory only where something asks for them") {
  const Run none(circuit("[[section]]\nkind = \"displacement\"\n")), some(circuit(dynamics)),
      limited(circuit("[limits]\nactuator_force = { q = \"60 N\" }\n[[section]]\nkind = \"displacement\"\n"));
  CHECK_FALSE(none.analysis.has_dynamics());
  CHECK_FALSE(none.analysis.has(ColumnId::named("q_dynamic_force")));
  CHECK(none.analysis.columns_of(analysis::dynamics_columns).empty());
  CHECK(some.analysis.has(ColumnId::named("q_dynamic_force")));
  CHECK_FALSE(some.analysis.has(ColumnId::named("q_drive_force")));
  CHECK_FALSE(some.analysis.has(ColumnId::named("R_force")));
  CHECK(limited.analysis.has_dynamics());
}

TEST_CASE("every residual of forces in motion is rounding, and every one is computed") {
  const Run r(circuit(dynamics));
  for (const auto& [measure, compared] : {std::pair{section::Measure::newton_euler, 201},
                                          {section::Measure::free_body, 201},
                                          {section::Measure::judge, 0},  // a chain is not cut into limbs: it would judge itself
                                          {section::Measure::power_balance, 64}}) {
    const section::Worst w = r.analysis.worst(measure);
    CAPTURE(static_cast<int>(measure), w.value);
    CHECK(w.compared == compared);
    CHECK(w.value < 1e-10);
  }
}

TEST_CASE("numbers do not depend on how the samples are shared out") {
  const Run coarse(circuit(dynamics, 101)), fine(circuit(dynamics, 201));
  for (int k = 0; k < 101; ++k) CHECK(coarse.at("q_dynamic_force", k) == Approx(fine.at("q_dynamic_force", 2 * k)).epsilon(rounding));
}

TEST_CASE("work over a closed path is that of the load alone, and what comes back is counted apart") {
  const Run r(circuit(dynamics));
  const auto work = analysis::motion_work(r.analysis);
  REQUIRE(work);
  CHECK(work->whole);
  CHECK(work->closed);
  CHECK(std::abs(work->load) < 1e-12);  // both loads are constant and both paths return
  CHECK(std::abs(work->work()) < 1e-12 * work->flow);
  // The lift carries 56.05 N + 5 a; by symmetry it gives back on the way down what it gives on the way up, and a v integrates to nothing
  // over either: twice 0.2 m up from the lowest point, 0.4 m down.
  CHECK(work->regenerated[0] == Approx(56.05 * 0.4).epsilon(1e-6));
}

TEST_CASE("a path that does not return leaves its work in the bodies or in the load") {
  const std::string half = circuit(dynamics).replace(circuit(dynamics).find("\"2 s\""), 5, "\"0.5 s\"");
  const Run r(half);
  const auto work = analysis::motion_work(r.analysis);
  REQUIRE(work);
  CHECK_FALSE(work->closed);
  // At 0.5 s: at the top, 0.2 m up, at rest; phi is back at zero, its rate reversed.
  const double kinetic = -2.5 * std::pow(0.2 * pi, 2);
  CHECK(work->stored == Approx(5 * 9.81 * 0.2 + kinetic));
  CHECK(work->load == Approx(-7 * 0.2));
  CHECK(work->work() == Approx(work->stored - work->load).epsilon(1e-11));
}

TEST_CASE("where the actuators exert nothing but rounding, the weights alone are measured by") {
  const Run fall(R"toml(title = "Fall"
[mechanism]
use = "lift"
[motion]
duration = "1 s"
samples = 101
z = "-4.905 m/s^2 * t^2"
[load]
gravity = ["0 m/s^2", "0 m/s^2", "-9.81 m/s^2"]
)toml" + dynamics);
  const auto work = analysis::motion_work(fall.analysis);
  REQUIRE(work);
  // What falls turns into motion: 5 kg through 4.905 m, once out of one store and once into the other.
  const double fallen = (car_mass + disc_mass) * 9.81 * 4.905;
  CHECK(work->flow == Approx(2 * fallen).epsilon(1e-3));
  CHECK(std::abs(work->work()) < 1e-12 * fallen);
  CHECK(std::abs(work->stored) < 1e-12 * fallen);
}

TEST_CASE("a motion whose jerk jumps still has its work to rounding, and its power where it is smooth") {
  std::string text = circuit(dynamics);
  const std::string smooth = "0.2 m * sin(pi*t/1 s)";
  text.replace(text.find(smooth), smooth.size(), "0.1 m * (max(t - 0.7303 s, 0 s)/1 s)^3");
  const Run r(text);
  const auto work = analysis::motion_work(r.analysis);
  REQUIRE(work);
  CHECK(std::abs(work->work() + work->load - work->stored) < 1e-10 * work->flow);
  const section::Worst w = r.analysis.worst(section::Measure::power_balance);
  CHECK(w.compared > 50);
  CHECK(w.value < 1e-8);
}

TEST_CASE("a recording that rounds its positions keeps its energy, and its power is compared beside its knots") {
  const trial::Folder folder;
  std::string table = "t [s],z [mm]\n";
  for (int i = 0; i <= 100; ++i) table += fmt::format("{:.3f},{:.2f}\n", 0.01 * i, 20 * std::sin(0.04 * i));
  folder.write("motion.csv", table);
  const std::string text =
      "title = \"Lift\"\n[mechanism]\nuse = \"lift\"\n[motion]\nfile = \"motion.csv\"\n[load]\ngravity = [\"0 m/s^2\", \"0 m/s^2\", "
      "\"-9.81 m/s^2\"]\n[[section]]\nkind = \"dynamics\"\n";
  for (const std::string samples : {"", "samples = 38\n"}) {
    CAPTURE(samples);
    std::string own = text;
    own.insert(own.find("[load]"), samples);
    const scenario::Loaded loaded = scenario::load_text(own, folder.path() / "a.toml", lift(), section::kinds());
    const section::Analysis a(loaded.scenario, loaded.trajectory, *loaded.machine, analysis::asked_by(loaded.scenario), {});
    const auto work = analysis::motion_work(a);
    REQUIRE(work);
    // From one end to the other by the masses alone: 5 kg by the height, and their speeds.
    const auto& t = loaded.trajectory;
    const auto last = t.value.rows() - 1;
    const double stored =
        5 * 9.81 * (t.value(last, 0) - t.value(0, 0)) + 2.5 * (t.rate(last, 0) * t.rate(last, 0) - t.rate(0, 0) * t.rate(0, 0));
    CHECK(std::abs(work->work() - stored) < work->uncertainty);
    CHECK(work->uncertainty < 1e-11 * work->flow);  // a cubic is integrated exactly between its knots
    const section::Result result = section::dynamics_section(a, request());
    CHECK(proved(result.section, 1));  // but for limbs that there are none of
    CHECK(a.worst(section::Measure::power_balance).compared > 20);
  }
}

TEST_CASE("work that is not known well enough decides nothing, and says so") {
  const Run r(circuit(dynamics));
  auto work = analysis::motion_work(r.analysis);
  REQUIRE(work);
  const section::EnergyEvidence sound = section::energy_evidence(r.analysis, work);
  CHECK(sound.notes.empty());
  REQUIRE(sound.lines.size() == 2);
  for (const document::Evidence& e : sound.lines) CHECK(e.verdict() == document::Verdict::passed);
  auto off = work;
  off->stored += 1e-6 * work->flow;  // what a millionth of the mass does
  CHECK(section::energy_evidence(r.analysis, off).lines[0].failed());
  work->uncertainty = 0.01 * work->flow;
  const section::EnergyEvidence vague = section::energy_evidence(r.analysis, work);
  const auto not_examined = [](const section::EnergyEvidence& e) -> std::string {
    REQUIRE(e.lines.size() == 1);
    CHECK(e.lines[0].claim == "Work becomes energy");
    CHECK(e.lines[0].verdict() == document::Verdict::not_examined);
    return e.lines[0].reason;
  };
  CHECK_THAT(not_examined(vague), Catch::Contains("known to 0.01 of it alone"));
  CHECK_THAT(not_examined(section::energy_evidence(r.analysis, std::nullopt)), Catch::Contains("no stretch of it has forces"));
}

TEST_CASE("a load that switches splits the integration, and a rate that jumps takes the proof away") {
  std::string text = circuit(dynamics);
  const std::string load = "\"-7 N\"";
  REQUIRE(text.find(load) != std::string::npos);
  const Run switching(text.replace(text.find(load), load.size(), "\"-7 N * max(0, abs(t - 0.737 s)/(t - 0.737 s))\""));
  CHECK(switching.loaded.scenario.load.knots.size() >= 1);
  const auto work = analysis::motion_work(switching.analysis);
  REQUIRE(work);
  CHECK(std::abs(work->work() + work->load - work->stored) < work->uncertainty);
  CHECK(work->uncertainty < 1e-9 * work->flow);

  text = circuit(dynamics);
  const std::string smooth = "0.2 m * sin(pi*t/1 s)";
  const Run corner(text.replace(text.find(smooth), smooth.size(), "0.2 m * abs(t/1 s - 0.737)"));
  const section::EnergyEvidence told = section::energy_evidence(corner.analysis, analysis::motion_work(corner.analysis));
  REQUIRE(told.lines.size() == 1);
  CHECK(told.lines[0].verdict() == document::Verdict::not_examined);
  CHECK_THAT(told.lines[0].reason, Catch::Contains("values or rates of the motion jump"));
}

TEST_CASE("differences tell the rate of what is smooth and how good they are, and own up to a kink") {
  const auto wave = analysis::smooth_rate([](double t) { return std::exp(std::sin(3 * t)); }, 0.4, 0, 2);
  REQUIRE(wave);
  CHECK(wave->value == Approx(3 * std::cos(1.2) * std::exp(std::sin(1.2))).epsilon(1e-11));
  CHECK(wave->change < 1e-10);
  const auto kink = analysis::smooth_rate([](double t) { return std::abs(t - 0.4); }, 0.4 + 1e-5, 0, 2);
  REQUIRE(kink);
  CHECK(kink->change > 1e-6);  // where 1e-9 counts as smooth
  CHECK_FALSE(analysis::smooth_rate([](double t) { return t; }, 0, 0, 2));
}

TEST_CASE("the dynamics section names its quantities and proves them") {
  const Run r(circuit(dynamics));
  const section::Result result = section::dynamics_section(r.analysis, request());
  CHECK(proved(result.section, 1));                                         // but for limbs that there are none of
  CHECK(value(result, "peak_force") == Approx(56.05 + 5 * 0.2 * pi * pi));  // at the lowest point, t = 1.5 s
  CHECK(value(result, "peak_torque") == Approx(0.5 + 0.01 * 1.5 * 4 * pi * pi));
  CHECK(value(result, "regenerated") > 56.05 * 0.4);
}

TEST_CASE("equations of motion are those of a mass and a disc") {
  const Run r(circuit(dynamics));
  const section::Result result = section::dynamics_section(r.analysis, request({0.25}));
  const auto tables = blocks<document::Table>(result.section);
  REQUIRE(tables.size() == 4);  // linear actuator, rotary actuator, equations, reflected inertia
  const document::Table& e = tables[2];
  REQUIRE(e.rows.size() == 2);
  CHECK(e.rows[0] == std::vector<std::string>{"z", "5", "0", "0", "49.05", "N"});
  CHECK(e.rows[1] == std::vector<std::string>{"phi" == e.rows[1][0] ? "phi" : "φ", "0", "0.01", "0", "0", "N·m"});
  CHECK(tables[3].rows[0] == std::vector<std::string>{"q", "5 kg"});
}

TEST_CASE("bodies alike are counted together, and those without mass named apart") {
  Topology t;
  t.add(Body{"platform", 0, false, {2}});
  t.add(Body{"rod 1", 1, true, {0.5}});
  t.add(Body{"rod 2", 1, true, {0.5}});
  t.add(Body{"guide 1", 1, true, {}});
  CHECK(section::masses(t) == "platform 2 kg; 2 × rod 0.5 kg; without mass: guide");
}

TEST_CASE("a screw turns force and way into torque and angle, and spins its own inertia") {
  const Run r(circuit("[drive]\nefficiency = 0.8\n[drive.q]\nlead = \"10 mm\"\ninertia = \"2e-5 kg*m^2\"\n" + drives));
  CHECK_FALSE(r.analysis.has(ColumnId::named("psi_motor_torque")));  // no motor is given for the disc
  for (const int k : {5, 90, 130}) {                                 // up, down, down
    CAPTURE(k);
    const double t = 0.01 * k, a = -0.2 * pi * pi * std::sin(pi * t), v = 0.2 * pi * std::cos(pi * t);
    const double force = 56.05 + 5 * a, drive = v > 0 ? force / 0.8 : force * 0.8, turns = 1 / 0.010;
    CHECK(r.at("q_drive_force", k) == Approx(drive));
    CHECK(r.at("q_motor_speed", k) == Approx(2 * pi * turns * v));
    CHECK(r.at("q_motor_torque", k) == Approx(drive * 0.010 / (2 * pi) + 2e-5 * 2 * pi * turns * a));
    CHECK(r.at("q_reflected_inertia", k) == Approx(5));
  }
  const section::Result result = section::drives_section(r.analysis);
  CHECK(proved(result.section));
  CHECK(value(result, "peak_speed") == Approx(2 * pi * 100 * 0.2 * pi));
  const auto proofs = blocks<document::Proof>(result.section);
  REQUIRE(proofs.size() == 1);
  CHECK(proofs[0].lines.size() == 2);
}

TEST_CASE("an efficiency that always divides is warned of where an actuator is driven back") {
  const auto warnings = [](const std::string& convention) {
    const Run r(circuit("[drive]\nefficiency = 0.8\nconvention = \"" + convention + "\"\n" + drives));
    int count = 0;
    const section::Result result = section::drives_section(r.analysis);
    for (const document::Paragraph& p : blocks<document::Paragraph>(result.section))
      count += p.tone == document::Paragraph::Tone::warning ? 1 : 0;
    return count;
  };
  CHECK(warnings("divides") == 1);
  CHECK(warnings("power") == 0);
}

TEST_CASE("the motors of a motion through points are held against their spin between the points") {
  // Sampled at its points, all of which are knots.
  const trial::Folder folder;
  std::string table = "t [s],z [mm]\n";
  for (int i = 0; i <= 50; ++i) table += fmt::format("{:.2f},{:.2f}\n", 0.02 * i, 100 * std::sin(0.06 * i));
  folder.write("motion.csv", table);
  const scenario::Loaded loaded = scenario::load_text(
      "title = \"Lift\"\n[mechanism]\nuse = \"lift\"\n[motion]\nfile = \"motion.csv\"\n[drive]\nefficiency = 0.8\n[drive.q]\nlead = \"10 "
      "mm\"\ninertia = \"2e-5 kg*m^2\"\n" +
          drives,
      folder.path() / "a.toml", lift(), section::kinds());
  const section::Analysis a(loaded.scenario, loaded.trajectory, *loaded.machine, analysis::asked_by(loaded.scenario), {});
  const double left_over = analysis::drive_balance(a).left_over;
  REQUIRE(std::isfinite(left_over));
  CHECK(left_over < 1e-8);
}

TEST_CASE("a drive without a motor shows what it must give at its actuator, and nothing of motors") {
  const Run r(circuit("[drive]\nefficiency = 1.0\n" + drives));
  const section::Result result = section::drives_section(r.analysis);
  CHECK(result.values.empty());
  CHECK(blocks<figure::Figure>(result.section).size() == 1);
  CHECK(blocks<document::Table>(result.section).size() == 4);  // drives and inertia, of what slides and of what turns
  for (const analysis::Column& c : r.analysis.columns_of(analysis::drive_columns)) CHECK(c.group.find("motor") == std::string::npos);
  CHECK(r.at("q_drive_force", 40) == r.at("q_dynamic_force", 40));
}
