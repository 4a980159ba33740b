#include <core/analysis/proof/proof.hpp>

#include <core/analysis/proof/prover.hpp>
#include <core/analysis/proof/recording_check.hpp>
#include <core/mechanics/recorded/motion_program.hpp>
#include <core/program/derivative.hpp>

#include <algorithm>

namespace pmreport::analysis {

const Extreme* MotionProof::extreme(const ColumnId& column) const {
  const auto found = std::ranges::find(extremes, column, &Extreme::column);
  return found != extremes.end() ? &*found : nullptr;
}

MotionProof prove_motion(const mechanics::Machine& machine, const mechanics::Trajectory& trajectory,
                         const mechanics::Enclosure& /*actuators*/, const ProofOptions& options) {
  MotionProof out;
  if (trajectory.samples() < 2) {
    out.unexamined = "there is no motion";
    return out;
  }
  out.begin = trajectory.time.front();
  out.end = trajectory.time.back();
  const auto program = mechanics::motion_program(machine, &out.unexamined);
  if (!program) return out;
  out.recording = recording_deviation(machine, trajectory);
  if (!trajectory.over) {
    out.unexamined = "the motion follows from forces, by an integration whose error has no bound";
    return out;
  }
  Prover prover(machine, *program, program::in_time(program->program, 2), trajectory.over, {out.begin, out.end}, trajectory.knots, options);
  prover.run(out);
  return out;
}

}  // namespace pmreport::analysis
