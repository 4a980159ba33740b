#include <core/analysis/samples/motion_blocks.hpp>

#include <core/analysis/samples/evenly.hpp>
#include <core/analysis/transmission/transmission_numbers.hpp>
#include <core/chunks/work.hpp>
#include <core/program/program.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <mutex>

namespace pmreport::analysis {

using mechanics::Outcome;

namespace {

// All columns that a run has.
std::vector<ColumnId> columns_of(const scenario::Scenario& scenario, const mechanics::Machine& machine, const Asked& asked,
                                 const mechanics::Transmission* transmission, bool elastic) {
  const Topology& t = machine.topology();
  std::vector<ColumnId> out;
  const auto add = [&](ColumnList* list) {
    for (const Column& c : list(t)) out.emplace_back(c);
  };
  for (ColumnList* list : {displacement_columns, velocity_columns, acceleration_columns, statics_columns}) add(list);
  if (transmission != nullptr) {
    const std::vector<Column> columns = transmission_columns(t);
    const std::vector<std::string> reasons = why_without(*transmission);
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (reasons[i].empty()) out.emplace_back(columns[i]);
  }
  if (asked.forces) add(dynamics_columns);
  if (asked.forces && asked.drives)
    for (const Column& c : drive_columns(t)) {
      const auto motor = std::ranges::find_if(t.actuators, [&](const Actuator& a) { return of_motor(a, c); });
      const auto i = static_cast<std::size_t>(motor - t.actuators.begin());
      if (motor == t.actuators.end() || (i < scenario.drives.size() && scenario.drives[i].ratio > 0)) out.emplace_back(c);
    }
  if (asked.forces && asked.reactions) add(reaction_columns);
  if (elastic) add(stiffness_columns);
  return out;
}

}  // namespace

struct MotionBlocks::Part {
  std::size_t first;
  MotionAnswers answers;
  std::vector<Row> rows;
  const std::function<void()>& stop_if_asked;

  std::size_t size() const { return rows.size(); }
  int sample(std::size_t k) const { return static_cast<int>(first + k); }
};

MotionBlocks::MotionBlocks(const scenario::Scenario& scenario, const mechanics::Trajectory& trajectory, const mechanics::Machine& machine,
                           const Asked& asked, double length, const mechanics::Transmission* transmission)
    : scenario_(scenario),
      trajectory_(trajectory),
      machine_(machine),
      asked_(asked),
      length_(length),
      transmission_(transmission),
      elasticity_(asked.stiffness && trajectory.samples() > 0 && gives_way(machine) ? stiffness_request(scenario) : nullptr),
      samples_(trajectory.time.size()),
      shape_{columns_of(scenario, machine, asked, transmission, elasticity_ != nullptr),
             asked.forces ? machine.topology().joints.size() : 0, elasticity_ != nullptr},
      closure_(machine),
      frames_(machine),
      sample_work_([this] { return SampleWork(trajectory_, scenario_.load, machine_, closure_, length_, asked_, transmission_); }),
      sample_forces_([this] {
        return SampleForces(trajectory_, scenario_.load, scenario_.drives, machine_, frames_, length_, asked_.force_evidence);
      }),
      sample_stiffness_([this] { return SampleStiffness(trajectory_, scenario_.load, machine_, *elasticity_, length_); }) {}

MotionAnswers MotionBlocks::compute(std::size_t block, const std::function<void()>& stop_if_asked) {
  const std::size_t n = samples(block);
  Part part{first(block), MotionAnswers(shape_, n), std::vector<Row>(n), stop_if_asked};
  kinematics(part);
  if (std::ranges::find(part.answers.outcomes, Outcome::failed) == part.answers.outcomes.end()) {
    if (asked_.forces) forces(part);
    if (elasticity_ != nullptr) stiffness(part);
  }
  for (std::size_t k = 0; k < n; ++k) part.answers.residuals.add(part.sample(k), part.rows[k]);
  return std::move(part.answers);
}

void MotionBlocks::kinematics(Part& part) {
  std::mutex sentences;
  std::map<int, std::string> why;
  tbb::parallel_for(std::size_t{0}, part.size(), [&](std::size_t k) {
    part.stop_if_asked();
    SampleWork& worker = sample_work_.local();
    const int sample = part.sample(k), neighbour = sample > 0 ? sample - 1 : std::min(1, trajectory_.samples() - 1);
    Outcome& outcome = part.answers.outcomes[k];
    outcome =
        worker.run(sample, neighbour, part.rows[k], [&](const ColumnId& id, double value) { part.answers.columns.put(id, k, value); });
    part.answers.wrenches[k] = worker.wrenches();
    if (outcome == Outcome::good) return;
    const std::scoped_lock lock(sentences);
    why[sample] = worker.why();
  });
  std::map<int, std::string>& told = part.answers.why;
  for (auto& [sample, sentence] : why)
    if (told.empty() || told.rbegin()->second != sentence) told.emplace(sample, std::move(sentence));
}

void MotionBlocks::forces(Part& part) {
  MotionAnswers& a = part.answers;
  // Of all samples of the motion that a second way judges those that fall to this block, spread over those that have forces.
  constexpr std::size_t judged = 16;
  const std::size_t here = evenly_before(part.first + part.size(), samples_, judged) - evenly_before(part.first, samples_, judged);
  std::vector<SampleForces::Order> orders;
  std::vector<std::size_t> numbers;
  for (std::size_t k = 0; k < part.size(); ++k) {
    if (a.outcomes[k] != Outcome::good) continue;
    numbers.push_back(orders.size());
    orders.push_back({part.sample(k), a.wrenches[k].are_comparable(), false});
  }
  for (const std::size_t i : evenly(numbers, here)) orders[i].judged = true;

  // Chunks that always begin at the same samples, so that no number depends on the threads.
  constexpr std::size_t chunk = 64;
  const ForceColumns columns(machine_.topology(), [&](const ColumnId& id) { return a.columns.find(id); });
  std::vector<ReactionFindings> found((orders.size() + chunk - 1) / chunk, ReactionFindings(shape_.joints));
  tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t i) {
    part.stop_if_asked();
    const std::span<const SampleForces::Order> some = std::span(orders).subspan(i * chunk, std::min(chunk, orders.size() - i * chunk));
    found[i] = sample_forces_.local().run(some, {columns, part.rows, part.sample(0)});
  });
  for (const ReactionFindings& f : found) a.reactions.join(f);
}

void MotionBlocks::stiffness(Part& part) {
  constexpr int judged = 8;  // spread evenly
  const int every = std::max(1, trajectory_.samples() / judged);
  tbb::parallel_for(std::size_t{0}, part.size(), [&](std::size_t k) {
    MotionAnswers& a = part.answers;
    if (a.outcomes[k] != Outcome::good) return;
    part.stop_if_asked();
    const int sample = part.sample(k);
    sample_stiffness_.local().run(
        sample, sample % every == every / 2, part.rows[k], [&](const ColumnId& id, double value) { a.columns.put(id, k, value); },
        a.compliances[k]);
  });
}

std::uint64_t MotionBlocks::meaning() const {
  chunks::Meaning out;
  const auto add = [&](const auto& numbers) {
    out << numbers.size();
    for (const double x : numbers) out << x;
  };
  // The scenario names files, whose numbers are here as they were read: motions, loads.
  out << scenario_.text << machine_.info().name << length_;
  for (const std::vector<double>& values : machine_.values()) add(values);
  add(trajectory_.time);
  for (const Eigen::MatrixXd* part : {&trajectory_.value, &trajectory_.rate, &trajectory_.acceleration}) add(part->reshaped());
  out << trajectory_.ending;
  for (const std::vector<Eigen::Vector3d>* part : {&scenario_.load.force, &scenario_.load.moment})
    for (const Eigen::Vector3d& v : *part) add(v);
  add(scenario_.load.gravity);
  for (const mechanics::DriveTrain& d : scenario_.drives) out << d.efficiency << d.convention << d.ratio << d.inertia << d.stiffness;
  const auto& [displacement_evidence, velocity_evidence, acceleration_evidence, statics, forces, force_evidence, power_evidence, drives,
               reactions, transmission, transmission_length, stiffness, singularities] = asked_;
  for (const bool asked : {displacement_evidence, velocity_evidence, acceleration_evidence, statics, forces, force_evidence, drives,
                           reactions, transmission, stiffness})
    out << asked;
  out << transmission_length;
  if (const program::Program* geometry = machine_.program())
    for (const program::Step& s : geometry->steps()) out << s.operation << s.a << s.b << s.c << s.constant;
  return out.value();
}

}  // namespace pmreport::analysis
