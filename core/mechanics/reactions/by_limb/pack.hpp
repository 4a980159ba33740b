// Numbers of several poses side by side, and vectors of them. Everything here is inlined into functions that each name their processor, so
// that no wide instruction is left where another processor could meet it; that is why neither Eigen nor the standard library serves.
#pragma once

#include <cstddef>
#include <cstdint>

#define PMREPORT_INLINE [[gnu::always_inline]] inline

namespace pmreport::mechanics {

template <int N>
struct Register;
template <>
struct Register<2> {
  typedef double Type __attribute__((vector_size(16)));
};
template <>
struct Register<4> {
  typedef double Type __attribute__((vector_size(32)));
};
template <>
struct Register<8> {
  typedef double Type __attribute__((vector_size(64)));
};

template <int N>
struct Pack {
  using Numbers = typename Register<N>::Type;
  static constexpr std::size_t width = N;
  Numbers v;

  Pack() = default;
  PMREPORT_INLINE Pack(const Numbers& numbers) : v(numbers) {}
  PMREPORT_INLINE Pack(double same) : v(Numbers{} + same) {}
  PMREPORT_INLINE double lane(std::size_t i) const { return v[i]; }
  PMREPORT_INLINE static Pack load(const double* from) {
    Pack x;
    __builtin_memcpy(&x.v, from, sizeof(Numbers));
    return x;
  }
  PMREPORT_INLINE void store(double* to, std::size_t lanes) const {
    if (lanes == width)
      __builtin_memcpy(to, &v, sizeof(Numbers));
    else
      for (std::size_t i = 0; i < lanes; ++i) to[i] = v[i];
  }
};

template <>
struct Pack<1> {
  static constexpr std::size_t width = 1;
  double v;

  Pack() = default;
  PMREPORT_INLINE Pack(double x) : v(x) {}
  PMREPORT_INLINE double lane(std::size_t) const { return v; }
  PMREPORT_INLINE static Pack load(const double* from) { return *from; }
  PMREPORT_INLINE void store(double* to, std::size_t) const { *to = v; }
};

template <int N>
PMREPORT_INLINE Pack<N> operator+(const Pack<N>& a, const Pack<N>& b) {
  return a.v + b.v;
}
template <int N>
PMREPORT_INLINE Pack<N> operator-(const Pack<N>& a, const Pack<N>& b) {
  return a.v - b.v;
}
template <int N>
PMREPORT_INLINE Pack<N> operator-(const Pack<N>& a) {
  return -a.v;
}
template <int N>
PMREPORT_INLINE Pack<N> operator*(const Pack<N>& a, const Pack<N>& b) {
  return a.v * b.v;
}
template <int N>
PMREPORT_INLINE Pack<N> operator*(const Pack<N>& a, double b) {
  return a.v * b;
}
template <int N>
PMREPORT_INLINE Pack<N> operator/(const Pack<N>& a, const Pack<N>& b) {
  return a.v / b.v;
}
template <int N>
PMREPORT_INLINE void operator+=(Pack<N>& a, const Pack<N>& b) {
  a.v += b.v;
}
template <int N>
PMREPORT_INLINE void operator-=(Pack<N>& a, const Pack<N>& b) {
  a.v -= b.v;
}

template <int N>
PMREPORT_INLINE Pack<N> root(const Pack<N>& a) {
  Pack<N> r;
  if constexpr (N == 1)
    r.v = __builtin_sqrt(a.v);
  else
    for (int i = 0; i < N; ++i) r.v[i] = __builtin_sqrt(a.v[i]);
  return r;
}
// a < b ? yes : no, which a NaN answers with no. Of a single number too without a branch: which way it would go, nothing foretells.
template <int N>
PMREPORT_INLINE Pack<N> where_less(const Pack<N>& a, const Pack<N>& b, const Pack<N>& yes, const Pack<N>& no) {
  if constexpr (N == 1) {
    const std::uint64_t mask = -static_cast<std::uint64_t>(a.v < b.v);
    const auto bits = [](double x) { return __builtin_bit_cast(std::uint64_t, x); };
    return __builtin_bit_cast(double, (bits(yes.v) & mask) | (bits(no.v) & ~mask));
  } else {
    return a.v < b.v ? yes.v : no.v;
  }
}
// 1 where a < b, else 0.
template <int N>
PMREPORT_INLINE Pack<N> less(const Pack<N>& a, const Pack<N>& b) {
  if constexpr (N == 1)
    return static_cast<double>(a.v < b.v);
  else
    return where_less(a, b, Pack<N>(1.0), Pack<N>(0.0));
}
template <int N>
PMREPORT_INLINE Pack<N> larger(const Pack<N>& a, const Pack<N>& b) {
  return a.v < b.v ? b.v : a.v;
}
template <int N>
PMREPORT_INLINE Pack<N> magnitude(const Pack<N>& a) {
  if constexpr (N == 1)
    return __builtin_fabs(a.v);
  else
    return larger(a, -a);
}

template <class T>
struct Triple {
  T x, y, z;
};
template <class T>
PMREPORT_INLINE Triple<T> operator+(const Triple<T>& a, const Triple<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
PMREPORT_INLINE Triple<T> operator-(const Triple<T>& a, const Triple<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T, class S>
PMREPORT_INLINE Triple<T> operator*(const Triple<T>& a, const S& s) {
  return {a.x * s, a.y * s, a.z * s};
}
template <class T>
PMREPORT_INLINE void operator+=(Triple<T>& a, const Triple<T>& b) {
  a = a + b;
}
template <class T>
PMREPORT_INLINE void operator-=(Triple<T>& a, const Triple<T>& b) {
  a = a - b;
}
template <class T>
PMREPORT_INLINE T dot(const Triple<T>& a, const Triple<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
PMREPORT_INLINE Triple<T> cross(const Triple<T>& a, const Triple<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
PMREPORT_INLINE Triple<T> zero() {
  return {T(0.0), T(0.0), T(0.0)};
}
template <class T>
PMREPORT_INLINE Triple<T> unit(const Triple<T>& a) {
  return a * (T(1.0) / root(dot(a, a)));
}

// Two unit vectors that complete the unit vector n to a frame, without a branch and without loss of digits anywhere: Duff et al. 2017,
// Building an orthonormal basis, revisited, J. Computer Graphics Techniques 6(1).
template <class T>
PMREPORT_INLINE void complete(const Triple<T>& n, Triple<T>& e1, Triple<T>& e2) {
  const T sign = where_less(n.z, T(0.0), T(-1.0), T(1.0));
  const T a = T(-1.0) / (sign + n.z), b = n.x * n.y * a;
  e1 = {T(1.0) + sign * n.x * n.x * a, sign * b, -(sign * n.x)};
  e2 = {b, sign + n.y * n.y * a, -n.y};
}

}  // namespace pmreport::mechanics
