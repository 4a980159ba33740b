#include <core/analysis/proof/proof.hpp>

#include <core/analysis/proof/followed.hpp>
#include <core/analysis/proof/prover.hpp>
#include <core/analysis/proof/recording_check.hpp>
#include <core/mechanics/recorded/motion_program.hpp>
#include <core/numbers.hpp>
#include <core/program/derivative.hpp>

#include <algorithm>

namespace pmreport::analysis {

const Extreme* MotionProof::extreme(const ColumnId& column) const {
  const auto found = std::ranges::find(extremes, column, &Extreme::column);
  return found != extremes.end() ? &*found : nullptr;
}

namespace {

// Of what comes after nothing is known: claims that hold before are undecided there, and no bracket holds for all of the motion.
void leave_open(MotionProof& proof, Bounds time, const std::string& reason) {
  for (Claim& c : proof.claims) {
    if (c.state == Claim::State::unexamined) continue;
    c.undecided.push_back(time);
    if (!c.broken.empty() && c.broken.back().end.high >= time.low) {  // how long it lasts, and how far it goes, is not known
      Claim::Broken& last = c.broken.back();
      last.end.high = time.high;
      (last.above ? last.worst.high : last.worst.low) = last.above ? infinity : -infinity;
    }
    if (c.state == Claim::State::holds) c.state = Claim::State::undecided;
    c.reason = reason;
  }
  for (Extreme& e : proof.extremes) e.least.low = -infinity, e.largest.high = infinity;
}

// What is looked at of a motion: its coordinates over spans of time, from begin to end, and why not farther.
struct Known {
  mechanics::Enclosure motion;
  Bounds time;
  std::string beyond;  // why not to the end; empty: it is
};

Known known(const mechanics::Machine& machine, const mechanics::Trajectory& trajectory, const mechanics::Enclosure& actuators) {
  const Bounds whole{trajectory.time.front(), trajectory.time.back()};
  if (trajectory.over) return {trajectory.over, whole, ""};
  if (!actuators) return {{}, whole, "the motion follows from forces, by an integration whose error has no bound"};
  FollowedProof followed = prove_followed(machine, trajectory, actuators);
  return {std::move(followed.over), followed.proved, std::move(followed.reason)};
}

}  // namespace

MotionProof prove_motion(const mechanics::Machine& machine, const mechanics::Trajectory& trajectory, const mechanics::Enclosure& actuators,
                         const ProofOptions& options) {
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
  if (out.recording > recording_rounding) {
    out.unexamined = "what was recorded is not what the plugin computes";
    return out;
  }
  const Known k = known(machine, trajectory, actuators);
  if (!k.motion) {
    out.unexamined = k.beyond;
    return out;
  }
  Prover prover(machine, *program, program::in_time(program->program, 2), k.motion, k.time, trajectory.knots, options);
  prover.run(out);
  if (k.time.high < out.end) leave_open(out, {k.time.high, out.end}, k.beyond);
  return out;
}

}  // namespace pmreport::analysis
