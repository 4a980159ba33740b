// Who does which chunks of work, and where the answers go: the same bytes however it is shared.
#pragma once

#include <core/chunks/bytes.hpp>
#include <core/chunks/work.hpp>

#include <atomic>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>

namespace pmreport::chunks {

// Deals chunks to those who share the work. They keep what they find in one folder, which all of them see.
class Dealer {
 public:
  virtual ~Dealer() = default;
  // A chunk to do here; nothing: there is none left. Asked by one thread at a time.
  virtual std::optional<std::size_t> next(const Work& work) = 0;
  // It is kept.
  virtual void kept(const Work& work, std::size_t chunk) = 0;
  // Returns when all chunks that were dealt to others are kept, or will not be. `stop_if_asked` is asked meanwhile.
  virtual void wait(const Work& work, const std::function<void()>& stop_if_asked) = 0;
  // The answers of all are put together here.
  virtual bool collects() const = 0;
  // Those who share wait for each other, so that work goes on with what all of them have found.
  virtual bool waits() const { return true; }
};

// Each of `of` shares has the chunks whose number, divided by `of`, leaves `index`, from 0 on. Nobody waits for anybody.
class Shard : public Dealer {
 public:
  Shard(std::size_t index, std::size_t of) : index_(index), of_(of) {}
  std::optional<std::size_t> next(const Work& work) override;
  void kept(const Work&, std::size_t) override {}
  void wait(const Work&, const std::function<void()>&) override {}
  bool collects() const override { return false; }
  bool waits() const override { return false; }

 private:
  std::size_t index_, of_;
  std::optional<std::size_t> next_;  // of the work that is dealt
};

// What has been done of all work, for those who tell of it. Counted by several threads.
struct Account {
  std::atomic<std::size_t> computed = 0, found = 0, damaged = 0;  // chunks: here; read from the folder; there, but not as they were written
};

struct Sharing {
  std::filesystem::path folder = {};  // where chunks are kept; empty: nowhere
  std::uint64_t of_run = 0;           // a hash of what decides all answers of the run: which program, which mechanism
  bool known = false;                 // chunks that are there already count; where none are computed they always do
  bool computes = true;               // chunks that are missing are computed; else that is an error, but of work that everyone needs
  Dealer* dealer = nullptr;           // of work that is shared; null: all of it is done here
  Account* account = nullptr;
  double keep_after = 1;  // [s] that work which is not shared takes before its chunks are kept: less is soon done again
};

// Work is left to others: its answers are not here, and what needs them cannot go on.
struct Elsewhere : std::exception {
  const char* what() const noexcept override { return "the work goes on elsewhere"; }
};

// Several works, none of which needs the answers of another: where those of one are elsewhere, the next one is begun all the same.
class Attempts {
 public:
  template <class F>
  void add(F&& work) {
    try {
      work();
    } catch (const Elsewhere&) {
      elsewhere_ = true;
    }
  }
  // What follows needs the answers of all of them.
  void demand() const {
    if (elsewhere_) throw Elsewhere();
  }

 private:
  bool elsewhere_ = false;
};

// To be called before work that cannot be shared: it is left to the process that collects the answers.
inline void leave_to_collector(const Sharing& sharing) {
  if (sharing.dealer != nullptr && !sharing.dealer->collects()) throw Elsewhere();
}

// To be called before work whose answers everyone needs (Work::everyone): where nobody waits for the others, it is left to the process that
// collects the answers, which does all of it.
inline void leave_unless_waiting(const Sharing& sharing) {
  if (sharing.dealer != nullptr && !sharing.dealer->waits()) leave_to_collector(sharing);
}

// The answers of a chunk, called by several threads at once, which may use all threads itself; and what becomes of them, in the order of
// the chunks, by one thread at a time. Answers that `take` cannot read (NotReadable) are told as ChunkError.
using Compute = std::function<Bytes(std::size_t chunk)>;
using Take = std::function<void(std::size_t chunk, std::span<const std::byte> answers)>;

// Throws Elsewhere, ChunkError, and what `compute`, `take` and the watch throw.
void run(const Work& work, const Sharing& sharing, const Compute& compute, const Take& take, const Watch& watch = {});

}  // namespace pmreport::chunks
