// One plugin, built in several ways, says the same to one host.
#include <fmt/core.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <core/host/plugin_file.hpp>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <tests/host/fixtures/samples.hpp>

namespace {

constexpr const char* tried_mechanism = "4sps-spr";
constexpr std::uint64_t seed = 20170401;
const std::string original = std::string(PLUGINS) + "/4sps-spr.so";

// Builds may differ by rounding alone: sines and cosines of wider lanes err by a unit in the last place, and sums may be taken in another
// order. Numbers are metres and radians of size one; eight units in the last place leave room for what follows from such a difference.
// Recordings are the same, but for constants that differ so.
constexpr double bound = 8 * std::numeric_limits<double>::epsilon();

std::vector<Sample> samples_of(const std::string& file) {
  const auto plugin = pmreport::host::load_plugin(file);
  REQUIRE(plugin.mechanisms.size() == 1);
  return take_samples(*plugin.mechanisms[0], seed);
}

// The largest difference of two rows of numbers, relative where a number exceeds one; not a number where one of them is not.
double difference(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double d = std::abs(a[i] - b[i]) / std::max(1.0, std::abs(a[i]));
    if (!(d <= largest)) largest = d;
  }
  return largest;
}

void check_equal(const std::vector<Sample>& a, const std::vector<std::vector<double>>& b) {
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    INFO(a[i].label << ", seed " << seed);
    REQUIRE(a[i].numbers.size() > 100);
    CHECK(difference(a[i].numbers, b[i]) <= bound);
  }
}

void check_equal(const std::vector<Sample>& a, const std::vector<Sample>& b) {
  std::vector<std::vector<double>> numbers;
  for (const Sample& s : b) numbers.push_back(s.numbers);
  check_equal(a, numbers);
}

struct Run {
  int status;
  std::string output;
};
Run run(const std::string& command) {
  std::FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  REQUIRE(pipe != nullptr);
  Run result{};
  char buffer[65536];
  while (const std::size_t n = std::fread(buffer, 1, sizeof buffer, pipe)) result.output.append(buffer, n);
  result.status = pclose(pipe);
  return result;
}

// What `checker` prints: a line of numbers a sample.
std::vector<std::vector<double>> samples_printed_by(const std::string& command) {
  const Run checked = run(command);
  INFO(command << "\n" << checked.output.substr(0, 2000));
  REQUIRE(checked.status == 0);
  std::vector<std::vector<double>> rows;
  std::istringstream lines(checked.output);
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    const char* at = line.c_str();
    for (char* end = nullptr;; at = end) {
      const double x = std::strtod(at, &end);
      if (end == at) break;
      rows.back().push_back(x);
    }
  }
  return rows;
}

std::string check_with(const std::string& checker, const std::string& file) {
  return fmt::format("'{}' '{}' {} {}", checker, file, tried_mechanism, seed);
}

}  // namespace

TEST_CASE("a pose among others is the pose alone") {
  const auto samples = samples_of(original);
  for (const Sample& s : samples) {
    const auto alone = [&](std::size_t pose) {  // the fewest poses that this one was asked among
      return *std::find_if(samples.begin(), samples.end(), [&](const Sample& o) { return o.order == s.order && o.pose == pose; });
    };
    INFO(s.label << ", seed " << seed);
    CHECK(difference(alone(s.pose).numbers, s.numbers) <= bound);
  }
}

TEST_CASE("all numbers of a placement and its Jacobian are finite, and poses differ") {
  const auto samples = samples_of(original);
  for (const Sample& s : samples)
    for (const double x : s.numbers) CHECK(std::isfinite(x));
  CHECK(difference(samples[1].numbers, samples[2].numbers) > 1e-3);
}

TEST_CASE("a plugin built for x86-64-v3 says what the plain one says") {
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) {
    WARN("this processor has no AVX2");
    return;
  }
  check_equal(samples_of(original), samples_of(FIXTURES "/variant_v3.so"));
}

TEST_CASE("a plugin built without Eigen's vector code says what the plain one says") {
  check_equal(samples_of(original), samples_of(FIXTURES "/variant_unvectorized.so"));
}

TEST_CASE("another process gets the same numbers from the same plugin") {
  check_equal(samples_of(original), samples_printed_by(check_with(CHECKER, original)));
}

#ifdef LIBASAN
// Leaks are not looked for: that needs ptrace, which containers often forbid.
TEST_CASE("a sanitized plugin in a plain host says what the plain one says, and no sanitizer complains") {
  check_equal(samples_of(original), samples_printed_by("ASAN_OPTIONS=detect_leaks=0 LD_PRELOAD='" LIBASAN "' " +
                                                       check_with(CHECKER, FIXTURES "/variant_sanitized.so")));
}

TEST_CASE("a plain plugin in a sanitized host says the same, and no sanitizer complains") {
  check_equal(samples_of(original), samples_printed_by("ASAN_OPTIONS=detect_leaks=0 " + check_with(CHECKER_SANITIZED, original)));
}

TEST_CASE("a sanitized plugin in a sanitized host says the same") {
  check_equal(samples_of(original),
              samples_printed_by("ASAN_OPTIONS=detect_leaks=0 " + check_with(CHECKER_SANITIZED, FIXTURES "/variant_sanitized.so")));
}

TEST_CASE("a sanitized plugin is refused by a host without the sanitizer, instead of ending the process") {
  const Run checked = run(check_with(CHECKER, FIXTURES "/variant_sanitized.so"));
  CAPTURE(checked.output);
  CHECK(checked.output.find("expected a library without AddressSanitizer") != std::string::npos);
  CHECK(checked.output.find("LD_PRELOAD=libasan.so") != std::string::npos);
}
#endif
