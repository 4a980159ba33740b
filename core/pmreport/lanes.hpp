// Several poses at once, one in each lane of a vector register. The width is the processor's, as the compiler was told; it is a detail of
// one translation unit and never shows in the contract.
#pragma once

#include <experimental/simd>
#include <pmreport/scalar.hpp>

namespace pmreport {

class Lanes {
 public:
  using Simd = std::experimental::native_simd<double>;
  static constexpr std::size_t width = Simd::size();

  // The answer of a comparison, one a lane.
  class Mask {
   public:
    explicit Mask(const Simd::mask_type& m) : m_(m) {}
    const Simd::mask_type& lanes() const { return m_; }
    friend Mask operator&&(const Mask& a, const Mask& b) { return Mask(a.m_ && b.m_); }
    friend Mask operator||(const Mask& a, const Mask& b) { return Mask(a.m_ || b.m_); }
    friend Mask operator!(const Mask& a) { return Mask(!a.m_); }
    // To one bool, for all lanes: never.
    template <class Bool>
    requires std::is_same_v<Bool, bool>
    operator Bool() const { return refused<decltype(void(Bool()))>(); }

   private:
    Simd::mask_type m_;
  };

  Lanes() = default;
  Lanes(double same) : x_(same) {}  // implicit: constants stay readable
  Lanes(const Simd& x) : x_(x) {}

  static Lanes load(const double* from) { return Simd(from, std::experimental::element_aligned); }
  void store(double* to) const { x_.copy_to(to, std::experimental::element_aligned); }

  Lanes operator-() const { return -x_; }
  Lanes& operator+=(const Lanes& o) { return *this = *this + o; }
  Lanes& operator-=(const Lanes& o) { return *this = *this - o; }
  Lanes& operator*=(const Lanes& o) { return *this = *this * o; }
  Lanes& operator/=(const Lanes& o) { return *this = *this / o; }

  friend Lanes operator+(const Lanes& a, const Lanes& b) { return Simd(a.x_ + b.x_); }
  friend Lanes operator-(const Lanes& a, const Lanes& b) { return Simd(a.x_ - b.x_); }
  friend Lanes operator*(const Lanes& a, const Lanes& b) { return Simd(a.x_ * b.x_); }
  friend Lanes operator/(const Lanes& a, const Lanes& b) { return Simd(a.x_ / b.x_); }
  friend Mask operator<(const Lanes& a, const Lanes& b) { return Mask(a.x_ < b.x_); }
  friend Mask operator>(const Lanes& a, const Lanes& b) { return Mask(a.x_ > b.x_); }

  friend Lanes choose(const Mask& mask, const Lanes& a, const Lanes& b) {
    Simd r = b.x_;
    where(mask.lanes(), r) = a.x_;
    return r;
  }
  friend Lanes sqrt(const Lanes& a) { return std::experimental::sqrt(a.x_); }
  friend Lanes sin(const Lanes& a) { return std::experimental::sin(a.x_); }
  friend Lanes cos(const Lanes& a) { return std::experimental::cos(a.x_); }
  friend Lanes tan(const Lanes& a) { return std::experimental::tan(a.x_); }
  friend Lanes asin(const Lanes& a) { return std::experimental::asin(a.x_); }
  friend Lanes acos(const Lanes& a) { return std::experimental::acos(a.x_); }
  friend Lanes atan2(const Lanes& a, const Lanes& b) { return std::experimental::atan2(a.x_, b.x_); }
  friend Lanes hypot(const Lanes& a, const Lanes& b) { return std::experimental::hypot(a.x_, b.x_); }
  friend Lanes abs(const Lanes& a) { return std::experimental::abs(a.x_); }

 private:
  Simd x_;
};

}  // namespace pmreport

PMREPORT_EIGEN_SCALAR(pmreport::Lanes)
