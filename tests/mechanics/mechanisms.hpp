// Small mechanisms whose answers are known by hand, written as a plugin author would write them and used in-process.
#pragma once

#include <pmreport/plugin.h>

#include <Eigen/Core>
#include <core/mechanics/machine/machine.hpp>
#include <core/mechanics/model/state.hpp>
#include <random>
#include <string_view>

namespace pmreport::test {

// Gough's platform: six limbs, base circle 0.5 m, platform circle 0.25 m, home height 0.6 m. Every limb ends at the base in a ball (then
// it spins freely: 6 idle freedoms) or in a universal joint whose first axis is the tangent of the base circle. Coordinates x y z [m],
// alpha beta gamma [rad], R = Rz(alpha) Ry(beta) Rx(gamma).
const pm_mechanism& hexapod();
enum class BaseJoint { ball = 0, universal = 1 };

// Planar four-bar in the plane z = 0: A (0, 0), D (0.5, 0), crank AB 0.2, coupler BC 0.45, rocker CD 0.35 [m]. The crank drives; the
// coupler carries the load, reference point B. One degree of freedom, and 3 constraints more than needed.
const pm_mechanism& four_bar();

// A serial arm: turns about Z by theta, and on its x axis a sleeve slides by d and turns by phi. Three degrees of freedom, a revolute and
// a cylindrical joint, the latter with two actuators.
const pm_mechanism& arm();

// Spatial slider-crank; see tests/given/slider_crank.hpp.
const pm_mechanism& slider_crank();

mechanics::Machine make(const pm_mechanism& table);
mechanics::Machine make_hexapod(BaseJoint base);

int joint_named(const mechanics::Machine& machine, std::string_view name);  // throws std::out_of_range
int body_named(const mechanics::Machine& machine, std::string_view name);

// A motion through `q` with this rate and acceleration at time 0, and with no more than that.
struct Motion {
  Eigen::VectorXd q, rate, acceleration;

  Eigen::VectorXd at(double t) const { return q + t * rate + 0.5 * t * t * acceleration; }
  Eigen::VectorXd rate_at(double t) const { return rate + t * acceleration; }
  mechanics::State state(const mechanics::Machine& machine, double t = 0) const;
};

// Random, in the box of the coordinates, rates of about a box a second.
Motion random_motion(const mechanics::Machine& machine, std::mt19937_64& random);

}  // namespace pmreport::test
