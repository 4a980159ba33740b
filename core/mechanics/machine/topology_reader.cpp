#include <core/mechanics/machine/topology_reader.hpp>

#include <core/mechanics/machine/contract.hpp>
#include <core/mechanics/machine/machine.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace pmreport::mechanics {

using namespace contract;

MechanismInfo describe(const pm_mechanism& table) {
  MechanismInfo info{table.name, text_or_empty(table.title), text_or_empty(table.source), table.dof, {}};
  info.parameters = map<pm_parameter>(table.parameters, [](const pm_parameter& p) {
    ParameterInfo i{text_or_empty(p.name),
                    text_or_empty(p.title),
                    text_or_empty(p.unit),
                    text_or_empty(p.display),
                    p.kind,
                    {p.defaults, p.defaults + p.default_count},
                    p.min,
                    p.max,
                    p.count_min,
                    p.count_max,
                    {},
                    false,
                    text_or_empty(p.unless)};
    for (std::size_t k = 0; k < p.choice_count; ++k) i.choices.push_back(text_or_empty(p.choices[k]));
    i.working_mode = p.kind == PM_CHOICE && p.working_mode != 0;
    return i;
  });
  return info;
}

Topology read_topology(const pm_mechanism& table, const pm_instance* instance) {
  std::string why;
  pm_topology c{};
  pm_list constraints{}, inertias{}, shapes{}, matrices{}, readings{}, elements{};
  const auto ask = [&](const char* what, auto function, auto* out) {
    const pm_status status = call(why, [&](pm_text* text) { return function(instance, out, text); });
    if (status != PM_OK) throw MechanismError(PM_FAILED, fmt::format("cannot tell its {}: {}", what, why));
  };
  ask("topology", table.kinematics->topology, &c);
  const pm_closed_forms* forms = closed_forms_of(table);
  if (forms != nullptr) {
    ask("matrices", forms->matrices, &matrices);
    ask("readings", forms->readings, &readings);
  }
  ask("constraint wrenches", table.statics->constraints, &constraints);
  ask("inertias", table.dynamics->inertias, &inertias);
  if (const pm_elasticity* elasticity = elasticity_of(table)) ask("elastic elements", elasticity->elements, &elements);
  if (table.appearance != nullptr) ask("shapes", table.appearance->shapes, &shapes);

  Topology t;
  t.platform = c.platform;
  t.idle = c.idle;
  t.coordinates = map<pm_coordinate>(c.coordinates, [](const pm_coordinate& x) {
    return Coordinate{text_or_empty(x.name), text_or_empty(x.title), text_or_empty(x.unit), x.home, {x.min, x.max}};
  });
  demand(inertias.count == c.bodies.count, fmt::format("has {} bodies, but inertias of {}", c.bodies.count, inertias.count));
  demand_list<pm_body>(c.bodies);
  demand_list<pm_inertia>(inertias);
  t.bodies.clear();
  for (std::size_t i = 0; i < c.bodies.count; ++i) {
    const auto b = item<pm_body>(c.bodies, i);
    const auto m = item<pm_inertia>(inertias, i);
    Inertia inertia{m.mass, Eigen::Vector3d(m.centre), Eigen::Matrix<double, 3, 3, Eigen::RowMajor>(m.inertia)};
    t.bodies.push_back({text_or_empty(b.name), b.limb, b.slender != 0, inertia});
  }
  t.joints = map<pm_joint>(c.joints, [](const pm_joint& x) {
    Joint j{text_or_empty(x.name), static_cast<JointKind>(x.kind), x.a, x.b, {{x.min[0], x.max[0]}}, x.stud};
    if (j.kind == JointKind::universal) j.limits.push_back({x.min[1], x.max[1]});
    j.from = Eigen::Vector3d(x.from);
    return j;
  });
  t.actuators = map<pm_actuator>(c.actuators, [](const pm_actuator& x) {
    return Actuator{text_or_empty(x.name), text_or_empty(x.title), text_or_empty(x.unit), x.joint, {x.min, x.max}};
  });
  t.derived = map<pm_derived>(c.derived, [](const pm_derived& x) {
    return Derived{text_or_empty(x.name), text_or_empty(x.title), text_or_empty(x.unit), x.dependent != 0};
  });
  t.constraints = map<pm_constraint>(constraints, [](const pm_constraint& x) {
    return Constraint{text_or_empty(x.name), text_or_empty(x.title), text_or_empty(x.unit)};
  });
  t.shapes = map<pm_shape>(shapes, [](const pm_shape& x) {
    return Shape{x.body, static_cast<ShapeKind>(x.kind), Eigen::Vector3d(x.a), Eigen::Vector3d(x.b), x.radius};
  });
  t.readings = map<pm_reading>(readings, [](const pm_reading& x) {
    return Reading{text_or_empty(x.name), text_or_empty(x.title), text_or_empty(x.unit)};
  });
  t.elements = map<pm_element>(elements, [](const pm_element& x) {
    Element e{text_or_empty(x.name), text_or_empty(x.title), static_cast<ElementKind>(x.kind), x.from, x.to, x.beside, x.actuator};
    e.material = {x.modulus, x.shear_modulus, x.expansion};
    e.section = {x.area, {x.bending[0], x.bending[1]}, x.torsion};
    e.bends = static_cast<Bending>(x.bends);
    e.buckling_length = x.buckling_length;
    e.offset = x.offset;
    std::copy_n(x.stiffness, 4, e.stiffness);
    return e;
  });
  t.matrices = map<pm_matrix>(matrices, [](const pm_matrix& x) {
    return SourceMatrix{text_or_empty(x.name),
                        text_or_empty(x.title),
                        static_cast<int>(x.rows),
                        static_cast<int>(x.columns),
                        static_cast<Rates>(x.acts_on),
                        static_cast<Rates>(x.gives),
                        x.relation};
  });
  return t;
}

}  // namespace pmreport::mechanics
