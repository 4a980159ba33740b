// What a motion and its load do between the samples, against what the samples show.
#pragma once

#include <core/analysis/analysis.hpp>

#include <string>
#include <vector>

namespace pmreport::analysis {

// A coordinate, an actuator that is prescribed, or a component of the load, that goes between samples where none of them goes.
struct Unseen {
  std::string what,
      unit;  // "x", "the load's force along x", and the unit of what is told of it, SI: of its value, its rate or its acceleration
  OfMotion of = OfMotion::value;
  double beyond = 0;        // how far it goes at most beyond the two samples around it, SI
  double time = 0;          // when [s]
  double moves = 0;         // from its least to its largest, SI
  double samples_move = 0;  // the same of its samples
  double enough = 0;        // so many samples would show it
};
// Of everything that moves, the lowest of value, rate and acceleration that the samples do not show; rates and accelerations count where
// the scenario asks for what follows from them. The worst first. Empty: the samples show the motion.
std::vector<Unseen> unseen_between_samples(const Analysis& a);

}  // namespace pmreport::analysis
