// What every scalar of the geometry must do, and Eigen's view of it.
//
// The geometry of a mechanism is written once, as templates over a scalar T: double, Jet (rates and accelerations in time), Partials
// (derivatives by the independent coordinates), Lanes (several poses at once), Jet or Partials of Lanes, and Recorded, which writes down
// what is done with it and so serves every other kind of number. A scalar offers
// + - * /, sqrt, sin, cos, tan, asin, acos, atan2, hypot, abs, and choose(mask, a, b) where a comparison yields the mask.
// Keep constants plain: `2.0 * x`, not `T(2.0) * x`; for a Jet that is a third of the work.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <type_traits>

namespace pmreport {

template <class T>
using Vector3 = Eigen::Matrix<T, 3, 1>;
template <class T>
using Matrix3 = Eigen::Matrix<T, 3, 3>;
template <class T>
using Matrix6 = Eigen::Matrix<T, 6, 6>;

using std::abs, std::acos, std::asin, std::atan2, std::cos, std::hypot, std::sin, std::sqrt, std::tan;

// choose(mask, a, b): a where the mask holds, else b. The mask of a plain number is a bool, of Lanes one bool a lane.
inline double choose(bool mask, double a, double b) { return mask ? a : b; }
inline long double choose(bool mask, long double a, long double b) { return mask ? a : b; }
inline long double choose(bool mask, long double a, double b) { return mask ? a : b; }
inline long double choose(bool mask, double a, long double b) { return mask ? a : b; }

template <class T>
T smaller(const T& a, const std::type_identity_t<T>& b) {
  return choose(a < b, a, b);
}
template <class T>
T larger(const T& a, const std::type_identity_t<T>& b) {
  return choose(a < b, b, a);
}
template <class T>
T square(const T& x) {
  return x * x;
}

// What Eigen's norm() and normalized() come to with a scalar of ours, and an `if` on one: the compiler's one error says what to write.
// normalized() asks whether the length is positive, which Lanes, several poses at a time, cannot answer with one bool.
template <class Void>
bool refused() {
  static_assert(!std::is_void_v<Void>,
                "on a scalar of the geometry: write length(v) for v.norm(), unit(v) for v.normalized(), and choose(mask, a, b) for an if "
                "or a ?:");
  return false;
}

// Length and direction of a vector.
template <class T>
T length(const Vector3<T>& v) {
  return sqrt(T(v.dot(v)));
}
template <class T>
Vector3<T> unit(const Vector3<T>& v) {
  const T scale = 1.0 / length(v);
  return v * scale;
}

}  // namespace pmreport

// A scalar S of ours mixes with double in Eigen's expressions: a constant point stays a Vector3<double>.
#define PMREPORT_EIGEN_SCALAR(S, ...)                                                                                       \
  template <__VA_ARGS__>                                                                                                    \
  struct Eigen::NumTraits<S> : Eigen::GenericNumTraits<S> {                                                                 \
    using Real = S;                                                                                                         \
    using NonInteger = S;                                                                                                   \
    using Nested = S;                                                                                                       \
    using Literal = double;                                                                                                 \
    enum { IsComplex = 0, IsInteger = 0, IsSigned = 1, RequireInitialization = 0, ReadCost = 3, AddCost = 3, MulCost = 9 }; \
  };                                                                                                                        \
  template <__VA_ARGS__>                                                                                                    \
  struct Eigen::internal::sqrt_impl<S> {                                                                                    \
    template <class X>                                                                                                      \
    static X run(const X& x) {                                                                                              \
      return pmreport::refused<decltype(void(X()))>() ? x : X();                                                            \
    }                                                                                                                       \
  };                                                                                                                        \
  template <__VA_ARGS__ PMREPORT_EIGEN_COMMA(__VA_ARGS__) class BinaryOp>                                                   \
  struct Eigen::ScalarBinaryOpTraits<S, double, BinaryOp> {                                                                 \
    using ReturnType = S;                                                                                                   \
  };                                                                                                                        \
  template <__VA_ARGS__ PMREPORT_EIGEN_COMMA(__VA_ARGS__) class BinaryOp>                                                   \
  struct Eigen::ScalarBinaryOpTraits<double, S, BinaryOp> {                                                                 \
    using ReturnType = S;                                                                                                   \
  };
#define PMREPORT_EIGEN_COMMA(...) __VA_OPT__(, )

// Extended precision mixes with plain constants too.
template <class BinaryOp>
struct Eigen::ScalarBinaryOpTraits<long double, double, BinaryOp> {
  using ReturnType = long double;
};
template <class BinaryOp>
struct Eigen::ScalarBinaryOpTraits<double, long double, BinaryOp> {
  using ReturnType = long double;
};
