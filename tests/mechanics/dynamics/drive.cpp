// Between a motor and its actuator.
#include <core/mechanics/dynamics/drive.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <random>

using namespace pmreport::mechanics;

TEST_CASE("losses take from the power that flows, whichever way it flows") {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> any(-10, 10), share(0.1, 1);
  for (int i = 0; i < 200; ++i) {
    const DriveTrain d{share(generator)};
    const double force = any(generator), rate = any(generator);
    CAPTURE(d.efficiency, force, rate);
    const double out = force * rate, in = drive_force(d, force, rate) * rate;
    CHECK(in >= out);  // the drive never gains
    // What leaves the drive is its efficiency times what enters: the actuator's power when it pushes, the motor's when it is driven back.
    CHECK((out > 0 ? out / in : in / out) == Approx(d.efficiency).epsilon(1e-13));
  }
}

TEST_CASE("an actuator that stands still is taken to push") {
  CHECK(drive_force({0.5}, -3, 0) == -6);
  CHECK(drive_force({0.5}, 0, 2) == 0);
}

TEST_CASE("the convention that always divides asks more of a drive that is driven back than losses do") {
  const DriveTrain by_power{0.8}, divides{0.8, EfficiencyConvention::always_divides};
  CHECK(drive_force(by_power, 100, 1) == Approx(125));
  CHECK(drive_force(divides, 100, 1) == Approx(125));
  CHECK(drive_force(by_power, 100, -1) == Approx(80));
  CHECK(drive_force(divides, 100, -1) == Approx(125));
}

TEST_CASE("a screw turns force into torque by its lead, and its own inertia asks for more") {
  const double lead = 0.005;
  const DriveTrain screw{1, EfficiencyConvention::by_power, 2 * std::numbers::pi / lead, 12e-6};
  // 1 kN over one turn of 5 mm is 5 J, over 2 pi of angle. 2 m/s^2 are 400 turns/s^2.
  const MotorState m = motor(screw, 1000, 0.1, 2);
  CHECK(m.torque == Approx(5 / (2 * std::numbers::pi) + 12e-6 * 400 * 2 * std::numbers::pi).epsilon(1e-13));
  CHECK(m.speed == Approx(20 * 2 * std::numbers::pi).epsilon(1e-13));
  CHECK(m.power() == Approx(m.torque * m.speed));
}

TEST_CASE("any list of limits counts") {
  MotionLimits limits;
  CHECK_FALSE(limits.any());
  limits.force = limits.joint_moment = {MotionLimits::none, MotionLimits::none};
  CHECK_FALSE(limits.any());
  limits.joint_moment[1] = 3;
  CHECK(limits.any());
}
