// Section `assembly`: every pose that the actuator values of one moment allow, and how near the motion comes to another of them.
#include <core/numbers.hpp>
#include <reports/section/assembly/along.hpp>
#include <reports/section/assembly/assembly.hpp>
#include <reports/section/assembly/modes.hpp>
#include <reports/section/common/words/words.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace pmreport::section {

using document::Paragraph;
using mechanics::AssemblyMode;
using mechanics::AssemblyModes;
using mechanics::ModeContinuum;

namespace {

constexpr double on_continuum = 1e-6;  // of the characteristic length

}  // namespace

Result assembly_section(const Analysis& a, const AssemblyOptions& r, const Stage& stage, const Progress& progress) {
  Result result{{"assembly", "assembly", "Assembly modes", {}}, {}, {}, {}};
  auto& blocks = result.section.blocks;
  const mechanics::Machine& m = a.machine();
  const bool moves = a.samples() > 0;
  const int sample = moves ? a.sample_at(r.time) : -1;
  if (moves && a.outcome(sample) == Outcome::unreachable) {
    blocks.push_back(Paragraph{Paragraph::Tone::warning,
                               fmt::format("t = {}: the mechanism cannot be assembled: {}.", show_time(a, sample), a.why(sample))});
    return result;
  }
  const mechanics::Pose pose = moves ? a.pose(sample) : m.home_pose();
  const Eigen::VectorXd reference = moves ? Eigen::VectorXd(a.trajectory().value.row(sample)) : m.home();
  const bool given = r.actuators.size() > 0;
  const Eigen::VectorXd here = Eigen::Map<const Eigen::VectorXd>(pose.numbers.data() + m.layout().actuator(0), m.dof());
  mechanics::AssemblyOptions options;
  options.working_modes = r.working_modes;
  const AssemblyModes found = find_assembly_modes(m, given ? r.actuators : here, reference, options);
  progress.stop_if_asked();

  std::string values;
  for (int i = 0; i < m.dof(); ++i) {
    const Actuator& actuator = m.topology().actuators[static_cast<std::size_t>(i)];
    values += fmt::format("{}{} = {}", i > 0 ? ", " : "", symbol(actuator.name), show(given ? r.actuators(i) : here(i), actuator.unit, 6));
  }
  const auto tell = [&](const std::string& text) { blocks.push_back(Paragraph{Paragraph::Tone::plain, text}); };
  const std::string when = given ? "given" : moves ? "at t = " + show_time(a, sample) : "at home";
  const bool several = found.modes.size() > 1 || !found.continua.empty();
  tell(fmt::format("The actuator values {}{}: {}. {}", when,
                   several ? " do not determine the pose alone, the mechanism can be assembled with them in several ways" : "", values,
                   counted(found)));
  if (moves && !found.continua.empty() && found.continua.front().distance < on_continuum * a.length())
    blocks.push_back(
        Paragraph{Paragraph::Tone::warning,
                  "The pose of the motion lies on a continuum: its actuators do not hold the platform there, which moves along "
                  "it while they stand still."});
  tell(fmt::format(
      "The distance between two poses is √(|Δp|² + (L·θ)²), with Δp the way of the reference point, θ the angle between the two "
      "orientations and L = {} the characteristic length.",
      show(a.length(), "m")));
  if (!found.modes.empty()) blocks.push_back(table_of_modes(a, found));
  if (!found.continua.empty()) blocks.push_back(table_of_continua(a, found));
  if (!found.modes.empty() || !found.continua.empty()) blocks.push_back(pictures_of_modes(a, found, stage, progress));

  document::Proof proof;
  double residual = 0, gap = 0, misalignment = 0, nearest = nan;
  int own = 0;
  for (const AssemblyMode& mode : found.modes) {
    residual = std::max(residual, mode.residual), gap = std::max(gap, mode.gap), misalignment = std::max(misalignment, mode.misalignment);
    own += mode.word == 0;
    if (!(nearest <= mode.distance)) nearest = mode.distance;
  }
  for (const ModeContinuum& c : found.continua) {
    residual = std::max(residual, c.residual);
    if (!(nearest <= c.distance)) nearest = c.distance;
  }
  result.values = {{"assembly", "modes", "", double(found.modes.size())},
                   {"assembly", "continua", "", double(found.continua.size())},
                   {"assembly", "own_working_mode", "", double(own)}};
  const auto of_modes = [&](const char* claim, const char* how, double value, double tolerance, const char* unit) {
    proof.lines.push_back(found.modes.empty() && found.continua.empty() ? document::Evidence::not_examined(claim, how, "no mode was found")
                                                                        : document::Evidence{claim, how, value, tolerance, unit});
  };
  of_modes("Every mode has the actuator values", "by substitution into inverse displacement, of the mechanism's size", residual, 1e-10, "");
  of_modes("Joints meet in every mode", "joint centres as both bodies carry them, of the mechanism's size", gap, 1e-9, "");
  of_modes("Joint axes agree in every mode", "axes as both bodies carry them", misalignment, 1e-9, "rad");
  if (!given) {
    proof.lines.push_back({moves ? "The pose of the motion is among the modes" : "The home pose is among the modes",
                           "its distance from the nearest, by the characteristic length", nearest / a.length(), 1e-7, ""});
  }
  if (!given && moves && !found.modes.empty()) {
    const analysis::ModesAlong along = analysis::modes_along(a, found, sample, options);
    progress.stop_if_asked();
    for (const std::string& s : sentences(a, along, found.modes.size())) tell(s);
    if (!along.tracks.events.empty()) blocks.push_back(table_of_events(along));
    if (std::isfinite(along.tracks.least)) {
      blocks.push_back(figure_of_modes(a, along));
      result.data.push_back(data_of_modes(a, along));
      result.values.push_back({"assembly", "nearest", "m", along.tracks.least});
    }
    if (along.closed) proof.lines.push_back(same_at_both_ends(along));
  }
  tell(searched(found));
  if (m.dof() == 6) {
    result.values.push_back({"assembly", "further", "", 0});  // six coordinates express every pose of a platform
  } else if (found.further) {
    tell(beyond_the_coordinates(a, *found.further));
    result.values.push_back({"assembly", "further", "", double(found.further->poses.size())});
    if (!found.further->poses.empty()) {
      double open = 0;
      for (const mechanics::FurtherPose& p : found.further->poses) open = std::max(open, p.error);
      proof.lines.push_back({"All joints close in the poses beyond the coordinates",
                             "by substitution into joints and actuators, lengths by the mechanism's size", open, 1e-10, ""});
    }
  }
  blocks.push_back(proof);
  return result;
}

}  // namespace pmreport::section
