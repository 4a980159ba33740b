#include <core/scenario/read/beside.hpp>

#include <core/text/text.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace pmreport::scenario {

std::optional<std::filesystem::path> file_beside(const std::string& given, Place place, const std::filesystem::path& scenario,
                                                 Diagnostics& diagnostics) {
  namespace fs = std::filesystem;
  const fs::path relative(std::u8string(given.begin(), given.end()));
  const auto refuse = [&](const std::string& why) {
    diagnostics.add(place, fmt::format("expected a file in the folder of the scenario, seen {}: {}", in_quotes(given), why));
    return std::nullopt;
  };
  if (given.empty() || given.find('\0') != std::string::npos) return refuse("no name of a file");
  if (relative.is_absolute()) return refuse("an absolute path");
  if (std::find(relative.begin(), relative.end(), fs::path("..")) != relative.end()) return refuse("it leads out of the folder");
  std::error_code error;
  const fs::path folder = fs::canonical(scenario.has_parent_path() ? scenario.parent_path() : fs::path("."), error);
  if (error) return refuse("the folder of the scenario cannot be found");
  const fs::path file = fs::canonical(folder / relative, error);
  if (error) return refuse("there is no such file");
  if (std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first != folder.end())
    return refuse("a link leads out of the folder");
  if (!fs::is_regular_file(file, error) || error) return refuse("not a regular file");
  return file;
}

std::string shown_beside(const std::string& given, const std::filesystem::path& scenario) {
  return printable(scenario.has_parent_path() ? (scenario.parent_path() / given).string() : given);
}

}  // namespace pmreport::scenario
