// What is said and shown of the modes that accompany the motion.
#pragma once

#include <core/analysis/study/modes_along.hpp>
#include <reports/section/kind.hpp>

#include <string>
#include <vector>

namespace pmreport::section {

// `listed`: modes that the section has shown, with their numbers.
std::vector<std::string> sentences(const Analysis& a, const analysis::ModesAlong& along, std::size_t listed);
document::Table table_of_events(const analysis::ModesAlong& along);
figure::Figure figure_of_modes(const Analysis& a, const analysis::ModesAlong& along);
document::Data data_of_modes(const Analysis& a, const analysis::ModesAlong& along);
document::Evidence same_at_both_ends(const analysis::ModesAlong& along);  // of a closed motion

}  // namespace pmreport::section
