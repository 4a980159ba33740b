// What checks and comparisons measure, and [[check]].
#pragma once

#include <core/mechanics/dynamics/drive.hpp>
#include <core/scenario/measured.hpp>
#include <core/scenario/motion/request.hpp>
#include <core/scenario/read/reader.hpp>
#include <core/scenario/section/kind.hpp>
#include <optional>
#include <pmreport/topology.hpp>
#include <vector>

namespace pmreport::scenario {

// What one number of the report may be made of.
struct Measurable {
  const std::vector<Section>& sections;
  const std::optional<Topology>& topology;
  const std::optional<TimeSpan>& span;
  const std::vector<mechanics::DriveTrain>& drives;
  Kinds kinds;  // all that a section could be of
};
// "max(abs(actuator_force))", "at(l1, 2.5 s)", "mobility.redundant". Nothing, told, when there is no such thing in this report; a thing
// without columns and quantity when the mechanism is unknown, so that it cannot be judged.
std::optional<Measured> read_measured(const Value& value, const Measurable& measurable, const Reader& reader);
bool judged(const Measured& m);

std::vector<Check> read_checks(const Entry* entry, const Measurable& measurable, const Reader& reader);

}  // namespace pmreport::scenario
