#include <core/scan/proof/boxed_margins.hpp>

#include <core/program/batch.hpp>
#include <core/program/derivative.hpp>
#include <core/program/intervals/boxes.hpp>
#include <core/scan/proof/apart.hpp>
#include <core/scan/proof/half_space.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

namespace pmreport::scan {

using program::Bounds, program::Boxes, program::Program;

namespace {

Program margins_of(const PoseSet& set) {
  if (!set.late.over_boxes) return set.margins;
  const program::Guided& late = *set.late.over_boxes;
  return joined(Program(set.margins.steps(), late.program.inputs(), set.margins.outputs()), late.program);
}

}  // namespace

BoxedMargins::BoxedMargins(const PoseSet& set, const Scan& scan) : coordinates_(scan.at.size()) {
  if (!set.provable())
    throw std::invalid_argument(
        fmt::format("a proof needs margins that a program gives; {} of {} are computed pose by pose", set.late.size, set.size()));
  if (set.late.over_boxes) guided_ = *set.late.over_boxes;

  std::vector<Bounds> inputs;
  for (const double x : scan.at) inputs.push_back(Bounds::exactly(x));
  inputs.resize(coordinates_ + guides());
  std::vector<bool> free_inputs(inputs.size());
  std::fill(free_inputs.begin() + static_cast<std::ptrdiff_t>(coordinates_), free_inputs.end(), true);
  std::vector<int> by;
  for (std::size_t a = 0; a < scan.points.size(); ++a) {
    const Axis& axis = scan.points[a];
    const auto input = static_cast<std::size_t>(axis.input);
    inputs[input] = {std::min(axis.from, axis.to), std::max(axis.from, axis.to)};
    if (axis.from == axis.to) continue;
    axes_.push_back({a, axis.input, inputs[input]});
    by.push_back(axis.input);
    free_inputs[input] = true;
  }
  if (axes_.size() > most_axes)
    throw std::invalid_argument(fmt::format("a proof over {} coordinates at once; {} at most can be scanned", axes_.size(), most_axes));

  const TakenApart apart = taken_apart(margins_of(set));
  const program::Split split = program::split(apart.program, free_inputs);
  part_of_ = apart.part_of;
  values_ = split.inner;
  with_partials_ = program::partials(values_, by);

  Boxes outer(split.outer);
  for (std::size_t o = 0; o < scan.orientation_count(); ++o) {
    std::vector<Bounds>& fixed = fixed_.emplace_back(inputs);
    if (!scan.orientations.empty())
      for (std::size_t i = 0; i < scan.turned.size(); ++i)
        fixed[static_cast<std::size_t>(scan.turned[i])] = Bounds::exactly(scan.orientations[o][i]);
    fixed.resize(inputs.size() + split.outer.outputs().size());
    outer.run(1, fixed.data(), fixed.data() + inputs.size());
  }
}

}  // namespace pmreport::scan
