#include <core/analysis/proof/quantities.hpp>

namespace pmreport::analysis {

Quantities::Quantities(const mechanics::Machine& machine, const mechanics::MotionProgram& program) {
  const Topology& t = machine.topology();
  const Layout& layout = machine.layout();
  all.push_back({});
  // Value, rate and acceleration, one after the other. Accelerations are dear, for their own rates are not known: those of coordinates come
  // with the motion, and those of actuators are asked for.
  const auto add_moved = [&](Quantity::Of of, std::size_t count, auto&& output) {
    for (std::size_t i = 0; i < count; ++i)
      for (const OfMotion order : {OfMotion::value, OfMotion::rate, OfMotion::acceleration}) {
        if (of == Quantity::Of::derived && order == OfMotion::acceleration) continue;
        if (of == Quantity::Of::actuator && order == OfMotion::value) actuators.push_back(static_cast<int>(all.size()));
        all.push_back({of, static_cast<int>(i), 0, order, output(static_cast<int>(i))});
      }
  };
  add_moved(Quantity::Of::coordinate, t.coordinates.size(), [](int) { return std::size_t{0}; });
  add_moved(Quantity::Of::derived, t.derived.size(), [&](int i) { return layout.derived(i); });
  add_moved(Quantity::Of::actuator, t.actuators.size(), [&](int i) { return layout.actuator(i); });
  for (const mechanics::MotionProgram::JointMotion& j : program.joints) {
    joints.push_back(static_cast<int>(all.size()));
    all.push_back({Quantity::Of::joint, j.joint, j.limit, OfMotion::value, j.output});
  }
}

ColumnId Quantities::column(const mechanics::Machine& machine, const Quantity& q) const {
  const Topology& t = machine.topology();
  const auto i = static_cast<std::size_t>(q.index);
  switch (q.of) {
    case Quantity::Of::coordinate:
      return column_of(t.coordinates[i], q.order);
    case Quantity::Of::derived:
      return column_of(t.derived[i], q.order);
    case Quantity::Of::actuator:
      return column_of(t.actuators[i], q.order);
    case Quantity::Of::joint:
      return joint_column(t.joints[i], static_cast<std::size_t>(q.part));
    case Quantity::Of::reach:
      break;
  }
  return ColumnId::named("");
}

}  // namespace pmreport::analysis
