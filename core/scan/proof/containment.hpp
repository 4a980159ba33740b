// Whether all poses of a box, or of what of it lies in a ball, belong to a set: branch and bound.
#pragma once

#include <core/scan/proof/ball.hpp>
#include <core/scan/proof/examiner.hpp>

#include <optional>
#include <span>
#include <vector>

namespace pmreport::scan {

class Containment {
 public:
  // All three must outlive it. `most_boxes`: looked at for one question.
  Containment(const PoseSet& set, const Scan& scan, std::uint64_t most_boxes, const Watch& watch);

  const std::vector<FreeAxis>& axes() const { return margins_.axes(); }
  std::uint64_t boxes() const { return boxes_; }  // looked at for all questions

  struct Answer {
    enum class Kind { inside, outside, open } kind = Kind::inside;
    int margin = -1;  // outside: that is negative at a pose; open: that was not decided when the proof ended
  };
  // Sides of the free axes, at every orientation of the scan; with `ball` of the poses that lie in it too.
  Answer ask(std::span<const program::Bounds> sides, const std::optional<Ball>& ball = {});

 private:
  struct Piece {
    Question question;
    std::vector<program::Bounds> sides;
  };
  std::uint32_t number_of(std::span<const std::uint64_t> set, std::uint32_t from);
  std::optional<Piece> halve(Piece& piece, std::span<const double> blame) const;
  std::optional<int> refuted_within(const Ball& ball, std::span<const Question> open);

  const Watch& watch_;
  std::uint64_t most_boxes_, boxes_ = 0;
  BoxedMargins margins_;
  MarginSets sets_;
  MarginPrograms programs_;
  Examiner examiner_;
  Examination examination_, of_points_;
  std::vector<std::size_t> uses_;  // of each set
};

}  // namespace pmreport::scan
