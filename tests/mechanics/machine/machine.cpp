// What a mechanism declares is checked once, and each slip has its own sentence.
#include <core/mechanics/machine/machine.hpp>

#include <pmreport/mechanism.hpp>
#include <tests/mechanics/mechanisms.hpp>

#include <catch2/catch.hpp>
#include <functional>

using namespace pmreport;
using namespace pmreport::mechanics;

namespace {

// A slider on a rail, whose declaration and numbers a test may spoil.
std::function<void(Topology&)> spoil_topology;
double home_value = 0, home_reach = 1;

class Slider : public Mechanism<1> {
 public:
  static constexpr const char *name = "slider", *title = "a slider", *source = "a test";
  static constexpr Parameter parameters[] = {Parameter::length("stroke", 0.4, "stroke", {0.1, 1}),
                                             Parameter::angle("slope", 0.1, "slope of the rail")};

  explicit Slider(const Parameters& p) : stroke_(p["stroke"]) {
    if (stroke_ > 0.9) throw std::invalid_argument("stroke must leave room for the end stops");
  }
  Topology topology() const {
    Topology t;
    t.coordinates = {{"x", "position", "m", 0, {-0.1, 0.1}}};
    t.platform = t.add(Body{"slider", 0, false, {}});
    t.add(Joint{"P", JointKind::prismatic, 0, 1, {}});
    t.add(Actuator{"s", "position", "m", 0, {0, stroke_}});
    for (const char* n : {"fy", "fz"}) t.constraints.push_back({n, "", "N"});
    for (const char* n : {"mx", "my", "mz"}) t.constraints.push_back({n, "", "N*m"});
    t.derived = {{"one", "a number", "m", false}};
    if (spoil_topology) spoil_topology(t);
    return t;
  }
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    at.require(T(home_reach), "the rail is missing");
    const Vector3<T> p(q[0], T(0.0), T(0.0));
    at.body(1, p, Eigen::Matrix3d::Identity().cast<T>());
    at.joint(0, p, Eigen::Vector3d::UnitX().cast<T>());
    at.actuator(0, q[0]);
    at.derived(0, T(home_value));
  }
  template <class T>
  Matrix6<T> jacobian(const Placement<T>&) const {
    return Eigen::Matrix<double, 6, 6>::Identity().cast<T>();
  }

 private:
  double stroke_;
};

const pm_mechanism& slider = contract::mechanism<Slider>;

struct Refusal {
  pm_status status = PM_OK;
  std::string sentence;
};
Refusal refusal_of(const pm_mechanism& table, const ParameterValues& values) {
  try {
    const Machine machine(table, values);
  } catch (const MechanismError& e) {
    return {e.status, e.what()};
  }
  return {};
}
Refusal refusal_of(const std::function<void(Topology&)>& spoil) {
  spoil_topology = spoil;
  const Refusal r = refusal_of(slider, {{0.4}, {0.1}});
  spoil_topology = nullptr;
  return r;
}

}  // namespace

TEST_CASE("a sound mechanism is taken, and tells what it was told") {
  const Machine machine(slider, {{0.5}, {0.2}});
  CHECK(machine.dof() == 1);
  CHECK(machine.info().name == "slider");
  CHECK(machine.values() == ParameterValues{{0.5}, {0.2}});
  CHECK(machine.topology().actuators[0].stroke.max == 0.5);
  CHECK(machine.topology().bodies[0].name == "base");
  CHECK(machine.layout().size() == 1 + 12 + 6 + 1 + 1);
  CHECK(machine.home_pose().status == PM_OK);
  CHECK(machine.rotation(machine.home_pose(), 0).isIdentity());
  CHECK(machine.axis(machine.home_pose(), 0) == Eigen::Vector3d::UnitX());
}

TEST_CASE("parameters are described before a mechanism is made") {
  const MechanismInfo info = describe(slider);
  CHECK(info.dof == 1);
  REQUIRE(info.parameters.size() == 2);
  CHECK(info.parameters[0].name == "stroke");
  CHECK(info.parameters[0].unit == "m");
  CHECK(info.parameters[0].display == "mm");
  CHECK(info.parameters[0].min == 0.1);
  CHECK(info.parameters[0].max == 1.0);
  CHECK(info.parameters[1].display == "deg");
  CHECK(default_values(info) == ParameterValues{{0.4}, {0.1}});
  const MechanismInfo crank = describe(test::slider_crank());
  CHECK(crank.parameters[0].kind == PM_CHOICE);
  CHECK(crank.parameters[0].choices.at(1) == "gap");
}

TEST_CASE("parameters that a mechanism refuses are the user's matter, in its own words") {
  const Refusal r = refusal_of(slider, {{0.95}, {0.1}});
  CHECK(r.status == PM_BAD_ARGUMENT);
  CHECK(r.sentence == "stroke must leave room for the end stops");
}

TEST_CASE("a declaration that makes no sense is told by name") {
  struct Slip {
    const char* sentence;
    std::function<void(Topology&)> spoil;
  };
  const Slip slips[] = {
      {"declares 1 degrees of freedom, but 2 independent coordinates; Mechanism<1> and topology() must say the same",
       [](Topology& t) { t.coordinates.push_back(t.coordinates[0]); }},
      {"declares 1 degrees of freedom, but 0 actuators; is a limb forgotten?", [](Topology& t) { t.actuators.clear(); }},
      {"declares 4 constraint wrenches, expected 5 (6 less the degrees of freedom)", [](Topology& t) { t.constraints.pop_back(); }},
      {"names body 2 as the platform, but has bodies 1 to 1", [](Topology& t) { t.platform = 2; }},
      {"names body 0 as the platform, but has bodies 1 to 1", [](Topology& t) { t.platform = 0; }},
      {"declares -1 idle freedoms, and 1 moving bodies have 6 freedoms in all", [](Topology& t) { t.idle = -1; }},
      {"declares 7 idle freedoms, and 1 moving bodies have 6 freedoms in all", [](Topology& t) { t.idle = 7; }},
      {"coordinate x: unit \"mm\", expected \"m\" or \"rad\"", [](Topology& t) { t.coordinates[0].unit = "mm"; }},
      {"coordinate x: home lies outside its own box", [](Topology& t) { t.coordinates[0].home = 0.2; }},
      {"joint P: unknown kind 9", [](Topology& t) { t.joints[0].kind = static_cast<JointKind>(9); }},
      {"joint P: body 5 does not exist (0 to 1)", [](Topology& t) { t.joints[0].b = 5; }},
      {"joint P: body -1 does not exist (0 to 1)", [](Topology& t) { t.joints[0].a = -1; }},
      {"joint P connects body 1 with itself", [](Topology& t) { t.joints[0].a = 1; }},
      {"joint P: its limits are not a finite range",
       [](Topology& t) {
         t.joints[0].limits = {{0, std::nan("")}};
       }},
      {"joint P: its limits are not a finite range",
       [](Topology& t) {
         t.joints[0].limits = {{1, -1}};
       }},
      {"joint P: its stud is body 7, which it does not connect",
       [](Topology& t) {
         t.joints[0].kind = JointKind::spherical;
         t.joints[0].stud = 7;
       }},
      {"actuator s: joint 3 does not exist", [](Topology& t) { t.actuators[0].joint = 3; }},
      {"actuator s: unit \"N\", expected \"m\" or \"rad\"", [](Topology& t) { t.actuators[0].unit = "N"; }},
      {"actuator s: joint P does not allow a motion in rad", [](Topology& t) { t.actuators[0].unit = "rad"; }},
      {"actuator s: joint P does not allow a motion in m", [](Topology& t) { t.joints[0].kind = JointKind::revolute; }},
      {"actuator s: joint P does not allow a motion in rad",
       [](Topology& t) {
         t.joints[0].kind = JointKind::spherical;
         t.actuators[0].unit = "rad";
       }},
      {"actuator s: its stroke is not a finite range",
       [](Topology& t) {
         t.actuators[0].stroke = {0, std::numeric_limits<double>::infinity()};
       }},
      {"actuator s: its stroke is not a finite range",
       [](Topology& t) {
         t.actuators[0].stroke = {0.2, 0.2};
       }},
      {"a shape belongs to body 4, which does not exist", [](Topology& t) { t.shapes.emplace_back().body = 4; }},
      {"body slider: a shape of radius -0.1 m; it cannot be negative",
       [](Topology& t) {
         t.shapes.push_back({1, ShapeKind::ball, {0, 0, 0}, {0, 0, 0}, -0.1});
       }},
      {"body slider: a shape whose places or radius are not finite numbers",
       [](Topology& t) {
         t.shapes.push_back({1, ShapeKind::cylinder, {0, 0, 0}, {0, std::nan(""), 0}, 0.1});
       }},
      {"body slider: a box with a negative half edge",
       [](Topology& t) {
         t.shapes.push_back({1, ShapeKind::box, {0, 0, 0}, {0.1, -0.1, 0.1}, 0});
       }},
      {"coordinate x: its box is not a finite range",
       [](Topology& t) { t.coordinates[0].box.max = std::numeric_limits<double>::infinity(); }},
      {"constraint fy: unit \"kg\", expected \"N\" or \"N*m\"", [](Topology& t) { t.constraints[0].unit = "kg"; }},
      {"coordinate 1 has no name", [](Topology& t) { t.coordinates[0].name.clear(); }},
      {"body 2 has no name", [](Topology& t) { t.bodies[1].name.clear(); }},
      {"coordinate 1 and derived quantity 1 are both called x; each needs a name of its own", [](Topology& t) { t.derived[0].name = "x"; }},
      {"constraint 1 and constraint 4 are both called fy; each needs a name of its own", [](Topology& t) { t.constraints[3].name = "fy"; }},
      {"body 1 and body 2 are both called base; each needs a name of its own", [](Topology& t) { t.bodies[1].name = "base"; }},
      {"body slider: its mass is -1 kg", [](Topology& t) { t.bodies[1].inertia.mass = -1; }},
  };
  for (const Slip& slip : slips) {
    const Refusal r = refusal_of(slip.spoil);
    CAPTURE(slip.sentence);
    CHECK(r.status == PM_FAILED);
    CHECK(r.sentence == slip.sentence);
  }
}

TEST_CASE("a home pose out of reach is the parameters' fault, one that is not finite the plugin's") {
  home_reach = -1;
  const Refusal unreachable = refusal_of(slider, {{0.4}, {0.1}});
  home_reach = 1;
  CHECK(unreachable.status == PM_BAD_ARGUMENT);
  CHECK(unreachable.sentence == "the home pose cannot be assembled: the rail is missing");

  home_value = std::nan("");
  const Refusal broken = refusal_of(slider, {{0.4}, {0.1}});
  home_value = 0;
  CHECK(broken.status == PM_FAILED);
  CHECK(broken.sentence == "the home pose: the geometry has no finite numbers there");
}

TEST_CASE("functions of a plugin that fail are told with what they were asked for") {
  pm_kinematics kinematics = *slider.kinematics;
  kinematics.topology = [](const pm_instance*, pm_topology*, pm_text* text) -> pm_status {
    contract::say(text, "out of paper");
    return PM_FAILED;
  };
  pm_mechanism mute = slider;
  mute.kinematics = &kinematics;
  CHECK(refusal_of(mute, {{0.4}, {0.1}}).sentence == "cannot tell its topology: out of paper");

  pm_dynamics dynamics = *slider.dynamics;
  dynamics.inertias = [](const pm_instance*, pm_list* out, pm_text*) -> pm_status {
    *out = {nullptr, 0, sizeof(pm_inertia)};
    return PM_OK;
  };
  pm_mechanism weightless = slider;
  weightless.dynamics = &dynamics;
  CHECK(refusal_of(weightless, {{0.4}, {0.1}}).sentence == "has 2 bodies, but inertias of 0");

  pm_mechanism bare = slider;
  bare.appearance = nullptr;
  CHECK(refusal_of(bare, {{0.4}, {0.1}}).sentence.empty());

  pm_mechanism empty_handed = slider;
  empty_handed.create = [](const pm_value*, std::size_t, pm_instance** out, pm_text*) -> pm_status {
    *out = nullptr;
    return PM_OK;
  };
  empty_handed.destroy = [](pm_instance*) {};
  CHECK(refusal_of(empty_handed, {{0.4}, {0.1}}).sentence == "made no instance, though it reported success");
}

TEST_CASE("what a plugin says when it cannot give its Jacobian is not lost, and leaves no number that could be taken for one") {
  pm_statics statics = *slider.statics;
  statics.jacobian = [](const pm_instance*, pm_order, size_t, const double*, double*, pm_text* text) -> pm_status {
    contract::say(text, "the lines meet in one point");
    return PM_SINGULAR;
  };
  pm_mechanism silent = slider;
  silent.statics = &statics;
  const Machine machine(silent, {{0.4}, {0.1}});
  const Jacobian g = machine.jacobian(machine.home_pose());
  CHECK_FALSE(g.known());
  CHECK(g.status == PM_SINGULAR);
  CHECK(g.why == "the lines meet in one point");
  CHECK(g.matrix.array().isNaN().all());

  std::vector<double> placement(3 * machine.layout().size()), jets(108, 7.0);
  CHECK(machine.jacobian(PM_JET, 1, placement.data(), jets.data()) == PM_SINGULAR);
  for (const double x : jets) CHECK(std::isnan(x));

  statics.jacobian = [](const pm_instance*, pm_order, size_t, const double*, double* out, pm_text*) -> pm_status {
    std::fill_n(out, 36, 1.0);
    out[7] = std::numeric_limits<double>::infinity();
    return PM_OK;
  };
  CHECK(machine.jacobian(machine.home_pose()).status == PM_SINGULAR);
  CHECK(machine.jacobian(machine.home_pose()).matrix.array().isNaN().all());
}

TEST_CASE("joints of a plugin of version 1.1, which know of no direction, count from home") {
  static std::vector<unsigned char> bytes;
  pm_kinematics kinematics = *slider.kinematics;
  kinematics.topology = [](const pm_instance* instance, pm_topology* out, pm_text* text) -> pm_status {
    const pm_status status = slider.kinematics->topology(instance, out, text);
    constexpr std::size_t old = offsetof(pm_joint, from);
    const auto* items = static_cast<const unsigned char*>(out->joints.items);
    bytes.clear();
    for (std::size_t i = 0; i < out->joints.count; ++i)
      bytes.insert(bytes.end(), items + i * out->joints.stride, items + i * out->joints.stride + old);
    out->joints = {bytes.data(), out->joints.count, old};
    return status;
  };
  pm_mechanism older = slider;
  older.kinematics = &kinematics;
  const Machine machine(older, {{0.4}, {0.1}});
  for (const Joint& j : machine.topology().joints) CHECK(j.from.isZero());
}

TEST_CASE("items of a newer plugin may be longer than ours") {
  struct LongerActuator {
    pm_actuator known;
    double unknown[3];
  };
  static LongerActuator items[1];
  pm_kinematics kinematics = *slider.kinematics;
  kinematics.topology = [](const pm_instance* instance, pm_topology* out, pm_text* text) -> pm_status {
    const pm_status status = slider.kinematics->topology(instance, out, text);
    items[0] = {*static_cast<const pm_actuator*>(out->actuators.items), {1, 2, 3}};
    out->actuators = {items, 1, sizeof(LongerActuator)};
    return status;
  };
  pm_mechanism newer = slider;
  newer.kinematics = &kinematics;
  const Machine machine(newer, {{0.4}, {0.1}});
  CHECK(machine.topology().actuators[0].name == "s");
  CHECK(machine.topology().actuators[0].stroke.max == 0.4);
}

TEST_CASE("a list that has no place for its items, more of them than any mechanism, or cuts them in two is not looked at") {
  static pm_list spoiled_bodies, spoiled_joints;
  pm_kinematics kinematics = *slider.kinematics;
  kinematics.topology = [](const pm_instance* instance, pm_topology* out, pm_text* text) -> pm_status {
    const pm_status status = slider.kinematics->topology(instance, out, text);
    if (spoiled_bodies.count > 0) out->bodies = spoiled_bodies;
    if (spoiled_joints.count > 0) out->joints = spoiled_joints;
    return status;
  };
  pm_dynamics dynamics = *slider.dynamics;
  dynamics.inertias = [](const pm_instance* instance, pm_list* out, pm_text* text) -> pm_status {
    const pm_status status = slider.dynamics->inertias(instance, out, text);
    if (spoiled_bodies.count > 0) out->count = spoiled_bodies.count;
    return status;
  };
  pm_mechanism spoiled = slider;
  spoiled.kinematics = &kinematics;
  spoiled.dynamics = &dynamics;
  const auto told = [&](const pm_list& bodies, const pm_list& joints) {
    spoiled_bodies = bodies, spoiled_joints = joints;
    return refusal_of(spoiled, {{0.4}, {0.1}}).sentence;
  };
  static const char place[64]{};
  CHECK(told({}, {}).empty());
  CHECK(told({nullptr, 2, sizeof(pm_body)}, {}) == "declares a list that has items but no place for them");
  CHECK(told({place, std::size_t{1} << 40, sizeof(pm_body)}, {}) == "declares a list of more items than any mechanism has");
  CHECK(told({place, 2, 12}, {}) == "declares a list whose stride cuts its items in two");
  CHECK(told({}, {nullptr, 1, sizeof(pm_joint)}) == "declares a list that has items but no place for them");
  CHECK(told({}, {place, 1, 0}) == "declares a list that has items but no place for them");
  CHECK(told({}, {place, 1, 20}) == "declares a list whose stride cuts its items in two");
}

TEST_CASE("a pose tells whether it is out of reach or not finite") {
  const Machine machine(test::slider_crank(), {{0}, {0.4}, {0.35}});
  const double far[] = {-1.5};
  const Pose pose = machine.pose(far);
  CHECK(pose.status == PM_UNREACHABLE);
  CHECK(pose.why == "the rod is too short");
  const Machine broken(test::slider_crank(), {{13}, {0.2}, {0.5}});
  const double beyond[] = {1.0};
  CHECK(broken.pose(beyond).status == PM_SINGULAR);
  CHECK(broken.pose(beyond).why == "the geometry has no finite numbers there");
}

TEST_CASE("a slender body has a right-handed frame with z along its axis") {
  const Machine machine = test::make_hexapod(test::BaseJoint::ball);
  for (int limb = 0; limb < 6; ++limb) {
    const Eigen::Matrix3d r = machine.rotation(machine.home_pose(), 2 + 2 * limb);
    CHECK((r.transpose() * r - Eigen::Matrix3d::Identity()).norm() < 1e-14);
    CHECK(r.determinant() > 0);
    CHECK((r.col(2) - machine.axis(machine.home_pose(), 3 * limb + 1)).norm() < 1e-15);
  }
}
