// Where everything is at a configuration: a view of the host's row of numbers, read and written in the scalar T of the geometry.
#pragma once

#include <pmreport/jet.hpp>
#include <pmreport/lanes.hpp>
#include <pmreport/partials.hpp>
#include <pmreport/topology.hpp>

namespace pmreport {

// How a scalar T stands in the contract's arrays: `Codec<T>::components` doubles, `stride` (the number of poses) apart.
template <class T>
struct Codec;
template <>
struct Codec<double> {
  static constexpr std::size_t components = 1;
  static double load(const double* at, std::size_t) { return *at; }
  static void store(double* at, std::size_t, double x) { *at = x; }
};
template <>
struct Codec<Lanes> {
  static constexpr std::size_t components = 1;
  static Lanes load(const double* at, std::size_t) { return Lanes::load(at); }
  static void store(double* at, std::size_t, const Lanes& x) { x.store(at); }
};
template <>
struct Codec<long double> {  // high part, low part
  static constexpr std::size_t components = 2;
  static long double load(const double* at, std::size_t stride) {
    return static_cast<long double>(at[0]) + static_cast<long double>(at[stride]);
  }
  static void store(double* at, std::size_t stride, long double x) {
    at[0] = static_cast<double>(x);
    at[stride] = static_cast<double>(x - static_cast<long double>(at[0]));
  }
};
template <class S>
struct Codec<Jet<S>> {
  static constexpr std::size_t components = 3;
  static Jet<S> load(const double* at, std::size_t stride) {
    return {Codec<S>::load(at, stride), Codec<S>::load(at + stride, stride), Codec<S>::load(at + 2 * stride, stride)};
  }
  static void store(double* at, std::size_t stride, const Jet<S>& x) {
    Codec<S>::store(at, stride, x.value);
    Codec<S>::store(at + stride, stride, x.rate);
    Codec<S>::store(at + 2 * stride, stride, x.acceleration);
  }
};
template <class S, int M>
struct Codec<Partials<S, M>> {
  static constexpr std::size_t components = 1 + M;
  static Partials<S, M> load(const double* at, std::size_t stride) {
    Partials<S, M> x;
    x.value = Codec<S>::load(at, stride);
    for (std::size_t i = 0; i < M; ++i) x.partial[i] = Codec<S>::load(at + (1 + i) * stride, stride);
    return x;
  }
  static void store(double* at, std::size_t stride, const Partials<S, M>& x) {
    Codec<S>::store(at, stride, x.value);
    for (std::size_t i = 0; i < M; ++i) Codec<S>::store(at + (1 + i) * stride, stride, x.partial[i]);
  }
};

template <class T>
class Placement {
 public:
  // `data` points at pose k of an array of `stride` poses.
  Placement(double* data, std::size_t stride, const Layout& layout) : data_(data), stride_(stride), layout_(&layout) { set(0, T(1.0)); }
  Placement(const double* data, std::size_t stride, const Layout& layout)
      : data_(const_cast<double*>(data)), stride_(stride), layout_(&layout) {}

  // -- what `place` says ------------------------------------------------------------------------------------------------------------

  // The pose exists only while `margin` is positive (say, a radicand). `why` completes "cannot be assembled: ..."; it must outlive the
  // call.
  void require(const T& margin, const char* why) {
    if constexpr (std::is_same_v<T, double>) {
      if (margin < 0 && why_ == nullptr) why_ = why;
    }
    const T now = get(0);  // what is out of reach stays so, whatever follows from numbers that mean nothing any more
    set(0, choose(now < T(0.0), now, smaller(now, margin)));
  }
  // A body: its origin and rotation (body axes to base axes); a slender one: its origin and unit z axis.
  void body(int i, const Vector3<T>& origin, const Matrix3<T>& rotation) {
    const std::size_t at = layout_->body(i);
    put(at, origin);
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) set(at + 3 + static_cast<std::size_t>(3 * r + c), rotation(r, c));
  }
  void slender(int i, const Vector3<T>& origin, const Vector3<T>& axis) {
    put(layout_->body(i), origin);
    put(layout_->body(i) + 3, axis);
  }
  // A joint: its centre, and its unit axes where it has any.
  void joint(int i, const Vector3<T>& centre) { put(layout_->joint(i), centre); }
  void joint(int i, const Vector3<T>& centre, const Vector3<T>& axis) {
    joint(i, centre);
    put(layout_->joint(i) + 3, axis);
  }
  void joint(int i, const Vector3<T>& centre, const Vector3<T>& axis1, const Vector3<T>& axis2) {
    joint(i, centre, axis1);
    put(layout_->joint(i) + 6, axis2);
  }
  void actuator(int i, const T& value) { set(layout_->actuator(i), value); }
  void derived(int i, const T& value) { set(layout_->derived(i), value); }

  // -- what `jacobian` and the host ask ---------------------------------------------------------------------------------------------

  T reach() const { return get(0); }
  const char* why() const { return why_; }
  Vector3<T> origin(int body) const { return vector(layout_->body(body)); }
  Matrix3<T> rotation(int body) const {  // not of a slender body
    Matrix3<T> r;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) r(i, j) = get(layout_->body(body) + 3 + static_cast<std::size_t>(3 * i + j));
    return r;
  }
  Vector3<T> spine(int body) const { return vector(layout_->body(body) + 3); }  // z axis of a slender body
  Vector3<T> centre(int joint) const { return vector(layout_->joint(joint)); }
  Vector3<T> axis(int joint, int k = 0) const { return vector(layout_->joint(joint) + 3 + 3 * static_cast<std::size_t>(k)); }
  T actuator(int i) const { return get(layout_->actuator(i)); }
  T derived(int i) const { return get(layout_->derived(i)); }

 private:
  T get(std::size_t scalar) const { return Codec<T>::load(data_ + scalar * Codec<T>::components * stride_, stride_); }
  void set(std::size_t scalar, const T& x) { Codec<T>::store(data_ + scalar * Codec<T>::components * stride_, stride_, x); }
  Vector3<T> vector(std::size_t at) const { return {get(at), get(at + 1), get(at + 2)}; }
  void put(std::size_t at, const Vector3<T>& v) {
    for (int i = 0; i < 3; ++i) set(at + static_cast<std::size_t>(i), v(i));
  }

  double* data_;
  std::size_t stride_;
  const Layout* layout_;
  const char* why_ = nullptr;
};

}  // namespace pmreport
