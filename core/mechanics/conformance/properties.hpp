// The property suite: what must hold for every mechanism, whoever wrote it. Run by the tests over all plugins and by `pmreport check`.
#pragma once

#include <core/mechanics/machine/machine.hpp>
#include <cstdint>
#include <string>
#include <vector>

namespace pmreport::mechanics {

enum class Verdict { passed, failed, not_examined, not_applicable };

struct Property {
  std::string claim;  // "joints close"
  std::string how;    // what was compared with what
  double worst = 0;   // largest deviation found
  double tolerance = 0;
  std::string unit;          // "m", "rad", "" relative or a count
  std::string where;         // the pose, joint or body of the worst case, and what to look at when it fails
  long evaluations = 0;      // how often it was looked at
  bool applies = true;       // false: the mechanism has nothing of the kind
  bool optional = false;     // a sound mechanism may leave it unexamined
  std::string unexamined{};  // why it was not looked at, though it applies
  Verdict verdict() const;   // what was never looked at does not pass
  bool holds() const { return verdict() == Verdict::passed || verdict() == Verdict::not_applicable; }
};

struct PropertyOptions {
  int poses = 1000;  // random poses in the box of the coordinates; those out of reach are counted, not judged
  std::uint64_t seed = 1;
  double out_of_reach = 0.5;                // the largest share of them that may be out of reach; 1: any
  std::vector<Eigen::VectorXd> at_first{};  // poses to look at before, in the order of a motion; any of them may be out of reach
};

// Every property at home, at the poses that are given and at random poses, with random rates and accelerations.
std::vector<Property> check_properties(const Machine& machine, const PropertyOptions& options = {});

}  // namespace pmreport::mechanics
