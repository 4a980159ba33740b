#include <core/mechanics/machine/geometry_recorder.hpp>

#include <core/mechanics/machine/contract.hpp>

#include <fmt/format.h>

#include <cstring>
#include <memory>

namespace pmreport::mechanics {

namespace {

struct Recorded {
  std::vector<pm_step> steps;
  std::vector<std::int32_t> outputs;
};

// Into a list with room for so many steps, and for all that are looked at where these are not enough.
Recorded record(const pm_mechanism& table, const pm_instance* instance, std::size_t outputs, std::size_t room = 4096) {
  using program::Program, program::ProgramError;
  Recorded out{std::vector<pm_step>(room), std::vector<std::int32_t>(outputs, -1)};
  pm_recording list{sizeof(pm_recording), out.steps.data(), out.steps.size(), 0, out.outputs.data()};
  std::string why;
  const pm_status status = contract::call(why, [&](pm_text* text) { return table.record(instance, &list, text); });
  if (status != PM_OK) throw ProgramError("the mechanism cannot record its geometry: " + why);
  if (list.count > Program::most_steps)
    throw ProgramError(
        fmt::format("the mechanism records {} operations, more than the {} that are looked at", list.count, Program::most_steps));
  if (list.count > room) return record(table, instance, outputs, Program::most_steps);
  out.steps.resize(list.count);
  return out;
}

}  // namespace

program::Program record_geometry(const pm_mechanism& table, const pm_instance* instance, int dof, std::size_t outputs) {
  using program::Program, program::ProgramError;
  if (!contract::records(table)) throw ProgramError("the plugin was built before geometry was recorded (contract 1.3)");
  const Recorded first = record(table, instance, outputs), second = record(table, instance, outputs);
  const auto same = [](const pm_step& x, const pm_step& y) {
    return x.operation == y.operation && x.a == y.a && x.b == y.b && x.c == y.c &&
           std::memcmp(&x.constant, &y.constant, sizeof x.constant) == 0;
  };
  if (first.outputs != second.outputs || !std::ranges::equal(first.steps, second.steps, same))
    throw ProgramError("the mechanism records other operations at a second call");
  try {
    return Program(program::steps_of(first.steps), dof, first.outputs);
  } catch (const ProgramError& e) {
    throw ProgramError(std::string("the mechanism records ") + e.what());
  }
}

}  // namespace pmreport::mechanics
