// A scenario: what a user asks of a mechanism. Read from TOML and validated against the mechanism by loaded.hpp.
#pragma once

#include <core/mechanics/dynamics/drive.hpp>
#include <core/mechanics/machine/machine.hpp>
#include <core/scenario/load.hpp>
#include <core/scenario/measured.hpp>
#include <core/scenario/motion/request.hpp>
#include <core/scenario/section/kind.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pmreport::scenario {

// How much of the report is shown: the worst alone, long tables at the end, or all.
enum class Detail { brief, engineering, full };

struct Scenario {
  std::string title, author, description;
  Detail detail = Detail::engineering;
  std::filesystem::path file;  // as given
  std::string text;            // the file itself, for the report
  std::string mechanism;       // name
  mechanics::ParameterValues parameters;
  std::vector<std::size_t> parameters_set;    // indices of those that the scenario gives
  std::optional<MotionRequest> motion;        // nothing: no section needs one
  Load load;                                  // along the motion; of no samples without one
  std::vector<mechanics::DriveTrain> drives;  // one an actuator; empty: the scenario has no [drive]
  mechanics::MotionLimits limits;             // from [limits]; all lists as long as the topology's
  std::vector<Section> sections;
  std::vector<Check> checks;
  bool asks_for(const SectionKind& kind) const;  // a section of that kind
  Needs needs() const;                           // of all sections together
};

}  // namespace pmreport::scenario
