// The actuators near a moving frame, over a span of time and a box of offsets: their partials and what is linear in these. The names are
// those of followed_krawczyk.hpp, and so are the numbers of its equations. For files named *_upward.cpp
// (core/program/intervals/rounding.hpp).
#pragma once

#include <core/analysis/proof/followed_krawczyk.hpp>
#include <core/program/intervals/interval.hpp>

#include <algorithm>
#include <array>
#include <vector>

namespace pmreport::analysis {

using program::Interval;
using Numbers = std::array<Interval, 6>;

class Linearised {
 public:
  using Found = Krawczyk::Found;

  Linearised(const ActuatorGeometry& geometry, const SmallVector& sizes)
      : geometry_(geometry),
        sizes_(sizes),
        m_(static_cast<std::size_t>(geometry.dof)),
        values_(geometry.values),
        partials_(geometry.partials),
        in_time_(geometry.in_time),
        turning_(geometry.turning),
        in_(3 * m_),
        out_(std::max({geometry.partials.outputs().size(), geometry.in_time.outputs().size(), geometry.turning.outputs().size()})) {}

  // The frame from here on, which must outlive what is asked, and T - c.
  void begin(const MovingFrame& frame, const Interval& elapsed) {
    frame_ = &frame;
    elapsed_ = elapsed;
  }
  const Interval& elapsed() const { return elapsed_; }

  // X, J(X) and R of these offsets. Where it is not `one` nothing else is to be asked that takes them.
  Found differentiate(const Offsets& d) {
    Numbers start;
    for (std::size_t i = 0; i < m_; ++i) {
      start[i] = Interval(d[i]) + entry(frame_->origin, i);
      coordinates_[i] = start[i] + elapsed_ * entry(frame_->velocity, i);
    }
    for (Numbers& row : turn_) row.fill(Interval(0.0));
    smooth_ = true;
    if (elapsed_.magnitude() != 0)
      if (const Found f = differentiate_along(); f != Found::one) return f;

    std::copy_n((smooth_ ? start : coordinates_).begin(), m_, in_.begin());
    partials_.run({in_.data(), m_}, {out_.data(), geometry_.outputs() * (1 + m_)});
    if (const Found f = look_at_kinks(out_.data() + m_); f != Found::one) return f;
    for (std::size_t k = 0; k < m_; ++k)
      for (std::size_t j = 0; j < m_; ++j) {
        jacobian_[k][j] = out_[geometry_.outputs() + k * m_ + j];
        if (!out_[k].bounded() || !jacobian_[k][j].bounded()) return Found::no_bounds;
      }
    for (std::size_t i = 0; i < m_; ++i)
      for (std::size_t j = 0; j < m_; ++j) {
        rest_[i][j] = Interval(i == j ? 1.0 : 0.0) - turn_[i][j] * elapsed_;
        for (std::size_t k = 0; k < m_; ++k) rest_[i][j] -= jacobian_[k][j] * inverse(i, k);
      }
    return Found::one;
  }
  const Numbers& coordinates() const { return coordinates_; }  // X
  bool smooth() const { return smooth_; }                      // no kink in X

  // Y F(0, c), l*(c) within `actuators`. Not bounded: the geometry has no bounds.
  Numbers error_now(const mechanics::Bounded* actuators) {
    for (std::size_t i = 0; i < m_; ++i) in_[i] = Interval(entry(frame_->origin, i));
    values_.run({in_.data(), m_}, {out_.data(), m_});
    Numbers error;
    for (std::size_t k = 0; k < m_; ++k) error[k] = out_[k] - Interval(actuators[k].value);
    return preconditioned(error);
  }

  // Y (b - J x0), J of the box at c, and Y J' x0: J(X) is the one and, (t - c) times, the other, or has all in the one where it has a kink.
  Numbers left_at_middle(Numbers b, const SmallVector& x0) const {
    for (std::size_t k = 0; k < m_; ++k)
      for (std::size_t j = 0; j < m_; ++j) b[k] -= jacobian_[k][j] * entry(x0, j);
    return preconditioned(b);
  }
  Numbers turned(const SmallVector& x0) const {
    Numbers x;
    for (std::size_t i = 0; i < m_; ++i) {
      x[i] = Interval(0.0);
      for (std::size_t j = 0; j < m_; ++j) x[i] += turn_[i][j] * entry(x0, j);
    }
    return x;
  }
  // Y (b - J(X) x0).
  Numbers left_of(const Numbers& b, const SmallVector& x0) const {
    Numbers x = left_at_middle(b, x0);
    const Numbers more = turned(x0);
    for (std::size_t i = 0; i < m_; ++i) x[i] -= more[i] * elapsed_;
    return x;
  }

  // x + R d.
  Numbers with_rest(Numbers x, const Numbers& d) const {
    for (std::size_t i = 0; i < m_; ++i)
      for (std::size_t j = 0; j < m_; ++j) x[i] += rest_[i][j] * d[j];
    return x;
  }

  // (6): bounds of x with J x = b, around x0. False where there are none.
  bool solve(const Numbers& b, const SmallVector& x0, Numbers& x) const {
    const Numbers z = left_of(b, x0);
    double rho = 0, largest = 0;
    for (std::size_t i = 0; i < m_; ++i) {
      double row = 0;
      for (std::size_t j = 0; j < m_; ++j) row += rest_[i][j].magnitude() * entry(sizes_, j);
      rho = std::max(rho, row / entry(sizes_, i));
      largest = std::max(largest, z[i].magnitude() / entry(sizes_, i));
    }
    if (!(rho < 1)) return false;
    const Interval all = largest / (1.0 - Interval(rho));
    if (!all.bounded()) return false;
    Numbers y;
    for (std::size_t i = 0; i < m_; ++i) {
      const double end = all.high * entry(sizes_, i);
      y[i] = Interval(-end, end);
    }
    for (int k = 0; k < 2; ++k) {
      const Numbers next = with_rest(z, y);
      for (std::size_t i = 0; i < m_; ++i) y[i] = common(y[i], next[i]);
    }
    for (std::size_t i = 0; i < m_; ++i) x[i] = y[i] + entry(x0, i);
    return true;
  }

  // (5): the rates; and the accelerations, of which nothing is known where they have no bounds.
  bool find_rates(const mechanics::Bounded* actuators, Numbers& rate) const {
    return solve(numbers(actuators, &mechanics::Bounded::rate), frame_->velocity, rate);
  }
  Numbers find_accelerations(const mechanics::Bounded* actuators, const Numbers& rate) {
    Numbers unknown, left, acceleration;
    unknown.fill(Interval::unbounded());
    for (std::size_t i = 0; i < m_; ++i) in_[i] = coordinates_[i], in_[m_ + i] = rate[i], in_[2 * m_ + i] = Interval(0.0);
    in_time_.run({in_.data(), 3 * m_}, {out_.data(), 3 * geometry_.outputs()});
    SmallVector nearly = SmallVector::Zero(static_cast<Eigen::Index>(m_));
    for (std::size_t k = 0; k < m_; ++k) {
      left[k] = Interval(actuators[k].acceleration) - out_[2 * geometry_.outputs() + k];
      if (!left[k].bounded()) return unknown;
      for (std::size_t i = 0; i < m_; ++i) nearly(static_cast<Eigen::Index>(i)) += inverse(i, k) * left[k].middle();
    }
    return solve(left, nearly, acceleration) ? acceleration : unknown;
  }

  Numbers preconditioned(const Numbers& x) const {  // Y x
    Numbers y;
    for (std::size_t i = 0; i < m_; ++i) {
      y[i] = Interval(0.0);
      for (std::size_t k = 0; k < m_; ++k) y[i] += x[k] * inverse(i, k);
    }
    return y;
  }

  Numbers numbers(const mechanics::Bounded* actuators, Bounds mechanics::Bounded::*part) const {
    Numbers x;
    for (std::size_t k = 0; k < m_; ++k) x[k] = Interval(actuators[k].*part);
    return x;
  }
  static double entry(const SmallVector& a, std::size_t i) { return a(static_cast<Eigen::Index>(i)); }

 private:
  double inverse(std::size_t i, std::size_t k) const { return frame_->inverse(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)); }

  // Whether a kink is open.
  Found look_at_kinks(const Interval* kinks) {
    for (int c = 0; c < geometry_.kinks; ++c) {
      if (!kinks[c].bounded()) return Found::no_bounds;
      smooth_ = smooth_ && kinks[c].width() == 0;
    }
    return Found::one;
  }

  // Y J' of (8), and whether there is one.
  Found differentiate_along() {
    for (std::size_t i = 0; i < m_; ++i) in_[i] = coordinates_[i], in_[m_ + i] = Interval(entry(frame_->velocity, i));
    const std::size_t first = geometry_.outputs() - m_;
    turning_.run({in_.data(), 2 * m_}, {out_.data(), first + m_ * m_});
    if (const Found f = look_at_kinks(out_.data()); f != Found::one) return f;
    for (std::size_t k = 0; k < m_ * m_; ++k) smooth_ = smooth_ && out_[first + k].bounded();
    for (std::size_t i = 0; smooth_ && i < m_; ++i)
      for (std::size_t j = 0; j < m_; ++j)
        for (std::size_t k = 0; k < m_; ++k) turn_[i][j] += out_[first + k * m_ + j] * inverse(i, k);
    return Found::one;
  }

  using Matrix = std::array<Numbers, 6>;

  const ActuatorGeometry& geometry_;
  const SmallVector& sizes_;
  std::size_t m_;
  program::Evaluator<Interval> values_, partials_, in_time_, turning_;
  std::vector<Interval> in_, out_;
  const MovingFrame* frame_ = nullptr;
  Interval elapsed_;
  Numbers coordinates_;
  Matrix jacobian_, turn_, rest_;  // J(X) = jacobian_ + J' (T - c); turn_ = Y J'; rest_ = R
  bool smooth_ = true;
};

}  // namespace pmreport::analysis
