// The axes in which joint reactions are read.
#include <core/mechanics/model/joint_frame.hpp>

#include <tests/mechanics/massive.hpp>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {
constexpr double frame_rounding = 1e-13;

const Joint& declared(const Machine& machine, int joint) { return machine.topology().joints[static_cast<std::size_t>(joint)]; }
const JointState& placed(const State& s, int joint) { return s.joints[static_cast<std::size_t>(joint)]; }
const Matrix3d& rotation(const State& s, int body) { return s.bodies[static_cast<std::size_t>(body)].rotation; }
}  // namespace

TEST_CASE("every joint's axes are a right-handed frame with the joint's own axis first") {
  std::mt19937_64 random(81);
  const Machine machines[] = {test::make_hexapod(test::BaseJoint::ball),
                              test::make_hexapod(test::BaseJoint::universal),
                              test::make(test::arm()),
                              test::make(test::four_bar()),
                              test::make(test::slider_crank()),
                              test::make_engine()};
  for (const Machine& machine : machines) {
    const JointFrames frames(machine);
    for (int k = 0; k < 10; ++k) {
      const test::Motion motion = test::random_motion(machine, random);
      const State s = motion.state(machine);
      for (int j = 0; j < static_cast<int>(s.joints.size()); ++j) {
        INFO(machine.info().name << ", joint " << declared(machine, j).name << ", q = " << motion.q.transpose());
        const Matrix3d f = frames(s, j);
        CHECK((f.transpose() * f - Matrix3d::Identity()).norm() < frame_rounding);
        CHECK(f.determinant() > 0);
        const bool ball = declared(machine, j).kind == JointKind::spherical;
        const Vector3d own = ball ? Vector3d(rotation(s, declared(machine, j).stud).col(2)) : placed(s, j).axis[0];
        CHECK((f.col(0) - own).norm() < frame_rounding);
      }
    }
  }
}

TEST_CASE("a frame turns with body a, and stays in it") {
  // Axis 1 of these joints is fixed in body a, and so is the mark that tells axis 2.
  std::mt19937_64 random(82);
  for (const pm_mechanism* table : {&test::arm(), &test::four_bar()}) {
    const Machine machine = test::make(*table);
    const JointFrames frames(machine);
    const State home =
        test::Motion{machine.home(), Eigen::VectorXd::Zero(machine.dof()), Eigen::VectorXd::Zero(machine.dof())}.state(machine);
    for (int k = 0; k < 5; ++k) {
      const State s = test::random_motion(machine, random).state(machine);
      for (int j = 0; j < static_cast<int>(s.joints.size()); ++j) {
        INFO(table->name << ", joint " << declared(machine, j).name);
        const int a = declared(machine, j).a;
        CHECK((rotation(s, a).transpose() * frames(s, j) - rotation(home, a).transpose() * frames(home, j)).norm() < frame_rounding);
      }
    }
  }
}

TEST_CASE("axis 2 of a universal joint is its second axis") {
  const Machine machine = test::make_hexapod(test::BaseJoint::universal);
  const JointFrames frames(machine);
  std::mt19937_64 random(83);
  const State s = test::random_motion(machine, random).state(machine);
  for (int i = 1; i <= 6; ++i) {
    const int j = test::joint_named(machine, "A" + std::to_string(i));
    CHECK((frames(s, j).col(1) - placed(s, j).axis[1]).norm() < frame_rounding);
  }
}

TEST_CASE("a slender leg does not carry a frame: the platform does, or the base") {
  const Machine machine = test::make_hexapod(test::BaseJoint::ball);
  const JointFrames frames(machine);
  std::mt19937_64 random(84);
  for (int k = 0; k < 5; ++k) {
    const State s = test::random_motion(machine, random).state(machine);
    for (int i = 1; i <= 6; ++i) {
      const std::string n = std::to_string(i);
      // Both neighbours of the slide are slender; those of the balls are the base and the platform. Of the base axes x or y stands most
      // across a leg, and axis 3 is across both.
      for (const auto& [joint, carrier] : {std::pair{"A" + n, 0}, std::pair{"P" + n, 0}, std::pair{"B" + n, 1}}) {
        const int j = test::joint_named(machine, joint);
        CAPTURE(joint);
        const JointFrames::Recipe& r = frames.recipe(j);
        CHECK(r.carrier == carrier);
        const Vector3d mark = rotation(s, r.carrier) * r.mark, third = frames(s, j).col(2);
        CHECK(std::abs(third.dot(mark)) < frame_rounding);
        CHECK(frames(s, j).col(1).dot(mark) > 0.5);  // its share across axis 1 is most of it
      }
    }
  }
}

TEST_CASE("the mark is the base axis that stands most across axis 1 at home") {
  const Machine machine = test::make_engine();  // revolute joints about z, a slide along x
  const JointFrames frames(machine);
  const State home = test::state_of(machine, machine.home()(0), 0, 0);
  for (int j = 0; j < 3; ++j) CHECK((frames(home, j).col(1) - Vector3d::UnitX()).norm() < frame_rounding);
  CHECK((frames(home, 3).col(1) - Vector3d::UnitY()).norm() < frame_rounding);
}
