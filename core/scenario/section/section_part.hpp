// [[section]]
#pragma once

#include <core/mechanics/dynamics/drive.hpp>
#include <core/scenario/measured_part.hpp>
#include <core/scenario/mechanism_part.hpp>
#include <optional>
#include <string_view>
#include <vector>

namespace pmreport::scenario {

// What sections build on besides the mechanism and its motion: [drive] and [limits], nullptr where they are not there, and what the first
// says.
struct Sizing {
  const Entry *drive, *limits;
  const std::vector<mechanics::DriveTrain>& drives;
};

// A section whose kind cannot be read keeps an empty one.
std::vector<SectionRequest> read_sections(const Entry* entry, const std::optional<TimeSpan>& span, const MechanismPart& mechanism,
                                          const Sizing& sizing, const Reader& reader);

// Whether a section of that kind shows the motion, so that there must be one.
bool needs_motion(std::string_view kind);
// Whether a quantity of a section that needs none is of the motion all the same.
bool is_of_motion(std::string_view quantity);
// Whether any of the sections as written needs a motion; a file without sections would.
bool need_motion(const Entry* sections);

// The options of a section, by kind.
void read_snapshots(TableReader& table, const std::optional<TimeSpan>& span, SectionRequest& request);
void read_singularity(TableReader& table, const MechanismPart& mechanism, SectionRequest& request);
void read_assembly(TableReader& table, const std::optional<TimeSpan>& span, const MechanismPart& mechanism, SectionRequest& request);
void read_dynamics(TableReader& table, const std::optional<TimeSpan>& span, SectionRequest& request);
void read_reactions(TableReader& table, const MechanismPart& mechanism, SectionRequest& request);
std::vector<ComparisonRow> read_comparison_rows(const Entry& rows, const Measurable& measurable, const Reader& reader);

// A time that must lie within the motion; told when it does not, or when there is no motion.
std::optional<double> read_time(const Value& value, const std::optional<TimeSpan>& span, const Reader& reader);
// The items of a list of one to `most`; what is wrong is reported.
std::vector<Value> items_of(const Entry& entry, std::size_t most, const Reader& reader);

}  // namespace pmreport::scenario
