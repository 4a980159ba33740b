// Batches of one program, lent to one thread at a time: to make one costs more than a few poses.
#pragma once

#include <core/program/batch.hpp>

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace pmreport::program {

class Batches {
 public:
  Batches() = default;
  explicit Batches(Program program) : program_(std::move(program)) {}
  void of(Program program) { program_ = std::move(program); }  // before the first run
  const Program& program() const { return program_; }
  // As Batch::run.
  void run(std::size_t count, const double* in, double* out) {
    std::unique_ptr<Batch> batch;
    {
      const std::scoped_lock lock(mutex_);
      if (!idle_.empty()) batch = std::move(idle_.back()), idle_.pop_back();
    }
    if (!batch) batch = std::make_unique<Batch>(program_);
    batch->run(count, in, out);
    const std::scoped_lock lock(mutex_);
    idle_.push_back(std::move(batch));
  }

 private:
  Program program_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Batch>> idle_;
};

}  // namespace pmreport::program
