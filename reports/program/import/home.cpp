#include <reports/program/import/imported.hpp>

#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/model/state.hpp>
#include <core/mechanics/singularity/singularity.hpp>
#include <core/text/units.hpp>

#include <fmt/format.h>

#include <cmath>

namespace pmreport::program {

namespace {

// What of the settings sets the home, and where; how it is put right.
struct Said {
  const settings::Place& place;
  std::string what, hint;
};
Said said_of(const Imported& made) {
  if (made.home.line > 0) return {made.home, "HOME", ""};
  return {made.place, "the home made up for it", "a HOME in the settings takes its place"};
}

}  // namespace

void check_home(const Imported& made, const mechanics::Machine& machine) {
  const Said said = said_of(made);
  const mechanics::State at = mechanics::state_at_rest(machine, machine.home());
  if (at.status != PM_OK) settings::refuse(said.place, fmt::format("expected {} within reach: {}", said.what, at.why), said.hint);

  constexpr double rounding = 1e-9;  // of a length: those of a home are sums
  const double unit = parse_unit(made.unit).value_or(Unit{}).factor;
  const auto length = [&](double x) { return fmt::format("{} {}", format_number(x / unit, 6), made.unit); };
  const auto& actuators = machine.topology().actuators;
  for (std::size_t i = 0; i < actuators.size(); ++i) {
    const auto& [min, max] = actuators[i].stroke;
    const double seen = at.actuators[i].value;
    if (seen < min - rounding * std::abs(min) || seen > max + rounding * std::abs(max))
      settings::refuse(said.place,
                       fmt::format("expected {} with {} from {} to {}, its stroke; seen {}", said.what, actuators[i].name, length(min),
                                   length(max), length(seen)),
                       said.hint);
  }

  const double size = mechanics::characteristic_length(machine);
  if (mechanics::singular_everywhere(machine, size))
    settings::refuse(made.place, "what the settings say is no machine: its actuators do not hold the platform, at home and everywhere");
  const auto wrenches = mechanics::wrench_determinant(machine, machine.home(), size);
  if (!wrenches || wrenches->side == 0)
    settings::refuse(said.place, fmt::format("expected {} where the actuators hold the platform, seen it on a singular surface", said.what),
                     said.hint);
}

}  // namespace pmreport::program
