// [motion]
#pragma once

#include <core/scenario/load.hpp>
#include <core/scenario/mechanism_part.hpp>
#include <core/scenario/motion/request.hpp>
#include <filesystem>
#include <optional>

namespace pmreport::scenario {

struct MotionPart {
  std::optional<MotionRequest> request;
  mechanics::Trajectory trajectory;
  std::optional<TimeSpan> span;  // from the first sample to the last; nothing when it is not known
};
// `needed`: a section shows the motion. `load`: a motion that follows from forces feels it.
MotionPart read_motion(const Entry* entry, bool needed, const MechanismPart& mechanism, const Load& load,
                       const std::filesystem::path& scenario, const Reader& reader);

}  // namespace pmreport::scenario
