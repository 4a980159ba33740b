#include <core/host/processor.hpp>

#include <cstdlib>
#include <string_view>
#include <system_error>

namespace pmreport::host {

std::vector<std::string> processor_levels() {
  std::vector<std::string> levels;
#ifdef __x86_64__
  // The features of each level that compilers use in geometry; the others of the level came with the same processors.
  const bool v3 =
      __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
  const bool v4 = v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd") &&
                  __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
  const char* asked = std::getenv("PMREPORT_PROCESSOR");
  const std::string_view highest = asked != nullptr ? asked : "";
  if (v4 && highest != "x86-64" && highest != "x86-64-v3") levels.push_back("x86-64-v4");
  if (v3 && highest != "x86-64") levels.push_back("x86-64-v3");
#endif
  return levels;
}

std::filesystem::path best_build(const std::filesystem::path& plugin, const std::vector<std::string>& levels) {
  std::error_code error;
  for (const std::string& level : levels)
    if (const auto file = plugin.parent_path() / level / plugin.filename(); std::filesystem::is_regular_file(file, error)) return file;
  return plugin;
}

}  // namespace pmreport::host
