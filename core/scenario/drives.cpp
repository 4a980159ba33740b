// [drive]: what stands between the motors and the actuators.
#include <core/scenario/parts.hpp>

namespace pmreport::scenario {

std::vector<mechanics::DriveTrain> read_drives(const Entry* entry, const MechanismPart& mechanism, const Reader& reader) {
  const Value* content = table_of(entry, "drive", reader);
  if (content == nullptr || !mechanism.topology) return {};
  std::vector<mechanics::DriveTrain> drives(mechanism.topology->actuators.size());
  TableReader table(*content, "[drive]", entry->place, reader);
  if (const Entry* e = table.find("efficiency"))
    for (mechanics::DriveTrain& d : drives) d.efficiency = reader.quantity(e->value, {}).value_or(1);
  table.finish();
  return drives;
}

}  // namespace pmreport::scenario
