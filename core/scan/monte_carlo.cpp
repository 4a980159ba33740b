#include <core/scan/monte_carlo.hpp>

#include <core/scan/judge/judge.hpp>
#include <core/scan/judge/kernel.hpp>
#include <core/scan/judge/orientations.hpp>
#include <core/scan/pace.hpp>
#include <core/scan/philox.hpp>

#include <fmt/core.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <stdexcept>

namespace pmreport::scan {

namespace {

constexpr std::uint64_t chunk = 4096;  // points that are judged at a time
constexpr std::size_t group = 4096;    // orientations that are prepared at a time

// Points of one chunk. Keeps its buffers: one a thread.
class Points {
 public:
  Points(const Plan& plan, std::size_t need) : plan_(plan), need_(need), judge_(plan, [this](const Accepted& a) { take(a); }) {}
  Points(const Points&) = delete;  // the judge knows where it is
  Points& operator=(const Points&) = delete;

  void place(std::uint64_t seed, std::uint64_t first, std::size_t count) {
    const std::vector<Axis>& axes = plan_.scan.points;
    points_.resize(count, plan_.slots.size());
    std::iota(points_.places.begin(), points_.places.end(), 0u);
    for (std::size_t a = 0; a < axes.size(); a += 2)
      for (std::size_t k = 0; k < count; ++k) {
        const auto u = uniform(seed, first + k, static_cast<std::uint32_t>(a / 2));
        for (std::size_t i = a; i < std::min(a + 2, axes.size()); ++i)
          points_.values[plan_.slots[i] * points_.stride + k] = axes[i].from + (axes[i].to - axes[i].from) * u[i - a];
      }
    points_.fill_up();
    accepted_.assign(count, 0);
    by_others_.assign(count, 0);
    surely_.assign(count, 0);
    tally_ = empty_tally(plan_.set.size(), plan_.reasons);
  }

  void judge(const Orientations& orientations) {
    for (std::size_t o = 0; o < orientations.size(); ++o) judge_.run(points_, orientations.others(o), 0, tally_);
    judge_.finish(tally_);
  }

  // Of the points, where the judge has told of their poses.
  Tally tally() const {
    Tally out = tally_;
    out.poses = points_.count;
    out.accepted = out.on_a_limit = 0;
    for (std::size_t k = 0; k < points_.count; ++k)
      if (accepted_[k] >= need_ && accepted_[k] == by_others_[k]) ++out.accepted, out.on_a_limit += surely_[k] < need_;
    return out;
  }

 private:
  void take(const Accepted& a) {
    for (std::size_t i = 0; i < a.places.size(); ++i) {
      ++by_others_[a.places[i]];
      accepted_[a.places[i]] += a.known[i] > is_refused;
      surely_[a.places[i]] += a.known[i] == is_kept;
    }
  }

  const Plan& plan_;
  const std::size_t need_;
  Judge judge_;
  PointBlock points_;
  // Of each point: orientations that are accepted; of these, such as are on no limit; that all margins accept but those that must hold at
  // every orientation.
  std::vector<std::size_t> accepted_, surely_, by_others_;
  Tally tally_;
};

// The interval of shares that would not be rejected by what was seen, at 95 % (Wilson 1927): where |seen - share| is no more than so many
// of its own standard deviations.
void enclose_share(Estimate& e) {
  constexpr double deviations = 1.959963984540054;
  const double n = static_cast<double>(e.tally.poses), z = deviations * deviations / n;
  e.share = static_cast<double>(e.tally.accepted) / n;
  const double middle = (e.share + z / 2) / (1 + z), half = std::sqrt(z * (e.share * (1 - e.share) + z / 4)) / (1 + z);
  e.low = e.tally.accepted == 0 ? 0.0 : std::max(0.0, middle - half);
  e.high = e.tally.accepted == e.tally.poses ? 1.0 : std::min(1.0, middle + half);
}

}  // namespace

Estimate monte_carlo(const PoseSet& set, const Scan& scan, std::size_t need, const MonteCarloOptions& options, const Watch& watch) {
  const std::size_t orientations = scan.orientation_count(), groups = (orientations + group - 1) / group;
  if (options.poses == 0) throw std::invalid_argument("a share is estimated from one random pose or more; here are none");
  if (need == 0 || need > orientations)
    throw std::invalid_argument(fmt::format(
        "{} of {} orientations are to be accepted at a point; ask for one or more, and no more than there are", need, orientations));
  const Plan plan(set, scan, options.reasons, nullptr);
  const auto prepare = [&](std::size_t g) {
    return std::make_shared<const Orientations>(plan, g * group, std::min(group, orientations - g * group));
  };
  const auto only = groups == 1 ? prepare(0) : nullptr;  // many groups are prepared again for each chunk, which has far more to do
  tbb::enumerable_thread_specific<Points> workers([&] { return Points(plan, need); });

  const std::uint64_t chunks = (options.poses + chunk - 1) / chunk;
  Estimate out;
  out.tally = empty_tally(set.size(), options.reasons);
  Pace pace;
  for (std::uint64_t done = 0; done < chunks;) {
    watch.stop_if_asked();
    std::vector<Tally> found(std::min<std::uint64_t>(pace.steps(), chunks - done));
    pace.run([&] {
      tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t i) {
        const std::uint64_t first = (done + i) * chunk;
        Points& points = workers.local();
        points.place(options.seed, first, std::min(chunk, options.poses - first));
        for (std::size_t g = 0; g < groups; ++g) points.judge(only ? *only : *prepare(g));
        found[i] = points.tally();
      });
    });
    for (const Tally& t : found) out.tally += t;
    done += found.size();
    watch.done(static_cast<double>(done) / static_cast<double>(chunks));
  }
  enclose_share(out);
  return out;
}

}  // namespace pmreport::scan
