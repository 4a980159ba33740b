// Indices over two coordinates.
#include <reports/section/common/words/words.hpp>
#include <reports/section/stiffness/stiffness.hpp>

#include <core/analysis/columns.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace pmreport::section {

namespace {

// "pF max", "f₁", "share of leg1"
std::string symbol_of(const Column& c) {
  if (c.group == "frequency") return symbol("f" + c.name.substr(9));
  if (c.group == "pF" || c.group == "pT" || c.group == "PhiT") {
    std::string out = c.name;
    std::ranges::replace(out, '_', ' ');
    return c.group == "PhiT" ? "ΦT" + out.substr(4) : out;
  }
  return c.name;
}

}  // namespace

DrawnMap stiffness_map(const Analysis& a, const StiffnessRequest& request, std::vector<document::Value>& values, int& singular) {
  const mechanics::Machine& m = a.machine();
  analysis::PoseMap map = *request.map;
  if (map.at.size() == 0) map.at = m.home();
  const std::vector<Column>& shown = request.shown;
  const bool loaded = a.samples() > 0;
  mechanics::Vector6d load = mechanics::Vector6d::Zero();
  if (loaded) load << a.scenario().load.force.front(), a.scenario().load.moment.front();
  const Eigen::Vector3d gravity = loaded ? a.scenario().load.gravity : Eigen::Vector3d(Eigen::Vector3d::Zero());
  // The limbs' masses count in frequencies alone, and cost several times the rest.
  const bool masses = request.limb_inertia && std::ranges::any_of(shown, [](const Column& c) { return c.group == "frequency"; });
  // One number more: 1 where the pose is there and not held.
  const auto numbers = analysis::over_map(map, shown.size() + 1, [&] {
    return [&, statics = std::make_shared<mechanics::Elastostatics>(m), placement = std::vector<double>(m.layout().size())](
               std::span<const double> q, std::span<double> out) mutable {
      if (m.place(PM_VALUE, 1, q.data(), placement.data()) != PM_OK) return;
      const Eigen::VectorXd coordinates = Eigen::Map<const Eigen::VectorXd>(q.data(), static_cast<Eigen::Index>(q.size()));
      const mechanics::ElasticPose pose = statics->at(coordinates, load, gravity, {loaded, masses});
      out.back() = pose.known ? 0 : 1;
      if (!pose.known) return;
      const auto tool = analysis::at_tool(m, pose, placement.data(), request);
      analysis::stiffness_numbers(m, pose, tool, request, a.length(), loaded, [&](const ColumnId& id, double x) {
        for (std::size_t i = 0; i < shown.size(); ++i)
          if (shown[i].name == id.name()) out[i] = x;
      });
    };
  });
  singular = static_cast<int>(std::ranges::count(numbers.back(), 1.0));
  std::vector<MapIndex> indices;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    double least = std::numeric_limits<double>::quiet_NaN(), largest = least;
    for (const double x : numbers[i])
      if (std::isfinite(x) && singular == 0) least = std::fmin(least, x), largest = std::fmax(largest, x);
    values.push_back({"stiffness", "map_min_" + shown[i].name, shown[i].unit, least});
    values.push_back({"stiffness", "map_max_" + shown[i].name, shown[i].unit, largest});
    indices.push_back({shown[i].name, shown[i].unit, shown[i].title, symbol_of(shown[i]), numbers[i]});
  }
  return draw_map(
      a, map, "stiffness-map",
      std::ranges::all_of(shown, analysis::of_compliance)
          ? "compliance and frequencies."
          : "elasticity; deflections and forces under the load at the start of the motion, whatever strokes and joint limits say.",
      indices);
}

}  // namespace pmreport::section
