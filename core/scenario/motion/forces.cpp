// [motion] from = "forces": the platform goes where the forces of its actuators, its load and its weight drive it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <core/mechanics/model/effort.hpp>
#include <core/scenario/motion/forces.hpp>
#include <core/text/text.hpp>
#include <memory>

namespace pmreport::scenario {
namespace {

constexpr Dimension time_dimension{0, 0, 1, 0};
constexpr const char* for_all = "all";  // the key of the force of all actuators that have none of their own

Dimension force_of(const std::string& unit) { return parse_unit(mechanics::unit_of_effort(sense_of(unit)))->dimension; }
const char* word_of(const Moved& m) { return sense_of(m.unit) == Sense::linear ? "linear" : "rotary"; }

// What the force of one actuator may name: its own value, rate and value at home; then value and rate of any actuator by its name. A name
// that says something else in an expression is left out.
struct Names {
  std::vector<Variable> variables;
  std::vector<int> of;  // see Forces::Force
};
Names names_for(const Moved& own, const std::vector<Moved>& actuators) {
  const Dimension d = parse_unit(own.unit)->dimension;
  Names out{{{"value", d}, {"rate", d / time_dimension}, {"home", d}}, {}};
  std::vector<std::string> taken = expression_functions();
  taken.insert(taken.end(), {"t", "pi", "value", "rate", "home"});
  for (std::size_t i = 0; i < actuators.size(); ++i) {
    const Dimension dimension = parse_unit(actuators[i].unit)->dimension;
    for (const bool rate : {false, true}) {
      const std::string name = actuators[i].name + (rate ? "_rate" : "");
      if (parse_unit(name) || std::find(taken.begin(), taken.end(), name) != taken.end()) continue;
      out.variables.push_back({name, rate ? dimension / time_dimension : dimension});
      out.of.push_back(static_cast<int>(2 * i) + (rate ? 1 : 0));
    }
  }
  return out;
}

// Coordinates by name, or their rates; those not named keep what `out` has.
bool read_start(const Entry* entry, const MechanismPart& mechanism, const Movables& movables, bool rates, Eigen::VectorXd& out,
                std::string& description, const Reader& reader) {
  if (entry == nullptr) return true;
  const std::string table = "motion." + entry->key;
  const Value* content = table_of(entry, table, reader);
  if (content == nullptr) return false;
  bool sound = true;
  std::vector<std::string> known, said;
  for (const Moved& m : movables.coordinates) known.push_back(m.name);
  for (const std::string& key : known) reader.looks_for(*content, key);
  for (const Entry& e : content->entries) {
    const auto found = std::find(known.begin(), known.end(), e.key);
    if (found == known.end()) {
      refuse_coordinate(e.place, e.key, mechanism, known, table, reader.diagnostics());
      sound = false;
      continue;
    }
    const auto i = found - known.begin();
    const Dimension dimension = parse_unit(movables.coordinates[static_cast<std::size_t>(i)].unit)->dimension;
    const auto value = reader.quantity(e.value, rates ? dimension / time_dimension : dimension);
    sound = sound && value.has_value();
    out(i) = value.value_or(out(i));
    said.push_back(fmt::format("{}{} = {}", e.key, rates ? "_rate" : "", printable(e.value.text)));
  }
  if (!said.empty()) description += fmt::format("{}{}", description.empty() ? "" : ", ", fmt::join(said, ", "));
  return sound;
}

// The forces of [motion.forces]; false, told, when one is wrong.
bool read_each(const Value& content, Place place, const Movables& movables, Forces& out, const Reader& reader) {
  TableReader table(content, "[motion.forces]", place, reader);
  const Entry* all = table.find(for_all);
  const std::vector<Moved>& actuators = movables.actuators;
  std::vector<std::string> lines, without;
  if (all != nullptr) lines.push_back(fmt::format("force of each actuator = {}", printable(all->value.text)));
  bool sound = true, all_sound = true;
  const Moved* first_of_all = nullptr;
  for (const Moved& m : actuators) {
    out.forces.emplace_back();
    const Entry* own = table.find(m.name);
    const Entry* e = own != nullptr ? own : all;
    if (e == nullptr) {
      without.push_back(m.name);
      continue;
    }
    if (own != nullptr) {
      lines.push_back(fmt::format("force of {} = {}", m.name, printable(own->value.text)));
    } else if (!all_sound) {
      continue;  // told once
    } else if (first_of_all != nullptr && first_of_all->unit != m.unit) {
      reader.diagnostics().add(all->place,
                               fmt::format("expected forces by name, seen one for all: {} is {}, and {} is {}", first_of_all->name,
                                           word_of(*first_of_all), m.name, word_of(m)),
                               fmt::format("write {} = \"...\" and {} = \"...\"", first_of_all->name, m.name));
      all_sound = sound = false;
      continue;
    } else {
      first_of_all = &m;
    }
    Names names = names_for(m, actuators);
    auto written = reader.expression(e->value, force_of(m.unit), Time::allowed, names.variables);
    if (!written) {
      sound = false;
      if (own == nullptr) all_sound = false;
      continue;
    }
    out.forces.back() = {written->place, std::move(written->expression), m.home, std::move(names.of)};
  }
  table.finish();
  if (!without.empty()) lines.push_back(fmt::format("no force of {}", listed(without, "and")));
  out.description = fmt::format("{}", fmt::join(lines, "\n"));
  return sound;
}

double force_at(const Forces::Force& force, std::size_t own, double t, const std::vector<mechanics::Scalar>& actuators) {
  std::vector<Jet<double>> variables{actuators[own].value, actuators[own].rate, force.home};
  for (const int i : force.variables) {
    const mechanics::Scalar& a = actuators[static_cast<std::size_t>(i / 2)];
    variables.emplace_back(i % 2 == 0 ? a.value : a.rate);
  }
  return force.expression.at(t, variables).value;
}

}  // namespace

std::optional<Forces> read_forces(const Value& motion, Place place, const MechanismPart& mechanism, const Movables& movables,
                                  const Reader& reader) {
  Diagnostics& diagnostics = reader.diagnostics();
  TableReader table(motion, "[motion]", place, reader);
  const Entry *start = table.find("start"), *start_rate = table.find("start_rate"), *until = table.find("until");
  const Entry* forces = table.need(
      "forces", "[motion.forces], and below it a line for each actuator that pushes or pulls: " + movables.actuators.front().name +
                    " = \"" + example_of(force_of(movables.actuators.front().unit)) + "\"");
  Forces out;
  out.place = start != nullptr ? start->place : place;
  bool sound = forces != nullptr;
  for (const Entry& e : motion.entries) {
    const bool prescribed = std::any_of(movables.coordinates.begin(), movables.coordinates.end(),
                                        [&](const Moved& m) { return m.name == without_rate(e.key); });
    const bool driven = !prescribed && std::any_of(movables.actuators.begin(), movables.actuators.end(),
                                                   [&](const Moved& m) { return m.name == without_rate(e.key); });
    if (!prescribed && !driven) continue;
    diagnostics.add(e.place, fmt::format("{} is prescribed, and the motion follows from forces", e.key),
                    prescribed
                        ? fmt::format("say where it begins, start = {{ {} = ... }}, or remove from = \"forces\"", without_rate(e.key))
                        : fmt::format("give its force in [motion.forces], or remove from = \"forces\""));
    sound = false;
  }
  if (until != nullptr)
    if (const auto word = reader.word(until->value, {"singularity", "limit"}, "what a motion may last until"))
      out.until_singularity = true, out.until_limit = *word == 1;

  const auto dof = static_cast<Eigen::Index>(movables.coordinates.size());
  out.start.resize(dof);
  out.start_rate = Eigen::VectorXd::Zero(dof);
  for (Eigen::Index i = 0; i < dof; ++i) out.start(i) = movables.coordinates[static_cast<std::size_t>(i)].home;
  std::string beginning = start == nullptr ? "home" : "";
  sound = read_start(start, mechanism, movables, false, out.start, beginning, reader) && sound;
  sound = read_start(start_rate, mechanism, movables, true, out.start_rate, beginning, reader) && sound;
  const Value* content = table_of(forces, "motion.forces", reader);
  sound = content != nullptr && read_each(*content, forces->place, movables, out, reader) && sound;
  out.description += "\nstart: " + beginning + (start_rate == nullptr ? ", at rest" : "");
  if (!sound) return std::nullopt;
  return out;
}

ActuatorForces all_of(const Forces& forces) {
  return [forces = std::make_shared<const std::vector<std::optional<Forces::Force>>>(forces.forces)](
             double t, const std::vector<mechanics::Scalar>& actuators, double* out) {
    for (std::size_t i = 0; i < forces->size(); ++i) out[i] = (*forces)[i] ? force_at(*(*forces)[i], i, t, actuators) : 0;
  };
}

bool finite_at_start(const Forces& forces, const mechanics::Machine& machine, double t, Diagnostics& diagnostics) {
  mechanics::State state;
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(machine.dof());
  evaluate(machine, forces.start.data(), forces.start_rate.data(), still.data(), state);
  bool sound = true;
  for (std::size_t i = 0; i < forces.forces.size() && state.status == PM_OK; ++i)
    if (forces.forces[i])
      sound = finite(force_at(*forces.forces[i], i, t, state.actuators), t, forces.forces[i]->place,
                     "the force of " + machine.topology().actuators[i].name, diagnostics) &&
              sound;
  return sound;
}

}  // namespace pmreport::scenario
