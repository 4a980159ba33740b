#include <core/mechanics/stiffness/springs.hpp>

#include <core/linear/eigenvalues.hpp>
#include <core/mechanics/model/generic_model.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace pmreport::mechanics {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

// Reads a placement whose numbers stand `stride` apart.
struct Reader {
  const Machine& machine;
  const double* numbers;
  std::size_t stride;

  Vector3d vector(std::size_t at, std::size_t step = 1) const {
    return {numbers[at * stride], numbers[(at + step) * stride], numbers[(at + 2 * step) * stride]};
  }
  Vector3d centre(int joint) const { return vector(machine.layout().joint(joint)); }
  Vector3d axis(int joint) const { return vector(machine.layout().joint(joint) + 3); }
  Vector3d column(int body, std::size_t k) const { return vector(machine.layout().body(body) + 3 + k, 3); }
  bool slender(int body) const { return machine.topology().bodies[static_cast<std::size_t>(body)].slender; }
  Vector3d along(int body) const { return slender(body) ? vector(machine.layout().body(body) + 3) : column(body, 2); }
  Vector3d origin(int body) const { return body == 0 ? Vector3d::Zero() : vector(machine.layout().body(body)); }
  Vector3d mass_centre(int body) const {
    const Vector3d& c = machine.topology().bodies[static_cast<std::size_t>(body)].inertia.centre;
    if (slender(body)) return origin(body) + along(body) * c.z();
    return origin(body) + column(body, 0) * c.x() + column(body, 1) * c.y() + column(body, 2) * c.z();
  }
};

// Component along e of the force, and of the moment about P, of a wrench about C.
Vector6d force_along(const Vector3d& e) { return (Vector6d() << e, Vector3d::Zero()).finished(); }
Vector6d moment_along(const Vector3d& e, const Vector3d& p_PC) { return (Vector6d() << e.cross(p_PC), e).finished(); }

// Of a beam's length: no stretch, but rounding of where two joints at its end lie along it.
constexpr double sliver = 1e-9;

double per(double stiffness) { return std::isinf(stiffness) ? 0 : 1 / stiffness; }

// A compliance matrix, symmetric and not negative, as springs of unit wrenches.
void add_mount(std::vector<Spring>& out, const Matrix6d& compliance, Spring::Of of) {
  if (compliance.isZero(0)) return;
  const linear::SymmetricEigen6 parts = linear::symmetric_eigen(compliance);
  for (int i = 0; i < 6; ++i)
    if (parts.values(i) > 0) out.push_back({-1, Spring::Kind::mount, of, 0, 0, -1, parts.vectors.col(i), parts.values(i), 0});
}

}  // namespace

SpringPlan::SpringPlan(const Machine& machine) : machine_(machine), length_(characteristic_length(machine)) {
  const Topology& t = machine.topology();
  actuator_of_joint_.assign(t.joints.size(), -1);
  for (std::size_t i = 0; i < t.actuators.size(); ++i)
    actuator_of_joint_[static_cast<std::size_t>(t.actuators[i].joint)] = static_cast<int>(i);
  misfit_.assign(t.elements.size(), 0);
  for (std::size_t i = 0; i < t.elements.size(); ++i) {
    const Element& e = t.elements[i];
    for (const auto& [name, more] : machine.elasticity().misfits)
      if (name == e.name) misfit_[i] += more;
    if (e.kind != ElementKind::beam) continue;
    const BeamPath path = path_of(t, e.from, e.to);
    const auto passed = [&](int joint, int body, bool onto) {  // onto the body, or by it onto what follows
      const Joint& j = t.joints[static_cast<std::size_t>(joint)];
      return Passed{joint, actuator_of_joint_[static_cast<std::size_t>(joint)], (onto ? j.b : j.a) == body ? 1.0 : -1.0};
    };
    Beam b{static_cast<int>(i), path.bodies, {passed(path.joints.front(), path.bodies.front(), true)}, {}};
    for (std::size_t k = 0; k < path.bodies.size(); ++k) {
      b.chain.push_back(passed(path.joints[k + 1], path.bodies[k], false));
      b.further.emplace_back();
      for (int j = 0; j < static_cast<int>(t.joints.size()); ++j) {
        const Joint& joint = t.joints[static_cast<std::size_t>(j)];
        if ((joint.a == path.bodies[k] || joint.b == path.bodies[k]) && j != path.joints[k] && j != path.joints[k + 1])
          b.further.back().push_back(passed(j, path.bodies[k], true));
      }
    }
    beams_.push_back(std::move(b));
  }
  add_mount(mounts_, machine.elasticity().base, Spring::Of::base);
  add_mount(mounts_, machine.elasticity().platform, Spring::Of::platform);
}

void SpringPlan::at(const double* placement, std::size_t stride, AtPose& out) const {
  const Topology& t = machine_.topology();
  const Reader read{machine_, placement, stride};
  const double warmer = machine_.elasticity().warmer;
  out.springs.clear();
  out.terms.clear();
  out.stretches.clear();
  out.lengths.assign(t.elements.size(), std::numeric_limits<double>::quiet_NaN());

  for (const Beam& b : beams_) {
    const Element& e = t.elements[static_cast<std::size_t>(b.element)];
    const Vector3d root = read.centre(e.from);
    const Vector3d reach = (e.beside < 0 ? read.centre(e.to) : Vector3d(0.5 * (read.centre(e.to) + read.centre(e.beside)))) - root;
    const double length = reach.norm();
    out.lengths[static_cast<std::size_t>(b.element)] = length;
    if (!(length > 0)) continue;
    const Vector3d n = reach / length;
    Vector3d x = read.slender(b.bodies.front()) ? Vector3d(n.unitOrthogonal()) : read.column(b.bodies.front(), 0);
    x -= n * n.dot(x);
    x = x.norm() > 1e-6 ? Vector3d(x.normalized()) : Vector3d(n.unitOrthogonal());
    const Vector3d y = n.cross(x);
    const double ea = e.material.modulus * e.section.area, gj = e.material.shear_modulus * e.section.torsion;
    const double bends_x = e.material.modulus * e.section.bending[0], bends_y = e.material.modulus * e.section.bending[1];

    // Of the springs of a stretch whose joints are `passed`: a component of the force, or of the moment about a point P.
    const auto sum_of = [&](const std::vector<Passed>& passed, auto&& component) {
      const int first = static_cast<int>(out.terms.size());
      for (const Passed& p : passed) out.terms.push_back({p.joint, p.actuator, p.sign * component(read.centre(p.joint))});
      return first;
    };
    const auto stretch = [&](double begin, double end, const std::vector<Passed>& passed) {
      const double l = end - begin;
      const Vector3d middle = root + n * (0.5 * (begin + end));
      const int first = static_cast<int>(out.springs.size());
      const auto add = [&](Spring::Kind kind, double compliance, double shortens, auto&& component) {
        const int first_term = sum_of(passed, component);
        out.springs.push_back(
            {b.element, kind, Spring::Of::joints, first_term, static_cast<int>(passed.size()), -1, Vector6d::Zero(), compliance, shortens});
      };
      const auto force = [](const Vector3d& along) { return [along](const Vector3d&) { return force_along(along); }; };
      const auto moment = [](const Vector3d& along, const Vector3d& p) {
        return [along, p](const Vector3d& centre) { return moment_along(along, centre - p); };
      };
      const auto by = [l](double rigidity) { return std::isinf(rigidity) ? 0 : l / rigidity; };
      const double longer = e.material.expansion * warmer * l + misfit_[static_cast<std::size_t>(b.element)] * l / length;
      const bool full = e.bends == Bending::full;
      const double bend_x = full ? by(bends_x) : 0, bend_y = full ? by(bends_y) : 0;
      add(Spring::Kind::axial, by(ea), -longer, force(n));
      add(Spring::Kind::across, bend_y * l * l / 12, 0, force(x));  // a force along x bends about y
      add(Spring::Kind::across, bend_x * l * l / 12, 0, force(y));
      add(Spring::Kind::torsion, by(gj), 0, moment(n, middle));
      add(Spring::Kind::bending, bend_x, 0, moment(x, middle));
      add(Spring::Kind::bending, bend_y, 0, moment(y, middle));
      if (e.bends == Bending::couples) {
        add(Spring::Kind::end_bending, by(bends_x), 0, moment(x, root + reach));
        add(Spring::Kind::end_bending, by(bends_y), 0, moment(y, root + reach));
      }
      out.stretches.push_back({b.element, first, l});
    };

    double begin = 0;
    std::vector<Passed> passed;
    for (std::size_t k = 0; k < b.bodies.size(); ++k) {
      struct Event {
        double at;
        const Passed* joint;  // nullptr: the centre of mass
      };
      std::vector<Event> events{{n.dot(read.mass_centre(b.bodies[k]) - root), nullptr}};
      for (const Passed& p : b.further[k]) events.push_back({n.dot(read.centre(p.joint) - root), &p});
      std::ranges::stable_sort(events, {}, &Event::at);
      bool behind_mass = false;
      for (std::size_t i = 0; i < events.size(); ++i) {
        const double end = std::clamp(events[i].at, begin, length);
        passed.assign(1, b.chain[behind_mass ? k + 1 : k]);
        for (std::size_t other = 0; other < events.size(); ++other) {
          if (events[other].joint == nullptr || (behind_mass ? other < i : other >= i)) continue;
          passed.push_back(*events[other].joint);
          if (behind_mass) passed.back().sign *= -1;
        }
        if (end - begin > sliver * length) stretch(begin, end, passed);
        begin = end;
        behind_mass = behind_mass || events[i].joint == nullptr;
      }
    }
    passed.assign(1, b.chain.back());
    if (length - begin > sliver * length) stretch(begin, length, passed);
  }

  for (std::size_t i = 0; i < t.elements.size(); ++i) {
    const Element& e = t.elements[i];
    const int element = static_cast<int>(i);
    if (e.kind == ElementKind::drive) {
      out.springs.push_back(
          {element, Spring::Kind::drive, Spring::Of::actuator, 0, 0, e.actuator, Vector6d::Zero(), per(e.stiffness[0]), -misfit_[i]});
    } else if (e.kind == ElementKind::rail) {
      const double way = placement[machine_.layout().actuator(actuator_of_joint_[static_cast<std::size_t>(e.from)]) * stride];
      const double l = std::abs(way) + e.offset, ea = e.material.modulus * e.section.area;
      out.lengths[i] = l;
      const double longer = (way < 0 ? -1 : 1) * (e.material.expansion * warmer * l + misfit_[i]);
      // The rail pushes the body that the slide carries, and that body what joint `to` holds.
      const Joint &slide = t.joints[static_cast<std::size_t>(e.from)], &to = t.joints[static_cast<std::size_t>(e.to)];
      int carried = slide.b;
      if (e.to != e.from && slide.b != to.a && slide.b != to.b) carried = slide.a;
      const double along = slide.b == carried ? 1 : -1, passed = e.to == e.from ? along : to.a == carried ? 1 : -1;
      out.terms.push_back({e.to, actuator_of_joint_[static_cast<std::size_t>(e.to)], along * passed * force_along(read.axis(e.from))});
      out.springs.push_back({element, Spring::Kind::rail, Spring::Of::joints, static_cast<int>(out.terms.size()) - 1, 1, -1,
                             Vector6d::Zero(), std::isinf(ea) ? 0 : l / ea, -longer});
    } else if (e.kind == ElementKind::bearing) {
      const Joint& j = t.joints[static_cast<std::size_t>(e.to)];
      const Vector3d n =
          j.kind == JointKind::spherical ? (j.stud == 0 ? Vector3d(Vector3d::UnitZ()) : read.along(j.stud)) : read.axis(e.to);
      const Vector3d x = n.unitOrthogonal(), y = n.cross(x);
      const auto add = [&](Spring::Kind kind, const Vector3d& along, double stiffness) {
        if (std::isinf(stiffness)) return;
        out.terms.push_back({e.to, -1, kind == Spring::Kind::bearing_force ? force_along(along) : moment_along(along, Vector3d::Zero())});
        out.springs.push_back(
            {element, kind, Spring::Of::joints, static_cast<int>(out.terms.size()) - 1, 1, -1, Vector6d::Zero(), 1 / stiffness, 0});
      };
      add(Spring::Kind::bearing_force, n, e.stiffness[0]);
      for (const Vector3d& across : {x, y}) add(Spring::Kind::bearing_force, across, e.stiffness[1]);
      add(Spring::Kind::bearing_moment, n, e.stiffness[2]);
      for (const Vector3d& across : {x, y}) add(Spring::Kind::bearing_moment, across, e.stiffness[3]);
    }
  }
  for (Spring s : mounts_) {
    if (s.of == Spring::Of::platform) {
      const int platform = t.platform;
      const auto turned = [&](const Vector3d& v) {
        return Vector3d(read.column(platform, 0) * v.x() + read.column(platform, 1) * v.y() + read.column(platform, 2) * v.z());
      };
      s.g << turned(s.g.head<3>()), turned(s.g.tail<3>());
    }
    out.springs.push_back(s);
  }
}

}  // namespace pmreport::mechanics
