// The P(2PRPU)/PRPS as its tests meet it.
#pragma once

#include <catch2/catch.hpp>
#include <tests/plugins/five_freedoms.hpp>
#include <tests/plugins/plugin.hpp>

namespace pmreport::test {

inline const pm_mechanism& p2prpu_prps() { return plugin("p2prpu-prps"); }

// Value, rate or acceleration of scalars, as a vector.
inline Eigen::VectorXd values(const std::vector<mechanics::Scalar>& of, double mechanics::Scalar::*part = &mechanics::Scalar::value) {
  Eigen::VectorXd v(static_cast<Eigen::Index>(of.size()));
  for (std::size_t i = 0; i < of.size(); ++i) v(static_cast<Eigen::Index>(i)) = of[i].*part;
  return v;
}

// What the mechanism reads at a pose, by name.
inline double reading(const mechanics::Machine& machine, const Eigen::VectorXd& q, const std::string& name) {
  const std::span<const double> at{q.data(), 5};
  const auto& readings = machine.topology().readings;
  for (std::size_t i = 0; i < readings.size(); ++i)
    if (readings[i].name == name) return machine.readings(at, machine.pose(at))[i];
  throw std::out_of_range("no reading is called " + name);
}

}  // namespace pmreport::test
