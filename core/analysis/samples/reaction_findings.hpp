// What the joint reactions of samples tell of all of them: which rigid bodies leave open, and which of these elasticity settles.
#pragma once

#include <core/chunks/bytes.hpp>
#include <core/mechanics/reactions/reactions.hpp>

#include <vector>

namespace pmreport::analysis {

struct ElasticReactions {
  std::vector<mechanics::Indeterminate> settled;  // of each joint, in any sample: components that it determines
  int stresses = 0, open = 0;                     // self-stresses that it settles, and that it leaves, most in any sample
  double force = 0, moment = 0;                   // by which the least-norm reaction of a joint missed it at most [N], [N m]
  int force_joint = -1, force_sample = -1, moment_joint = -1, moment_sample = -1;
};

struct ReactionFindings {
  std::vector<mechanics::Indeterminate> indeterminate;  // of each joint, in any sample, and not settled by elasticity
  int self_stresses = 0;                                // of rigid bodies, most in any sample
  ElasticReactions elastic;

  explicit ReactionFindings(std::size_t joints = 0) : indeterminate(joints, 0) { elastic.settled.assign(joints, 0); }
  // Both have as many joints as the other. Of two samples with the same number the earlier is told.
  void join(const ReactionFindings& other);
  void put(chunks::Writer& to) const;
  void get(chunks::Reader& from);
};

}  // namespace pmreport::analysis
