#include <core/mechanics/machine/topology_check.hpp>

#include <core/mechanics/machine/contract.hpp>
#include <core/mechanics/machine/elastic_settings.hpp>

#include <fmt/core.h>

#include <cmath>

namespace pmreport::mechanics {

using contract::demand;

namespace {

// Every body hangs on the base by a chain of joints.
void check_connected(const Topology& t) {
  std::vector<bool> held(t.bodies.size(), false);
  held[0] = true;
  for (std::size_t pass = 1; pass < held.size(); ++pass)
    for (const Joint& j : t.joints) {
      const auto a = static_cast<std::size_t>(j.a), b = static_cast<std::size_t>(j.b);
      held[a] = held[b] = held[a] || held[b];
    }
  std::string loose;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (!held[i]) loose += (loose.empty() ? "" : ", ") + t.bodies[i].name;
  demand(loose.empty(), "no chain of joints leads from the base to: " + loose + "; is a joint, or a limb, forgotten?");
}

// Names are what scenarios, columns, checks and reports call things by.
struct Named {
  std::string what, name;  // "joint 2", "A1"
};
template <class List>
void add_names(std::vector<Named>& out, const char* what, const List& list) {
  for (const auto& item : list) {
    out.push_back({fmt::format("{} {}", what, &item - list.data() + 1), item.name});
    demand(!item.name.empty(), out.back().what + " has no name");
  }
}
void demand_distinct(const std::vector<Named>& all) {
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      demand(all[i].name != all[k].name,
             fmt::format("{} and {} are both called {}; each needs a name of its own", all[k].what, all[i].what, all[i].name));
}

void check_names(const Topology& t) {
  std::vector<Named> quantities, bodies, joints, matrices, elements;
  add_names(quantities, "coordinate", t.coordinates);
  add_names(quantities, "derived quantity", t.derived);
  add_names(quantities, "actuator", t.actuators);
  add_names(quantities, "constraint", t.constraints);
  add_names(quantities, "reading", t.readings);
  add_names(bodies, "body", t.bodies);
  add_names(joints, "joint", t.joints);
  add_names(matrices, "matrix", t.matrices);
  add_names(elements, "element", t.elements);
  for (const auto& names : {quantities, bodies, joints, matrices, elements}) demand_distinct(names);
}

// What cannot be drawn.
void check_shapes(const Topology& t) {
  for (const Shape& s : t.shapes) {
    demand(s.body >= 0 && s.body < static_cast<int>(t.bodies.size()),
           fmt::format("a shape belongs to body {}, which does not exist", s.body));
    const std::string& body = t.bodies[static_cast<std::size_t>(s.body)].name;
    const int kind = static_cast<int>(s.kind);
    demand(kind >= PM_CYLINDER && kind <= PM_BOX, fmt::format("body {}: a shape of unknown kind {}", body, kind));
    demand(s.a.allFinite() && s.b.allFinite() && std::isfinite(s.radius),
           fmt::format("body {}: a shape whose places or radius are not finite numbers", body));
    demand(s.radius >= 0, fmt::format("body {}: a shape of radius {} m; it cannot be negative", body, s.radius));
    demand(s.kind != ShapeKind::box || s.b.minCoeff() >= 0, fmt::format("body {}: a box with a negative half edge", body));
  }
}

}  // namespace

void check_topology(const Topology& t, int dof) {
  const auto count = [](const auto& list) { return static_cast<int>(list.size()); };
  demand(count(t.coordinates) == dof,
         fmt::format("declares {} degrees of freedom, but {} independent coordinates; Mechanism<{}> and topology() must say the same", dof,
                     count(t.coordinates), dof));
  demand(count(t.actuators) == dof,
         fmt::format("declares {} degrees of freedom, but {} actuators; is a limb forgotten?", dof, count(t.actuators)));
  demand(count(t.constraints) == 6 - dof,
         fmt::format("declares {} constraint wrenches, expected {} (6 less the degrees of freedom)", count(t.constraints), 6 - dof));
  demand(t.platform > 0 && t.platform < count(t.bodies),
         fmt::format("names body {} as the platform, but has bodies 1 to {}", t.platform, count(t.bodies) - 1));
  demand(t.idle >= 0 && t.idle <= 6 * (count(t.bodies) - 1),
         fmt::format("declares {} idle freedoms, and {} moving bodies have {} freedoms in all", t.idle, count(t.bodies) - 1,
                     6 * (count(t.bodies) - 1)));
  for (const Coordinate& c : t.coordinates) {
    demand(c.unit == "m" || c.unit == "rad", fmt::format("coordinate {}: unit \"{}\", expected \"m\" or \"rad\"", c.name, c.unit));
    demand(std::isfinite(c.box.min) && std::isfinite(c.box.max), fmt::format("coordinate {}: its box is not a finite range", c.name));
    demand(c.box.min <= c.home && c.home <= c.box.max, fmt::format("coordinate {}: home lies outside its own box", c.name));
  }
  for (const Joint& j : t.joints) {
    const bool known = static_cast<int>(j.kind) >= 0 && static_cast<int>(j.kind) <= PM_CYLINDRICAL;
    demand(known, fmt::format("joint {}: unknown kind {}", j.name, static_cast<int>(j.kind)));
    for (const int body : {j.a, j.b})
      demand(body >= 0 && body < count(t.bodies),
             fmt::format("joint {}: body {} does not exist (0 to {})", j.name, body, count(t.bodies) - 1));
    demand(j.a != j.b, fmt::format("joint {} connects body {} with itself", j.name, j.a));
    for (const Range& r : j.limits)
      demand(std::isfinite(r.min) && std::isfinite(r.max) && r.min <= r.max,
             fmt::format("joint {}: its limits are not a finite range", j.name));
    if (j.kind == JointKind::spherical)
      demand(j.stud == j.a || j.stud == j.b, fmt::format("joint {}: its stud is body {}, which it does not connect", j.name, j.stud));
    demand(j.from.allFinite() && (j.kind == JointKind::spherical || j.from.isZero()),
           fmt::format("joint {}: only the limit of a ball joint counts from a direction, which is finite", j.name));
  }
  check_connected(t);
  for (const Actuator& a : t.actuators) {
    demand(a.joint >= 0 && a.joint < count(t.joints), fmt::format("actuator {}: joint {} does not exist", a.name, a.joint));
    demand(a.unit == "m" || a.unit == "rad", fmt::format("actuator {}: unit \"{}\", expected \"m\" or \"rad\"", a.name, a.unit));
    const JointKind kind = t.joints[static_cast<std::size_t>(a.joint)].kind;
    demand(a.sense() == Sense::linear ? kind == JointKind::prismatic || kind == JointKind::cylindrical
                                      : kind != JointKind::prismatic && kind != JointKind::spherical,
           fmt::format("actuator {}: joint {} does not allow a motion in {}", a.name, t.joints[static_cast<std::size_t>(a.joint)].name,
                       a.unit));
    demand(std::isfinite(a.stroke.min) && std::isfinite(a.stroke.max) && a.stroke.min < a.stroke.max,
           fmt::format("actuator {}: its stroke is not a finite range", a.name));
  }
  const std::size_t width[] = {static_cast<std::size_t>(dof), static_cast<std::size_t>(dof), 6};
  for (const SourceMatrix& m : t.matrices) {
    const auto known = [](Rates r, int last) { return static_cast<int>(r) >= 0 && static_cast<int>(r) <= last; };
    demand(known(m.acts_on, PM_TWIST) && known(m.gives, PM_NO_RATES), fmt::format("matrix {}: acts on, or gives, unknown rates", m.name));
    demand(m.rows > 0 && static_cast<std::size_t>(m.columns) == width[static_cast<std::size_t>(m.acts_on)],
           fmt::format("matrix {}: {} columns, but the rates it acts on are {}", m.name, m.columns,
                       width[static_cast<std::size_t>(m.acts_on)]));
    demand(m.gives == Rates::none || static_cast<std::size_t>(m.rows) == width[static_cast<std::size_t>(m.gives)],
           fmt::format("matrix {}: {} rows, but the rates it gives are {}", m.name, m.rows, width[static_cast<std::size_t>(m.gives) % 3]));
    for (const SourceMatrix& other : t.matrices)
      demand(other.relation != m.relation || (other.gives == m.gives && other.rows == m.rows),
             fmt::format("matrices {} and {} are of one relation, but do not give the same", m.name, other.name));
  }
  for (const Constraint& c : t.constraints)
    demand(c.unit == "N" || c.unit == "N*m", fmt::format("constraint {}: unit \"{}\", expected \"N\" or \"N*m\"", c.name, c.unit));
  check_shapes(t);
  check_names(t);
  for (const Element& e : t.elements) {
    const std::string fault = fault_of(e, t);
    demand(fault.empty(), fault);
  }
}

}  // namespace pmreport::mechanics
