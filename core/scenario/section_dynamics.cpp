// Options of the sections `dynamics` and `reactions`.
#include <core/scenario/parts.hpp>

namespace pmreport::scenario {

void read_dynamics(TableReader& table, const std::optional<Interval>& interval, SectionRequest& request) {
  if (const Entry* e = table.find("equations"))
    for (const Value& item : items_of(*e, 12, table.read()))
      if (const auto t = read_time(item, interval, table.read())) request.equations.push_back(*t);
}

void read_reactions(TableReader& table, const MechanismPart& mechanism, SectionRequest& request) {
  if (const Entry* e = table.find("joints"); e != nullptr && mechanism.topology) {
    std::vector<std::string> names;
    for (const Joint& j : mechanism.topology->joints) names.push_back(j.name);
    for (const Value& item : items_of(*e, names.size(), table.read()))
      if (const auto index = table.read().word(item, names, "the joints")) request.joints.push_back(static_cast<int>(*index));
  }
}

}  // namespace pmreport::scenario
