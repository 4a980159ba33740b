#include <reports/mpi/ranks.hpp>

#include <mpi.h>
#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>

namespace pmreport::mpi {

namespace {

enum class Question : std::uint64_t { next, kept, complete, leave };
using Words = std::array<std::uint64_t, 3>;  // question, work, number of chunks
constexpr std::uint64_t nothing = ~std::uint64_t{0}, no = 0, yes = 1, end = 2;
constexpr int to_head = 1, to_hand = 2;
// A rank that waits inside MPI takes all of a core from those that work. These are short beside a chunk.
constexpr std::chrono::microseconds between_looks{200};
constexpr std::chrono::milliseconds between_questions{5};

std::uint64_t key_of(const chunks::Work& work) { return (chunks::Meaning() << work.name << work.meaning).value(); }

void sleep(std::chrono::microseconds time) { std::this_thread::sleep_for(time); }

std::uint64_t ask(Question question, const chunks::Work* work = nullptr) {
  const Words words{static_cast<std::uint64_t>(question), work != nullptr ? key_of(*work) : 0, work != nullptr ? work->count : 0};
  MPI_Send(words.data(), words.size(), MPI_UINT64_T, 0, to_head, MPI_COMM_WORLD);
  std::uint64_t answer = nothing;
  MPI_Request request;
  MPI_Irecv(&answer, 1, MPI_UINT64_T, 0, to_hand, MPI_COMM_WORLD, &request);
  for (int done = 0; MPI_Test(&request, &done, MPI_STATUS_IGNORE), done == 0;) sleep(between_looks);
  return answer;
}

}  // namespace

Job::Job(int* argc, char*** argv) {
  int provided = 0;
  MPI_Init_thread(argc, argv, MPI_THREAD_SERIALIZED, &provided);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks_);
  MPI_Comm machine;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, rank_, MPI_INFO_NULL, &machine);
  MPI_Comm_size(machine, &on_this_machine_);
  MPI_Comm_free(&machine);
}

Job::~Job() { MPI_Finalize(); }

int Job::threads() const {
  const int cores = static_cast<int>(sysconf(_SC_NPROCESSORS_ONLN));
  cpu_set_t mine;
  // Where each rank was given cores of its own, these.
  if (sched_getaffinity(0, sizeof mine, &mine) == 0 && CPU_COUNT(&mine) < cores) return std::max(1, CPU_COUNT(&mine));
  return std::max(1, cores / on_this_machine_);
}

std::optional<std::size_t> Book::next(std::uint64_t work, std::uint64_t count, int rank) {
  Dealt& dealt = works_[work];
  if (dealt.next >= count) return std::nullopt;
  ++dealt.open[rank];
  return static_cast<std::size_t>(dealt.next++);
}

void Book::kept(std::uint64_t work, int rank) { --works_[work].open[rank]; }

void Book::leaves(int rank) { gone_[static_cast<std::size_t>(rank)] = true; }

bool Book::complete(std::uint64_t work, std::uint64_t count) const {
  const auto found = works_.find(work);
  if (found == works_.end() || found->second.next < count) return false;
  return std::ranges::all_of(found->second.open, [&](const auto& o) { return o.second == 0 || gone_[static_cast<std::size_t>(o.first)]; });
}

bool Book::all_left() const {
  return std::all_of(gone_.begin() + 1, gone_.end(), [](bool gone) { return gone; });
}

Head::Head(const Job& job) : book_(job.ranks()), thread_([this] { serve(); }) {}

Head::~Head() {
  ends_ = true;
  thread_.join();
}

void Head::serve() {
  for (;;) {
    int waits = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, to_head, MPI_COMM_WORLD, &waits, &status);
    if (waits == 0) {
      const std::scoped_lock lock(mutex_);
      if (ends_ && book_.all_left()) return;
    }
    if (waits == 0) {
      sleep(between_looks);
      continue;
    }
    Words words{};
    const int rank = status.MPI_SOURCE;
    MPI_Recv(words.data(), words.size(), MPI_UINT64_T, rank, to_head, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    std::uint64_t answer = yes;
    {
      const std::scoped_lock lock(mutex_);
      switch (static_cast<Question>(words[0])) {
        case Question::next:
          answer = ends_ ? nothing : std::uint64_t{book_.next(words[1], words[2], rank).value_or(nothing)};
          break;
        case Question::kept:
          book_.kept(words[1], rank);
          break;
        case Question::complete:
          answer = ends_ ? end : book_.complete(words[1], words[2]) ? yes : no;
          break;
        case Question::leave:
          book_.leaves(rank);
          break;
      }
    }
    MPI_Send(&answer, 1, MPI_UINT64_T, rank, to_hand, MPI_COMM_WORLD);
  }
}

std::optional<std::size_t> Head::next(const chunks::Work& work) {
  const std::scoped_lock lock(mutex_);
  return book_.next(key_of(work), work.count, 0);
}

void Head::kept(const chunks::Work& work, std::size_t) {
  const std::scoped_lock lock(mutex_);
  book_.kept(key_of(work), 0);
}

void Head::wait(const chunks::Work& work, const std::function<void()>& stop_if_asked) {
  for (;;) {
    stop_if_asked();
    {
      const std::scoped_lock lock(mutex_);
      if (book_.complete(key_of(work), work.count)) return;
    }
    sleep(between_questions);
  }
}

Hand::~Hand() {
  const std::scoped_lock lock(mutex_);
  ask(Question::leave);
}

std::optional<std::size_t> Hand::next(const chunks::Work& work) {
  const std::scoped_lock lock(mutex_);
  const std::uint64_t answer = ask(Question::next, &work);
  return answer == nothing ? std::nullopt : std::optional<std::size_t>(answer);
}

void Hand::kept(const chunks::Work& work, std::size_t) {
  const std::scoped_lock lock(mutex_);
  ask(Question::kept, &work);
}

void Hand::wait(const chunks::Work& work, const std::function<void()>& stop_if_asked) {
  for (;;) {
    stop_if_asked();
    {
      const std::scoped_lock lock(mutex_);
      const std::uint64_t answer = ask(Question::complete, &work);
      if (answer == yes) return;
      if (answer == end) throw chunks::Elsewhere();
    }
    sleep(between_questions);
  }
}

std::unique_ptr<chunks::Dealer> dealer_of(const Job& job) {
  if (job.rank() == 0) return std::make_unique<Head>(job);
  return std::make_unique<Hand>();
}

}  // namespace pmreport::mpi
