// What is said of single boxes, attacked with random poses in extended precision.
#include <catch2/catch.hpp>
#include <core/scan/proof/examiner.hpp>
#include <tests/scan/legs.hpp>

#include <random>

using namespace pmreport;
using namespace pmreport::scan;
using program::Bounds;

namespace {

struct Attack {
  std::size_t inside = 0, outside = 0, open = 0;  // verdicts
  std::size_t false_inside = 0, false_outside = 0, false_shares = 0;
};

// Boxes of `claimed`, of which the poses of the legs tell what is true; `dropped`: a margin that is not asked about.
Attack attack(const PoseSet& claimed, int dropped) {
  constexpr int inputs = 4, boxes = 200, poses = 200;
  const Scan scan = leg_scan(inputs, 0.16, 0.16);  // about as wide as what the legs allow
  const BoxedMargins margins(claimed, scan);
  MarginSets sets(margins.margins());
  MarginPrograms programs(margins, sets);
  programs.inherit(sets.add_all(margins.margins()), 0);
  std::vector<std::uint64_t> bits(sets.bits(0).begin(), sets.bits(0).end());
  if (dropped >= 0) bits[0] &= ~(std::uint64_t{1} << dropped);
  const std::uint32_t set = sets.add(bits);
  if (set > 0) programs.inherit(set, 0);
  Examiner examiner(margins, sets, programs);
  Examination examination(margins.margins());

  std::mt19937_64 random(31);
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<Bounds> sides;
  std::vector<Question> questions;
  for (std::uint32_t b = 0; b < boxes; ++b) {
    const double size = 0.3 * std::exp2(-5 * share(random));
    for (const FreeAxis& axis : margins.axes()) {
      const double low = axis.range.low + (1 - size) * axis.range.width() * share(random);
      sides.push_back({low, low + size * axis.range.width() * share(random)});
    }
    questions.push_back({b, 0, set});
  }
  examiner.examine(sides, questions, examination);

  Attack found;
  std::vector<long double> x(inputs);
  for (std::size_t b = 0; b < boxes; ++b) {
    const Verdict& verdict = examination.verdicts[b];
    int kept = 0;
    for (int k = 0; k < poses; ++k) {
      for (std::size_t a = 0; a < inputs; ++a) {
        const Bounds side = sides[b * inputs + a];
        x[a] = side.low + static_cast<long double>(share(random)) * (static_cast<long double>(side.high) - side.low);
      }
      kept += least_margin(x).first >= 0;
    }
    // Five standard deviations of a count of so many, and one pose.
    const double counted = double(kept) / poses, slack = 5 * std::sqrt(0.25 / poses) + 1.0 / poses;
    found.inside += verdict.kind == Verdict::Kind::inside;
    found.outside += verdict.kind == Verdict::Kind::outside;
    found.open += verdict.kind == Verdict::Kind::open;
    found.false_inside += verdict.kind == Verdict::Kind::inside && kept < poses;
    found.false_outside += verdict.kind == Verdict::Kind::outside && kept > 0;
    found.false_shares += verdict.kind == Verdict::Kind::open && (counted < verdict.low - slack || verdict.high + slack < counted);
  }
  return found;
}

}  // namespace

TEST_CASE("No pose contradicts what is said of boxes: a margin that is dropped, or has the wrong sign, is found out") {
  const Attack right = attack(leg_set(4), -1);
  CAPTURE(right.inside, right.outside, right.open);
  CHECK(right.inside > 10);
  CHECK(right.outside > 10);
  CHECK(right.open > 10);
  CHECK(right.false_inside == 0);
  CHECK(right.false_outside == 0);
  CHECK(right.false_shares == 0);

  std::size_t found_out = 0;
  for (const int m : {2, 5, 8, 11}) {  // one leg's greatest length each
    const Attack wrong = attack(leg_set(4), m);
    found_out += wrong.false_inside + wrong.false_shares > 0;
  }
  CHECK(found_out > 0);

  program::Recorder recorder(4);
  std::vector<Recorded> x;
  for (int i = 0; i < 4; ++i) x.push_back(recorder.input(i));
  std::vector<Recorded> margins = leg_margins(x);
  margins[2] = -margins[2];
  const Attack turned = attack({recorder.finish(margins), std::vector<double>(margins.size(), 0.0), {}}, -1);
  CHECK(turned.false_outside > 0);
}
