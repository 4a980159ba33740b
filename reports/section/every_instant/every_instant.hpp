// The section "At every instant", which every report of a motion has: what is proved of it between its samples too.
#pragma once

#include <core/analysis/study/between_samples.hpp>
#include <reports/document/report.hpp>
#include <reports/section/common/words/proof_words.hpp>

#include <vector>

namespace pmreport::section {

// Its sentence, table of extremes and evidence, with the brackets as data; the same as programs read it.
struct AtEveryInstant {
  document::Section section;
  std::vector<document::Data> data;
};
AtEveryInstant every_instant_section(const Analysis& a, const Proved& p, const std::vector<analysis::Unseen>& unseen);
document::EveryInstant every_instant_results(const Analysis& a, const Proved& p);

// A line a kind of claim, or one for those that hold, one for those that are broken, and so on, where they differ.
document::Proof proof_of_motion(const Analysis& a, const Proved& p, const std::vector<analysis::Unseen>& unseen);

// A column with a bracket as it is shown: its name, title and unit, and the range that bounds it; none: an infinite one.
struct ExtremeShown {
  const analysis::Extreme* extreme;
  Column column;
  Bounds range;
};
// In the order of the lists of columns; of readings and columns that nothing is known of none.
std::vector<ExtremeShown> extremes_shown(const Analysis& a, const Proved& p);
document::Table table_of_extremes(const Analysis& a, const std::vector<ExtremeShown>& extremes);

}  // namespace pmreport::section
