// Joint reactions of a motion that rigid bodies leave open and elasticity settles.
#pragma once

#include <core/mechanics/reactions/reactions.hpp>

#include <vector>

namespace pmreport::analysis {

struct ElasticReactions {
  std::vector<mechanics::Indeterminate> settled;  // of each joint, in any sample: components that it determines
  int stresses = 0, open = 0;                     // self-stresses that it settles, and that it leaves, most in any sample
  double force = 0, moment = 0;                   // by which the least-norm reaction of a joint missed it at most [N], [N m]
  int force_joint = -1, force_sample = -1, moment_joint = -1, moment_sample = -1;
  void join(const ElasticReactions& other);
};

}  // namespace pmreport::analysis
