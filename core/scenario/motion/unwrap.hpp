// Angles in tables that come back by a turn: an encoder or a tracker that counts from -180 to 180 degrees writes 178, 180, -178.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace pmreport::scenario {

// The first angle [rad] that lies nearly a turn from the one before, while a turn less would go on as the angles around it do.
std::optional<std::size_t> wrapped_at(const std::vector<double>& times, const std::vector<double>& angles);
// Every step between two neighbours made the shortest: whole turns are added to all that follow.
void unwrap(std::vector<double>& angles);

}  // namespace pmreport::scenario
