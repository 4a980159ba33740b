#include <core/mechanics/recorded/motion_program.hpp>

#include <core/mechanics/model/closure.hpp>
#include <core/mechanics/model/joint_motion.hpp>
#include <core/program/recorder.hpp>

namespace pmreport::mechanics {

namespace {

using pmreport::Recorded;

// Where body `i` is, as recorded. Of a slender body the z axis alone is known: `whole` is false, and its other axes are zero.
Placed<Recorded> placed(const Machine& machine, const program::Recorder& recorder, int i, bool& whole) {
  Placed<Recorded> out;
  whole = true;
  if (i == 0) {
    out.origin = Vector3<Recorded>::Zero();
    out.rotation = Matrix3<Recorded>::Identity();
    return out;
  }
  const int first = static_cast<int>(machine.layout().body(i));
  for (int k = 0; k < 3; ++k) out.origin(k) = recorder.output(first + k);
  if (machine.topology().bodies[static_cast<std::size_t>(i)].slender) {
    whole = false;
    out.rotation.setZero();
    for (int k = 0; k < 3; ++k) out.rotation(k, 2) = recorder.output(first + 3 + k);
    return out;
  }
  for (int k = 0; k < 9; ++k) out.rotation(k / 3, k % 3) = recorder.output(first + 3 + k);
  return out;
}

bool along_z(const Eigen::Vector3d& v) { return v.x() == 0 && v.y() == 0; }

}  // namespace

std::optional<MotionProgram> motion_program(const Machine& machine, std::string* why) {
  const program::Program* geometry = machine.program(why);
  if (geometry == nullptr) return std::nullopt;
  const Topology& t = machine.topology();
  const Closure closure(machine);
  program::Recorder recorder(*geometry);
  MotionProgram out;
  out.wrenches = machine.layout().size();
  std::vector<Recorded> outputs;
  for (std::size_t o = 0; o < geometry->outputs().size(); ++o) outputs.push_back(recorder.output(static_cast<int>(o)));
  for (std::size_t j = 0; j < t.joints.size(); ++j) {
    const Joint& joint = t.joints[j];
    std::vector<Recorded> motions;
    bool known = true;
    for (std::size_t k = 0; k < joint.limits.size(); ++k) {
      if (!binds(joint, joint.limits[k], false) && !binds(joint, joint.limits[k], true)) continue;
      if (motions.empty()) {
        bool whole_a = false, whole_b = false;
        const Placed<Recorded> a = placed(machine, recorder, joint.a, whole_a), b = placed(machine, recorder, joint.b, whole_b);
        const JointHome& home = closure.home(static_cast<int>(j));
        // A ball shows its stud's z axis in its socket; a socket without spin shows its own z axis alone.
        known = joint.kind == JointKind::spherical ? (joint.stud == joint.a ? whole_b : whole_a) || along_z(home.stud) : whole_a && whole_b;
        // A slide needs of its first body no more than the axis, and where the second's centre lies on its own.
        if (joint.kind == JointKind::prismatic) known = (whole_a || along_z(home.a.axis[0])) && (whole_b || along_z(home.b.centre));
        if (!known) break;
        motions = joint_motion(joint, home, a, b);
      }
      out.joints.push_back({static_cast<int>(j), static_cast<int>(k), outputs.size()});
      outputs.push_back(motions[k]);
    }
    if (!known) out.left_out.push_back(joint.name);
  }
  try {
    out.program = recorder.finish(outputs);
  } catch (const program::ProgramError& e) {
    if (why != nullptr) *why = e.what();
    return std::nullopt;
  }
  return out;
}

}  // namespace pmreport::mechanics
