#include <core/host/processor.hpp>
#include <core/host/refusal.hpp>

#include <core/vectors.hpp>

#include <cstdlib>
#include <string_view>
#include <system_error>

namespace pmreport::host {

std::vector<std::string> processor_levels() {
  std::vector<std::string> levels;
  const char* asked = std::getenv("PMREPORT_PROCESSOR");
  const std::string_view highest = asked != nullptr ? asked : "";
  if (vector_level() >= 4 && highest != "x86-64" && highest != "x86-64-v3") levels.push_back("x86-64-v4");
  if (vector_level() >= 3 && highest != "x86-64") levels.push_back("x86-64-v3");
  return levels;
}

std::string fault_of_processor() {
  const char* asked = std::getenv("PMREPORT_PROCESSOR");
  const std::string_view highest = asked != nullptr ? asked : "";
  for (const std::string_view known : {"", "x86-64", "x86-64-v3", "x86-64-v4"})
    if (highest == known) return {};
  return "PMREPORT_PROCESSOR: expected x86-64, x86-64-v3 or x86-64-v4, seen " + quoted(highest);
}

std::filesystem::path best_build(const std::filesystem::path& plugin, const std::vector<std::string>& levels) {
  std::error_code error;
  for (const std::string& level : levels)
    if (const auto file = plugin.parent_path() / level / plugin.filename(); std::filesystem::is_regular_file(file, error)) return file;
  return plugin;
}

}  // namespace pmreport::host
