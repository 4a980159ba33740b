// Gough's, Stewart's and the two parallel-cross mechanisms as their tests meet them: the same six coordinates, the same reference file.
#pragma once

#include <core/mechanics/model/closed_form.hpp>
#include <core/mechanics/statics/statics.hpp>
#include <core/numbers.hpp>
#include <tests/given/reference.hpp>
#include <tests/plugins/plugin.hpp>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <memory>

namespace pmreport::test {

using mechanics::Machine;

// By the names of the reference: "gough", "stewart", "cross1" (inner cross drives), "cross2" (outer).
std::unique_ptr<Machine> hexapod(const std::string& name);

// det G at home but for the yaw `alpha` [rad].
double det_at_yaw(const Machine& machine, double alpha);

// The yaw [deg] between `low` and `high` at which det G changes its sign, to the last digits of a double.
double singular_yaw(const Machine& machine, double low, double high);

void check_matrix(const char* what, const Eigen::MatrixXd& seen, const Eigen::MatrixXd& expected);

// The joints called `letter`1, `letter`2, ... stand at `points`, of which the first is that of joint 1 + `first`.
void check_centres(const mechanics::State& s, const Machine& machine, const std::string& letter, const json& points, std::size_t first = 0);

// The reference lists the heads D of the cross chains in the order of their feet: that of chain 1 is D1 of Stewart's platform, on leg 1,
// and D2 of the parallel-cross mechanisms, on leg 2.
std::size_t first_head(const json& c);

mechanics::State state_of(const Machine& machine, const json& c);

// Displacement, rates, accelerations, the matrices of the source and massless statics of one reference case.
void check_case(const json& c);

// Every reference case of `mechanism`, of which there are two.
void check_cases(const std::string& mechanism);

// A uniform solid cylinder from `low` to `high` along z [m], by the mean squares of x, y (r^2/4) and z over it: I_xx = m <y^2 + z^2>.
void check_cylinder(const Body& body, const json& solid, double low, double high);

const Body& body_named(const Machine& machine, const std::string& name);
const mechanics::BodyState& body_state(const Machine& machine, const mechanics::State& s, const std::string& name);

// Angle between two directions [rad].
double angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

// The sentence with which a mechanism refuses these parameters.
std::string refusal(const std::string& name, const std::map<std::string, std::vector<double>>& changes);

// The body frames of a case with cross chains: x along the second axis of the Cardan joint at the chain's head, which lies across the chain
// and across the joint's first axis: on the platform tangential to its circle, on the leg that carries D as `on_leg` lists it, along u, e2
// and u x e2 of that leg.
void check_spins(const json& c, const json& on_leg);

}  // namespace pmreport::test
