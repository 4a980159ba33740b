// Calls that never fail otherwise, failed one at a time: the report is the old one or the new one, whole, and the exit status says why.
// tests/torture.sh does the same at far more places.
#include <catch2/catch.hpp>

#include <tests/program/workshop.hpp>

#include <algorithm>
#include <fstream>
#include <random>
#include <set>

namespace fs = std::filesystem;
using program_test::Result;
using program_test::Surroundings;
using program_test::Workshop;

namespace {

struct Torment {
  Torment() {
    fs::create_directory(workshop / "plugins"), fs::copy_file(fs::path(FIXTURES) / "plain.so", workshop / "plugins" / "plain.so");
  }
  Result report(const std::string& call, long at) const {
    return workshop.report(program_test::slider, {"--plugin-path", (workshop / "plugins").string()},
                           Surroundings{.environment = {{"LD_PRELOAD", FAIL_NTH},
                                                        {"FAIL_CALL", call},
                                                        {"FAIL_IN", "worker"},
                                                        {"FAIL_AT", std::to_string(at)},
                                                        {"FAIL_COUNT", (workshop / "count").string()}}});
  }
  // How many there are in a run in which none fails.
  long count(const std::string& call) const {
    REQUIRE(report(call, 0).status == 0);
    std::ifstream file(workshop / "count");
    long most = 0;
    for (long n = 0; file >> n;) most = std::max(most, n);
    return most;
  }
  Workshop workshop;
};

}  // namespace

TEST_CASE("every write, sync, rename, folder and file that fails is told, and the report is whole") {
  if (program_test::sanitized) return;  // their own allocator cannot be failed from outside
  const Torment bench;
  for (const char* call : {"write", "fsync", "rename", "mkdir"}) {
    const long all = bench.count(call);
    const auto good = program_test::contents(bench.workshop.report_folder());
    REQUIRE(all > 0);
    int failed = 0;
    for (long k = 1; k <= all; k += all > 12 ? 3 : 1) {
      CAPTURE(call, k);
      const Result r = bench.report(call, k);
      CAPTURE(r.err);
      CHECK((r.status == 0 || r.status == 4));
      CHECK((r.status == 0 || r.err.find("error: ") != std::string::npos));
      CHECK(program_test::contents(bench.workshop.report_folder()) == good);
      failed += r.status == 4;
    }
    CHECK(failed > 0);
  }
}

TEST_CASE("memory and threads that are not to be had are told as that, and not as the plugin's fault") {
  if (program_test::sanitized) return;  // their own allocator cannot be failed from outside
  const Torment bench;
  std::mt19937 random(20261201);
  std::set<int> seen;
  for (const char* call : {"malloc", "thread"}) {
    const long all = bench.count(call);
    const auto good = program_test::contents(bench.workshop.report_folder());
    REQUIRE(all > 10);
    for (int attempt = 0; attempt < 8; ++attempt) {
      // The second half of the allocations is the drawing libraries': these do not tell all of theirs.
      const long k = std::uniform_int_distribution<long>(1, std::string_view(call) == "malloc" ? all / 2 : all)(random);
      CAPTURE(call, k);
      const Result r = bench.report(call, k);
      CAPTURE(r.err);
      CHECK((r.status == 0 || r.status == 5));
      CHECK(program_test::contents(bench.workshop.report_folder()) == good);
      seen.insert(r.status);
    }
  }
  CHECK(seen.contains(5));
}

// Libraries are set up before main(), where nobody can take what they throw.
TEST_CASE("memory that is lacking before the work has begun is no plugin's fault") {
  if (program_test::sanitized) return;  // their own allocator cannot be failed from outside
  const Torment bench;
  const Result r = bench.report("malloc", 1);
  CAPTURE(r.err);
  CHECK(r.status == 5);
  CHECK(r.err.find("out of memory") != std::string::npos);
  CHECK(r.err.find("plugin") == std::string::npos);
}
