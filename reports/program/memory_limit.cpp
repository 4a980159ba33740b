#include <reports/program/memory_limit.hpp>

#include <core/text/text.hpp>

#include <fmt/format.h>

#include <sys/resource.h>
#include <unistd.h>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string_view>

namespace pmreport::program {

namespace {

constexpr double share = 0.9;  // of what is available: estimates are rough, and others live here too
constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr std::size_t most_told = 4;

// The number behind a word in a file of lines, such as "MemAvailable:   123 kB".
std::optional<double> number_behind(const char* file, std::string_view word) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(word)) return std::strtod(line.c_str() + word.size(), nullptr);
  return std::nullopt;
}

// The whole of a file; "max" is no limit, and so is a file that is not there.
double number_in(const std::filesystem::path& file) {
  std::ifstream in(file);
  double x = 0;
  return in >> x ? x : unlimited;
}

// Of the group and all that it lies in; what a file system has kept of files is given back where memory is asked for.
double left_in_groups() {
  double least = unlimited;
  std::ifstream groups("/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const bool unified = controllers.empty();
    if (!unified && controllers.find("memory") == std::string::npos) continue;
    const std::filesystem::path root = unified ? "/sys/fs/cgroup" : "/sys/fs/cgroup/memory";
    const char* const limit = unified ? "memory.max" : "memory.limit_in_bytes";
    const char* const used = unified ? "memory.current" : "memory.usage_in_bytes";
    for (std::filesystem::path group = std::filesystem::path(line.substr(second + 1)).relative_path();; group = group.parent_path()) {
      const std::filesystem::path folder = group.empty() ? root : root / group;
      if (const double most = number_in(folder / limit); std::isfinite(most)) {
        const double files =
            number_behind((folder / "memory.stat").c_str(), unified ? "inactive_file " : "total_inactive_file ").value_or(0);
        const double now = number_in(folder / used);
        least = std::min(least, most - (std::isfinite(now) ? std::max(0.0, now - files) : 0));
      }
      if (group.empty()) break;
    }
  }
  return std::max(0.0, least);
}

double left_of_addresses() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unlimited;
  const double now = number_in("/proc/self/statm") * static_cast<double>(sysconf(_SC_PAGESIZE));
  return std::max(0.0, static_cast<double>(limit.rlim_cur) - (std::isfinite(now) ? now : 0));
}

}  // namespace

std::optional<double> size_of(const std::string& text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || !(value > 0) || !std::isfinite(value)) return std::nullopt;
  const std::string_view unit = trim(std::string_view(rest, static_cast<std::size_t>(end - rest)));
  constexpr std::pair<std::string_view, double> units[] = {{"kB", 1e3},   {"MB", 1e6},          {"GB", 1e9},     {"TB", 1e12},
                                                           {"KiB", 1024}, {"MiB", 1024 * 1024}, {"GiB", 0x1p30}, {"TiB", 0x1p40}};
  for (const auto& [name, size] : units)
    if (unit == name) return value * size;
  return std::nullopt;
}

Available available_memory() {
  const std::optional<double> machine = number_behind("/proc/meminfo", "MemAvailable:");
  Available out{machine ? *machine * 1024 : unlimited, "this machine has available"};
  for (const auto& [bytes, by] :
       {std::pair{left_in_groups(), "the group of processes may still take (cgroup)"}, {left_of_addresses(), "`ulimit -v` leaves"}})
    if (bytes < out.bytes) out = {bytes, by};
  return out;
}

void require_memory(const section::MemoryNeed& need, const std::optional<double>& most) {
  using section::memory_words;
  const Available there = most ? Available{*most, ""} : available_memory();
  const double may = most ? *most : share * there.bytes;
  if (need.bytes() <= may) return;
  std::string parts, less;
  for (std::size_t i = 0; i < std::min(need.parts.size(), most_told); ++i) {
    const section::MemoryNeed::Part& p = need.parts[i];
    parts += fmt::format("{}{} for {}", i > 0 ? ", " : "", memory_words(p.bytes), p.what);
    if (less.empty() && !p.less.empty()) less = p.less + ", or ";
  }
  const std::string bound = most ? fmt::format("--max-memory allows {}", memory_words(may))
                                 : fmt::format("{} {}, of which {} may be used", there.by, memory_words(there.bytes), memory_words(may));
  throw TooLarge(
      fmt::format("the report would take about {} of memory at its peak, and {}; nothing was begun\n       it is {}\n       ask for "
                  "{}allow more by --max-memory",
                  memory_words(need.bytes()), bound, parts, less));
}

}  // namespace pmreport::program
