// [mechanism]
#pragma once

#include <core/scenario/loaded.hpp>
#include <core/scenario/read/reader.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pmreport::scenario {

struct MechanismPart {
  std::string name;
  mechanics::MechanismInfo info;
  mechanics::ParameterValues values;
  std::vector<std::size_t> set;
  std::unique_ptr<mechanics::Machine> machine;  // nullptr when something is wrong
  std::optional<Topology> topology;             // to judge the other parts by; nothing when the mechanism is unknown
};
MechanismPart read_mechanism(const Entry* entry, const MechanismSource& source, const Reader& reader);

// One number of a parameter within its range, SI; nothing, told, when it is none.
std::optional<double> read_parameter_number(const Value& value, const mechanics::ParameterInfo& info, const Reader& reader);
// The parameter among `set` that stands in the place of this one; nothing: it counts.
std::optional<std::string> silenced_by(const mechanics::MechanismInfo& info, std::size_t parameter, const std::vector<std::size_t>& set);
// A table of parameters over the `values` that there are; those that it gives are added to `set`. False, told, when something is wrong.
bool read_parameters(const Entry& entry, const std::string& where, const mechanics::MechanismInfo& info, mechanics::ParameterValues& values,
                     std::vector<std::size_t>& set, const Reader& reader);

// A coordinate that is named but cannot be given: unknown, or dependent. `keys`: what may be named, in words; else `known` is listed.
void refuse_coordinate(Place place, const std::string& name, const MechanismPart& mechanism, const std::vector<std::string>& known,
                       const std::string& where, Diagnostics& diagnostics, const std::string& keys = {});

// What can be moved: the independent coordinates, or the actuators.
struct Moved {
  std::string name, unit;  // SI
  double home = 0;
};
std::string names_of(const std::vector<Moved>& list);  // "x, y and z"
struct Movables {
  explicit Movables(const MechanismPart& mechanism);  // whose topology is known
  std::vector<Moved> coordinates, actuators;
};

// "q1" of "q1_rate", else the name itself.
std::string without_rate(const std::string& name);

}  // namespace pmreport::scenario
