// What margins say of boxes of poses: all of it inside, none of it, or how much at least and at most.
#pragma once

#include <core/program/intervals/boxes.hpp>
#include <core/scan/proof/ball.hpp>
#include <core/scan/proof/boxed_margins.hpp>
#include <core/scan/proof/margin_sets.hpp>

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

namespace pmreport::scan {

// A box at an orientation, and the margins that are not yet known to hold throughout it.
struct Question {
  std::uint32_t box = 0;  // free axis q of box b lies between the bounds at b axes + q
  std::uint32_t orientation = 0;
  std::uint32_t set = 0;
};

struct Verdict {
  enum class Kind : std::uint8_t { outside, inside, open } kind = Kind::open;
  std::uint32_t set = 0;     // open: the margins that are left, as Examination::sets numbers them
  bool blind = false;        // open: a margin that is left has no bounds
  double low = 0, high = 1;  // the share of the box that belongs to the set lies between
  int margin = -1;           // that is negative all over; open: that is nearest to it
  double depth = 0;  // of that margin: its middle value over how far it may be from it, -1: nearly negative all over; with a ball its
                     // least value in the ball over how far it falls from the centre
  int middle = -1;   // a margin that is negative at the middle of the box, if there is one
};

struct Examination {
  explicit Examination(std::size_t margins) : sets(margins) {}
  std::vector<Verdict> verdicts;  // one a question
  // One a question and axis: how much of what is open is owed to the width along it, comparable within a box.
  std::vector<double> blame;
  // With a ball, one a question and axis: the pose of the ball where the margin that is nearest to negative is likely to be least.
  std::vector<double> lowest;
  MarginSets sets;
};

// Keeps its buffers: one a thread. What it takes must outlive it, and the sets and programs must not grow while it runs.
class Examiner {
 public:
  Examiner(const BoxedMargins& margins, const MarginSets& sets, const MarginPrograms& programs);
  ~Examiner();

  // The answers do not depend on how questions are put together. With `ball` a margin holds where it does at the poses of the box that lie
  // in it, and "inside" says no more; shares are of the whole box.
  void examine(std::span<const program::Bounds> boxes, std::span<const Question> questions, Examination& out, const Ball* ball = nullptr);

 private:
  struct Runner;
  struct Batch;
  Runner& runner(std::uint32_t number);
  void examine_batch(const Batch& batch, Runner& runner);
  void fill(const Batch& batch, Runner& runner);
  void weigh(const Batch& batch, const Runner& runner);

  const BoxedMargins& margins_;
  const MarginSets& sets_;
  const MarginPrograms& programs_;
  std::map<std::uint32_t, std::unique_ptr<Runner>> runners_;
  std::vector<std::uint32_t> order_;
};

// Verdicts of one box, of `open` orientations of which `need` must hold, put together: the share of the box where they do.
program::Bounds share_of_orientations(std::span<const program::Bounds> open, std::size_t need);

}  // namespace pmreport::scan
