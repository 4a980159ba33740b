// One report by several processes: the same bytes however the work was spread, and nothing lost.
#include <catch2/catch.hpp>
#include <tests/program/workshop.hpp>

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <stdexcept>

namespace fs = std::filesystem;
using namespace program_test;
using Catch::Contains;

namespace {

// All that comes in chunks.
const std::string everything = bytes_of(fs::path(SOURCE) / "tests/data/spread.toml");
const std::string parallel_program = std::string(PROGRAM) + "-mpi";

std::vector<std::string> command_of_ranks(int count, const std::vector<std::string>& arguments) {
  std::vector<std::string> command{"mpiexec", "-n", std::to_string(count), parallel_program};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return command;
}
Surroundings surroundings_of_ranks(const Workshop& here) {
  return {
      .environment = {{"OMPI_ALLOW_RUN_AS_ROOT", "1"}, {"OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1"}, {"OMPI_MCA_rmaps_base_oversubscribe", "1"}},
      .folder = here.path()};
}
Result ranks(const Workshop& here, int count, const std::vector<std::string>& arguments) {
  return run(command_of_ranks(count, arguments), surroundings_of_ranks(here));
}

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> out;
  for (const auto& e : fs::directory_iterator(folder)) out.insert(e.path().filename().string());
  return out;
}

// Until some chunks of the report r are kept.
void wait_for_chunks(const Workshop& here) {
  const auto kept = [&] {
    std::size_t n = 0;
    std::error_code gone;
    for (auto it = fs::recursive_directory_iterator(here / "r.chunks", gone); !gone && it != fs::recursive_directory_iterator();
         it.increment(gone))
      n += it->is_regular_file();
    return n;
  };
  for (int k = 0; k < 2000 && kept() < 4; ++k) usleep(10'000);
  REQUIRE(kept() >= 4);
}

// The last of the program's processes that work in this folder.
pid_t a_rank_in(const fs::path& folder) {
  pid_t out = 0;
  for (const auto& e : fs::directory_iterator("/proc")) {
    std::error_code not_ours;
    const std::string number = e.path().filename().string();
    if (number.find_first_not_of("0123456789") != std::string::npos) continue;
    if (fs::read_symlink(e.path() / "cwd", not_ours) != folder ||
        fs::read_symlink(e.path() / "exe", not_ours) != fs::canonical(parallel_program))
      continue;
    out = std::max(out, static_cast<pid_t>(std::stoi(number)));
  }
  if (out == 0) throw std::runtime_error("no rank is at work");
  return out;
}

}  // namespace

TEST_CASE("shards and ranks of any number make the report that one process makes, byte by byte") {
  const Workshop here;
  here.write("s.toml", everything);
  const auto report = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "s.toml");
    const Result result = run_pmreport(arguments, {.folder = here.path()});
    INFO(result.out << result.err);
    REQUIRE(result.status == 0);
    return result.out;
  };
  report({"-o", "alone", "--threads", "1"});
  const auto alone = contents(here / "alone");
  report({"-o", "two", "--threads", "2"});
  CHECK(contents(here / "two") == alone);

  for (const std::string shard : {"2/3", "1/3", "3/3"})
    CHECK_THAT(report({"-o", "shards", "--shard", shard}), Contains("computed, 0 were there"));
  CHECK_FALSE(fs::exists(here / "shards"));
  const Result merged = run_pmreport({"merge", "s.toml", "-o", "shards"}, {.folder = here.path()});
  INFO(merged.out << merged.err);
  REQUIRE(merged.status == 0);
  CHECK(contents(here / "shards") == alone);
  CHECK_FALSE(fs::exists(here / "shards.chunks"));

  if (!fs::exists(parallel_program)) return;
  for (const int count : {1, 2, 3}) {
    const std::string name = "ranks" + std::to_string(count);
    const Result result = ranks(here, count, {"s.toml", "-o", name, "--quiet"});
    INFO(result.out << result.err);
    REQUIRE(result.status == 0);
    CHECK(contents(here / name) == alone);
  }
}

TEST_CASE("what shards have not done is told, and computed by --resume") {
  const Workshop here;
  here.write("s.toml", everything);
  REQUIRE(run_pmreport({"s.toml", "-o", "r", "--shard", "1/2", "--chunks", "kept"}, {.folder = here.path()}).status == 0);
  const Result early = run_pmreport({"merge", "s.toml", "-o", "r", "--chunks", "kept"}, {.folder = here.path()});
  CHECK(early.status == 2);
  CHECK_THAT(early.err, Contains("chunks of ") && Contains("are missing in kept") && Contains("run the shards that have not ended"));
  CHECK_FALSE(fs::exists(here / "r"));
  const Result again = run_pmreport({"s.toml", "-o", "r", "--shard", "1/2", "--chunks", "kept"}, {.folder = here.path()});
  CHECK_THAT(again.out, Contains("0 chunks computed"));
  REQUIRE(run_pmreport({"merge", "s.toml", "-o", "r", "--chunks", "kept", "--resume"}, {.folder = here.path()}).status == 0);
  CHECK(fs::exists(here / "kept"));  // its name was given: whose it is, we do not know
  REQUIRE(run_pmreport({"s.toml", "-o", "alone"}, {.folder = here.path()}).status == 0);
  CHECK(contents(here / "r") == contents(here / "alone"));
}

TEST_CASE("chunks of another scenario, or what is damaged, are not gone on with") {
  const Workshop here;
  here.write("s.toml", everything);
  REQUIRE(run_pmreport({"s.toml", "-o", "r", "--shard", "1/1"}, {.folder = here.path()}).status == 0);
  here.write("s.toml", with(everything, {{"20 mm * sin", "21 mm * sin"}}));
  const Result other = run_pmreport({"merge", "s.toml", "-o", "r"}, {.folder = here.path()});
  CHECK(other.status == 2);
  CHECK_THAT(other.err, Contains("are missing"));
  here.write("s.toml", everything);
  for (const auto& work : fs::directory_iterator(here / "r.chunks"))
    if (fs::exists(work.path() / "0")) fs::resize_file(work.path() / "0", 50);
  const Result damaged = run_pmreport({"merge", "s.toml", "-o", "r"}, {.folder = here.path()});
  CHECK(damaged.status == 2);
  CHECK_THAT(damaged.err, Contains("is damaged"));
  const Result resumed = run_pmreport({"merge", "s.toml", "-o", "r", "--resume"}, {.folder = here.path()});
  CHECK(resumed.status == 0);
  CHECK_THAT(resumed.err, Contains("not as written, and done again"));
}

TEST_CASE("a rank that is killed costs its chunk alone") {
  if (!fs::exists(parallel_program)) return;
  const Workshop here;
  here.write("s.toml", with(everything, {{"61] }", "261] }"}}));
  Process process(command_of_ranks(3, {"s.toml", "-o", "r"}), surroundings_of_ranks(here));
  wait_for_chunks(here);
  REQUIRE(kill(a_rank_in(here.path()), SIGKILL) == 0);
  CHECK(process.finish().status != 0);
  CHECK_FALSE(fs::exists(here / "r"));
  const Result rerun = ranks(here, 2, {"s.toml", "-o", "r"});
  INFO(rerun.out << rerun.err);
  REQUIRE(rerun.status == 0);
  REQUIRE(run_pmreport({"s.toml", "-o", "alone"}, {.folder = here.path()}).status == 0);
  CHECK(contents(here / "r") == contents(here / "alone"));
}

TEST_CASE("ranks that are told to end leave the earlier report as it was, and what they have found to the next run") {
  if (!fs::exists(parallel_program)) return;
  const Workshop here;
  here.write("s.toml", everything);
  REQUIRE(run_pmreport({"s.toml", "-o", "r"}, {.folder = here.path()}).status == 0);
  const auto earlier = contents(here / "r");
  here.write("s.toml", with(everything, {{"61] }", "261] }"}}));
  for (const int signal : {SIGINT, SIGTERM}) {
    fs::remove_all(here / "r.chunks");
    Process process(command_of_ranks(2, {"s.toml", "-o", "r"}), surroundings_of_ranks(here));
    wait_for_chunks(here);
    process.send(signal);
    const Result ended = process.finish();
    INFO(ended.out << ended.err);
    CHECK(ended.status != 0);
    CHECK(contents(here / "r") == earlier);
    // mpiexec may end before its ranks have cleared away.
    const std::set<std::string> expected{"r", "r.chunks", "s.toml"};
    for (int k = 0; k < 500 && names_in(here.path()) != expected; ++k) usleep(10'000);
    CHECK(names_in(here.path()) == expected);
  }
  // That they are read shows where one of them is damaged.
  for (const auto& file : fs::recursive_directory_iterator(here / "r.chunks"))
    if (file.is_regular_file()) {
      fs::resize_file(file.path(), 50);
      break;
    }
  const Result rerun = ranks(here, 2, {"s.toml", "-o", "r"});
  INFO(rerun.out << rerun.err);
  CHECK(rerun.status == 0);
  CHECK_THAT(rerun.err, Contains("1 chunk") && Contains("done again"));
  CHECK_FALSE(fs::exists(here / "r.chunks"));
}

TEST_CASE("what all ranks would say one says") {
  if (!fs::exists(parallel_program)) return;
  const Workshop here;
  const auto times = [](const std::string& words, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = words.find(part); at != std::string::npos; at = words.find(part, at + 1)) ++n;
    return n;
  };
  const Result wrong = ranks(here, 3, {"s.toml", "--no-such-option"});
  CHECK(wrong.status == 2);
  CHECK(times(wrong.out + wrong.err, "--no-such-option") == 1);
  const Result help = ranks(here, 3, {"--help"});
  CHECK(help.status == 0);
  CHECK(times(help.out + help.err, "--max-memory") == 1);
}

TEST_CASE("a shard is one of its number, and of a report alone") {
  const Workshop here;
  here.write("s.toml", small);
  for (const std::string wrong : {"0/3", "4/3", "1", "a/b", "1/0", "-1/3", "1/3x", ""}) {
    const Result result = run_pmreport({"s.toml", "--shard", wrong}, {.folder = here.path()});
    CHECK(result.status == 2);
    CHECK_THAT(result.err, Contains("expected I/N with I from 1 to N, as in 3/64"));
  }
  CHECK_THAT(run_pmreport({"merge", "s.toml", "--shard", "1/3"}, {.folder = here.path()}).err,
             Contains("--shard: expected with one scenario"));
}
