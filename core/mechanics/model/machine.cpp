#include <core/mechanics/model/machine.hpp>

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace pmreport::mechanics {

namespace {

// Item i of a list, whose items may be longer (a newer plugin) than ours.
template <class T>
T item(const pm_list& list, std::size_t i) {
  T out{};
  std::memcpy(&out, static_cast<const char*>(list.items) + i * list.stride, std::min(list.stride, sizeof(T)));
  return out;
}
template <class T, class F>
auto map(const pm_list& list, F&& f) {
  std::vector<decltype(f(T{}))> out;
  for (std::size_t i = 0; i < list.count; ++i) out.push_back(f(item<T>(list, i)));
  return out;
}

std::string text_or_empty(const char* s) { return s != nullptr ? s : ""; }

// Calls a function of the contract with room for a sentence.
template <class F>
pm_status call(std::string& sentence, F&& f) {
  std::array<char, 512> buffer{};
  pm_text text{buffer.data(), buffer.size()};
  const pm_status status = f(&text);
  buffer.back() = '\0';
  if (status != PM_OK) sentence = buffer.data();
  return status;
}

void demand(bool condition, const std::string& sentence) {
  if (!condition) throw MechanismError(PM_FAILED, sentence);
}

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

// Indices in range, ranges in order, counts that fit: a plugin's slip is told by name instead of showing later as a wrong number.
void check(const Topology& t, int dof) {
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
  demand(t.idle >= 0, "declares a negative number of idle freedoms");
  for (const Coordinate& c : t.coordinates) {
    demand(c.unit == "m" || c.unit == "rad", fmt::format("coordinate {}: unit \"{}\", expected \"m\" or \"rad\"", c.name, c.unit));
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
  }
  check_connected(t);
  for (const Actuator& a : t.actuators) {
    demand(a.joint >= 0 && a.joint < count(t.joints), fmt::format("actuator {}: joint {} does not exist", a.name, a.joint));
    demand(a.unit == "m" || a.unit == "rad", fmt::format("actuator {}: unit \"{}\", expected \"m\" or \"rad\"", a.name, a.unit));
    const JointKind kind = t.joints[static_cast<std::size_t>(a.joint)].kind;
    demand(a.unit == "m" ? kind == JointKind::prismatic || kind == JointKind::cylindrical
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
  for (const Shape& s : t.shapes)
    demand(s.body >= 0 && s.body < count(t.bodies), fmt::format("a shape belongs to body {}, which does not exist", s.body));
}

// Values that the plugin never sees because they break what it declared.
void check(const std::vector<ParameterInfo>& parameters, const ParameterValues& values) {
  const auto refuse = [](const std::string& sentence) { throw MechanismError(PM_BAD_ARGUMENT, sentence); };
  if (values.size() != parameters.size())
    refuse(fmt::format("expected values of {} parameters, seen {}", parameters.size(), values.size()));
  for (std::size_t i = 0; i < values.size(); ++i) {
    const ParameterInfo& p = parameters[i];
    if (values[i].size() < p.count_min || values[i].size() > p.count_max)
      refuse(fmt::format("{}: expected {} to {} numbers, seen {}", p.name, p.count_min, p.count_max, values[i].size()));
    const bool choice = p.kind == PM_CHOICE;
    const double low = choice ? 0 : p.min, high = choice ? static_cast<double>(p.choices.size()) - 1 : p.max;
    for (const double x : values[i])
      if (!(x >= low && x <= high) || (choice && x != std::floor(x)))
        refuse(fmt::format("{}: expected a value from {} to {}, seen {}", p.name, low, high, x));
  }
}

// Older plugins end before this member.
const pm_closed_forms* closed_forms_of(const pm_mechanism& table) {
  return table.struct_size >= offsetof(pm_mechanism, closed_forms) + sizeof(table.closed_forms) ? table.closed_forms : nullptr;
}

Topology read_topology(const pm_mechanism& table, const pm_instance* instance) {
  std::string why;
  pm_topology c{};
  pm_list constraints{}, inertias{}, shapes{}, matrices{}, readings{};
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
  if (table.appearance != nullptr) ask("shapes", table.appearance->shapes, &shapes);

  Topology t;
  t.platform = c.platform;
  t.idle = c.idle;
  t.coordinates = map<pm_coordinate>(c.coordinates, [](const pm_coordinate& x) {
    return Coordinate{text_or_empty(x.name), text_or_empty(x.title), text_or_empty(x.unit), x.home, {x.min, x.max}};
  });
  demand(inertias.count == c.bodies.count, fmt::format("has {} bodies, but inertias of {}", c.bodies.count, inertias.count));
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

}  // namespace

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
                    false};
    for (std::size_t k = 0; k < p.choice_count; ++k) i.choices.push_back(p.choices[k]);
    i.working_mode = p.kind == PM_CHOICE && p.working_mode != 0;
    return i;
  });
  return info;
}

ParameterValues default_values(const MechanismInfo& info) {
  ParameterValues values;
  for (const ParameterInfo& p : info.parameters) values.push_back(p.defaults);
  return values;
}

Machine::Machine(const pm_mechanism& table, ParameterValues values) : table_(&table), info_(describe(table)), values_(std::move(values)) {
  check(info_.parameters, values_);
  std::vector<pm_value> spans;
  for (const auto& v : values_) spans.push_back({v.data(), v.size()});
  std::string why;
  const pm_status status = call(why, [&](pm_text* text) { return table.create(spans.data(), spans.size(), &instance_, text); });
  if (status != PM_OK) throw MechanismError(status == PM_BAD_ARGUMENT ? PM_BAD_ARGUMENT : PM_FAILED, why);
  try {
    demand(instance_ != nullptr, "made no instance, though it reported success");
    topology_ = read_topology(table, instance_);
    check(topology_, info_.dof);
    layout_ = Layout(topology_);
    const Eigen::VectorXd q = home();
    home_pose_ = pose({q.data(), static_cast<std::size_t>(q.size())});
    if (home_pose_.status == PM_UNREACHABLE) throw MechanismError(PM_BAD_ARGUMENT, "the home pose cannot be assembled: " + home_pose_.why);
    if (home_pose_.status != PM_OK) throw MechanismError(PM_FAILED, "the home pose: " + home_pose_.why);
  } catch (...) {
    table_->destroy(instance_);
    throw;
  }
}

Machine::~Machine() { table_->destroy(instance_); }

Eigen::VectorXd Machine::home() const {
  Eigen::VectorXd q(info_.dof);
  for (int i = 0; i < info_.dof; ++i) q(i) = topology_.coordinates[static_cast<std::size_t>(i)].home;
  return q;
}

Pose Machine::pose(std::span<const double> coordinates) const {
  Pose p;
  p.numbers.resize(layout_.size());
  p.status = place(PM_VALUE, 1, coordinates.data(), p.numbers.data(), &p.why);
  if (p.status != PM_OK) return p;
  for (const double x : p.numbers)
    if (!std::isfinite(x)) {
      p.status = PM_FAILED;
      p.why = "the plugin returned numbers that are not finite";
      break;
    }
  return p;
}

Eigen::Vector3d Machine::origin(const Pose& pose, int body) const {
  if (body == 0) return Eigen::Vector3d::Zero();
  return Eigen::Vector3d(pose.numbers.data() + layout_.body(body));
}

Eigen::Matrix3d Machine::rotation(const Pose& pose, int body) const {
  if (body == 0) return Eigen::Matrix3d::Identity();
  const double* at = pose.numbers.data() + layout_.body(body) + 3;
  if (!topology_.bodies[static_cast<std::size_t>(body)].slender) return Eigen::Matrix3d(Eigen::Matrix<double, 3, 3, Eigen::RowMajor>(at));
  const Eigen::Vector3d z(at), x = z.unitOrthogonal();
  Eigen::Matrix3d r;
  r << x, z.cross(x), z;
  return r;
}

Eigen::Vector3d Machine::centre(const Pose& pose, int joint) const { return Eigen::Vector3d(pose.numbers.data() + layout_.joint(joint)); }

Eigen::Vector3d Machine::axis(const Pose& pose, int joint, int k) const {
  return Eigen::Vector3d(pose.numbers.data() + layout_.joint(joint) + 3 + 3 * k);
}

std::size_t Machine::components(pm_order order) const {
  switch (order) {
    case PM_JET:
      return 3;
    case PM_PARTIALS:
      return 1 + static_cast<std::size_t>(info_.dof);
    case PM_EXTENDED:
      return 2;
    default:
      return 1;
  }
}

pm_status Machine::place(pm_order order, std::size_t count, const double* coordinates, double* placement, std::string* why) const {
  if (why == nullptr) return table_->kinematics->place(instance_, order, count, coordinates, placement, nullptr);
  return call(*why, [&](pm_text* text) { return table_->kinematics->place(instance_, order, count, coordinates, placement, text); });
}

std::vector<Eigen::MatrixXd> Machine::matrices(std::span<const double> coordinates, const Pose& pose) const {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  std::size_t size = 0;
  for (const SourceMatrix& m : topology_.matrices) size += static_cast<std::size_t>(m.rows * m.columns);
  std::vector<double> numbers(size);
  const pm_closed_forms* forms = closed_forms_of(*table_);
  if (size == 0 || forms->evaluate(instance_, coordinates.data(), pose.numbers.data(), numbers.data(), nullptr) != PM_OK) return {};
  std::vector<Eigen::MatrixXd> out;
  const double* at = numbers.data();
  for (const SourceMatrix& m : topology_.matrices) {
    out.emplace_back(Eigen::Map<const RowMajor>(at, m.rows, m.columns));
    at += m.rows * m.columns;
  }
  return out;
}

std::vector<double> Machine::readings(std::span<const double> coordinates, const Pose& pose) const {
  std::vector<double> out(topology_.readings.size(), std::numeric_limits<double>::quiet_NaN());
  if (!out.empty()) closed_forms_of(*table_)->read(instance_, coordinates.data(), pose.numbers.data(), out.data(), nullptr);
  return out;
}

pm_status Machine::jacobian(pm_order order, std::size_t count, const double* placement, double* jacobian, std::string* why) const {
  if (why == nullptr) return table_->statics->jacobian(instance_, order, count, placement, jacobian, nullptr);
  return call(*why, [&](pm_text* text) { return table_->statics->jacobian(instance_, order, count, placement, jacobian, text); });
}

}  // namespace pmreport::mechanics
