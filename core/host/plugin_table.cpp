// Versions. Majors must be equal. A plugin of a newer minor has structs that are longer than ours and begin alike: what we do not know we
// do not read. A plugin of an older minor has shorter ones: at least as long as in 1.0, and a member added since is read only where
// `struct_size` covers it.
#include <fmt/core.h>

#include <cmath>
#include <core/host/plugin_table.hpp>
#include <core/host/refusal.hpp>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string_view>

namespace pmreport::host {
namespace {

constexpr const char* rebuild = "build the plugin again with the headers of this pmreport";
constexpr const char* repair = "correct the declaration and build the plugin again";

// Sizes in the version that brought each struct (most of them 1.0), by its last member then: they stay when the structs grow.
#define PM_SIZE_TO(type, member) (offsetof(type, member) + sizeof(type::member))
constexpr std::size_t table_size = PM_SIZE_TO(pm_plugin_table, mechanisms);
constexpr std::size_t mechanism_size = PM_SIZE_TO(pm_mechanism, appearance);
constexpr std::size_t parameter_size = PM_SIZE_TO(pm_parameter, choice_count);
constexpr std::size_t unless_end = PM_SIZE_TO(pm_parameter, unless);
constexpr std::size_t kinematics_size = PM_SIZE_TO(pm_kinematics, place);
constexpr std::size_t statics_size = PM_SIZE_TO(pm_statics, jacobian);
constexpr std::size_t dynamics_size = PM_SIZE_TO(pm_dynamics, inertias);
constexpr std::size_t closed_forms_size = PM_SIZE_TO(pm_closed_forms, read);
constexpr std::size_t closed_forms_end = PM_SIZE_TO(pm_mechanism, closed_forms);
constexpr std::size_t elasticity_size = PM_SIZE_TO(pm_elasticity, elements);
constexpr std::size_t elasticity_end = PM_SIZE_TO(pm_mechanism, elasticity);
constexpr std::size_t appearance_size = PM_SIZE_TO(pm_appearance, shapes);
#undef PM_SIZE_TO

void require_size(const std::string& where, const char* what, std::size_t seen, std::size_t least) {
  if (seen < least) refuse(where, fmt::format("{} of at least {} bytes", what, least), fmt::format("{}", seen), rebuild);
}
void require_present(const std::string& where, const char* what, bool present) {
  if (!present) refuse(where, what, "a null pointer", repair);
}

bool is_name(const char* text, std::string_view extra) {
  constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz0123456789";
  if (text == nullptr || *text == '\0' || letters.find(*text) == letters.npos) return false;
  for (const char c : std::string_view(text))
    if (letters.find(c) == letters.npos && extra.find(c) == extra.npos) return false;
  return true;
}

void require_choice(const std::string& where, const pm_parameter& p) {
  if (p.choice_count == 0 || p.choices == nullptr) refuse(where, "a list of choices", "none", repair);
  for (std::size_t i = 0; i < p.choice_count; ++i)
    require_present(where, fmt::format("a word for choice {}", i).c_str(), p.choices[i] != nullptr);
  const double index = p.defaults[0];
  if (!(index >= 0 && index < static_cast<double>(p.choice_count) && index == std::floor(index)))
    refuse(where, fmt::format("a default index from 0 to {}", p.choice_count - 1), fmt::format("{}", index), repair);
}

void require_numbers(const std::string& where, const pm_parameter& p) {
  if (!(std::isfinite(p.min) && std::isfinite(p.max) && p.min <= p.max))
    refuse(where, "a finite range, min first", fmt::format("{} to {}", p.min, p.max), repair);
  for (std::size_t i = 0; i < p.default_count; ++i)
    if (!(p.defaults[i] >= p.min && p.defaults[i] <= p.max))
      refuse(where, fmt::format("defaults from {} to {}", p.min, p.max), fmt::format("{}", p.defaults[i]), repair);
}

void require_parameter(const std::string& where, const pm_parameter& p) {
  require_present(where, "a title", p.title != nullptr);
  require_present(where, "a unit, \"\" for a plain number", p.unit != nullptr);
  require_present(where, "a display unit, \"\" for a plain number", p.display != nullptr);
  if (p.kind != PM_NUMBER && p.kind != PM_NUMBERS && p.kind != PM_CHOICE)
    refuse(where, "a kind of parameter that this pmreport knows (number, numbers, choice)", fmt::format("kind {}", p.kind),
           "use a pmreport as new as the plugin");
  const std::size_t least = p.kind == PM_NUMBERS ? p.count_min : 1, most = p.kind == PM_NUMBERS ? p.count_max : 1;
  if (least > most) refuse(where, "count_min no more than count_max", fmt::format("{} and {}", least, most), repair);
  if (p.default_count < least || p.default_count > most)
    refuse(where, least == most ? fmt::format("defaults: {}", least) : fmt::format("defaults: {} to {}", least, most),
           fmt::format("{}", p.default_count), repair);
  require_present(where, "defaults", p.defaults != nullptr || p.default_count == 0);
  if (p.kind == PM_CHOICE)
    require_choice(where, p);
  else
    require_numbers(where, p);
}

void require_parameters(const std::string& where, const pm_list& list) {
  if (list.count == 0) return;
  require_present(where, "a list of parameters", list.items != nullptr);
  require_size(where, "a stride of the parameters", list.stride, parameter_size);
  // As every array of such structs has it. Others would cut a member in two, or put it where a processor does not read it.
  if (list.stride % alignof(pm_parameter) != 0 || reinterpret_cast<std::uintptr_t>(list.items) % alignof(pm_parameter) != 0)
    refuse(where, fmt::format("parameters at addresses that divide by {}", alignof(pm_parameter)),
           fmt::format("a stride of {} bytes from {}", list.stride, list.items), repair);
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < list.count; ++i) {
    const auto& p = *reinterpret_cast<const pm_parameter*>(static_cast<const char*>(list.items) + i * list.stride);
    if (!is_name(p.name, "_"))
      refuse(where, fmt::format("a name of lower-case letters, digits and underscores for parameter {}", i + 1), quoted(p.name), repair);
    if (!names.insert(p.name).second) refuse(where, "parameters of different names", fmt::format("{} twice", quoted(p.name)), repair);
    require_parameter(fmt::format("{}: parameter '{}'", where, p.name), p);
  }
  if (list.stride < unless_end) return;
  for (std::size_t i = 0; i < list.count; ++i) {
    const auto& p = *reinterpret_cast<const pm_parameter*>(static_cast<const char*>(list.items) + i * list.stride);
    if (p.unless != nullptr && (!names.contains(p.unless) || p.unless == std::string_view(p.name)))
      refuse(fmt::format("{}: parameter '{}'", where, p.name), "another parameter that stands in its place", quoted(p.unless), repair);
  }
}

void require_mechanism(const std::string& where, const pm_mechanism& m) {
  if (m.dof < 1 || m.dof > 6) refuse(where, "1 to 6 degrees of freedom", fmt::format("{}", m.dof), repair);
  require_present(where, "a title", m.title != nullptr);
  require_present(where, "a source", m.source != nullptr);
  require_present(where, "the function create", m.create != nullptr);
  require_present(where, "the function destroy", m.destroy != nullptr);

  require_present(where, "the table kinematics", m.kinematics != nullptr);
  require_size(where, "the table kinematics", m.kinematics->struct_size, kinematics_size);
  require_present(where, "the function kinematics.topology", m.kinematics->topology != nullptr);
  require_present(where, "the function kinematics.place", m.kinematics->place != nullptr);

  require_present(where, "the table statics", m.statics != nullptr);
  require_size(where, "the table statics", m.statics->struct_size, statics_size);
  require_present(where, "the function statics.constraints", m.statics->constraints != nullptr);
  require_present(where, "the function statics.jacobian", m.statics->jacobian != nullptr);

  require_present(where, "the table dynamics", m.dynamics != nullptr);
  require_size(where, "the table dynamics", m.dynamics->struct_size, dynamics_size);
  require_present(where, "the function dynamics.inertias", m.dynamics->inertias != nullptr);

  if (m.appearance != nullptr) {
    require_size(where, "the table appearance", m.appearance->struct_size, appearance_size);
    require_present(where, "the function appearance.shapes", m.appearance->shapes != nullptr);
  }
  if (m.struct_size >= closed_forms_end && m.closed_forms != nullptr) {
    require_size(where, "the table closed_forms", m.closed_forms->struct_size, closed_forms_size);
    require_present(where, "the function closed_forms.matrices", m.closed_forms->matrices != nullptr);
    require_present(where, "the function closed_forms.evaluate", m.closed_forms->evaluate != nullptr);
    require_present(where, "the function closed_forms.readings", m.closed_forms->readings != nullptr);
    require_present(where, "the function closed_forms.read", m.closed_forms->read != nullptr);
  }
  if (m.struct_size >= elasticity_end && m.elasticity != nullptr) {
    require_size(where, "the table elasticity", m.elasticity->struct_size, elasticity_size);
    require_present(where, "the function elasticity.elements", m.elasticity->elements != nullptr);
  }
  require_parameters(where, m.parameters);
}

}  // namespace

void require_sound(const pm_plugin_table& table, const std::string& where) {
  // The three members that tell the version come first in every version there will be.
  require_size(where, "a plugin table", table.struct_size, offsetof(pm_plugin_table, abi_minor) + sizeof(table.abi_minor));
  if (table.abi_major != PM_ABI_MAJOR)
    refuse(where, fmt::format("a plugin for ABI {}.x", PM_ABI_MAJOR), fmt::format("{}.{}", table.abi_major, table.abi_minor),
           table.abi_major < PM_ABI_MAJOR ? rebuild : "use a pmreport as new as the plugin");
  require_size(where, "a plugin table", table.struct_size, table_size);
  require_present(where, "a build string", table.build != nullptr);
  if (table.mechanism_count == 0) refuse(where, "at least one mechanism", "none", repair);
  require_present(where, "a table of mechanisms", table.mechanisms != nullptr);

  std::set<std::string_view> names;
  for (std::size_t i = 0; i < table.mechanism_count; ++i) {
    const std::string nth = fmt::format("{}: mechanism {}", where, i + 1);
    require_present(nth, "a table", table.mechanisms[i] != nullptr);
    const pm_mechanism& m = *table.mechanisms[i];
    require_size(nth, "a table", m.struct_size, mechanism_size);
    if (!is_name(m.name, "-_")) refuse(nth, "a name of lower-case letters, digits and dashes", quoted(m.name), repair);
    if (!names.insert(m.name).second) refuse(where, "mechanisms of different names", fmt::format("'{}' twice", m.name), repair);
    require_mechanism(fmt::format("{}: mechanism '{}'", where, m.name), m);
  }
}

}  // namespace pmreport::host
