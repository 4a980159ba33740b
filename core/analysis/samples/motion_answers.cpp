#include <core/analysis/samples/motion_answers.hpp>

#include <limits>

namespace pmreport::analysis {

using mechanics::Matrix6d;
using mechanics::Outcome;

namespace {

std::span<const double> numbers(const Matrix6d& m) { return {m.data(), static_cast<std::size_t>(m.size())}; }
std::span<double> numbers(Matrix6d& m) { return {m.data(), static_cast<std::size_t>(m.size())}; }

}  // namespace

MotionAnswers::MotionAnswers(const Shape& shape, std::size_t samples)
    : outcomes(samples, Outcome::good), wrenches(samples), reactions(shape.joints) {
  for (const ColumnId& id : shape.columns) columns.add(id, samples);
  if (shape.compliances) compliances.assign(samples, Matrix6d::Constant(std::numeric_limits<double>::quiet_NaN()));
}

const std::string& MotionAnswers::reason(int sample) const {
  static const std::string none;
  if (outcomes[static_cast<std::size_t>(sample)] == Outcome::good) return none;
  const auto after = why.upper_bound(sample);
  return after != why.begin() ? std::prev(after)->second : none;
}

chunks::Bytes MotionAnswers::bytes() const {
  chunks::Writer to;
  constexpr std::size_t besides = 128;  // of a sample, beside its columns and its compliance
  to.reserve(samples() * (columns.count() * sizeof(double) + besides) + compliances.size() * sizeof(Matrix6d));
  for (const Outcome o : outcomes) to.put(o);
  for (const HoldingWrenches& w : wrenches) to.put(w.side), to.put(w.determinant), to.put(w.condition), to.put(w.amplification);
  to.put(std::uint64_t{why.size()});
  for (const auto& [sample, sentence] : why) to.put(sample), to.put(sentence);
  columns.put(to);
  residuals.put(to);
  reactions.put(to);
  for (const Matrix6d& c : compliances) to.put_all(numbers(c));
  return to.take();
}

void MotionAnswers::take(std::span<const std::byte> block, std::size_t first, std::size_t count) {
  chunks::Reader from(block);
  for (Outcome& o : std::span(outcomes).subspan(first, count)) from.get(o);
  for (HoldingWrenches& w : std::span(wrenches).subspan(first, count))
    from.get(w.side), from.get(w.determinant), from.get(w.condition), from.get(w.amplification);
  std::uint64_t sentences = 0;
  for (from.get(sentences); sentences > 0; --sentences) {
    int sample = 0;
    std::string sentence;
    from.get(sample), from.get(sentence);
    if (why.empty() || why.rbegin()->second != sentence) why.emplace(sample, std::move(sentence));
  }
  columns.get(from, first, count);
  Residuals more;
  more.get(from);
  residuals.join(more);
  ReactionFindings found = reactions;
  found.get(from);
  reactions.join(found);
  if (!compliances.empty())
    for (Matrix6d& c : std::span(compliances).subspan(first, count)) from.get_all(numbers(c));
  from.end();
}

}  // namespace pmreport::analysis
