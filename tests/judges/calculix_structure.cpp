#include <tests/judges/calculix_model.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pmreport::judges {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using mechanics::Machine;

namespace {

Vector6d force(const Vector3d& along) { return (Vector6d() << along, Vector3d::Zero()).finished(); }
Vector6d moment(const Vector3d& about) { return (Vector6d() << Vector3d::Zero(), about).finished(); }

Matrix3d tilde(const Vector3d& v) { return (Matrix3d() << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0).finished(); }

// What a joint passes, about its centre, without its drive: what is reciprocal to the motions that it allows.
std::vector<Vector6d> passed_by(const Machine& machine, const mechanics::Pose& pose, int joint) {
  std::vector<Vector6d> out;
  const JointKind kind = machine.topology().joints[static_cast<std::size_t>(joint)].kind;
  const Vector3d n = axes_of(kind) > 0 ? machine.axis(pose, joint) : Vector3d(Vector3d::UnitZ());
  const Vector3d x = n.unitOrthogonal(), y = n.cross(x);
  const bool slides = kind == JointKind::prismatic || kind == JointKind::cylindrical;
  for (const Vector3d& along : {x, y}) out.push_back(force(along));
  if (!slides) out.push_back(force(n));
  if (kind == JointKind::universal) out.push_back(moment(n.cross(machine.axis(pose, joint, 1)).normalized()));
  if (kind == JointKind::spherical || kind == JointKind::universal) return out;
  for (const Vector3d& about : {x, y}) out.push_back(moment(about));
  if (kind == JointKind::prismatic) out.push_back(moment(n));
  return out;
}

}  // namespace

CalculixModel::CalculixModel(const Machine& machine, std::span<const double> coordinates, Mass mass, int elements)
    : machine_(machine), pose_(machine.pose(coordinates)) {
  const Topology& t = machine.topology();
  const mechanics::ElasticSettings& settings = machine.elasticity();
  if (pose_.status != PM_OK) throw std::invalid_argument("no such pose: " + pose_.why);
  if (!settings.base.isZero(0) || !settings.platform.isZero(0) || settings.warmer != 0 || !settings.misfits.empty())
    throw std::invalid_argument("compliance of base and platform, temperature and misfits are not in the model");
  rigid_.assign(t.bodies.size(), -1);
  elastic_.resize(t.joints.size());
  for (std::size_t i = 0; i < t.elements.size(); ++i)
    if (t.elements[i].kind == ElementKind::beam) add_beam(static_cast<int>(i), elements);
  add_bodies();
  add_springs();
  for (int j = 0; j < static_cast<int>(t.joints.size()); ++j) add_joint(j);
  add_masses(mass);
}

// Relative displacement of b against a at `centre` along the wrench `held`, f . (u + w x r) + m . w at either, is what the springs give.
void CalculixModel::connect(int a, int b, const Vector3d& centre, const Vector6d& held, const std::vector<Elastic>& gives) {
  std::vector<CalculixDeck::Term> terms;
  for (const int node : {a, b}) {
    if (node == CalculixDeck::base) continue;
    const Vector3d f = held.head<3>(), about = (centre - deck_.place(node)).cross(f) + held.tail<3>();
    for (int k = 0; k < 3; ++k) {
      terms.push_back({node, k, node == b ? f(k) : -f(k)});
      terms.push_back({node, 3 + k, node == b ? about(k) : -about(k)});
    }
  }
  for (const Elastic& e : gives) terms.push_back({e.spring, 0, -held.dot(e.wrench)});
  deck_.relate(std::move(terms));
}

int CalculixModel::add_spring(int element, double stiffness) {
  springs_.push_back({deck_.add_spring(stiffness), element, stiffness});
  return springs_.back().node;
}

// A leg that may spin about itself does not.
void CalculixModel::add_bodies() {
  const Topology& t = machine_.topology();
  for (std::size_t i = 1; i < t.bodies.size(); ++i) {
    const int body = static_cast<int>(i);
    if (rigid_[i] < 0) rigid_[i] = deck_.add_rigid(machine_.origin(pose_, body));
    if (!t.bodies[i].slender) continue;
    const Vector3d n = machine_.rotation(pose_, body).col(2);
    deck_.relate({{rigid_[i], 3, n.x()}, {rigid_[i], 4, n.y()}, {rigid_[i], 5, n.z()}});
  }
  platform_ = rigid_[static_cast<std::size_t>(t.platform)];
}

// In series with what the joint passes. A rail of the slide that it is loaded by is in series with the drive.
void CalculixModel::add_springs() {
  const Topology& t = machine_.topology();
  for (std::size_t i = 0; i < t.elements.size(); ++i) {
    const Element& e = t.elements[i];
    const int element = static_cast<int>(i);
    const auto give = [&](int joint, const Vector6d& wrench, double stiffness, bool of_drive) {
      if (std::isfinite(stiffness)) elastic_[static_cast<std::size_t>(joint)].push_back({wrench, add_spring(element, stiffness), of_drive});
    };
    if (e.kind == ElementKind::drive) {
      const Actuator& a = t.actuators[static_cast<std::size_t>(e.actuator)];
      const Vector3d n = machine_.axis(pose_, a.joint);
      give(a.joint, a.sense() == Sense::linear ? force(n) : moment(n), e.stiffness[0], true);
    } else if (e.kind == ElementKind::rail) {
      const auto by = std::ranges::find(t.actuators, e.from, &Actuator::joint);
      const double way = pose_.numbers[machine_.layout().actuator(static_cast<int>(by - t.actuators.begin()))];
      const double l = std::abs(way) + e.offset;
      give(e.to, force(machine_.axis(pose_, e.from)), e.material.modulus * e.section.area / l, e.to == e.from);
    } else if (e.kind == ElementKind::bearing) {
      const Joint& j = t.joints[static_cast<std::size_t>(e.to)];
      const Vector3d n = j.kind != JointKind::spherical ? machine_.axis(pose_, e.to) : Vector3d(machine_.rotation(pose_, j.stud).col(2));
      const Vector3d x = n.unitOrthogonal(), y = n.cross(x);
      give(e.to, force(n), e.stiffness[0], false);
      give(e.to, moment(n), e.stiffness[2], false);
      for (const Vector3d& across : {x, y}) {
        give(e.to, force(across), e.stiffness[1], false);
        give(e.to, moment(across), e.stiffness[3], false);
      }
    }
  }
}

void CalculixModel::add_joint(int joint) {
  const Topology& t = machine_.topology();
  const Joint& j = t.joints[static_cast<std::size_t>(joint)];
  const Vector3d centre = machine_.centre(pose_, joint);
  int a = end_at(j.a, joint), b = end_at(j.b, joint);
  for (const Beam& beam : beams_)
    for (std::size_t k = 1; k < beam.parts.size(); ++k) {
      if (beam.joints[k] != joint) continue;
      const int before = beam.parts[k - 1].nodes.back(), behind = beam.parts[k].nodes.front();
      const bool forwards = beam.parts[k].body == j.b;
      a = forwards ? before : behind, b = forwards ? behind : before;
    }
  std::vector<Elastic> of_drive, of_joint;
  for (const Elastic& e : elastic_[static_cast<std::size_t>(joint)]) (e.of_drive ? of_drive : of_joint).push_back(e);
  for (const Vector6d& held : passed_by(machine_, pose_, joint)) connect(a, b, centre, held, of_joint);
  for (const Actuator& actuator : t.actuators) {
    if (actuator.joint != joint) continue;
    const Vector3d n = machine_.axis(pose_, joint);
    connect(a, b, centre, actuator.sense() == Sense::linear ? force(n) : moment(n), of_drive);
  }
}

void CalculixModel::add_lump(int node, const Vector3d& centre, double mass, const Matrix3d& about_centre) {
  const Matrix3d r = tilde(centre - deck_.place(node));
  Matrix6d m;
  m << mass * Matrix3d::Identity(), -mass * r, mass * r, about_centre - mass * r * r;
  const auto same = std::ranges::find(lumps_, node, &Lump::node);
  if (same != lumps_.end())
    same->inertia += m;
  else
    lumps_.push_back({node, m});
}

// A rod of mass m and length h has m h^2 / 12 across, beside half of what it has about its axis. In slices, each with what its own length
// adds, its mass, centre and inertia are those of the body exactly.
void CalculixModel::add_masses(Mass mass) {
  const Topology& t = machine_.topology();
  lumps_.push_back({platform_, Matrix6d::Zero()});
  for (std::size_t i = 1; i < t.bodies.size(); ++i) {
    const int body = static_cast<int>(i);
    const Inertia& inertia = t.bodies[i].inertia;
    const Matrix3d r = machine_.rotation(pose_, body);
    const Vector3d centre = machine_.origin(pose_, body) + r * inertia.centre;
    int beams = 0;
    Vector3d n = Vector3d::Zero();
    for (const Beam& beam : beams_)
      for (const Part& part : beam.parts)
        if (part.body == body) ++beams, n = beam.n;
    const double axial = inertia.about_centre(2, 2), slender = inertia.about_centre(0, 0) - 0.5 * axial;
    if (mass == Mass::of_bodies || beams != 1 || !(slender > 0) || !(n.cross(r.col(2)).norm() < 1e-9)) {
      add_lump(place_on(body, centre), centre, inertia.mass, r * inertia.about_centre * r.transpose());
      continue;
    }
    constexpr int slices = 24;
    const double share = 1.0 / slices, h = std::sqrt(12 * slender / inertia.mass);
    const Matrix3d along = n * n.transpose(), across = Matrix3d::Identity() - along;
    for (int k = 0; k < slices; ++k) {
      const Vector3d at = centre + n * (h * ((k + 0.5) * share - 0.5));
      add_lump(place_on(body, at), at, inertia.mass * share, share * (axial * along + (0.5 * axial + slender * share * share) * across));
    }
  }
}

}  // namespace pmreport::judges
