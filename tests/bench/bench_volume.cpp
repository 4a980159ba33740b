// What the bracket of a volume costs: gap against seconds and boxes. See README.md.
#include <algorithm>
#include <core/scan/proved_volume.hpp>
#include <tests/bench/six_ups.hpp>

#include <fmt/core.h>
#include <tbb/global_control.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>

using namespace pmreport;

int main(int count, char** words) {
  const std::size_t threads = std::max<std::size_t>(1, count > 1 ? std::strtoul(words[1], nullptr, 10) : 1);
  const double finest = count > 2 ? std::strtod(words[2], nullptr) : 1e-3;
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
  const scan::PoseSet set = bench::six_ups();
  fmt::print("   gap asked     reached   wall [s]    CPU [s]      boxes   volume [m^3]\n");
  for (double gap = 1e-1; gap > 0.99 * finest; gap /= std::sqrt(10)) {
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t used = std::clock();
    scan::VolumeOptions options;
    options.gap = gap;
    const scan::ProvedVolume proved = scan::prove_volume(set, bench::six_ups_range(), options);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    fmt::print("{:12.3g} {:11.3g} {:10.3f} {:10.3f} {:10}   {:.12f} {:.12f} {}\n", gap, proved.volume.width() / proved.volume.middle(),
               taken.count(), double(std::clock() - used) / CLOCKS_PER_SEC, proved.boxes, proved.volume.low, proved.volume.high,
               proved.why);
  }
}
