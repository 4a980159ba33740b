// Two threads as the ranks of a job. The first one collects; chunks are dealt in turn, so that both have some.
#pragma once

#include <core/chunks/sharing.hpp>

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <utility>

namespace pmreport::chunks {

class TwoRanks {
 public:
  class Rank : public Dealer {
   public:
    Rank(TwoRanks& job, std::size_t index) : job_(job), index_(index) {}
    std::optional<std::size_t> next(const Work& work) override {
      const std::scoped_lock lock(job_.mutex_);
      std::size_t& next = dealt_.try_emplace(key(work), index_).first->second;
      if (next >= work.count) return std::nullopt;
      return std::exchange(next, next + 2);
    }
    void kept(const Work& work, std::size_t chunk) override {
      const std::scoped_lock lock(job_.mutex_);
      job_.kept_[key(work)].insert(chunk);
      job_.changed_.notify_all();
    }
    void wait(const Work& work, const std::function<void()>& stop_if_asked) override {
      stop_if_asked();
      std::unique_lock lock(job_.mutex_);
      job_.changed_.wait(lock, [&] { return job_.left_ || job_.kept_[key(work)].size() == work.count; });
    }
    bool collects() const override { return index_ == 0; }

   private:
    using Key = std::pair<std::string, std::uint64_t>;
    static Key key(const Work& work) { return {work.name, work.meaning}; }
    friend TwoRanks;

    TwoRanks& job_;
    std::size_t index_;
    std::map<Key, std::size_t> dealt_;  // the next one of each work
  };

  // `f` on each rank at once.
  template <class F>
  void run(F&& f) {
    const auto run_one = [&](std::size_t index) {
      Rank rank(*this, index);
      f(index, rank);
      const std::scoped_lock lock(mutex_);
      left_ = true;
      changed_.notify_all();
    };
    std::thread other(run_one, 1);
    run_one(0);
    other.join();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<Rank::Key, std::set<std::size_t>> kept_;
  bool left_ = false;  // one of them; what it has not kept it never will
};

}  // namespace pmreport::chunks
