// Elementary rotations and frames, for every scalar.
#pragma once

#include <pmreport/scalar.hpp>

namespace pmreport {

// Rotation by `angle` about a coordinate axis: columns are the turned axes.
template <class T>
Matrix3<T> rotation_x(const T& angle) {
  const T c = cos(angle), s = sin(angle);
  Matrix3<T> r;
  r << T(1.0), T(0.0), T(0.0), T(0.0), c, -s, T(0.0), s, c;
  return r;
}
template <class T>
Matrix3<T> rotation_y(const T& angle) {
  const T c = cos(angle), s = sin(angle);
  Matrix3<T> r;
  r << c, T(0.0), s, T(0.0), T(1.0), T(0.0), -s, T(0.0), c;
  return r;
}
template <class T>
Matrix3<T> rotation_z(const T& angle) {
  const T c = cos(angle), s = sin(angle);
  Matrix3<T> r;
  r << c, -s, T(0.0), s, c, T(0.0), T(0.0), T(0.0), T(1.0);
  return r;
}

// R = Rz(a) Ry(b) Rx(c), multiplied out: a third of the arithmetic of two matrix products.
template <class T>
Matrix3<T> rotation_zyx(const T& a, const T& b, const T& c) {
  const T ca = cos(a), sa = sin(a), cb = cos(b), sb = sin(b), cc = cos(c), sc = sin(c);
  const T ca_sb = ca * sb, sa_sb = sa * sb;
  Matrix3<T> r;
  r << ca * cb, ca_sb * sc - sa * cc, ca_sb * cc + sa * sc,  //
      sa * cb, sa_sb * sc + ca * cc, sa_sb * cc - ca * sc,   //
      -sb, cb * sc, cb * cc;
  return r;
}

// R = Rz(a) Rx(b) Ry(c), likewise.
template <class T>
Matrix3<T> rotation_zxy(const T& a, const T& b, const T& c) {
  const T ca = cos(a), sa = sin(a), cb = cos(b), sb = sin(b), cc = cos(c), sc = sin(c);
  const T sa_sb = sa * sb, ca_sb = ca * sb;
  Matrix3<T> r;
  r << ca * cc - sa_sb * sc, -sa * cb, ca * sc + sa_sb * cc,  //
      sa * cc + ca_sb * sc, ca * cb, sa * sc - ca_sb * cc,    //
      -cb * sc, sb, cb * cc;
  return r;
}

// Frame whose x axis is `x` and whose z axis is `z`: two perpendicular unit vectors.
template <class T>
Matrix3<T> frame_xz(const Vector3<T>& x, const Vector3<T>& z) {
  Matrix3<T> r;
  r.col(0) = x;
  r.col(1) = z.cross(x);
  r.col(2) = z;
  return r;
}

}  // namespace pmreport
