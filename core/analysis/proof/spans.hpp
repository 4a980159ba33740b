// What is known of a motion at instants and over spans of time, by interval arithmetic.
//
// Over a span T with the middle c, each quantity x with a rate that is bounded on T lies in
//     x(T)  and  x(c) + x'(T) (T - c)                                    (1)
// the natural enclosure of its program and the mean value form, which is good to the second order of the span; both count. The rates come
// from the program of the time derivatives. G is regular at all instants of T when with C, any matrix, here the inverse of G at c,
//     I - C G(T)   has no row whose magnitudes sum to 1 or more           (2)
// since C G then is strictly diagonally dominant (Neumaier 1990, Interval Methods for Systems of Equations, section 4.1). Columns 4 to 6
// are taken per length, so that the entries of (2) compare.
#pragma once

#include <core/analysis/proof/quantities.hpp>
#include <core/mechanics/trajectory/trajectory.hpp>
#include <core/program/intervals/bounds.hpp>
#include <core/program/intervals/boxes.hpp>

#include <array>
#include <span>
#include <vector>

namespace pmreport::analysis {

using program::Bounds;

struct InstantFacts {
  double time = 0;
  bool assembled = false;           // for certain: the reach is not negative, and all of the geometry has finite numbers
  int side = 0;                     // the sign of det G, where it is certain
  std::vector<Bounds> value;        // of each quantity
  std::array<Bounds, 36> wrenches;  // G, by rows
};
// How much is looked at: for claims all; for extremes the quantities alone, the reach not among them, where it is known that the mechanism
// can be assembled.
enum class Look { whole, quantities };
struct SpanFacts {
  Bounds time;
  bool placed = false;           // all of the geometry has finite numbers, at every instant
  bool finite_wrenches = false;  // all of G is bounded
  bool regular = false;          // det G is not zero at any instant
  std::vector<Bounds> value;     // of each quantity
  std::vector<Bounds> rate;  // of each that has one and of the joints and the reach; not bounded: it is not known, or the quantity jumps
};

// Keeps its buffers: one a thread. All that it refers to must outlive it.
class Spans {
 public:
  // `moving`: the program with its rates and accelerations (program::in_time).
  Spans(const mechanics::Machine& machine, const mechanics::MotionProgram& program, const program::Program& moving,
        const Quantities& quantities, const mechanics::Enclosure& motion);

  void at(Look look, std::span<const double> times, std::span<InstantFacts> out);
  // `middles`: the facts at an instant in each span, about its middle; (1) and (2) count from there.
  void over(Look look, std::span<const Bounds> times, std::span<const InstantFacts* const> middles, std::span<SpanFacts> out);

  long evaluations() const { return evaluations_; }

 private:
  // Where values, rates and accelerations of an output are in a program; none: -1.
  struct Places {
    std::vector<int> value, rate, acceleration;
  };
  struct Timed {
    Places of;  // by the mechanism's outputs
    std::size_t outputs;
    program::Boxes boxes;
  };
  Timed timed(const program::Program& moving, Look look, bool all_rates) const;
  struct Pair {
    Timed at_instants, over_spans;
  };
  Pair& pair_for(Look look) { return look == Look::whole ? whole_ : lean_; }
  void run(Timed& timed, std::size_t count, auto&& time_of);
  bool placed(const Places& of, std::size_t k, std::size_t count) const;
  bool without_singular(std::span<const Bounds, 36> wrenches, const linear::Matrix6d& middle) const;
  void gather(const Places& of, std::size_t k, std::size_t count, std::vector<Bounds>& value, std::vector<Bounds>& rate) const;

  const mechanics::Machine& machine_;
  const Quantities& quantities_;
  const mechanics::Enclosure& motion_;
  std::size_t dof_, placed_, wrenches_;  // coordinates; outputs that place; the first of G
  double length_, per_length_;           // per_length_: a power of two, so that scaling by it is exact
  Pair whole_, lean_;
  std::vector<mechanics::Bounded> moved_;
  std::vector<Bounds> in_, out_, unused_;
  long evaluations_ = 0;
};

}  // namespace pmreport::analysis
