#include <core/mechanics/workspace/pose_limits.hpp>

#include <core/mechanics/machine/joint_words.hpp>
#include <core/mechanics/machine/limb_line.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/model/joint_motion.hpp>
#include <core/mechanics/recorded/motion_program.hpp>
#include <core/mechanics/transmission/pressure.hpp>
#include <core/mechanics/transmission/transmission_paths.hpp>
#include <core/mechanics/workspace/late_limits.hpp>
#include <core/mechanics/workspace/margin_recorder.hpp>
#include <core/mechanics/workspace/segments.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace pmreport::mechanics {

namespace {

using Group = PoseLimit::Group;

// Where the numbers of a placement stand among the outputs.
class Recordings {
 public:
  Recordings(const Machine& machine, const program::Recorder& recorder) : machine_(machine), recorder_(recorder) {}
  Vector3<Recorded> centre(int joint) const { return vector(machine_.layout().joint(joint)); }
  // A direction that is fixed in a body, base axes. Of a slender body its z axis alone is known.
  Vector3<Recorded> direction(const Direction& d) const {
    const Eigen::Vector3d axis = d.axis.normalized();
    if (d.body == 0) return axis.cast<Recorded>();
    const std::size_t first = machine_.layout().body(d.body) + 3;
    if (machine_.topology().bodies[static_cast<std::size_t>(d.body)].slender) return vector(first) * Recorded(axis.z());
    Vector3<Recorded> out;
    for (int r = 0; r < 3; ++r) {
      Recorded sum(0.0);
      for (int c = 0; c < 3; ++c) sum += recorder_.output(static_cast<int>(first) + 3 * r + c) * axis(c);
      out(r) = sum;
    }
    return out;
  }

 private:
  Vector3<Recorded> vector(std::size_t first) const {
    Vector3<Recorded> out;
    for (int k = 0; k < 3; ++k) out(k) = recorder_.output(static_cast<int>(first) + k);
    return out;
  }
  const Machine& machine_;
  const program::Recorder& recorder_;
};

// What a value is: where its number stands, or which reading gives it.
struct Found {
  std::string name, title, unit;
  std::optional<std::size_t> output;
  int reading = -1;
};
std::vector<Found> values_named(const Machine& machine, const MotionProgram* motion, const std::string& name) {
  const Topology& t = machine.topology();
  std::vector<Found> out;
  const auto meant = [&](const std::string& own, const char* group) { return name == own || name == group; };
  for (std::size_t i = 0; i < t.actuators.size(); ++i)
    if (meant(t.actuators[i].name, "actuator"))
      out.push_back({t.actuators[i].name, t.actuators[i].title, t.actuators[i].unit, machine.layout().actuator(static_cast<int>(i))});
  for (std::size_t i = 0; i < t.derived.size(); ++i)
    if (meant(t.derived[i].name, "derived"))
      out.push_back({t.derived[i].name, t.derived[i].title, t.derived[i].unit, machine.layout().derived(static_cast<int>(i))});
  for (std::size_t i = 0; i < t.readings.size(); ++i)
    if (meant(t.readings[i].name, "reading"))
      out.push_back({t.readings[i].name, t.readings[i].title, t.readings[i].unit, std::nullopt, static_cast<int>(i)});
  for (std::size_t j = 0; j < t.joints.size(); ++j)
    for (std::size_t k = 0; k < t.joints[j].limits.size(); ++k) {
      const std::string own = motion_name(t.joints[j], k);
      if (!meant(own, "joint_angle")) continue;
      Found f{own, "motion of joint " + t.joints[j].name, t.joints[j].kind == JointKind::prismatic ? "m" : "rad", std::nullopt};
      if (motion != nullptr)
        for (const auto& m : motion->joints)
          if (m.joint == static_cast<int>(j) && m.limit == static_cast<int>(k)) f.output = m.output;
      if (motion == nullptr || f.output) out.push_back(std::move(f));
    }
  return out;
}

PoseLimit value_limit(const Found& f, const AskedLimit& asked) {
  const bool alone = std::get<AskedValue>(asked.what).name == f.name;
  const std::string name = asked.name.empty() ? f.name : alone ? asked.name : asked.name + " " + f.name;
  return {Group::values, name, f.title, f.unit, asked.min, asked.max, f.name};
}

void add_strokes(MarginRecorder& margins, const Machine& machine) {
  const Topology& t = machine.topology();
  for (std::size_t i = 0; i < t.actuators.size(); ++i) {
    const Actuator& a = t.actuators[i];
    margins.add_output({Group::strokes, a.name, a.title, a.unit, a.stroke.min, a.stroke.max},
                       machine.layout().actuator(static_cast<int>(i)));
  }
}

void add_joints(MarginRecorder& margins, program::Recorder& recorder, const Machine& machine, const MotionProgram& motion) {
  const Topology& t = machine.topology();
  for (const MotionProgram::JointMotion& m : motion.joints) {
    const Joint& joint = t.joints[static_cast<std::size_t>(m.joint)];
    const auto k = static_cast<std::size_t>(m.limit);
    const Range& range = joint.limits[k];
    PoseLimit limit{Group::joints, motion_name(joint, k), fmt::format("motion of joint {} from {}", joint.name, origin_of(t, joint)),
                    motion_unit(joint)};
    if (binds(joint, range, false)) limit.min = range.min;
    if (binds(joint, range, true)) limit.max = range.max;
    const program::Step& step = motion.program.steps()[static_cast<std::size_t>(motion.program.outputs()[m.output])];
    // The stud and what its deflection counts from are unit vectors.
    if (joint.kind == JointKind::spherical && step.operation == program::Operation::atan2)
      margins.add_angle(std::move(limit), recorder.step(step.b), Recorded(1.0));
    else
      margins.add_output(std::move(limit), m.output);
  }
}

void add_angles(MarginRecorder& margins, const Recordings& at, const Machine& machine, const AskedLimit& asked, const AskedAngle& angle) {
  const Vector3<Recorded> direction = at.direction(angle.against);
  for (const int n : angle.limbs) {
    const std::optional<LimbLine> line = limb_line(machine, n);
    if (!line) continue;  // refused before
    const Vector3<Recorded> along = at.centre(line->to) - at.centre(line->from);
    const std::string name = asked.name.empty() ? fmt::format("angle of limb {}", n) : fmt::format("{} {}", asked.name, n);
    margins.add_angle({Group::angles, name, fmt::format("angle of limb {} against a declared direction", n), "rad", asked.min, asked.max},
                      along.dot(direction), length(along));
  }
}

void add_distances(MarginRecorder& margins, const Recordings& at, const Machine& machine, const AskedLimit& asked, const AskedDistance& d) {
  for (const auto& [a, b] : pairs_of(machine, d)) {
    const std::string name = fmt::format("{} {}-{}", asked.name.empty() ? "distance" : asked.name, a.limb, b.limb);
    PoseLimit limit{Group::distances, name, fmt::format("distance of limbs {} and {}", a.limb, b.limb), "m", asked.min, asked.max};
    const double radii = d.surfaces ? a.radius + b.radius : 0.0;
    limit.min += radii, limit.max += radii;
    margins.add_square(std::move(limit),
                       squared_distance<Recorded>(at.centre(a.low), at.centre(a.high), at.centre(b.low), at.centre(b.high)));
  }
}

// The part of a limit that no program gives.
void add_late(MarginRecorder& margins, LateLimits& late, const Machine& machine, const MotionProgram& motion, const AskedLimit& asked) {
  const bool lower = std::isfinite(asked.min), upper = std::isfinite(asked.max);
  const auto named = [&](const std::string& own) { return asked.name.empty() ? own : asked.name; };
  if (const auto* value = std::get_if<AskedValue>(&asked.what))
    for (const Found& f : values_named(machine, &motion, value->name))
      if (f.reading >= 0) {
        margins.add_late(value_limit(f, asked), lower, upper);
        late.add_reading(f.reading, asked.min, asked.max);
      }
  if (std::holds_alternative<AskedPressure>(asked.what)) {
    for (const Actuator& a : machine.topology().actuators)
      margins.add_late({Group::pressure, named("pressure") + " " + a.name, "pressure angle of " + a.name, "rad", asked.min, asked.max},
                       lower, upper);
    late.add_pressure(asked.min, asked.max);
  }
  if (std::holds_alternative<AskedCondition>(asked.what)) {
    margins.add_late({Group::condition, named("condition"), "condition number of the overall Jacobian", "", asked.min, asked.max}, lower,
                     upper);
    late.add_condition(asked.min, asked.max);
  }
  if (std::holds_alternative<AskedTransmission>(asked.what)) {
    margins.add_late({Group::transmission, named("transmission"), "local transmission index", "", asked.min, asked.max}, lower, upper);
    late.add_transmission(asked.min, asked.max);
  }
  if (const auto* c = std::get_if<AskedCompliance>(&asked.what)) {
    margins.add_late({Group::compliance, named("compliance"), "largest displacement by a force", "m/N", asked.min, asked.max}, lower,
                     upper);
    late.add_compliance(c->drive_stiffness, c->horizontal, asked.min, asked.max);
  }
}

}  // namespace

const char* name_of(PoseLimit::Group group) {
  switch (group) {
    case Group::reach:
      return "reach";
    case Group::strokes:
      return "strokes";
    case Group::joints:
      return "joints";
    case Group::angles:
      return "angles";
    case Group::values:
      return "values";
    case Group::distances:
      return "distances";
    case Group::pressure:
      return "pressure";
    case Group::condition:
      return "condition";
    case Group::transmission:
      return "transmission";
    case Group::compliance:
      return "compliance";
  }
  return "";
}

std::vector<std::pair<LimbLine, LimbLine>> pairs_of(const Machine& machine, const AskedDistance& asked) {
  std::vector<std::pair<LimbLine, LimbLine>> out;
  const auto add = [&](int i, int k) {
    const std::optional<LimbLine> a = limb_line(machine, i), b = limb_line(machine, k);
    if (a && b && !adjacent(machine, *a, *b)) out.emplace_back(*a, *b);
  };
  for (std::size_t i = 0; i < asked.limbs.size(); ++i) {
    if (asked.with.empty())
      for (std::size_t k = i + 1; k < asked.limbs.size(); ++k) add(asked.limbs[i], asked.limbs[k]);
    for (const int k : asked.with) add(asked.limbs[i], k);
  }
  return out;
}

std::string unit_of_value(const Machine& machine, const std::string& name) {
  const std::vector<Found> found = values_named(machine, nullptr, name);
  return found.empty() ? std::string() : found.front().unit;
}

std::optional<std::string> refusal(const Machine& machine, const AskedLimit& asked) {
  std::string why;
  const auto limbs = [&](const std::vector<int>& numbers) -> std::optional<std::string> {
    for (const int n : numbers)
      if (!limb_line(machine, n, &why)) return fmt::format("limb {} {}", n, why);
    return std::nullopt;
  };
  if (const auto* angle = std::get_if<AskedAngle>(&asked.what)) return limbs(angle->limbs);
  if (const auto* value = std::get_if<AskedValue>(&asked.what)) {
    if (values_named(machine, nullptr, value->name).empty())
      return fmt::format("there is no actuator, derived quantity, reading or joint motion \"{}\"", value->name);
    const std::optional<MotionProgram> motion = motion_program(machine);
    if (motion && values_named(machine, &*motion, value->name).empty())
      return fmt::format("{} is not known from the recorded geometry: the joint has no limit that binds, or ends at a body without spin",
                         value->name);
    return std::nullopt;
  }
  if (const auto* distance = std::get_if<AskedDistance>(&asked.what)) {
    for (const auto& numbers : {distance->limbs, distance->with})
      if (auto out = limbs(numbers)) return out;
    if (pairs_of(machine, *distance).empty()) return "no two of the limbs are apart: all share a joint, or meet in one point";
    return std::nullopt;
  }
  if (std::holds_alternative<AskedPressure>(asked.what) && !pressure_known(machine, &why)) return why;
  if (std::holds_alternative<AskedTransmission>(asked.what)) {
    const TransmissionPaths paths = transmission_paths(machine, characteristic_length(machine));
    for (std::size_t i = 0; i < paths.drives.size(); ++i)
      if (!paths.drives[i].no_output.empty())
        return fmt::format("the local transmission index is not known, for {} has none: {}", machine.topology().actuators[i].name,
                           paths.drives[i].no_output);
  }
  return std::nullopt;
}

std::optional<PoseMargins> pose_margins(const Machine& machine, const LimitChoice& choice, std::string* why) {
  const std::optional<MotionProgram> motion = motion_program(machine, why);
  if (!motion) return std::nullopt;
  program::Recorder recorder(motion->program);
  PoseMargins out;
  MarginRecorder margins(recorder, motion->program, out);
  const Recordings at(machine, recorder);
  margins.add_reach();
  if (choice.strokes) add_strokes(margins, machine);
  if (choice.joints) {
    add_joints(margins, recorder, machine, *motion);
    out.left_out = motion->left_out;
  }
  for (const AskedLimit& asked : choice.asked) {
    if (const auto* angle = std::get_if<AskedAngle>(&asked.what)) add_angles(margins, at, machine, asked, *angle);
    if (const auto* value = std::get_if<AskedValue>(&asked.what))
      for (const Found& f : values_named(machine, &*motion, value->name))
        if (f.output) margins.add_output(value_limit(f, asked), *f.output);
    if (const auto* distance = std::get_if<AskedDistance>(&asked.what)) add_distances(margins, at, machine, asked, *distance);
  }
  // What no program gives stands behind, and behind it what must hold at every orientation.
  LateLimits late(machine);
  for (const AskedLimit& asked : choice.asked)
    if (!asked.every) add_late(margins, late, machine, *motion, asked);
  const std::size_t alone = out.late;
  for (const AskedLimit& asked : choice.asked)
    if (asked.every) add_late(margins, late, machine, *motion, asked);
  out.every = out.late - alone;
  if (out.late > 0) out.judge_late = late.judge();
  try {
    out.program = recorder.finish(margins.outputs);
  } catch (const program::ProgramError& e) {
    if (why != nullptr) *why = e.what();
    return std::nullopt;
  }
  try {
    out.late_over_boxes = late.over_boxes();
  } catch (const program::ProgramError&) {
    // Too long: no proof is made, and poses are judged as ever.
  }
  return out;
}

}  // namespace pmreport::mechanics
