// Margins as they are recorded: smooth where the limit lies, and without the functions that cost time.
//
// A limit is an end of a number, min <= v <= max, and what is held against it is told by the step that gives v:
//     v = sqrt(s), min >= 0        s - min^2,            max^2 - s
//     v = acos(c)                  cos min - c,          c - cos max                      for ends within 0 and pi
//     v = k +- atan2(s, c)         of the angle's sine and cosine, by either end: below
//     else                         v - min,              max - v
// Of an angle v in (-pi, pi], with s and c its sine and cosine times one positive length, v >= min is a half plane of (c, s) cut out, or
// joined, by another:
//     min <= 0:  s >= 0  or   s cos min - c sin min >= 0         the larger of the two
//     min > 0:   s >= 0  and  s cos min - c sin min >= 0         the smaller
// and v <= max is -v >= -max. Where s is a root, s = sqrt(r), v lies within 0 and pi, and squares tell the same without it:
//     v >= min:   r cos min |cos min| - c |c| sin^2 min >= 0      of both signs for max
// Each is negative where the limit is broken, and zero only on it and, for min <= 0, nowhere else.
#pragma once

#include <core/mechanics/workspace/pose_limits.hpp>
#include <core/program/recorder.hpp>

#include <optional>
#include <vector>

namespace pmreport::mechanics {

class MarginRecorder {
 public:
  MarginRecorder(program::Recorder& recorder, const program::Program& start, PoseMargins& out)
      : recorder_(recorder), start_(start), out_(out) {}

  // The reach, which must come first: output 0 of the program started from.
  void add_reach();
  // Output `o` of the program started from between the two ends of the limit.
  void add_output(PoseLimit limit, std::size_t o);
  // An angle between two directions, by the product of their vectors and the length of both: 0 to pi.
  void add_angle(PoseLimit limit, const Recorded& product, const Recorded& lengths);
  // A length by its square.
  void add_square(PoseLimit limit, const Recorded& square);
  // A limit whose margins are judged late: of its lower end, of its upper end.
  void add_late(PoseLimit limit, bool lower, bool upper);

  std::vector<Recorded> outputs;

 private:
  struct ShiftedAngle {  // sign atan2(sine, cosine) + offset
    int sine = 0, cosine = 0;
    double sign = 1, offset = 0;
  };
  std::optional<ShiftedAngle> shifted_angle(int number) const;
  int begin(PoseLimit limit);
  void margin(int limit, bool upper, const Recorded& value, double rounding);
  const program::Step& step(int s) const { return start_.steps()[static_cast<std::size_t>(s)]; }

  program::Recorder& recorder_;
  const program::Program& start_;
  PoseMargins& out_;
};

}  // namespace pmreport::mechanics
