#include <core/chunks/chunk_folder.hpp>
#include <core/chunks/sharing.hpp>

#include <fmt/format.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pmreport::chunks {

namespace {

using Clock = std::chrono::steady_clock;

std::size_t threads() { return static_cast<std::size_t>(std::max(1, tbb::this_task_arena::max_concurrency())); }

class Run {
 public:
  Run(const Work& work, const Sharing& sharing, const Compute& compute, const Take& take, const Watch& watch)
      : work_(work), sharing_(sharing), compute_(compute), take_(take), watch_(watch) {
    if (!sharing.folder.empty()) folder_.emplace(sharing.folder, sharing.of_run, work);
  }

  // Chunks that are dealt to this process, no more of them at a time than there are threads for: the others wait for work too.
  void do_share() {
    Dealer& dealer = *sharing_.dealer;
    tbb::parallel_pipeline(
        threads(), tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order, [&](tbb::flow_control& flow) -> std::size_t {
                     watch_.stop_if_asked();
                     const std::optional<std::size_t> chunk = dealer.next(work_);
                     if (!chunk) flow.stop();
                     return chunk.value_or(0);
                   }) & tbb::make_filter<std::size_t, void>(tbb::filter_mode::parallel, [&](std::size_t chunk) {
                     if (!find(chunk)) folder_->keep(chunk, computed(chunk));
                     dealer.kept(work_, chunk);
                   }));
  }

  // All of them, in their order.
  void collect() {
    std::size_t next = 0;
    // Some more than there are threads, so that a chunk that takes long does not hold up the others. What the pipeline hands on are
    // numbers: of what owns memory it would lose those that are on their way when one throws. No two on their way have one place, for they
    // leave in their order.
    const std::size_t at_once = 4 * threads();
    std::vector<Bytes> found(at_once);
    tbb::parallel_pipeline(
        at_once, tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order, [&](tbb::flow_control& flow) -> std::size_t {
                   watch_.stop_if_asked();
                   if (next == work_.count) flow.stop();
                   return next == work_.count ? 0 : next++;
                 }) & tbb::make_filter<std::size_t, std::size_t>(tbb::filter_mode::parallel, [&](std::size_t chunk) {
                   found[chunk % at_once] = answers(chunk);
                   return chunk;
                 }) & tbb::make_filter<std::size_t, void>(tbb::filter_mode::serial_in_order, [&](std::size_t chunk) {
                   const Bytes bytes = std::move(found[chunk % at_once]);
                   try {
                     take_(chunk, bytes);
                   } catch (const NotReadable&) {
                     throw ChunkError(fmt::format("chunk {} of {} holds other answers than this program writes: remove the folder {}",
                                                  chunk, work_.name, sharing_.folder.string()));
                   }
                   watch_.done(static_cast<double>(chunk + 1) / static_cast<double>(work_.count));
                 }));
  }

  bool complete() const {
    for (std::size_t chunk = 0; chunk < work_.count; ++chunk)
      if (!folder_->has(chunk)) return false;
    return true;
  }

  // All that are missing are told at once, not where the first one is missed.
  void demand_all() const {
    constexpr std::size_t told = 10;
    std::string some;
    std::size_t missing = 0;
    for (std::size_t chunk = 0; chunk < work_.count; ++chunk) {
      if (folder_ && folder_->has(chunk)) continue;
      if (missing++ < told) some += fmt::format("{}{}", some.empty() ? "" : ", ", chunk);
    }
    if (missing == 0) return;
    throw ChunkError(
        fmt::format("{} of {} chunks of {} are missing in {} (numbers {}{}): run the shards that have not ended, or let --resume "
                    "compute them",
                    missing, work_.count, work_.name, sharing_.folder.string(), some, missing > told ? ", ..." : ""));
  }

 private:
  std::optional<Bytes> find(std::size_t chunk) const {
    if (!folder_ || (!sharing_.known && sharing_.computes)) return std::nullopt;
    bool damaged = false;
    std::optional<Bytes> out = folder_->load(chunk, damaged);
    if (sharing_.account != nullptr) {
      if (out) ++sharing_.account->found;
      if (damaged) ++sharing_.account->damaged;
    }
    if (damaged && !sharing_.computes && !work_.everyone)
      throw ChunkError(fmt::format("chunk {} of {} in {} is damaged: run its shard again, or let --resume compute it", chunk, work_.name,
                                   sharing_.folder.string()));
    return out;
  }
  Bytes computed(std::size_t chunk) const {
    if (sharing_.account != nullptr) ++sharing_.account->computed;
    Bytes out;
    // In a context of its own: where another chunk throws, loops of this one that were cut short would not tell, and half of its answers be
    // kept as all of them.
    tbb::task_group_context own(tbb::task_group_context::isolated);
    tbb::task_group group(own);
    // What it shares among the threads ends before they turn to other chunks, which would have to end first.
    tbb::this_task_arena::isolate([&] { group.run_and_wait([&] { out = compute_(chunk); }); });
    return out;
  }
  Bytes answers(std::size_t chunk) const {
    if (std::optional<Bytes> known = find(chunk)) return *std::move(known);
    Bytes out = computed(chunk);
    const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    if (folder_ && sharing_.dealer == nullptr && seconds >= sharing_.keep_after) folder_->keep(chunk, out);
    return out;
  }

  const Work& work_;
  const Sharing& sharing_;
  const Compute& compute_;
  const Take& take_;
  const Watch& watch_;
  std::optional<ChunkFolder> folder_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace

std::optional<std::size_t> Shard::next(const Work& work) {
  const std::size_t out = next_.value_or(index_);
  next_ = out + of_;
  if (out < work.count) return out;
  next_.reset();
  return std::nullopt;
}

void run(const Work& work, const Sharing& sharing, const Compute& compute, const Take& take, const Watch& watch) {
  Run r(work, sharing, compute, take, watch);
  if (Dealer* dealer = sharing.dealer) {
    if (work.everyone) leave_unless_waiting(sharing);
    r.do_share();
    if (!dealer->collects() && !work.everyone) throw Elsewhere();
    dealer->wait(work, watch.stop_if_asked);
    if (!dealer->collects() && !r.complete()) throw Elsewhere();
  }
  if (!sharing.computes && !work.everyone) r.demand_all();
  r.collect();
}

}  // namespace pmreport::chunks
