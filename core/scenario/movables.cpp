// What a scenario may move: coordinates and actuators by name.
#include <fmt/format.h>

#include <algorithm>
#include <core/scenario/mechanism_part.hpp>
#include <core/text/text.hpp>

namespace pmreport::scenario {
namespace {

constexpr std::string_view rate_suffix = "_rate";

}  // namespace

std::string without_rate(const std::string& name) {
  return name.ends_with(rate_suffix) ? name.substr(0, name.size() - rate_suffix.size()) : name;
}

std::string names_of(const std::vector<Moved>& list) {
  std::vector<std::string> out;
  for (const Moved& m : list) out.push_back(m.name);
  return listed(out, "and");
}

Movables::Movables(const MechanismPart& mechanism) {
  for (const Coordinate& c : mechanism.topology->coordinates) coordinates.push_back({c.name, c.unit, c.home});
  for (std::size_t i = 0; i < mechanism.topology->actuators.size(); ++i) {
    const Actuator& a = mechanism.topology->actuators[i];
    // Without a machine nothing will be followed; the middle of the stroke is as good as any value then.
    const double home = mechanism.machine != nullptr
                            ? mechanism.machine->home_pose().numbers[mechanism.machine->layout().actuator(static_cast<int>(i))]
                            : 0.5 * (a.stroke.min + a.stroke.max);
    actuators.push_back({a.name, a.unit, home});
  }
}

void refuse_coordinate(Place place, const std::string& name, const MechanismPart& mechanism, const std::vector<std::string>& known,
                       const std::string& where, Diagnostics& diagnostics, const std::string& keys) {
  const std::string base = without_rate(name);
  for (const Derived& d : mechanism.topology->derived) {
    if (!d.dependent || d.name != base) continue;
    std::string hint = "leave it out";
    for (const auto& p : mechanism.info.parameters)
      if (p.kind == PM_CHOICE && std::find(p.choices.begin(), p.choices.end(), base) != p.choices.end()) {
        std::vector<std::string> others = p.choices;
        std::erase(others, base);
        hint += fmt::format(", or let another coordinate follow: {} = {} in [mechanism.parameters]", p.name, listed(others, "or", true));
      }
    diagnostics.add(place,
                    fmt::format("{} is a dependent coordinate of {}: it follows from the others and cannot be given", base, mechanism.name),
                    hint);
    return;
  }
  diagnostics.add(place, fmt::format("unknown key {} in {}{}", in_quotes(name), where, did_you_mean(name, known)),
                  keys.empty() ? fmt::format("the keys are {}", listed(known, "and")) : keys);
}

}  // namespace pmreport::scenario
