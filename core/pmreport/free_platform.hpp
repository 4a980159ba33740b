// A platform with all six freedoms, its pose x, y, z and three turns in the order z, x', y'':  R = Rz(alpha) Rx(beta) Ry(gamma).
#pragma once

#include <pmreport/placement.hpp>
#include <pmreport/rotation.hpp>

#include <array>
#include <vector>

namespace pmreport {

// Coordinates about `home` (x y z [m], alpha beta gamma [rad]), in a box of these half widths.
inline std::vector<Coordinate> free_pose(const std::array<double, 6>& home, double half_position, double half_angle) {
  constexpr const char* names[] = {"x", "y", "z", "alpha", "beta", "gamma"};
  constexpr const char* titles[] = {"X position", "Y position", "Z position", "turn about z0", "turn about x1", "turn about y2"};
  std::vector<Coordinate> out;
  for (std::size_t k = 0; k < 6; ++k)
    out.push_back(Coordinate::around(home[k], k < 3 ? half_position : half_angle, names[k], titles[k], k < 3 ? "m" : "rad"));
  return out;
}

// Places the platform; returns its rotation.
template <class T>
Matrix3<T> place_free(Placement<T>& at, int platform, const std::array<T, 6>& q) {
  const Matrix3<T> r = rotation_zxy(q[3], q[4], q[5]);
  at.body(platform, Vector3<T>(q[0], q[1], q[2]), r);
  return r;
}

// D of t = D X', t = (v; w) the platform's twist and X its pose:  D = (I, 0; 0, L),  the columns of L the axes of the turns, z0, x1, y2.
// Singular where beta is a quarter turn, and z0 and y2 are one axis.
inline Matrix6<double> twist_map(const std::array<double, 6>& q, const Matrix3<double>& rotation) {
  Matrix6<double> d = Matrix6<double>::Identity();
  d.bottomRightCorner<3, 3>() << Eigen::Vector3d::UnitZ(), Eigen::Vector3d(cos(q[3]), sin(q[3]), 0), rotation.col(1);
  return d;
}

// dB/dX of a point B of the platform, at `arm` from its reference point: (I, z0 x arm, x1 x arm, y2 x arm).
inline Eigen::Matrix<double, 3, 6> point_partials(const Matrix6<double>& twists, const Eigen::Vector3d& arm) {
  Eigen::Matrix<double, 3, 6> e = twists.topRows<3>();
  for (int k = 3; k < 6; ++k) e.col(k) = twists.col(k).tail<3>().cross(arm);
  return e;
}

// The matrices of six constraint equations f(X, rho) = 0 as a source states them:  A X' + B rho' = 0,  A = df/dX,  B = df/drho;  t = D X'.
inline std::vector<SourceMatrix> constraint_matrices() {
  return {{"A", "constraint equations by the pose", 6, 6, Rates::coordinates, Rates::none, 0},
          {"B", "constraint equations by the drives", 6, 6, Rates::actuators, Rates::none, 0},
          {"D", "twist from the rates of the pose", 6, 6, Rates::coordinates, Rates::twist, 1}};
}

}  // namespace pmreport
