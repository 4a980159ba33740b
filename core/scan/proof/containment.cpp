#include <core/scan/proof/containment.hpp>

#include <algorithm>
#include <functional>

namespace pmreport::scan {

using program::Bounds;

namespace {

constexpr std::size_t pieces_at_once = 60;      // one call of the program
constexpr std::size_t uses_of_a_program = 256;  // from so many on it pays to make one for a set alone

}  // namespace

Containment::Containment(const PoseSet& set, const Scan& scan, std::uint64_t most_boxes, const Watch& watch)
    : watch_(watch),
      most_boxes_(most_boxes),
      margins_(set, scan),
      sets_(margins_.margins()),
      programs_(margins_, sets_),
      examiner_(margins_, sets_, programs_),
      examination_(margins_.margins()),
      of_points_(margins_.margins()),
      uses_(1) {
  programs_.inherit(sets_.add_all(margins_.margins()), 0);
}

std::uint32_t Containment::number_of(std::span<const std::uint64_t> set, std::uint32_t from) {
  const std::uint32_t number = sets_.add(set);
  if (number == uses_.size()) {
    programs_.inherit(number, from);
    uses_.push_back(0);
  }
  if (++uses_[number] == uses_of_a_program) programs_.give_own(number);
  return number;
}

// Along the axis that is to blame most; where none is, or cannot be halved, along the widest. Nothing: as narrow as numbers are.
std::optional<Containment::Piece> Containment::halve(Piece& piece, std::span<const double> blame) const {
  std::size_t best = piece.sides.size();
  double most = 0, widest = 0;
  for (std::size_t q = 0; q < piece.sides.size(); ++q) {
    const Bounds side = piece.sides[q];
    const double middle = side.middle(), width = side.width() / margins_.axes()[q].range.width();
    if (!(side.low < middle && middle < side.high)) continue;
    if (blame[q] > most || (most == 0 && width > widest)) best = q, most = blame[q], widest = width;
  }
  if (best == piece.sides.size()) return {};
  Piece other = piece;
  piece.sides[best].high = other.sides[best].low = piece.sides[best].middle();
  return other;
}

// Of the poses of the ball where margins are likely to be least, one that is refused.
std::optional<int> Containment::refuted_within(const Ball& ball, std::span<const Question> open) {
  constexpr double within = 1 - 1e-9;  // and so surely of the ball
  const std::size_t axes = margins_.axes().size();
  std::vector<Bounds> points;
  std::vector<Question> questions;
  for (Question question : open) {
    std::vector<Bounds> point;
    for (std::size_t q = 0; q < axes; ++q)
      point.push_back(Bounds::exactly(ball.centre[q] + within * (examination_.lowest[question.box * axes + q] - ball.centre[q])));
    if (!relation(ball, point).middle_in) continue;
    question.box = static_cast<std::uint32_t>(questions.size());
    questions.push_back(question);
    points.insert(points.end(), point.begin(), point.end());
  }
  examiner_.examine(points, questions, of_points_);
  for (const Verdict& verdict : of_points_.verdicts)
    if (verdict.kind == Verdict::Kind::outside) return verdict.margin;
  return {};
}

// Depth first, the pieces on top of the stack that are most nearly outside: an answer "outside" is found soon, and few pieces wait.
Containment::Answer Containment::ask(std::span<const Bounds> sides, const std::optional<Ball>& ball) {
  using Kind = Answer::Kind;
  const std::size_t axes = margins_.axes().size();
  std::vector<Piece> stack;
  for (std::uint32_t o = 0; o < margins_.orientations(); ++o) stack.push_back({{0, o, 0}, {sides.begin(), sides.end()}});
  Examination& examination = examination_;
  std::uint64_t looked_at = 0;
  while (!stack.empty()) {
    watch_.stop_if_asked();
    std::vector<Piece> pieces;
    std::vector<BallAndBox> relations;
    std::vector<Bounds> boxes;
    std::vector<Question> questions;
    while (!stack.empty() && pieces.size() < pieces_at_once) {
      Piece piece = std::move(stack.back());
      stack.pop_back();
      const BallAndBox r = ball ? relation(*ball, piece.sides) : BallAndBox{false, true, true};
      if (r.apart) continue;
      piece.question.box = static_cast<std::uint32_t>(pieces.size());
      boxes.insert(boxes.end(), piece.sides.begin(), piece.sides.end());
      questions.push_back(piece.question);
      relations.push_back(r);
      pieces.push_back(std::move(piece));
    }
    examiner_.examine(boxes, questions, examination, ball ? &*ball : nullptr);
    boxes_ += pieces.size(), looked_at += pieces.size();

    std::vector<std::size_t> open;
    std::vector<Question> open_questions;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const Verdict& verdict = examination.verdicts[k];
      if (verdict.kind == Verdict::Kind::inside) continue;
      if (verdict.middle >= 0 && relations[k].middle_in) return {Kind::outside, margins_.part_of(verdict.middle)};
      if (verdict.kind == Verdict::Kind::outside && relations[k].nearest_in) return {Kind::outside, margins_.part_of(verdict.margin)};
      open.push_back(k);
      if (verdict.kind == Verdict::Kind::open) open_questions.push_back(questions[k]);
    }
    if (ball)
      if (const std::optional<int> margin = refuted_within(*ball, open_questions)) return {Kind::outside, margins_.part_of(*margin)};
    std::ranges::stable_sort(open, std::greater<>(), [&](std::size_t k) { return examination.verdicts[k].depth; });
    if (!open.empty() && looked_at >= most_boxes_) return {Kind::open, margins_.part_of(examination.verdicts[open.back()].margin)};
    for (const std::size_t k : open) {
      const Verdict& verdict = examination.verdicts[k];
      if (verdict.kind == Verdict::Kind::open)
        pieces[k].question.set = number_of(examination.sets.bits(verdict.set), pieces[k].question.set);
      std::optional<Piece> other = halve(pieces[k], std::span(examination.blame).subspan(k * axes, axes));
      if (!other) return {Kind::open, margins_.part_of(verdict.margin)};
      stack.push_back(std::move(pieces[k]));
      stack.push_back(std::move(*other));
    }
  }
  return {Kind::inside, -1};
}

}  // namespace pmreport::scan
