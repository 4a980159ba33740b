// The motion in extended precision, by the recorded geometry alone: values, rates and accelerations by Taylor arithmetic on long doubles,
// and the sign of det G from its factors.
#pragma once

#include <core/mechanics/machine/machine.hpp>
#include <core/mechanics/recorded/motion_program.hpp>
#include <core/program/evaluate.hpp>
#include <pmreport/jet.hpp>
#include <tests/proof/law.hpp>

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <vector>

namespace pmreport::test {

using Number = long double;
using Moved = Jet<Number>;

class Oracle {
 public:
  Oracle(const mechanics::Machine& machine, const mechanics::MotionProgram& program, const Law& law)
      : dof_(static_cast<std::size_t>(machine.dof())),
        outputs_(program.program.outputs().size()),
        law_(law),
        moved_(program.program),
        wrenches_(wrenches_of(program)),
        sides_(wrenches_),
        q_(3 * dof_),
        in_(dof_),
        out_(outputs_ + dof_) {}

  // All outputs and then the coordinates, at a time.
  const std::vector<Moved>& at(Number t) {
    law_(t, q_.data(), q_.data() + dof_, q_.data() + 2 * dof_);
    for (std::size_t i = 0; i < dof_; ++i) out_[outputs_ + i] = in_[i] = {q_[i], q_[dof_ + i], q_[2 * dof_ + i]};
    moved_.run(in_, {out_.data(), outputs_});
    return out_;
  }
  std::size_t coordinate(std::size_t i) const { return outputs_ + i; }

  // The sign of det G, 0 where the factors leave it open, as they do where the mechanism cannot be assembled.
  int side(Number t) {
    law_(t, q_.data(), q_.data() + dof_, q_.data() + 2 * dof_);
    std::array<Number, 37> g;
    sides_.run({q_.data(), dof_}, g);
    if (!(g[36] >= 0)) return 0;
    Eigen::Matrix<Number, 6, 6> m;
    for (int e = 0; e < 36; ++e) m(e / 6, e % 6) = g[static_cast<std::size_t>(e)];
    if (!m.allFinite()) return 0;
    for (int k = 0; k < 2; ++k) {  // rows and columns of one size
      for (int i = 0; i < 6; ++i)
        if (const Number size = m.row(i).norm(); size > 0) m.row(i) /= size;
      for (int i = 0; i < 6; ++i)
        if (const Number size = m.col(i).norm(); size > 0) m.col(i) /= size;
    }
    const Number det = m.fullPivLu().determinant();
    return std::abs(det) < 1e-16L ? 0 : det > 0 ? 1 : -1;
  }

 private:
  // G, and the reach.
  static program::Program wrenches_of(const mechanics::MotionProgram& program) {
    std::vector<int> outputs;
    for (int e = 0; e < 36; ++e) outputs.push_back(static_cast<int>(program.wrenches) + e);
    outputs.push_back(0);
    return program.program.slice(outputs);
  }

  std::size_t dof_, outputs_;
  const Law& law_;
  program::Evaluator<Moved> moved_;
  program::Program wrenches_;
  program::Evaluator<Number> sides_;
  std::vector<Number> q_;
  std::vector<Moved> in_, out_;
};

}  // namespace pmreport::test
