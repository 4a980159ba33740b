#include <core/scan/proof/boxed_margins.hpp>

#include <core/assertion.hpp>
#include <core/program/batch.hpp>
#include <core/program/boxes.hpp>
#include <core/program/derivative.hpp>
#include <core/scan/proof/apart.hpp>
#include <core/scan/proof/half_space.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

namespace pmreport::scan {

using program::Bounds, program::Boxes, program::Program;

BoxedMargins::BoxedMargins(const PoseSet& set, const Scan& scan) {
  if (set.late.size > 0)
    throw std::invalid_argument(
        fmt::format("a proof needs margins that a program gives; {} of {} are computed pose by pose", set.late.size, set.size()));

  std::vector<Bounds> inputs;
  for (const double x : scan.at) inputs.push_back(Bounds::exactly(x));
  std::uint64_t free_inputs = 0;
  std::vector<int> by;
  for (std::size_t a = 0; a < scan.points.size(); ++a) {
    const Axis& axis = scan.points[a];
    const auto input = static_cast<std::size_t>(axis.input);
    inputs[input] = {std::min(axis.from, axis.to), std::max(axis.from, axis.to)};
    if (axis.from == axis.to) continue;
    PMREPORT_ASSERT(input < 64, "a scanned coordinate is one of the first 64");
    axes_.push_back({a, axis.input, inputs[input]});
    by.push_back(axis.input);
    free_inputs |= std::uint64_t{1} << input;
  }
  if (axes_.size() > most_axes)
    throw std::invalid_argument(fmt::format("a proof over {} coordinates at once; {} at most can be scanned", axes_.size(), most_axes));

  const TakenApart apart = taken_apart(set.margins);
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
