// The ranks of an MPI job share the chunks of one report: rank 0 deals them and collects the answers, which go through a folder that all
// ranks see. Messages carry numbers of chunks alone.
#pragma once

#include <core/chunks/sharing.hpp>

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <thread>

namespace pmreport::mpi {

// Begins and ends MPI. To be made once, before all other threads.
class Job {
 public:
  Job(int* argc, char*** argv);
  ~Job();
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  int rank() const { return rank_; }
  int ranks() const { return ranks_; }
  int threads() const;  // that are this rank's, where those of a machine share its cores

 private:
  int rank_ = 0, ranks_ = 1, on_this_machine_ = 1;
};

// Which chunks of each work have gone to whom.
class Book {
 public:
  explicit Book(int ranks) : gone_(static_cast<std::size_t>(ranks), false) {}

  std::optional<std::size_t> next(std::uint64_t work, std::uint64_t count, int rank);
  void kept(std::uint64_t work, int rank);
  void leaves(int rank);
  // All chunks are dealt, and those of ranks that are still there are kept.
  bool complete(std::uint64_t work, std::uint64_t count) const;
  bool all_left() const;

 private:
  struct Dealt {
    std::uint64_t next = 0;
    std::map<int, std::uint64_t> open;  // of each rank: chunks that it has and has not kept
  };
  std::map<std::uint64_t, Dealt> works_;
  std::vector<bool> gone_;
};

// On rank 0: answers the others, in a thread of its own.
class Head : public chunks::Dealer {
 public:
  explicit Head(const Job& job);
  ~Head() override;

  std::optional<std::size_t> next(const chunks::Work& work) override;
  void kept(const chunks::Work& work, std::size_t chunk) override;
  void wait(const chunks::Work& work, const std::function<void()>& stop_if_asked) override;
  bool collects() const override { return true; }

 private:
  void serve();

  std::mutex mutex_;
  Book book_;
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

// On the others: asks rank 0.
class Hand : public chunks::Dealer {
 public:
  ~Hand() override;

  std::optional<std::size_t> next(const chunks::Work& work) override;
  void kept(const chunks::Work& work, std::size_t chunk) override;
  void wait(const chunks::Work& work, const std::function<void()>& stop_if_asked) override;
  bool collects() const override { return false; }

 private:
  std::mutex mutex_;  // MPI is called by one thread at a time
};

std::unique_ptr<chunks::Dealer> dealer_of(const Job& job);

}  // namespace pmreport::mpi
