#include <core/scan/proof/examiner.hpp>

#include <core/program/intervals/interval.hpp>
#include <core/program/intervals/rounding.hpp>
#include <core/scan/proof/half_space.hpp>

#include <algorithm>
#include <array>
#include <limits>

namespace pmreport::scan {

namespace {

using program::Bounds, program::Boxes, program::Interval;

constexpr std::size_t most_boxes = 60;  // of a call: enough to pay for choosing an instruction, and no power of two, which caches dislike
constexpr std::size_t most_runners = 256;  // kept by a thread

// The box along one axis about m, the number near its middle that margins are computed at: x = m + offset + half u, u in [-1, 1].
struct Side {
  Interval offset, half;
};
Side side(Bounds x, double middle) {
  const Interval low(x.low), high(x.high), m(middle);
  return {((low - m) + (high - m)) * 0.5, (high - low) * 0.5};
}

// A margin over a box. By the mean value theorem there are, for each pose of the box, a_q within the bounds A_q of the partial derivatives
// over it with
//     g = g(m) + sum of a_q (offset_q + half_q u_q) = c + sum of w_q u_q + r,   |r| <= spread,      (1)
// where c = g(m) + sum of A_q offset_q, w_q is any number in the middle of A_q half_q, and spread the sum of the largest |A_q half_q -
// w_q|. So g >= 0 on no less than the share of the half-space c.low - spread + w.u >= 0, and on no more than that of c.high + spread + w.u
// >= 0.
struct Centred {
  Interval value = Interval::unbounded();  // over the box
  bool linear = false;                     // (1) is known
  Interval centre{0.0};                    // c
  double spread = 0;                       // of all axes
  std::array<double, most_axes> w{};
  double low = 0, high = 0;      // g >= 0 on no less than low + w.u >= 0, no more than high + w.u >= 0; where `value` is bounded
  double middle = 0, scale = 0;  // of g, and how far it may be from it
  std::array<double, most_axes> spread_along{};  // what of low to high is owed to the width along an axis, over two
};

// What g varies by beyond what is owed to axes with bounds is owed to the others. Sums of magnitudes are negative, and so no greater
// than they are.
void bound_by_slopes(Centred& g, const Bounds* partials, std::size_t stride, std::span<const Side> sides) {
  g.w.fill(0), g.spread_along.fill(0);
  double minus_weight = 0, owed = 0, others = 0;
  for (std::size_t q = 0; q < sides.size(); ++q) {
    const Interval rise = Interval(partials[q * stride]) * sides[q].half;
    if (!rise.bounded()) {
      ++others;
      continue;
    }
    g.w[q] = 0 < rise.low() ? rise.low() : std::min(rise.high, 0.0);
    minus_weight -= std::abs(g.w[q]);
    g.spread_along[q] = rise.magnitude() - std::abs(g.w[q]);
    owed += rise.magnitude();
  }
  g.low = -(g.value.negative_low + minus_weight);
  g.high = g.value.high + minus_weight;
  g.middle = g.value.middle();
  g.scale = 0.5 * g.value.width();
  for (std::size_t q = 0; q < sides.size(); ++q)
    if (!partials[q * stride].bounded()) g.spread_along[q] = std::max(0.0, g.scale - owed) / others;
}

Centred centred(const Bounds* natural, const Bounds* middle, const Bounds* partials, std::size_t stride, std::span<const Side> sides) {
  Centred g;
  g.value = Interval(*natural);
  g.centre = Interval(*middle);
  g.linear = g.centre.bounded();
  double reach = 0, weight = 0;
  for (std::size_t q = 0; q < sides.size() && g.linear; ++q) {
    const Interval slope(partials[q * stride]), rise = slope * sides[q].half;
    g.centre += slope * sides[q].offset;
    g.linear = rise.bounded() && g.centre.bounded();
    if (!g.linear) break;
    g.w[q] = rise.middle();
    g.spread_along[q] = (rise - g.w[q]).magnitude();
    g.spread += g.spread_along[q];
    weight += std::abs(g.w[q]);
    reach += rise.magnitude();
  }
  if (g.linear) {
    g.value = common(g.value, g.centre + Interval(-reach, reach));
    g.low = -(g.centre.negative_low + g.spread);
    g.high = g.centre.high + g.spread;
    g.middle = g.centre.middle();
    g.scale = weight + g.spread;
  } else if (g.value.bounded()) {
    bound_by_slopes(g, partials, stride, sides);
  }
  return g;
}

// The least that (1) lets the margin be within a ball about z with half axes R p, x = z + R p t, |t| <= 1: that of a linear function,
//     c + sum of (w_q / half_q) (z_q - m_q - offset_q) - R |(w_q p_q / half_q)| - spread.
// Where it has that least is likely to be where the margin has its own.
struct Within {
  double least = -std::numeric_limits<double>::infinity();
  double depth = -1;  // the linear function's least, over what it changes by along the radius
  std::array<double, most_axes> lowest{};
};
Within within(const Centred& g, std::span<const Side> sides, std::span<const double> middles, const Ball& ball) {
  Within out;
  std::array<double, most_axes> slopes{};
  Interval at_centre = g.centre, square_of_slope(0.0);
  for (std::size_t q = 0; q < sides.size(); ++q) {
    out.lowest[q] = ball.centre[q];
    if (g.w[q] == 0) continue;
    const Interval slope = Interval(g.w[q]) / sides[q].half;
    at_centre += slope * (Interval(ball.centre[q]) - middles[q] - sides[q].offset);
    square_of_slope += square(slope * ball.proportions[q]);
    slopes[q] = slope.middle() * ball.proportions[q];
  }
  const Interval fall = Interval(ball.radius) * sqrt(square_of_slope), least = at_centre - fall;
  if (!least.bounded() || !(fall.high > 0)) return out;
  out.least = -(least.negative_low + g.spread);
  out.depth = least.middle() / fall.high;
  for (std::size_t q = 0; q < sides.size(); ++q) out.lowest[q] -= ball.radius * ball.proportions[q] * slopes[q] * ball.radius / fall.high;
  return out;
}

}  // namespace

struct Examiner::Runner {
  Runner(const MarginProgram& what, std::size_t inputs, std::size_t coordinates, std::size_t guides)
      : program(&what),
        over(what.with_partials),
        at(what.values),
        in(inputs * most_boxes),
        in_middle(inputs * most_boxes),
        out(what.with_partials.outputs().size() * most_boxes),
        out_middle(what.values.outputs().size() * most_boxes),
        guided(std::ranges::any_of(what.inputs, [&](std::uint32_t i) { return coordinates <= i && i < coordinates + guides; })) {
    if (guided) middles.resize(coordinates * most_boxes), chosen.resize(guides * most_boxes);
  }

  const MarginProgram* program;
  Boxes over, at;
  std::vector<Bounds> in, in_middle, out, out_middle;
  bool guided;
  std::vector<double> middles, chosen;
};

struct Examiner::Batch {
  std::span<const Bounds> boxes;
  std::span<const Question> questions;     // all
  std::span<const std::uint32_t> numbers;  // of those of the batch
  Examination* out;
  const Ball* ball;
};

Examiner::Examiner(const BoxedMargins& margins, const MarginSets& sets, const MarginPrograms& programs)
    : margins_(margins), sets_(sets), programs_(programs) {}
Examiner::~Examiner() = default;

Examiner::Runner& Examiner::runner(std::uint32_t number) {
  if (const auto found = runners_.find(number); found != runners_.end()) return *found->second;
  if (runners_.size() >= most_runners) runners_.clear();
  auto made = std::make_unique<Runner>(programs_.program(number), static_cast<std::size_t>(margins_.values().inputs()),
                                       margins_.coordinates(), margins_.guides());
  return *runners_.emplace(number, std::move(made)).first->second;
}

void Examiner::examine(std::span<const Bounds> boxes, std::span<const Question> questions, Examination& out, const Ball* ball) {
  out.verdicts.assign(questions.size(), {});
  out.blame.assign(questions.size() * margins_.axes().size(), 0);
  out.lowest.assign(ball != nullptr ? out.blame.size() : 0, 0);
  order_.resize(questions.size());
  for (std::uint32_t i = 0; i < order_.size(); ++i) order_[i] = i;
  const auto number = [&](std::uint32_t i) { return programs_.number(questions[i].set); };
  std::ranges::stable_sort(order_, {}, number);
  for (std::size_t from = 0, to = 0; from < order_.size(); from = to) {
    while (to < order_.size() && to - from < most_boxes && number(order_[to]) == number(order_[from])) ++to;
    examine_batch({boxes, questions, std::span(order_).subspan(from, to - from), &out, ball}, runner(number(order_[from])));
  }
}

void Examiner::examine_batch(const Batch& batch, Runner& runner) {
  const std::size_t count = batch.numbers.size();
  fill(batch, runner);
  runner.over.run(count, runner.in.data(), runner.out.data());
  runner.at.run(count, runner.in_middle.data(), runner.out_middle.data());
  program::round_upward([&] { weigh(batch, runner); });
}

void Examiner::fill(const Batch& batch, Runner& runner) {
  const std::size_t count = batch.numbers.size(), axes = margins_.axes().size();
  for (const std::uint32_t i : runner.program->inputs)
    for (std::size_t k = 0; k < count; ++k)
      runner.in[i * count + k] = runner.in_middle[i * count + k] = margins_.fixed(batch.questions[batch.numbers[k]].orientation)[i];
  for (std::size_t q = 0; q < axes; ++q)
    for (std::size_t k = 0; k < count; ++k) {
      const Bounds x = batch.boxes[batch.questions[batch.numbers[k]].box * axes + q];
      const std::size_t at = static_cast<std::size_t>(margins_.axes()[q].input) * count + k;
      runner.in[at] = x;
      runner.in_middle[at] = Bounds::exactly(x.middle());
    }
  if (!runner.guided) return;
  const std::size_t coordinates = margins_.coordinates();
  for (std::size_t i = 0; i < coordinates; ++i)
    for (std::size_t k = 0; k < count; ++k)
      runner.middles[i * count + k] = margins_.fixed(batch.questions[batch.numbers[k]].orientation)[i].middle();
  for (std::size_t q = 0; q < axes; ++q) {
    const auto i = static_cast<std::size_t>(margins_.axes()[q].input);
    for (std::size_t k = 0; k < count; ++k) runner.middles[i * count + k] = runner.in_middle[i * count + k].low;
  }
  margins_.choose_guides(count, runner.middles.data(), runner.chosen.data());
  for (std::size_t e = 0; e < margins_.guides() * count; ++e)
    runner.in[coordinates * count + e] = runner.in_middle[coordinates * count + e] = Bounds::exactly(runner.chosen[e]);
}

void Examiner::weigh(const Batch& batch, const Runner& runner) {
  const std::size_t count = batch.numbers.size(), axes = margins_.axes().size(), words = sets_.words();
  const std::vector<std::uint32_t>& margins = runner.program->margins;
  std::vector<std::uint64_t> left(words);
  std::array<Side, most_axes> sides{};
  std::array<double, most_axes> spreads{}, weights{}, middles{};
  for (std::size_t k = 0; k < count; ++k) {
    const Question& question = batch.questions[batch.numbers[k]];
    const std::span<const std::uint64_t> asked = sets_.bits(question.set);
    Verdict& verdict = batch.out->verdicts[batch.numbers[k]];
    for (std::size_t q = 0; q < axes; ++q) {
      middles[q] = runner.in_middle[static_cast<std::size_t>(margins_.axes()[q].input) * count + k].low;
      sides[q] = side(batch.boxes[question.box * axes + q], middles[q]);
    }
    std::ranges::fill(left, 0);
    spreads.fill(0), weights.fill(0);
    std::size_t open = 0;
    double missing = 0;  // no less than the share that is outside
    verdict.depth = std::numeric_limits<double>::infinity();

    for (std::size_t i = 0; i < margins.size(); ++i) {
      const std::uint32_t m = margins[i];
      if (!(asked[m / 64] >> m % 64 & 1)) continue;
      const Bounds* at_middle = &runner.out_middle[i * count + k];
      const Centred g =
          centred(&runner.out[i * count + k], at_middle, &runner.out[(margins.size() + i * axes) * count + k], count, {sides.data(), axes});
      if (g.value.bounded() && g.value.high < 0) {
        verdict = {Verdict::Kind::outside, 0, false, 0, 0, static_cast<int>(m), -1, static_cast<int>(m)};
        break;
      }
      if (g.value.bounded() && 0 <= g.value.low()) continue;
      Within ball;
      if (batch.ball != nullptr && g.linear) ball = within(g, {sides.data(), axes}, {middles.data(), axes}, *batch.ball);
      if (0 <= ball.least) continue;
      ++open;
      left[m / 64] |= std::uint64_t{1} << m % 64;
      if (verdict.middle < 0 && at_middle->bounded() && at_middle->high < 0) verdict.middle = static_cast<int>(m);
      double depth = -1;
      if (g.value.bounded()) {
        const Bounds share = half_space_share_upward({g.low, g.high}, {g.w.data(), axes});
        missing += 1 - share.low;
        verdict.high = std::min(verdict.high, share.high);
        if (g.scale > 0) depth = g.middle / g.scale;
        for (std::size_t q = 0; q < axes && g.scale > 0; ++q) {
          spreads[q] += g.spread_along[q] / g.scale;
          weights[q] += std::abs(g.w[q]) / g.scale;
        }
      } else {
        missing += 1;
        verdict.blind = true;
        for (std::size_t q = 0; q < axes; ++q)
          spreads[q] += batch.boxes[question.box * axes + q].width() / margins_.axes()[q].range.width();
      }
      if (batch.ball != nullptr) depth = ball.depth;
      if (depth < verdict.depth) {
        verdict.depth = depth, verdict.margin = static_cast<int>(m);
        if (batch.ball != nullptr)
          std::copy_n(ball.lowest.begin(), axes, batch.out->lowest.begin() + static_cast<std::ptrdiff_t>(batch.numbers[k] * axes));
      }
    }
    if (verdict.kind == Verdict::Kind::outside) continue;
    if (open == 0) {
      verdict = {Verdict::Kind::inside, 0, false, 1, 1, -1, 1, -1};
      continue;
    }
    // One margin is open for how it bends alone, which its halves do a quarter of; several also for what each of them covers.
    for (std::size_t q = 0; q < axes; ++q) batch.out->blame[batch.numbers[k] * axes + q] = open > 1 ? spreads[q] + weights[q] : spreads[q];
    verdict.set = batch.out->sets.add(left);
    verdict.low = std::max(0.0, -(missing - 1));
  }
}

// Where `need` of the open hold, one at least does of any m - need + 1 of them: no more than the sum of the m - need + 1 least shares. And
// where they do not, one at least of any `need` of them fails.
Bounds share_of_orientations(std::span<const Bounds> open, std::size_t need) {
  if (open.size() == 1) return open.front();
  std::vector<double> missing, high;
  return program::round_upward([&]() -> Bounds {
    for (const Bounds& b : open) missing.push_back(1 - b.low), high.push_back(b.high);
    std::ranges::sort(missing);
    std::ranges::sort(high);
    double most = 0, fails = 0;
    for (std::size_t i = 0; i + need < open.size() + 1; ++i) most += high[i];
    for (std::size_t i = 0; i < need; ++i) fails += missing[i];
    return {std::max(0.0, -(fails - 1)), std::min(1.0, most)};
  });
}

}  // namespace pmreport::scan
