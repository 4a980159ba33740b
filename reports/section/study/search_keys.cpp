// Ranges of parameters, goals and constraints as a scenario writes them.
#include <reports/section/study/keys.hpp>

#include <core/text/digits.hpp>
#include <core/text/text.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace pmreport::section {

using analysis::DesignConstraint;
using analysis::DesignGoal;
using scenario::Entry;
using scenario::Reading;
using scenario::Value;
using O = StudyOptions;

namespace {

// Only a single number has a range; nothing, told, for all else.
std::optional<std::size_t> index_of_number(const Entry& e, const Reading& r) {
  const auto& parameters = r.mechanism.info.parameters;
  std::vector<std::string> numbers;
  for (const mechanics::ParameterInfo& p : parameters)
    if (p.kind == PM_NUMBER) numbers.push_back(p.name);
  const auto found = std::ranges::find_if(parameters, [&](const mechanics::ParameterInfo& p) { return p.name == e.key; });
  scenario::Diagnostics& diagnostics = r.reader.diagnostics();
  if (found == parameters.end()) {
    diagnostics.add(e.place, fmt::format("{} has no parameter {}{}", r.mechanism.name, in_quotes(e.key), did_you_mean(e.key, numbers)),
                    fmt::format("its numbers are {}", listed(numbers, "and")));
    return std::nullopt;
  }
  if (found->kind != PM_NUMBER) {
    diagnostics.add(e.place, fmt::format("{} is {} and has no range", e.key, found->kind == PM_CHOICE ? "a choice" : "a list of numbers"),
                    fmt::format("write variants = [{{ name = \"...\", parameters = {{ {} = ... }} }}]", e.key));
    return std::nullopt;
  }
  const auto index = static_cast<std::size_t>(found - parameters.begin());
  if (const auto other = scenario::silenced_by(r.mechanism.info, index, r.mechanism.set)) {
    diagnostics.add(e.place, fmt::format("{} says nothing once {} is given", e.key, *other),
                    fmt::format("vary {}, or leave it out of [mechanism]", *other));
    return std::nullopt;
  }
  return index;
}

// [from, to], of a sweep with how many values.
void read_range(const Entry& e, bool counted, const Reading& r, O& options) {
  const auto index = index_of_number(e, r);
  if (!index) return;
  scenario::Diagnostics& diagnostics = r.reader.diagnostics();
  const mechanics::ParameterInfo& info = r.mechanism.info.parameters[*index];
  const auto* list = r.reader.list(e.value, counted ? 3 : 2, counted ? "two ends of a range and how many values" : "two ends of a range");
  if (list == nullptr) return;
  const auto from = read_parameter_number((*list)[0], info, r.reader), to = read_parameter_number((*list)[1], info, r.reader);
  const auto count = counted ? r.reader.integer((*list)[2], 2, most_variants) : std::optional(0.0);
  if (!from || !to || !count) return;
  if (!(*from < *to)) {
    diagnostics.add(
        e.value.place,
        fmt::format("expected a range of {} that rises, seen {}", e.key, *from == *to ? "one value at both ends" : "one that falls"),
        "give the smaller end first");
    return;
  }
  options.over.push_back(
      {*index, info.name, info.title, info.unit, r.mechanism.values[*index].front(), *from, *to, static_cast<std::size_t>(*count)});
}

void read_ranges(const Entry& e, bool counted, std::size_t most, const Reading& r, O& options) {
  const Value* table = table_of(&e, "section." + e.key, r.reader);
  if (table == nullptr || !r.mechanism.machine) return;
  for (const Entry& range : table->entries) read_range(range, counted, r, options);
  if (table->entries.empty() || table->entries.size() > most)
    r.reader.diagnostics().add(e.value.place,
                               fmt::format("expected 1 to {} parameters in {}, seen {}", most, e.key, table->entries.size()));
}

void read_goals(const Entry* e, bool maximise, const Reading& r, O& options) {
  if (e == nullptr) return;
  const std::vector<Value> items = e->value.kind == Value::Kind::array ? items_of(*e, 2, r.reader) : std::vector<Value>{e->value};
  for (const Value& item : items) {
    const auto number = read_studied_number(item, r, options);
    if (!number) continue;
    if (std::ranges::any_of(options.goals, [&](const DesignGoal& g) { return g.measure == *number; }))
      r.reader.diagnostics().add(item.place, fmt::format("{} is a goal already", in_quotes(item.text)), "remove one of the two");
    else
      options.goals.push_back({*number, maximise});
  }
}

void read_constraint(const Value& content, const Reading& r, O& options) {
  if (content.kind != Value::Kind::table) {
    if (content.kind != Value::Kind::refused)
      r.reader.diagnostics().add(content.place, fmt::format("expected a constraint, seen {}", name_of(content)),
                                 "write { that = \"home.condition\", below = \"40\" }");
    return;
  }
  scenario::TableReader table(content, "a constraint", content.place, r.reader);
  const Entry *that = table.need("that", "that = \"home.condition\""), *below = table.find("below"), *above = table.find("above");
  table.finish();
  if (below == nullptr && above == nullptr)
    r.reader.diagnostics().add(content.place, "expected below or above in a constraint", "write below = \"40\"");
  if (that == nullptr) return;
  const auto number = read_studied_number(that->value, r, options);
  if (!number) return;
  const Dimension dimension = parse_unit(options.numbers[*number].unit).value_or(Unit{}).dimension;
  for (const Entry* e : {below, above})
    if (e != nullptr)
      if (const auto bound = r.reader.quantity(e->value, dimension)) options.constraints.push_back({*number, e == below, *bound});
}

// What optimise and pareto have in common.
void read_search(const Entry& e, std::size_t goals, const Reading& r, O& options) {
  const Value* content = table_of(&e, "section." + e.key, r.reader);
  if (content == nullptr) return;
  scenario::Diagnostics& diagnostics = r.reader.diagnostics();
  scenario::TableReader table(*content, e.key, e.place, r.reader);
  const Entry *maximise = table.find("maximise"), *minimise = table.find("minimise"),
              *over = table.need("over", "over = { base_radius = [\"200 mm\", \"500 mm\"] }"), *subject_to = table.find("subject_to"),
              *evaluations = table.find("evaluations"), *points = goals == 2 ? table.find("points") : nullptr;
  table.finish();
  read_goals(maximise, true, r, options);
  read_goals(minimise, false, r, options);
  const auto named = [](const Entry* g) { return g == nullptr ? 0 : g->value.kind == Value::Kind::array ? g->value.items.size() : 1; };
  if (named(maximise) + named(minimise) != goals)
    diagnostics.add(
        e.place, fmt::format("expected {} in {}, seen {}", goals == 1 ? "one goal" : "two goals", e.key, named(maximise) + named(minimise)),
        goals == 1 ? "write maximise = \"workspace.volume\", or minimise = \"...\""
                   : "write maximise = [\"workspace.volume\", \"home.smallest_singular_value\"]");
  if (over != nullptr) read_ranges(*over, false, analysis::most_variables, r, options);
  if (subject_to != nullptr)
    for (const Value& item : items_of(*subject_to, most_constraints, r.reader)) read_constraint(item, r, options);
  if (evaluations != nullptr)
    if (const auto n = r.reader.integer(evaluations->value, fewest_trials, most_variants)) options.evaluations = static_cast<int>(*n);
  if (points != nullptr)
    if (const auto n = r.reader.integer(points->value, fewest_points, most_points)) options.points = static_cast<int>(*n);
  if (goals == 2 && options.evaluations < trials_a_point * options.points)
    diagnostics.add(e.place,
                    fmt::format("{} points of a front need {:.0f} evaluations or more, seen {}", options.points,
                                trials_a_point * options.points, options.evaluations),
                    "raise evaluations, or lower points");
}

}  // namespace

void read_sweep(const Entry& e, const Reading& r, O& options) {
  read_ranges(e, true, 2, r, options);
  double count = 1;
  for (const StudiedParameter& p : options.over) count *= static_cast<double>(p.count);
  if (count > most_variants)
    r.reader.diagnostics().add(e.value.place, fmt::format("expected at most {:.0f} variants, seen {:.0f}", most_variants, count));
}

void read_optimise(const Entry& e, const Reading& r, O& options) { read_search(e, 1, r, options); }

void read_pareto(const Entry& e, const Reading& r, O& options) {
  options.evaluations = pareto_evaluations;
  read_search(e, 2, r, options);
}

}  // namespace pmreport::section
