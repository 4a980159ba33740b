#include <tests/judges/calculix_model.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pmreport::judges {

using Eigen::Vector3d;

namespace {

// Places along a beam that are one, by its length: a mass that is off by that is where it is to 1e-10 of what it moves by.
constexpr double one_place = 1e-5;
// Bodies nearer to one another than this meet where the first ends: two short beams beside long ones would cost CalculiX the cube of their
// ratio in digits.
constexpr double close = 1e-2;

Vector6d unit_force(const Vector3d& along) { return (Vector6d() << along, Vector3d::Zero()).finished(); }
Vector6d unit_moment(const Vector3d& about) { return (Vector6d() << Vector3d::Zero(), about).finished(); }

}  // namespace

// The bodies of a chain meet halfway between what is fixed to one and to the next. Where a mass stands in the way, as in a telescope that
// is pushed together, joints have the say, and the mass is fixed to its own bar's end.
void CalculixModel::add_beam(int element, int elements) {
  const Topology& t = machine_.topology();
  const Element& e = t.elements[static_cast<std::size_t>(element)];
  const mechanics::BeamPath path = mechanics::path_of(t, e.from, e.to);
  Beam beam{element, machine_.centre(pose_, e.from), {}, {}, 0, path.joints, {}};
  Vector3d end = machine_.centre(pose_, e.to);
  if (e.beside >= 0) end = 0.5 * (end + machine_.centre(pose_, e.beside));
  beam.length = (end - beam.root).norm();
  if (!(beam.length > 0)) return;
  beam.n = (end - beam.root) / beam.length;
  const int front = path.bodies.front();
  const Vector3d x = machine_.rotation(pose_, front).col(0), across = x - beam.n * beam.n.dot(x);
  beam.x = t.bodies[static_cast<std::size_t>(front)].slender || across.norm() < 1e-6 ? beam.n.unitOrthogonal() : across.normalized();

  const std::size_t count = path.bodies.size();
  const auto along = [&](const Vector3d& point) { return std::clamp(beam.n.dot(point - beam.root), 0.0, beam.length); };
  std::vector<std::vector<double>> fixed(count);  // of each body: its further joints, then its centre of mass
  std::vector<double> cuts{0};
  for (std::size_t k = 0; k < count; ++k) {
    for (int j = 0; j < static_cast<int>(t.joints.size()); ++j) {
      const Joint& joint = t.joints[static_cast<std::size_t>(j)];
      if ((joint.a == path.bodies[k] || joint.b == path.bodies[k]) && j != path.joints[k] && j != path.joints[k + 1] && j != e.beside)
        fixed[k].push_back(along(machine_.centre(pose_, j)));
    }
    const Inertia& inertia = t.bodies[static_cast<std::size_t>(path.bodies[k])].inertia;
    fixed[k].push_back(along(machine_.origin(pose_, path.bodies[k]) + machine_.rotation(pose_, path.bodies[k]) * inertia.centre));
  }
  for (std::size_t k = 0; k + 1 < count; ++k) {
    double last = cuts.back(), first = beam.length;
    for (std::size_t i = 0; i + 1 < fixed[k].size(); ++i) last = std::max(last, fixed[k][i]);
    for (std::size_t i = 0; i + 1 < fixed[k + 1].size(); ++i) first = std::min(first, fixed[k + 1][i]);
    if (last > first) throw std::invalid_argument("the joints of " + e.name + " stand in the way of one another");
    const double behind = std::max(last, fixed[k].back()), halfway = 0.5 * (behind + std::min(first, fixed[k + 1].back()));
    cuts.push_back(std::clamp(halfway - behind < close * beam.length ? behind : halfway, last, first));
  }
  cuts.push_back(beam.length);

  for (std::size_t k = 0; k < count; ++k) {
    const int body = path.bodies[k];
    for (const Beam& other : beams_)
      for (const Part& p : other.parts)
        if (p.body == body && (k > 0 || p.body != other.parts.front().body))
          throw std::invalid_argument(t.bodies[static_cast<std::size_t>(body)].name + " is in two beams, and not the root of both");
    std::vector<double> stops{cuts[k], cuts[k + 1]};
    for (std::size_t i = 0; i + 1 < fixed[k].size(); ++i) stops.push_back(std::clamp(fixed[k][i], cuts[k], cuts[k + 1]));
    const double mass = std::clamp(fixed[k].back(), cuts[k], cuts[k + 1]);
    if (std::ranges::none_of(stops, [&](double s) { return std::abs(s - mass) < one_place * beam.length; })) stops.push_back(mass);
    std::ranges::sort(stops);
    int& root = rigid_[static_cast<std::size_t>(body)];
    const Vector3d begin = beam.root + beam.n * cuts[k];
    if (root >= 0 && !(deck_.place(root) - begin).isZero(one_place * beam.length))
      throw std::invalid_argument("beams of one body have two roots");
    const auto add_node = [&](const Vector3d& at) { return e.bends == Bending::full ? deck_.add_node(at) : deck_.add_rigid(at); };
    if (root < 0) root = add_node(begin);
    Part part{body, {root}, {cuts[k]}, {0}, {}};
    for (const double stop : stops) {
      const double from = part.along.back(), stretch = stop - from;
      if (!(stretch > one_place * beam.length)) continue;
      const int pieces = static_cast<int>(std::ceil(elements * stretch / beam.length));
      for (int i = 1; i <= pieces; ++i) {
        const double s = from + stretch * i / pieces;
        part.nodes.push_back(add_node(beam.root + beam.n * s));
        part.along.push_back(s);
        add_stretch(beam, part.nodes[part.nodes.size() - 2], part.nodes.back());
      }
      part.stops.push_back(part.nodes.size() - 1);
    }
    add_gauges(beam, part);
    beam.parts.push_back(std::move(part));
  }
  beams_.push_back(std::move(beam));
}

// Between its stops a beam is Euler's and Bernoulli's: with slopes p, q at the ends of a stretch of length l and c that of its chord, E I
// times its curvature is E I (6 c - 4 p - 2 q) / l and E I (2 p + 4 q - 6 c) / l there. Gauges read these by E A, G J and E I.
void CalculixModel::add_gauges(const Beam& beam, Part& part) {
  const Element& e = machine_.topology().elements[static_cast<std::size_t>(beam.element)];
  const Vector3d &n = beam.n, &x = beam.x, y = n.cross(x);
  for (std::size_t k = 0; k + 1 < part.stops.size(); ++k) {
    const int i = part.nodes[part.stops[k]], j = part.nodes[part.stops[k + 1]];
    const double per = 1 / (part.along[part.stops[k + 1]] - part.along[part.stops[k]]);
    struct Share {
      int node;
      Vector3d of_move, of_turn;
    };
    const auto gauge = [&](std::initializer_list<Share> shares) {
      std::vector<CalculixDeck::Term> terms;
      for (const Share& s : shares)
        for (int c = 0; c < 3; ++c) {
          terms.push_back({s.node, c, s.of_move(c)});
          terms.push_back({s.node, 3 + c, s.of_turn(c)});
        }
      part.gauges.push_back(deck_.add_gauge(std::move(terms)));
    };
    const Vector3d none = Vector3d::Zero();
    gauge({{i, -per * n, none}, {j, per * n, none}});
    gauge({{i, none, -per * n}, {j, none, per * n}});
    for (const auto& [along, about] : {std::pair<Vector3d, Vector3d>{y, -x}, {x, y}}) {
      if (e.bends == Bending::full) {
        const Vector3d chord = 6 * per * per * along;
        gauge({{i, -chord, -4 * per * about}, {j, chord, -2 * per * about}});
        gauge({{i, chord, 2 * per * about}, {j, -chord, 4 * per * about}});
      } else {
        for (int end = 0; end < 2; ++end) gauge({{i, none, -per * about}, {j, none, per * about}});
      }
    }
  }
}

// A bar that is not bent by every force is no bar of CalculiX: rigid, but for springs that stretch and twist it, and turn it about its end.
void CalculixModel::add_stretch(const Beam& beam, int from, int to) {
  const Element& e = machine_.topology().elements[static_cast<std::size_t>(beam.element)];
  const double axial = e.material.modulus * e.section.area, torsion = e.material.shear_modulus * e.section.torsion;
  const double about_x = e.material.modulus * e.section.bending[0], about_y = e.material.modulus * e.section.bending[1];
  for (const double rigidity : {axial, torsion, about_x, about_y})
    if (!std::isfinite(rigidity)) throw std::invalid_argument(e.name + " does not give");
  if (e.bends == Bending::full) return deck_.add_bar(from, to, {axial, torsion, about_x, about_y, beam.x});
  const double l = (deck_.place(to) - deck_.place(from)).norm();
  const Vector3d y = beam.n.cross(beam.x), end = beam.root + beam.n * beam.length;
  std::vector<Elastic> gives{{unit_force(beam.n), deck_.add_spring(axial / l), false},
                             {unit_moment(beam.n), deck_.add_spring(torsion / l), false}};
  if (e.bends == Bending::couples) {
    gives.push_back({unit_moment(beam.x), deck_.add_spring(about_x / l), false});
    gives.push_back({unit_moment(y), deck_.add_spring(about_y / l), false});
  }
  for (int k = 0; k < 6; ++k) connect(from, to, end, Vector6d::Unit(k), gives);
}

int CalculixModel::end_at(int body, int joint) const {
  if (body == 0) return CalculixDeck::base;
  for (const Beam& beam : beams_) {
    const Element& e = machine_.topology().elements[static_cast<std::size_t>(beam.element)];
    if (beam.parts.back().body == body && (e.to == joint || e.beside == joint)) return beam.parts.back().nodes.back();
    if (beam.parts.front().body == body && e.from == joint) return beam.parts.front().nodes.front();
  }
  return place_on(body, machine_.centre(pose_, joint));
}

int CalculixModel::place_on(int body, const Vector3d& point) const {
  for (const Beam& beam : beams_)
    for (const Part& part : beam.parts) {
      if (part.body != body) continue;
      const double s = beam.n.dot(point - beam.root);
      const auto behind = std::ranges::lower_bound(part.along, s - one_place * beam.length);
      const auto at = std::min<std::ptrdiff_t>(behind - part.along.begin(), std::ssize(part.along) - 1);
      const bool nearer = at > 0 && s - part.along[static_cast<std::size_t>(at - 1)] < part.along[static_cast<std::size_t>(at)] - s;
      if (at > 0) return part.nodes[static_cast<std::size_t>(nearer ? at - 1 : at)];
    }
  return rigid_[static_cast<std::size_t>(body)];
}

}  // namespace pmreport::judges
