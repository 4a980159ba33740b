#include <core/mechanics/machine/machine.hpp>

#include <core/assertion.hpp>
#include <core/mechanics/machine/contract.hpp>
#include <core/mechanics/machine/geometry_recorder.hpp>
#include <core/mechanics/machine/inertia_check.hpp>
#include <core/mechanics/machine/topology_check.hpp>
#include <core/mechanics/machine/topology_reader.hpp>

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <cmath>
#include <core/program/evaluate.hpp>
#include <limits>
#include <mutex>
#include <numeric>
#include <optional>
#include <pmreport/placement.hpp>

namespace pmreport::mechanics {

using contract::call, contract::closed_forms_of, contract::demand, contract::undisturbed;

namespace {

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

}  // namespace

ParameterValues default_values(const MechanismInfo& info) {
  ParameterValues values;
  for (const ParameterInfo& p : info.parameters) values.push_back(p.defaults);
  return values;
}

struct Machine::Recording {
  std::once_flag made;
  std::optional<program::Program> program;
  program::Program placement;  // the same without G
  std::string why;
};

Machine::Machine(const pm_mechanism& table, ParameterValues values)
    : table_(&table), info_(describe(table)), values_(std::move(values)), recording_(std::make_unique<Recording>()) {
  check(info_.parameters, values_);
  std::vector<pm_value> spans;
  for (const auto& v : values_) spans.push_back({v.data(), v.size()});
  std::string why;
  const pm_status status = call(why, [&](pm_text* text) { return table.create(spans.data(), spans.size(), &instance_, text); });
  if (status != PM_OK) throw MechanismError(status == PM_BAD_ARGUMENT ? PM_BAD_ARGUMENT : PM_FAILED, why);
  try {
    demand(instance_ != nullptr, "made no instance, though it reported success");
    topology_ = read_topology(table, instance_);
    check_topology(topology_, info_.dof);
    declared_ = topology_.elements;
    layout_ = Layout(topology_);
    const Eigen::VectorXd q = home();
    home_pose_ = pose({q.data(), static_cast<std::size_t>(q.size())});
    if (home_pose_.status == PM_UNREACHABLE) throw MechanismError(PM_BAD_ARGUMENT, "the home pose cannot be assembled: " + home_pose_.why);
    if (home_pose_.status != PM_OK) throw MechanismError(PM_FAILED, "the home pose: " + home_pose_.why);
    check_inertias(*this, table);
  } catch (...) {
    table_->destroy(instance_);
    throw;
  }
}

Machine::~Machine() { table_->destroy(instance_); }

void Machine::give(ElasticSettings settings) {
  elasticity_ = std::move(settings);
  topology_.elements = declared_;
  topology_.elements = elements_under(elasticity_, topology_);
}

std::unique_ptr<Machine> Machine::with(ParameterValues values) const {
  auto out = std::make_unique<Machine>(*table_, std::move(values));
  out->give(elasticity_);
  return out;
}

Eigen::VectorXd Machine::home() const {
  Eigen::VectorXd q(info_.dof);
  for (int i = 0; i < info_.dof; ++i) q(i) = topology_.coordinates[static_cast<std::size_t>(i)].home;
  return q;
}

Pose Machine::pose(std::span<const double> coordinates) const {
  PMREPORT_ASSERT(static_cast<int>(coordinates.size()) == info_.dof, "a pose has as many coordinates as degrees of freedom");
  Pose p;
  p.numbers.resize(layout_.size());
  p.status = place(PM_VALUE, 1, coordinates.data(), p.numbers.data(), &p.why);
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

const program::Program* Machine::program(std::string* why) const {
  std::call_once(recording_->made, [this] {
    try {
      recording_->program = record_geometry(*table_, instance_, info_.dof, layout_.size() + 36);
      std::vector<int> placed(layout_.size());
      std::iota(placed.begin(), placed.end(), 0);
      recording_->placement = recording_->program->slice(placed);
    } catch (const program::ProgramError& e) {
      recording_->why = e.what();
    }
  });
  if (recording_->program) return &*recording_->program;
  if (why != nullptr) *why = recording_->why;
  return nullptr;
}

bool Machine::records() const { return contract::records(*table_); }

pm_status Machine::place(pm_order order, std::size_t count, const double* coordinates, double* placement, std::string* why) const {
  if (order == PM_EXTENDED && program() != nullptr) return place_extended(count, coordinates, placement, why);
  const auto ask = [&](pm_text* text) { return table_->kinematics->place(instance_, order, count, coordinates, placement, text); };
  const pm_status status = why == nullptr ? undisturbed([&] { return ask(nullptr); }) : call(*why, ask);
  if (status != PM_OK || count != 1) return status;
  return finite_or_singular(order, placement, why);
}

pm_status Machine::place_extended(std::size_t count, const double* coordinates, double* placement, std::string* why) const {
  const program::Program& geometry = recording_->placement;
  program::Evaluator<long double> evaluator(geometry);
  std::vector<long double> in(static_cast<std::size_t>(info_.dof)), out(layout_.size());
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t i = 0; i < in.size(); ++i) in[i] = Codec<long double>::load(coordinates + 2 * i * count + k, count);
    evaluator.run(in, out);
    for (std::size_t i = 0; i < out.size(); ++i) Codec<long double>::store(placement + 2 * i * count + k, count, out[i]);
  }
  if (count != 1) return PM_OK;
  if (placement[0] < 0) {
    if (why != nullptr) *why = "out of reach";
    return PM_UNREACHABLE;
  }
  return finite_or_singular(PM_EXTENDED, placement, why);
}

// Of one pose.
pm_status Machine::finite_or_singular(pm_order order, const double* placement, std::string* why) const {
  // A sum is finite only when no term is NaN or infinite.
  const Eigen::Map<const Eigen::ArrayXd> numbers(placement, static_cast<Eigen::Index>(layout_.size() * components(order)));
  if ((0.0 * numbers).sum() == 0) return PM_OK;
  if (why != nullptr)
    *why = order == PM_VALUE ? "the geometry has no finite numbers there" : "the rates of the geometry are not finite there";
  return PM_SINGULAR;
}

std::vector<Eigen::MatrixXd> Machine::matrices(std::span<const double> coordinates, const Pose& pose) const {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  std::size_t size = 0;
  for (const SourceMatrix& m : topology_.matrices) size += static_cast<std::size_t>(m.rows * m.columns);
  std::vector<double> numbers(size);
  const pm_closed_forms* forms = closed_forms_of(*table_);
  const auto ask = [&] { return forms->evaluate(instance_, coordinates.data(), pose.numbers.data(), numbers.data(), nullptr); };
  if (size == 0 || undisturbed(ask) != PM_OK) return {};
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
  const auto ask = [&] { return closed_forms_of(*table_)->read(instance_, coordinates.data(), pose.numbers.data(), out.data(), nullptr); };
  if (!out.empty()) undisturbed(ask);
  return out;
}

pm_status Machine::jacobian(pm_order order, std::size_t count, const double* placement, double* jacobian, std::string* why) const {
  const auto ask = [&](pm_text* text) { return table_->statics->jacobian(instance_, order, count, placement, jacobian, text); };
  const pm_status status = why == nullptr ? undisturbed([&] { return ask(nullptr); }) : call(*why, ask);
  if (status != PM_OK) std::fill_n(jacobian, 36 * components(order) * count, std::numeric_limits<double>::quiet_NaN());
  return status;
}

Jacobian Machine::jacobian(const double* placement) const {
  double numbers[36];
  Jacobian out;
  out.status = jacobian(PM_VALUE, 1, placement, numbers, &out.why);
  if (out.status != PM_OK) return out;
  const linear::Matrix6d g = Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>>(numbers);
  if (g.allFinite()) {
    out.matrix = g;
  } else {
    out.status = PM_SINGULAR;
    out.why = "the overall Jacobian has no finite value at this pose";
  }
  return out;
}

Jacobian Machine::jacobian(const Pose& pose) const {
  PMREPORT_ASSERT(pose.status == PM_OK, "the pose is assembled");
  return jacobian(pose.numbers.data());
}

}  // namespace pmreport::mechanics
