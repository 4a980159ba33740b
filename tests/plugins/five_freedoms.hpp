// States of the mechanisms of five freedoms.
#pragma once

#include <catch2/catch.hpp>
#include <core/mechanics/model/state.hpp>

namespace pmreport::test {

inline mechanics::State state_at(const mechanics::Machine& machine, const Eigen::VectorXd& q,
                                 const Eigen::VectorXd& rate = Eigen::VectorXd::Zero(5),
                                 const Eigen::VectorXd& acceleration = Eigen::VectorXd::Zero(5)) {
  mechanics::State s;
  mechanics::evaluate(machine, q.data(), rate.data(), acceleration.data(), s);
  REQUIRE(s.status == PM_OK);
  return s;
}

}  // namespace pmreport::test
