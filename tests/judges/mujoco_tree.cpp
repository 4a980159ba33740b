#include <tests/judges/mujoco_tree.hpp>

#include <core/mechanics/machine/joint_words.hpp>
#include <core/mechanics/model/generic_model.hpp>

#include <fmt/core.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

namespace pmreport::judges {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using mechanics::Machine;

namespace {

// A pin says all of a spherical joint, two say all of a revolute one; the others have to be branches.
int eagerness_to_close(JointKind kind) { return kind == JointKind::spherical ? 2 : kind == JointKind::revolute ? 1 : 0; }

std::vector<Pin> pins_of(const Machine& machine, int joint) {
  const Joint& j = machine.topology().joints[static_cast<std::size_t>(joint)];
  const mechanics::Pose& home = machine.home_pose();
  const auto pin = [&](const Vector3d& point) -> Pin {
    return {joint, machine.rotation(home, j.b).transpose() * (point - machine.origin(home, j.b))};
  };
  const Vector3d centre = machine.centre(home, joint);
  if (j.kind == JointKind::spherical) return {pin(centre)};
  if (j.kind == JointKind::revolute) {
    const Vector3d apart = 0.5 * mechanics::characteristic_length(machine) * machine.axis(home, joint);
    return {pin(centre - apart), pin(centre + apart)};
  }
  throw std::invalid_argument(
      fmt::format("joint {} closes a loop, and no pins can stand for a {} joint", j.name, mechanics::word_of(j.kind)));
}

std::string text(const Vector3d& v) { return fmt::format("{} {} {}", v.x(), v.y(), v.z()); }
std::string orientation(const Matrix3d& rotation) {
  const Quaterniond q(rotation);
  return fmt::format("{} {} {} {}", q.w(), q.x(), q.y(), q.z());
}
std::string name(int body) { return body == 0 ? "world" : fmt::format("b{}", body); }

class Writer {
 public:
  Writer(const Machine& machine, const Tree& tree) : machine_(machine), home_(machine.home_pose()), tree_(tree) {}

  // What hangs on `parent`, and what hangs on that.
  std::string children(int parent) const {
    std::string out;
    for (const Branch& branch : tree_.branches) {
      if (branch.parent != parent) continue;
      const Matrix3d up = machine_.rotation(home_, parent).transpose();
      out += fmt::format("<body name='{}' pos='{}' quat='{}'>\n", name(branch.child),
                         text(up * (machine_.origin(home_, branch.child) - machine_.origin(home_, parent))),
                         orientation(up * machine_.rotation(home_, branch.child)));
      const Inertia& inertia = machine_.topology().bodies[static_cast<std::size_t>(branch.child)].inertia;
      out += fmt::format("<inertial pos='{}' quat='{}' mass='1' diaginertia='1 1 1'/>\n", text(inertia.centre),
                         orientation(principal(inertia).axes));
      out += freedoms(branch) + children(branch.child) + "</body>\n";
    }
    return out;
  }

  std::string pins() const {
    std::string out;
    for (const Pin& pin : tree_.pins) {
      const Joint& j = machine_.topology().joints[static_cast<std::size_t>(pin.joint)];
      out += fmt::format("<connect body1='{}' body2='{}' anchor='{}'/>\n", name(j.b), name(j.a), text(pin.on_b));
    }
    return out;
  }

 private:
  std::string freedoms(const Branch& branch) const {
    const Joint& j = machine_.topology().joints[static_cast<std::size_t>(branch.joint)];
    const Vector3d at =
        machine_.rotation(home_, branch.child).transpose() * (machine_.centre(home_, branch.joint) - machine_.origin(home_, branch.child));
    int next = 0;
    const auto freedom = [&](const char* type, int axis) {
      return fmt::format("<joint name='j{}_{}' type='{}' pos='{}' axis='{}'/>\n", branch.joint, next++, type, text(at),
                         text(branch_axis(machine_, branch, axis)));
    };
    switch (j.kind) {
      case JointKind::revolute:
        return freedom("hinge", 0);
      case JointKind::prismatic:
        return freedom("slide", 0);
      case JointKind::universal: {
        const std::string first = freedom("hinge", 0);
        return first + freedom("hinge", 1);
      }
      case JointKind::cylindrical: {
        const std::string slide = freedom("slide", 0);
        return slide + freedom("hinge", 0);
      }
      case JointKind::spherical:
        break;
    }
    return fmt::format("<joint name='j{}_0' type='ball' pos='{}'/>\n", branch.joint, text(at));
  }

  const Machine& machine_;
  const mechanics::Pose& home_;
  const Tree& tree_;
};

}  // namespace

// Kruskal's spanning tree: driven joints first, which must have freedoms of their own, then those that cannot close a loop, so that those
// left over are the ones that can.
Tree tree_of(const Machine& machine) {
  const Topology& t = machine.topology();
  std::vector<int> order(t.joints.size()), island(t.bodies.size());
  std::iota(order.begin(), order.end(), 0);
  std::iota(island.begin(), island.end(), 0);
  const auto joint = [&](int i) -> const Joint& { return t.joints[static_cast<std::size_t>(i)]; };
  const auto eagerness = [&](int i) {
    const bool driven = std::ranges::any_of(t.actuators, [&](const Actuator& a) { return a.joint == i; });
    return driven ? -1 : eagerness_to_close(joint(i).kind);
  };
  std::stable_sort(order.begin(), order.end(), [&](int i, int k) { return eagerness(i) < eagerness(k); });
  Tree tree;
  std::vector<int> chosen;
  for (const int i : order) {
    const int of_a = island[static_cast<std::size_t>(joint(i).a)], of_b = island[static_cast<std::size_t>(joint(i).b)];
    if (of_a != of_b) {
      chosen.push_back(i);
      std::replace(island.begin(), island.end(), of_b, of_a);
    } else {
      for (const Pin& pin : pins_of(machine, i)) tree.pins.push_back(pin);
    }
  }
  std::vector<int> reached{0};
  for (std::size_t next = 0; next < reached.size(); ++next) {
    const int parent = reached[next];
    for (int& i : chosen) {
      if (i < 0 || (joint(i).a != parent && joint(i).b != parent)) continue;
      tree.branches.push_back({i, parent, joint(i).a == parent ? joint(i).b : joint(i).a});
      reached.push_back(tree.branches.back().child);
      i = -1;
    }
  }
  return tree;
}

Principal principal(const Inertia& inertia) {
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(inertia.about_centre);
  Principal out{solver.eigenvalues(), solver.eigenvectors()};
  if (out.axes.determinant() < 0) out.axes.col(0) = -out.axes.col(0);
  return out;
}

// The axis fixed in the parent acts first, so that the one fixed in the child is carried along by it.
Vector3d branch_axis(const Machine& machine, const Branch& branch, int k) {
  const Joint& j = machine.topology().joints[static_cast<std::size_t>(branch.joint)];
  const bool reversed = j.b == branch.parent;
  const int axis = reversed ? axes_of(j.kind) - 1 - k : k;
  const Vector3d n = machine.axis(machine.home_pose(), branch.joint, axis);
  return machine.rotation(machine.home_pose(), branch.child).transpose() * (reversed ? Vector3d(-n) : n);
}

std::string mjcf(const Machine& machine, const Tree& tree) {
  const Writer writer(machine, tree);
  return "<mujoco>\n<compiler angle='radian' inertiafromgeom='false'/>\n"
         "<option jacobian='dense'><flag contact='disable' limit='disable' passive='disable' warmstart='disable'/></option>\n"
         "<worldbody>\n" +
         writer.children(0) + "</worldbody>\n<equality>\n" + writer.pins() + "</equality>\n</mujoco>\n";
}

}  // namespace pmreport::judges
