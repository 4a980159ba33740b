#include <core/scan/proof/refine.hpp>

#include <core/program/intervals/interval.hpp>
#include <core/program/intervals/rounding.hpp>

#include <algorithm>
#include <array>
#include <bit>

namespace pmreport::scan {

using program::Bounds, program::Interval;

namespace {

// The axes to halve a box along: the one that is to blame most, and those that are nearly as much; three at most, so that no box has more
// than eight parts. Along an axis on which no number lies between the ends nothing can be halved.
std::uint16_t axes_to_split(std::span<const Bounds> sides, std::span<const double> blame, std::span<const FreeAxis> axes) {
  constexpr std::size_t most_at_once = 3;
  constexpr double nearly = 0.5;
  std::array<double, 16> due{};
  double most = 0;
  for (const bool of_width : {false, true}) {  // where nobody is to blame, the widest are
    for (std::size_t q = 0; q < sides.size(); ++q) {
      const double middle = sides[q].middle();
      if (!(sides[q].low < middle && middle < sides[q].high)) continue;
      due[q] = of_width ? sides[q].width() / axes[q].range.width() : blame[q];
      most = std::max(most, due[q]);
    }
    if (most > 0) break;
  }
  std::uint16_t split = 0;
  for (std::size_t n = 0; n < most_at_once && n < sides.size(); ++n) {
    const auto q = static_cast<std::size_t>(std::ranges::max_element(due) - due.begin());
    if (!(due[q] > 0 && due[q] >= nearly * most)) break;
    split = static_cast<std::uint16_t>(split | 1u << q);
    due[q] = 0;
  }
  return split;
}

void append_halves(std::span<const Bounds> sides, unsigned split, std::vector<Bounds>& out) {
  const unsigned parts = 1u << std::popcount(split);
  for (unsigned part = 0; part < parts; ++part) {
    unsigned bit = 0;
    for (std::size_t q = 0; q < sides.size(); ++q) {
      Bounds side = sides[q];
      if (split >> q & 1) (part >> bit++ & 1 ? side.low : side.high) = sides[q].middle();
      out.push_back(side);
    }
  }
}

Interval volume_of(std::span<const Bounds> sides) {
  Interval v(1.0);
  for (const Bounds& side : sides) v = v * (Interval(side.high) - Interval(side.low));
  return v;
}

// The examined parts, one after the other; where rounding goes upward.
class Sorter {
 public:
  Sorter(std::size_t need, const BoxedMargins& margins, Refined& out)
      : need_(need), margins_(margins), out_(out), blame_(margins.axes().size()) {}

  void take(std::span<const Bounds> sides, std::uint32_t sure, std::span<const Question> questions, std::size_t first) {
    bool blind = false;
    open_.clear(), shares_.clear();
    std::ranges::fill(blame_, 0);
    for (std::size_t k = 0; k < questions.size(); ++k) {
      const Verdict& verdict = out_.examination.verdicts[first + k];
      if (verdict.kind == Verdict::Kind::inside) ++sure;
      if (verdict.kind != Verdict::Kind::open) continue;
      if (out_.came_from[verdict.set] == Refined::nowhere) out_.came_from[verdict.set] = questions[k].set;
      open_.push_back({questions[k].orientation, verdict.set});
      blind = blind || verdict.blind;
      shares_.push_back({verdict.low, verdict.high});
      for (std::size_t q = 0; q < blame_.size(); ++q) blame_[q] += out_.examination.blame[(first + k) * blame_.size() + q];
    }
    if (sure + open_.size() < need_) return;
    const Interval volume = volume_of(sides);
    if (sure >= need_) {
      inside_ = inside_ + volume;
      ++out_.filled_count;
      for (std::size_t q = 0; q < sides.size(); ++q) out_.ends[q].filled(sides[q]);
      return;
    }
    const Interval covered = Interval(share_of_orientations(shares_, need_ - sure)) * volume;
    out_.open.add(sides, covered.bounds(), {sure, axes_to_split(sides, blame_, margins_.axes()), blind}, open_);
  }
  Bounds inside() const { return inside_.bounds(); }

 private:
  std::size_t need_;
  const BoxedMargins& margins_;
  Refined& out_;
  Interval inside_{0.0};
  std::vector<OpenOrientation> open_;
  std::vector<Bounds> shares_;
  std::vector<double> blame_;
};

}  // namespace

void Ends::may_hold(Bounds side) {
  least = std::min(least, side.low);
  greatest = std::max(greatest, side.high);
}
void Ends::has_one_in(Bounds side) {
  low_at_most = std::min(low_at_most, side.high);
  high_at_least = std::max(high_at_least, side.low);
}
void Ends::filled(Bounds side) {
  may_hold(side);
  low_at_most = std::min(low_at_most, side.low);
  high_at_least = std::max(high_at_least, side.high);
}
void Ends::add(const Ends& more) {
  may_hold({more.least, more.greatest});
  low_at_most = std::min(low_at_most, more.low_at_most);
  high_at_least = std::max(high_at_least, more.high_at_least);
}

void refine(const OpenBoxes& from, std::span<const std::uint32_t> which, std::size_t need, const BoxedMargins& margins, Examiner& examiner,
            Refined& out) {
  const std::size_t axes = margins.axes().size();
  std::vector<Bounds> parts;
  std::vector<Question> questions;
  std::vector<std::size_t> of_part, first;  // the box it came from; its first question
  for (const std::uint32_t k : which) {
    const unsigned split = from.state(k).split;
    append_halves(from.sides(k), split, parts);
    for (unsigned part = 0; part < 1u << std::popcount(split); ++part) {
      const auto number = static_cast<std::uint32_t>(of_part.size());
      of_part.push_back(k);
      first.push_back(questions.size());
      for (const OpenOrientation& o : from.open(k)) questions.push_back({number, o.orientation, o.set});
    }
  }
  first.push_back(questions.size());
  examiner.examine(parts, questions, out.examination);
  out.came_from.assign(out.examination.sets.size(), Refined::nowhere);
  out.boxes = of_part.size();
  program::round_upward([&] {
    Sorter sorter(need, margins, out);
    for (std::size_t p = 0; p < of_part.size(); ++p)
      sorter.take({parts.data() + p * axes, axes}, from.state(of_part[p]).sure,
                  std::span(questions).subspan(first[p], first[p + 1] - first[p]), first[p]);
    out.filled = sorter.inside();
  });
}

Bounds sum(std::span<const Bounds> terms) {
  return program::round_upward([&] {
    Interval total(0.0);
    for (const Bounds& x : terms) total = total + Interval(x);
    return total.bounds();
  });
}

}  // namespace pmreport::scan
