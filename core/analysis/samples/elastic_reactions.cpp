#include <core/analysis/samples/elastic_reactions.hpp>

#include <algorithm>

namespace pmreport::analysis {

using mechanics::Indeterminate;

void ElasticReactions::join(const ElasticReactions& other) {
  settled.resize(std::max(settled.size(), other.settled.size()), 0);
  for (std::size_t j = 0; j < other.settled.size(); ++j) settled[j] = static_cast<Indeterminate>(settled[j] | other.settled[j]);
  stresses = std::max(stresses, other.stresses), open = std::max(open, other.open);
  // The earlier sample of two, whatever thread it was on.
  const auto larger = [](double x, int at, double y, int there) { return y > x || (y == x && y > 0 && there < at); };
  if (larger(force, force_sample, other.force, other.force_sample))
    force = other.force, force_joint = other.force_joint, force_sample = other.force_sample;
  if (larger(moment, moment_sample, other.moment, other.moment_sample))
    moment = other.moment, moment_joint = other.moment_joint, moment_sample = other.moment_sample;
}

}  // namespace pmreport::analysis
