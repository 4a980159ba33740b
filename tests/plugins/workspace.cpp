#include <tests/plugins/workspace.hpp>

#include <algorithm>

namespace pmreport::test {

std::unique_ptr<mechanics::Machine> machine_of(const json& c) {
  const pm_mechanism& table = plugin(c.at("mechanism"));
  std::map<std::string, std::vector<double>> changes;
  for (const auto& [name, value] : c.at("parameters").items())
    changes[name] = value.is_string()  ? std::vector{choice(table, name, value)}
                    : value.is_array() ? value.get<std::vector<double>>()
                                       : std::vector{value.get<double>()};
  return std::make_unique<mechanics::Machine>(table, values_with(table, changes));
}

scan::PoseSet pose_set(const mechanics::PoseMargins& margins) {
  scan::PoseSet out{margins.program, {}, {margins.late, margins.judge_late}};
  for (const mechanics::PoseMargin& m : margins.margins) out.rounding.push_back(m.rounding);
  return out;
}

scan::Scan scan_of(const mechanics::Machine& machine, const json& grid, const std::vector<std::string>& points) {
  scan::Scan out;
  std::vector<scan::Axis> turned;
  const auto& coordinates = machine.topology().coordinates;
  out.at.resize(coordinates.size());
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    const json& g = grid.at(coordinates[i].name);
    const scan::Axis axis{static_cast<int>(i), g.at("from"), g.at("to"), g.at("count").get<std::size_t>()};
    out.at[i] = axis.from;
    if (axis.count < 2) continue;
    (std::ranges::find(points, coordinates[i].name) != points.end() ? out.points : turned).push_back(axis);
  }
  if (turned.empty()) return out;
  out.orientations = {{}};
  for (const scan::Axis& a : turned) {
    out.turned.push_back(a.input);
    std::vector<std::vector<double>> longer;
    for (const auto& o : out.orientations)
      for (std::size_t k = 0; k < a.count; ++k) {
        longer.push_back(o);
        longer.back().push_back(a.value(k));
      }
    out.orientations = longer;
  }
  return out;
}

}  // namespace pmreport::test
