#include <tests/scan/sets.hpp>

#include <catch2/catch.hpp>
#include <core/program/evaluate.hpp>

#include <cmath>
#include <limits>

namespace sets {

namespace {

constexpr double rounding = 1e-12;  // of margins of about 1 from some ten operations: far above their rounding, far below what counts

}  // namespace

scan::PoseSet three_legs() {
  const program::Program margins = recording::recorded(5, [](const std::vector<Recorded>& q) {
    const Recorded &x = q[0], &y = q[1], &z = q[2];
    const Recorded c = cos(q[3]), s = sin(q[3]), ct = cos(q[4]), st = sin(q[4]);
    std::vector<Recorded> out{3.0 - x * x - y * y - z * z};
    std::vector<Recorded> late;
    for (int i = 0; i < 3; ++i) {
      const double at = 2.0 * i, bx = 0.25 * std::cos(at), by = 0.25 * std::sin(at);
      // The joint on the platform, turned about z and tilted about x; the joint on the base lies twice as far out.
      const Recorded px = bx * ct - by * st, py = (bx * st + by * ct) * c, pz = (bx * st + by * ct) * s;
      const Recorded u = x + px - 2 * bx, v = y + py - 2 * by, w = z + pz;
      const Recorded squared = u * u + v * v + w * w;
      out.push_back(squared - 0.25);
      out.push_back(2.25 - squared);
      late.push_back(w - 0.5 * sqrt(squared));
    }
    out.push_back(x * x + y * y + z * z - 1.0);
    for (const Recorded& m : late) out.push_back(m);
    out.push_back(choose(x < y, y - x, 2.0 * (x - y)) - 0.125);
    out.push_back(sqrt(x + 0.75) + 0.25 * s);
    return out;
  });
  return {margins, std::vector<double>(margins.outputs().size(), rounding), {}};
}

scan::PoseSet shell(double r1, double r2) {
  const program::Program margins = recording::recorded(3, [&](const std::vector<Recorded>& q) {
    const Recorded squared = q[0] * q[0] + q[1] * q[1] + q[2] * q[2];
    return std::vector<Recorded>{squared + 1.0, squared - r1 * r1, r2 * r2 - squared};
  });
  return {margins, std::vector<double>(3, rounding), {}};
}

program::Program plane() {
  return recording::recorded(5, [](const std::vector<Recorded>& q) { return std::vector<Recorded>{q[0] + q[1] + q[2] + q[3] - 0.25}; });
}

scan::Scan any_scan(Random& random, bool turned) {
  const auto whole = [&](double min, double max) { return static_cast<std::size_t>(random.within(min, max)); };
  scan::Scan s;
  s.at = {0.25, 0.0, 0.75, 0.125, 0.5};
  const int orders[][3] = {{0, 1, 2}, {2, 0, 1}, {1, 2, 0}};
  for (const int input : orders[whole(0, 3)]) {
    scan::Axis axis{input, -1.5, 1.5, 13};
    if (whole(0, 3) == 0) axis = {input, 2.0, -1.0, 25};
    if (whole(0, 4) == 0) axis = {input, random.within(-1, 0), random.within(0.5, 1.5), 11};
    if (whole(0, 6) == 0) axis = {input, 0.25, 0.25, whole(1, 4)};
    s.points.push_back(axis);
  }
  if (!turned) return s;
  s.turned = {4, 3};
  for (std::size_t k = 0, n = whole(2, 20); k < n; ++k) s.orientations.push_back({random.within(-1, 1), random.within(-0.5, 0.5)});
  s.orientations.push_back(s.orientations.front());
  return s;
}

scan::GridCounts brute_force(const scan::PoseSet& set, const scan::Scan& scan, const scan::GridOptions& options) {
  const std::size_t margins = set.margins.outputs().size(), all = set.size(), orientations = scan.orientation_count();
  program::Evaluator<double> evaluator(set.margins);
  scan::GridCounts out;
  if (options.reasons) out.tally.first.assign(all, 0), out.tally.any.assign(all, 0);
  out.accepted_at.resize(scan.point_count());
  const std::size_t words = options.keep_poses ? (scan.point_count() * orientations + 63) / 64 : 0;
  out.accepted_poses.resize(words);
  if (options.sign != nullptr) out.positive_poses.resize(words), out.negative_poses.resize(words);
  std::vector<double> q, m(all), sums(scan.points.size(), 0.0);
  for (std::size_t point = 0; point < scan.point_count(); ++point)
    for (std::size_t o = 0; o < orientations; ++o) {
      q = scan.at;
      std::size_t rest = point;
      for (std::size_t a = scan.points.size(); a-- > 0; rest /= scan.points[a].count)
        q[static_cast<std::size_t>(scan.points[a].input)] = scan.points[a].value(rest % scan.points[a].count);
      for (std::size_t i = 0; i < scan.turned.size(); ++i) q[static_cast<std::size_t>(scan.turned[i])] = scan.orientations[o][i];
      evaluator.run(q, std::span(m).first(margins));
      if (set.late.size > 0) set.late.judge(1, q.data(), m.data() + margins);
      ++out.tally.poses;
      bool accepted = true, on_a_limit = false;
      for (std::size_t k = 0; k < all; ++k) {
        const bool kept = m[k] >= -set.rounding[k];
        on_a_limit = on_a_limit || (kept && m[k] <= set.rounding[k]);
        if (!kept && options.reasons) ++out.tally.any[k], out.tally.first[k] += accepted;
        accepted = accepted && kept;
        if (k == 0 && !kept) break;
      }
      if (!accepted) continue;
      ++out.tally.accepted;
      out.tally.on_a_limit += on_a_limit;
      ++out.accepted_at[point];
      const std::size_t pose = point * orientations + o;
      const auto mark = [&](std::vector<std::uint64_t>& to) {
        if (words > 0) to[pose / 64] |= std::uint64_t{1} << pose % 64;
      };
      mark(out.accepted_poses);
      for (std::size_t a = 0; a < sums.size(); ++a) {
        const double x = q[static_cast<std::size_t>(scan.points[a].input)];
        if (out.low.size() <= a) out.low.push_back(x), out.high.push_back(x);
        out.low[a] = std::min(out.low[a], x), out.high[a] = std::max(out.high[a], x);
        sums[a] += x;
      }
      if (options.sign == nullptr) continue;
      double sign = 0;
      program::Evaluator<double>(*options.sign).run(q, std::span(&sign, 1));
      out.positive += sign > 0, out.negative += sign < 0;
      if (sign > 0) mark(out.positive_poses);
      if (sign < 0) mark(out.negative_poses);
    }
  if (out.tally.accepted > 0)
    for (const double s : sums) out.centroid.push_back(s / static_cast<double>(out.tally.accepted));
  return out;
}

void check_same(const scan::GridCounts& a, const scan::GridCounts& b) {
  CHECK(a.tally.poses == b.tally.poses);
  CHECK(a.tally.accepted == b.tally.accepted);
  CHECK(a.tally.on_a_limit == b.tally.on_a_limit);
  CHECK(a.tally.first == b.tally.first);
  CHECK(a.tally.any == b.tally.any);
  CHECK((a.accepted_at == b.accepted_at));
  CHECK(a.low == b.low);
  CHECK(a.high == b.high);
  REQUIRE(a.centroid.size() == b.centroid.size());
  // Up to some ten thousand numbers of no more than 2, added in another order.
  for (std::size_t k = 0; k < a.centroid.size(); ++k) CHECK(std::abs(a.centroid[k] - b.centroid[k]) < 1e-11);
  CHECK(a.positive == b.positive);
  CHECK(a.negative == b.negative);
  CHECK((a.accepted_poses == b.accepted_poses));
  CHECK((a.positive_poses == b.positive_poses));
  CHECK((a.negative_poses == b.negative_poses));
}

}  // namespace sets
