#include <reports/section/front/live_geometry.hpp>

#include <core/mechanics/recorded/motion_program.hpp>
#include <core/program/derivative.hpp>
#include <core/program/recorder.hpp>
#include <reports/scene/gltf/machine_model.hpp>

#include <numeric>

namespace pmreport::section {

namespace {

using Eigen::Vector3d;
using pmreport::Recorded;
using Outputs = std::vector<Recorded>;

int number(std::size_t i) { return static_cast<int>(i); }

// Three outputs of the program that a recorder started from.
Vector3<Recorded> vector_at(const program::Recorder& r, std::size_t at) {
  return {r.output(number(at)), r.output(number(at + 1)), r.output(number(at + 2))};
}

// Sum of m c over all bodies: what their weights do is its displacement in the direction of gravity. The centre of mass of a slender body
// lies on its axis.
Vector3<Recorded> first_moment(const mechanics::Machine& machine, const program::Recorder& recorder) {
  const Topology& t = machine.topology();
  Vector3<Recorded> sum = Vector3<Recorded>::Zero();
  for (std::size_t b = 1; b < t.bodies.size(); ++b) {
    const Inertia& inertia = t.bodies[b].inertia;
    if (inertia.mass == 0) continue;
    const bool slender = t.bodies[b].slender;
    const std::size_t at = machine.layout().body(number(b));
    Vector3<Recorded> centre = vector_at(recorder, at);
    for (std::size_t k = 0; k < 3; ++k) {
      Recorded& c = centre(number(k));
      c += slender ? recorder.output(number(at + 3 + k)) * inertia.centre.z()
                   : Recorded(vector_at(recorder, at + 3 + 3 * k).dot(inertia.centre.cast<Recorded>()));
    }
    sum += inertia.mass * centre;
  }
  return sum;
}

// How the platform turns by each coordinate. Of a rotation R, dR R^T is skew, and its entries are those of its axial vector:
// dR R^T (2, 1) = (row 2 of dR) . (row 1 of R) is the first. A slender platform turns about n x dn.
//
// `moved`: a program whose outputs at `value` are the platform's rotation, 9 numbers or 3, and at `partials` the partials of each in turn.
struct Turned {
  const program::Recorder& moved;
  std::size_t value, partials, dof;
  bool slender;

  Recorded by(std::size_t axis, std::size_t coordinate) const {
    const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
    const auto r = [&](std::size_t e) { return moved.output(number(value + e)); };
    const auto dr = [&](std::size_t e) { return moved.output(number(partials + e * dof + coordinate)); };
    if (slender) return r(i) * dr(j) - r(j) * dr(i);
    return r(3 * i) * dr(3 * j) + r(3 * i + 1) * dr(3 * j + 1) + r(3 * i + 2) * dr(3 * j + 2);
  }
};

}  // namespace

std::optional<LiveGeometry> live_geometry(const mechanics::Machine& machine) try {
  const std::optional<mechanics::MotionProgram> recorded = mechanics::motion_program(machine);
  if (!recorded) return std::nullopt;
  const Topology& t = machine.topology();
  const Layout& layout = machine.layout();
  const std::size_t dof = static_cast<std::size_t>(machine.dof());

  LiveGeometry out;
  std::vector<int> values;
  const auto put = [&](std::size_t first, std::size_t count) {
    const std::size_t at = values.size();
    for (std::size_t i = 0; i < count; ++i) values.push_back(number(first + i));
    return at;
  };
  put(0, 1);
  out.bodies.push_back(0);
  for (std::size_t b = 1; b < t.bodies.size(); ++b) out.bodies.push_back(put(layout.body(number(b)), t.bodies[b].slender ? 6 : 12));
  for (std::size_t b = 1; b < t.bodies.size(); ++b)
    if (const auto guide = t.bodies[b].slender ? scene::guide_of(machine, number(b)) : std::nullopt)
      out.guides.push_back({number(b), put(layout.joint(guide->joint) + 3 + 3 * static_cast<std::size_t>(guide->k), 3)});
  out.actuators = put(layout.actuator(0), dof);
  out.derived = put(layout.derived(0), t.derived.size());
  out.jacobian = put(recorded->wrenches, 36);
  for (const mechanics::MotionProgram::JointMotion& m : recorded->joints) out.motions.push_back({m.joint, m.limit, put(m.output, 1)});

  // What is differentiated: actuators, the platform's origin and rotation, the first moment of mass.
  const std::size_t platform = layout.body(t.platform), turning = t.bodies[static_cast<std::size_t>(t.platform)].slender ? 3 : 9;
  program::Recorder recorder(recorded->program);
  Outputs moved;
  for (std::size_t i = 0; i < dof; ++i) moved.push_back(recorder.output(number(layout.actuator(number(i)))));
  for (std::size_t i = 0; i < 3 + turning; ++i) moved.push_back(recorder.output(number(platform + i)));
  for (const Recorded& x : first_moment(machine, recorder)) moved.push_back(x);
  std::vector<int> by(dof);
  std::iota(by.begin(), by.end(), 0);
  program::Recorder differentiated(program::partials(recorder.finish(moved), by));

  Outputs motion;
  const auto partials_of = [&](std::size_t first) { return moved.size() + first * dof; };
  const auto copy = [&](std::size_t first, std::size_t count) {
    for (std::size_t i = 0; i < count * dof; ++i) motion.push_back(differentiated.output(number(partials_of(first) + i)));
  };
  out.rates = values.size();
  copy(0, dof);
  out.twist = values.size() + motion.size();
  copy(dof, 3);
  const Turned turned{differentiated, dof + 3, partials_of(dof + 3), dof, turning == 3};
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t i = 0; i < dof; ++i) motion.push_back(turned.by(axis, i));
  out.masses = values.size() + motion.size();
  copy(dof + 3 + turning, 3);
  out.program = program::joined(recorded->program.slice(values), differentiated.finish(motion));
  return out;
} catch (const program::ProgramError&) {
  return std::nullopt;  // more operations than there is room for
}

}  // namespace pmreport::section
