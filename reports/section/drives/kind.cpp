#include <reports/section/drives/drives.hpp>

#include <core/scenario/measured_part.hpp>
#include <core/scenario/sizing_part.hpp>
#include <core/text/text.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace pmreport::section {

namespace {

std::vector<scenario::Quantity> quantities(const scenario::Options*) {
  return {{"drives.peak_torque", "N*m", "largest motor torque", false},
          {"drives.peak_speed", "rad/s", "largest motor speed", false},
          {"drives.peak_power", "W", "largest motor power", false}};
}

// Takes from a group of motor columns those of actuators whose [drive] has no motor: they would hold no number.
void keep_motors(const scenario::Measurable& measurable, std::size_t offset, scenario::Measured& measured) {
  if (!measurable.topology || measurable.drives.empty()) return;
  const std::vector<Actuator>& actuators = measurable.topology->actuators;
  std::vector<const Actuator*> without;
  for (std::size_t i = 0; i < actuators.size(); ++i)
    if (measurable.drives[i].ratio == 0) without.push_back(&actuators[i]);
  const auto refuse = [&] {
    std::vector<std::string> names;
    for (const Actuator* a : without) names.push_back(a->name);
    throw scenario::ExpressionError(
        offset,
        fmt::format("no motor is described for {}: [drive] does not say what stands between motor and actuator", listed(names, "and")),
        scenario::how_to_give_motor(*without.front()));
  };
  if (measured.quantity.starts_with("drives.peak_") && without.size() == actuators.size()) refuse();
  std::vector<std::string> kept;
  for (const std::string& column : measured.columns) {
    const auto idle =
        std::find_if(without.begin(), without.end(), [&](const Actuator* a) { return analysis::of_motor(*a, ColumnId::named(column)); });
    if (idle == without.end())
      kept.push_back(column);
    else if (measured.columns.size() == 1)
      without = {*idle};
  }
  if (!measured.columns.empty() && kept.empty()) refuse();
  measured.columns = kept;
}

}  // namespace

const SectionKind& drives_kind() {
  static const SectionKind kind{
      {.name = "drives",
       .purpose = "what drives and motors must give, with their losses and inertia",
       .needs = {.dynamics = true, .drives = true},
       .tables = {{"drive", "the table [drive], which is not there", "add [drive] and, for instance, efficiency = 0.9",
                   "forces of the other sections are those of the actuators themselves"}},
       .columns = analysis::drive_columns,
       .quantities = quantities,
       .narrow = keep_motors},
      [](const Context& c, const scenario::Section&) { return drives_section(c.analysis); }};
  return kind;
}

}  // namespace pmreport::section
