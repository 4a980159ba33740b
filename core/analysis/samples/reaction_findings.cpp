#include <core/analysis/samples/reaction_findings.hpp>

#include <algorithm>

namespace pmreport::analysis {

using mechanics::Indeterminate;

namespace {

void join(std::vector<Indeterminate>& all, const std::vector<Indeterminate>& more) {
  for (std::size_t j = 0; j < all.size(); ++j) all[j] = static_cast<Indeterminate>(all[j] | more[j]);
}

}  // namespace

void ReactionFindings::join(const ReactionFindings& other) {
  analysis::join(indeterminate, other.indeterminate);
  self_stresses = std::max(self_stresses, other.self_stresses);
  ElasticReactions& e = elastic;
  const ElasticReactions& o = other.elastic;
  analysis::join(e.settled, o.settled);
  e.stresses = std::max(e.stresses, o.stresses), e.open = std::max(e.open, o.open);
  const auto larger = [](double x, int at, double y, int there) { return y > x || (y == x && y > 0 && there < at); };
  if (larger(e.force, e.force_sample, o.force, o.force_sample))
    e.force = o.force, e.force_joint = o.force_joint, e.force_sample = o.force_sample;
  if (larger(e.moment, e.moment_sample, o.moment, o.moment_sample))
    e.moment = o.moment, e.moment_joint = o.moment_joint, e.moment_sample = o.moment_sample;
}

void ReactionFindings::put(chunks::Writer& to) const {
  for (const std::vector<Indeterminate>* joints : {&indeterminate, &elastic.settled})
    for (const Indeterminate x : *joints) to.put(x);
  const ElasticReactions& e = elastic;
  for (const int x : {self_stresses, e.stresses, e.open, e.force_joint, e.force_sample, e.moment_joint, e.moment_sample}) to.put(x);
  to.put(e.force), to.put(e.moment);
}

void ReactionFindings::get(chunks::Reader& from) {
  for (std::vector<Indeterminate>* joints : {&indeterminate, &elastic.settled})
    for (Indeterminate& x : *joints) from.get(x);
  ElasticReactions& e = elastic;
  for (int* x : {&self_stresses, &e.stresses, &e.open, &e.force_joint, &e.force_sample, &e.moment_joint, &e.moment_sample}) from.get(*x);
  from.get(e.force), from.get(e.moment);
}

}  // namespace pmreport::analysis
