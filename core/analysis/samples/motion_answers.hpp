// What is known of the samples of a motion: of all of them, or of a block of them until it is put into its place.
#pragma once

#include <core/analysis/column_store.hpp>
#include <core/analysis/conditioning.hpp>
#include <core/analysis/residuals.hpp>
#include <core/analysis/samples/reaction_findings.hpp>
#include <core/mechanics/model/outcome.hpp>
#include <core/mechanics/stiffness/answers.hpp>

#include <map>
#include <span>
#include <string>
#include <vector>

namespace pmreport::analysis {

struct MotionAnswers {
  // What there is room for.
  struct Shape {
    std::vector<ColumnId> columns;
    std::size_t joints = 0;    // that have reactions
    bool compliances = false;  // there is elasticity
  };
  MotionAnswers() = default;
  MotionAnswers(const Shape& shape, std::size_t samples);  // of nothing yet: NaN, good

  ColumnStore columns;
  std::vector<mechanics::Outcome> outcomes;
  std::vector<HoldingWrenches> wrenches;
  std::map<int, std::string> why;  // of samples that are not good, where it is another sentence than of the one before that is not
  Residuals residuals;             // by samples of the motion, as are those that `reactions` names
  ReactionFindings reactions;
  std::vector<mechanics::Matrix6d> compliances;  // at the tool, in the axes of section `stiffness`; NaN where there is none; or empty

  std::size_t samples() const { return outcomes.size(); }
  const std::string& reason(int sample) const;  // of a sample that is not good; of others nothing

  chunks::Bytes bytes() const;
  // Puts a block of the same shape, samples `first` to `first` + `count` - 1, in its place. The blocks in their order, each once. Throws
  // chunks::NotReadable.
  void take(std::span<const std::byte> block, std::size_t first, std::size_t count);
};

}  // namespace pmreport::analysis
