// Mechanisms whose elements are as a test wants them.
#pragma once

#include <core/mechanics/stiffness/answers.hpp>
#include <core/numbers.hpp>
#include <pmreport/elastic.hpp>
#include <tests/plugins/every_mechanism.hpp>

namespace pmreport::test {

inline const Eigen::Vector3d down(0, 0, -9.81);
inline const mechanics::Elastostatics::Wanted everything{true, true}, compliance_alone{false, false};

inline mechanics::Machine made(const std::string& name, const std::map<std::string, std::vector<double>>& changes = {}) {
  return {plugin(name), values_with(plugin(name), changes)};
}

inline mechanics::ElasticPose at_home(const mechanics::Machine& m, const linear::Vector6d& load = linear::Vector6d::Zero(),
                                      const Eigen::Vector3d& gravity = Eigen::Vector3d::Zero()) {
  return mechanics::Elastostatics(m).at(m.home(), load, gravity, everything);
}

// The settings of a machine whose declared elements are all rigid, but for those added.
inline mechanics::ElasticSettings only(const mechanics::Machine& m, std::vector<Element> added) {
  mechanics::ElasticSettings out;
  for (const Element& e : m.topology().elements) out.rigid.push_back(e.name);
  out.added = std::move(added);
  for (const Element& e : out.added) std::erase(out.rigid, e.name);
  return out;
}

}  // namespace pmreport::test
