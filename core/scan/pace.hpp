// How much of a long scan is done between two looks at its watch.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>

namespace pmreport::scan {

// Steps of about equal length are done so many at a time that the watch is looked at some ten times a second. What a scan finds must not
// depend on it.
class Pace {
 public:
  std::size_t steps() const { return steps_; }

  // Runs f, which does these steps.
  template <class F>
  void run(F&& f) {
    using Clock = std::chrono::steady_clock;
    constexpr double longest = 0.1, shortest = 0.05;  // [s]
    const auto start = Clock::now();
    f();
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    if (seconds < shortest) steps_ = std::min(steps_ * 2, most);
    if (seconds > longest) steps_ = std::max<std::size_t>(1, steps_ / 2);
  }

 private:
  static constexpr std::size_t most = 1024;  // what they found is held until all of them are done
  std::size_t steps_ = 8;
};

}  // namespace pmreport::scan
