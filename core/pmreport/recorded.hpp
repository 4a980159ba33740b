// A number that writes down what is done with it: the geometry once more, as a list of operations.
//
// Run on it, `place` and `jacobian` leave in a pm_recording (plugin.h) a straight line of operations on the independent coordinates, which
// the host can run on other kinds of numbers: intervals, for one. What depends on no coordinate is computed at once and stays a constant.
// A comparison becomes a mask of the list, and choose(mask, a, b) an operation that has both: no branch is taken, so that the list is the
// same whatever the coordinates are.
#pragma once

#include <pmreport/plugin.h>
#include <pmreport/placement.hpp>
#include <pmreport/scalar.hpp>

#include <bit>
#include <cstdint>

namespace pmreport {

class Recorded {
 public:
  // The answer of a comparison.
  class Mask {
   public:
    friend Mask operator&&(const Mask& a, const Mask& b) { return both(PM_OP_AND, a, b); }
    friend Mask operator||(const Mask& a, const Mask& b) { return both(PM_OP_OR, a, b); }
    friend Mask operator!(const Mask& a) { return a.opposite(); }
    // To one bool, for all poses: never.
    template <class Bool>
    requires std::is_same_v<Bool, bool>
    operator Bool() const { return refused<decltype(void(Bool()))>(); }

   private:
    friend class Recorded;
    explicit Mask(bool holds) : holds_(holds) {}
    Mask(pm_recording& list, std::int32_t step) : list_(&list), step_(step) {}
    static Mask both(pm_operation o, const Mask& a, const Mask& b) {
      const bool neutral = o == PM_OP_AND;  // the constant that leaves the other as it is; the opposite decides alone
      if (a.list_ == nullptr) return a.holds_ == neutral ? b : a;
      if (b.list_ == nullptr) return b.holds_ == neutral ? a : b;
      return Mask(*a.list_, add(*a.list_, o, a.step_, b.step_));
    }

    Mask opposite() const { return list_ == nullptr ? Mask(!holds_) : Mask(*list_, add(*list_, PM_OP_NOT, step_)); }

    pm_recording* list_ = nullptr;  // none: a constant
    std::int32_t step_ = 0;
    bool holds_ = false;
  };

  Recorded() = default;
  Recorded(double constant) : constant_(constant) {}  // implicit: constants stay readable
  Recorded(pm_recording& list, std::int32_t step) : list_(&list), step_(step) {}
  // Independent coordinate number `i`.
  static Recorded input(pm_recording& list, int i) { return {list, add(list, PM_OP_INPUT, i)}; }

  bool is_constant() const { return list_ == nullptr; }
  double constant() const { return constant_; }
  // The step that gives it; a constant is written down as one.
  std::int32_t step(pm_recording& list) const { return list_ != nullptr ? step_ : add(list, PM_OP_CONSTANT, 0, 0, 0, constant_); }

  Recorded operator-() const {
    return of(PM_OP_NEGATE, *this, [](double x) { return -x; });
  }
  Recorded& operator+=(const Recorded& o) { return *this = *this + o; }
  Recorded& operator-=(const Recorded& o) { return *this = *this - o; }
  Recorded& operator*=(const Recorded& o) { return *this = *this * o; }
  Recorded& operator/=(const Recorded& o) { return *this = *this / o; }

  // Zero and one are what most constant vectors and rotations are made of. What is multiplied by zero is taken to be finite.
  friend Recorded operator+(const Recorded& a, const Recorded& b) {
    if (a.is(0)) return b;
    if (b.is(0)) return a;
    return of(PM_OP_ADD, a, b, [](double x, double y) { return x + y; });
  }
  friend Recorded operator-(const Recorded& a, const Recorded& b) {
    if (b.is(0)) return a;
    if (a.is(0)) return -b;
    return of(PM_OP_SUBTRACT, a, b, [](double x, double y) { return x - y; });
  }
  friend Recorded operator*(const Recorded& a, const Recorded& b) {
    if (a.is(0) || b.is(1)) return a;
    if (b.is(0) || a.is(1)) return b;
    return of(PM_OP_MULTIPLY, a, b, [](double x, double y) { return x * y; });
  }
  friend Recorded operator/(const Recorded& a, const Recorded& b) {
    if (b.is(1)) return a;
    return of(PM_OP_DIVIDE, a, b, [](double x, double y) { return x / y; });
  }
  friend Mask operator<(const Recorded& a, const Recorded& b) { return less(a, b); }
  friend Mask operator>(const Recorded& a, const Recorded& b) { return less(b, a); }
  friend Recorded choose(const Mask& mask, const Recorded& a, const Recorded& b) { return chosen(mask, a, b); }
  friend Recorded sqrt(const Recorded& a) {
    return of(PM_OP_SQRT, a, [](double x) { return std::sqrt(x); });
  }
  friend Recorded sin(const Recorded& a) {
    return of(PM_OP_SIN, a, [](double x) { return std::sin(x); });
  }
  friend Recorded cos(const Recorded& a) {
    return of(PM_OP_COS, a, [](double x) { return std::cos(x); });
  }
  friend Recorded tan(const Recorded& a) {
    return of(PM_OP_TAN, a, [](double x) { return std::tan(x); });
  }
  friend Recorded asin(const Recorded& a) {
    return of(PM_OP_ASIN, a, [](double x) { return std::asin(x); });
  }
  friend Recorded acos(const Recorded& a) {
    return of(PM_OP_ACOS, a, [](double x) { return std::acos(x); });
  }
  friend Recorded abs(const Recorded& a) {
    return of(PM_OP_ABS, a, [](double x) { return std::abs(x); });
  }
  friend Recorded atan2(const Recorded& a, const Recorded& b) {
    return of(PM_OP_ATAN2, a, b, [](double y, double x) { return std::atan2(y, x); });
  }
  friend Recorded hypot(const Recorded& a, const Recorded& b) {
    return of(PM_OP_HYPOT, a, b, [](double x, double y) { return std::hypot(x, y); });
  }

 private:
  friend struct Codec<Recorded>;
  bool is(double x) const { return list_ == nullptr && constant_ == x; }

  static std::int32_t add(pm_recording& list, pm_operation o, std::int32_t a = 0, std::int32_t b = 0, std::int32_t c = 0,
                          double constant = 0) {
    if (list.count < list.capacity) list.steps[list.count] = {o, a, b, c, constant};
    return static_cast<std::int32_t>(list.count++);
  }
  static Mask less(const Recorded& a, const Recorded& b) {
    if (a.is_constant() && b.is_constant()) return Mask(a.constant_ < b.constant_);
    pm_recording& list = a.is_constant() ? *b.list_ : *a.list_;
    const std::int32_t first = a.step(list);
    return {list, add(list, PM_OP_LESS, first, b.step(list))};
  }
  static Recorded chosen(const Mask& mask, const Recorded& a, const Recorded& b) {
    if (mask.list_ == nullptr) return mask.holds_ ? a : b;
    pm_recording& list = *mask.list_;
    const std::int32_t first = a.step(list);
    return {list, add(list, PM_OP_CHOOSE, mask.step_, first, b.step(list))};
  }
  template <class F>
  static Recorded of(pm_operation o, const Recorded& a, F&& f) {
    if (a.is_constant()) return f(a.constant_);
    return {*a.list_, add(*a.list_, o, a.step_)};
  }
  template <class F>
  static Recorded of(pm_operation o, const Recorded& a, const Recorded& b, F&& f) {
    if (a.is_constant() && b.is_constant()) return f(a.constant_, b.constant_);
    pm_recording& list = a.is_constant() ? *b.list_ : *a.list_;
    const std::int32_t first = a.step(list);
    return {list, add(list, o, first, b.step(list))};
  }

  pm_recording* list_ = nullptr;  // none: a constant
  std::int32_t step_ = 0;
  double constant_ = 0;
};

// Within one call alone: where the list is, which step, or which constant.
template <>
struct Codec<Recorded> {
  static constexpr std::size_t components = 3;
  static Recorded load(const double* at, std::size_t stride) {
    Recorded x(at[2 * stride]);
    x.list_ = std::bit_cast<pm_recording*>(at[0]);
    x.step_ = static_cast<std::int32_t>(at[stride]);
    return x;
  }
  static void store(double* at, std::size_t stride, const Recorded& x) {
    at[0] = std::bit_cast<double>(x.list_);
    at[stride] = x.step_;
    at[2 * stride] = x.constant_;
  }
};

}  // namespace pmreport

PMREPORT_EIGEN_SCALAR(pmreport::Recorded)
