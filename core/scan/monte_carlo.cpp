#include <core/scan/monte_carlo.hpp>

#include <core/scan/judge/groups.hpp>
#include <core/scan/judge/judge.hpp>
#include <core/scan/judge/kernel.hpp>
#include <core/scan/meaning.hpp>
#include <core/scan/philox.hpp>

#include <fmt/core.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <stdexcept>

namespace pmreport::scan {

namespace {

constexpr std::uint64_t block = 4096;  // points that are judged at a time

// Points of one block. Keeps its buffers: one a thread.
class Points {
 public:
  Points(const Plan& plan, std::size_t need, std::function<void()> stop_if_asked)
      : plan_(plan), need_(need), stop_if_asked_(std::move(stop_if_asked)), judge_(plan, [this](const Accepted& a) { take(a); }) {}
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
    judge_.forget();  // what a block left that threw
  }

  void judge(const Orientations& orientations) {
    for (std::size_t o = 0; o < orientations.size(); ++o) {
      stop_if_asked_();
      judge_.run(points_, orientations.others(o), 0, tally_);
    }
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
  const std::function<void()> stop_if_asked_;
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

// A long scan has some hundred chunks or more, each of which is done in about a second, or in what one block takes.
std::uint64_t points_of_a_chunk(const PoseSet& set, const Scan& scan, std::uint64_t points) {
  const std::uint64_t most_poses = set.late.size > 0 ? 1 << 18 : 1 << 26;
  return std::max(block, std::min(points / 256, most_poses / scan.orientation_count()) / block * block);
}

}  // namespace

Estimate monte_carlo(const PoseSet& set, const Scan& scan, std::size_t need, const MonteCarloOptions& options, const Watch& watch,
                     const chunks::Work& work, const chunks::Sharing& sharing) {
  const std::size_t orientations = scan.orientation_count();
  if (options.poses == 0) throw std::invalid_argument("a share is estimated from one random pose or more; here are none");
  if (need == 0 || need > orientations)
    throw std::invalid_argument(fmt::format(
        "{} of {} orientations are to be accepted at a point; ask for one or more, and no more than there are", need, orientations));
  const Plan plan(set, scan, options.reasons, nullptr);
  Groups groups(plan);
  tbb::enumerable_thread_specific<Points> workers([&] { return Points(plan, need, watch.stop_if_asked); });
  const Tally nothing = empty_tally(set.size(), options.reasons);
  const std::uint64_t of_a_chunk = points_of_a_chunk(set, scan, options.poses);

  const auto compute = [&](std::size_t chunk) {
    const std::uint64_t begin = chunk * of_a_chunk, end = std::min(options.poses, begin + of_a_chunk);
    std::vector<Tally> found((end - begin + block - 1) / block);
    tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t i) {
      const std::uint64_t first = begin + i * block;
      Points& points = workers.local();
      points.place(options.seed, first, std::min(block, end - first));
      for (std::size_t g = 0; g < groups.size(); ++g) points.judge(*groups.at(g));
      found[i] = points.tally();
    });
    Tally sum = nothing;
    for (const Tally& t : found) sum += t;
    chunks::Writer out;
    put(out, sum);
    return out.take();
  };
  Estimate out;
  out.tally = nothing;
  const auto take = [&](std::size_t, std::span<const std::byte> answers) {
    chunks::Reader in(answers);
    Tally more = nothing;
    get(in, more);
    in.end();
    out.tally += more;
  };
  chunks::Meaning meaning;
  meaning << work.meaning << meaning_of(set, scan) << need << options.poses << options.seed << options.reasons << of_a_chunk;
  chunks::run({work.name, meaning.value(), (options.poses + of_a_chunk - 1) / of_a_chunk}, sharing, compute, take, watch);
  enclose_share(out);
  return out;
}

}  // namespace pmreport::scan
