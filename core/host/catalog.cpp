#define BOOST_DLL_USE_STD_FS
#include <sys/stat.h>
#include <sys/utsname.h>

#include <algorithm>
#include <boost/dll/runtime_symbol_info.hpp>
#include <core/host/catalog.hpp>
#include <core/host/refusal.hpp>
#include <cstdlib>
#include <set>
#include <system_error>

namespace pmreport::host {
namespace {

namespace fs = std::filesystem;

std::string_view environment(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

// The folders of a list with colons between. An empty element would mean the working directory to a shell: here it means nothing.
std::vector<fs::path> split(std::string_view list) {
  std::vector<fs::path> folders;
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(':'), list.size());
    if (end > 0) folders.emplace_back(list.substr(0, end));
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return folders;
}

// Where `cmake --install` puts the plugins of a program in <prefix>/bin: CMAKE_INSTALL_LIBDIR is lib, or lib64 on other distributions, or
// lib/x86_64-linux-gnu on Debian for the prefix /usr.
std::vector<fs::path> beside_program() {
  std::error_code error;
  const fs::path program = boost::dll::program_location(error);
  if (error) return {};
  const fs::path prefix = program.parent_path().parent_path();
  std::vector<fs::path> folders{prefix / "lib", prefix / "lib64"};
  if (utsname system{}; uname(&system) == 0) folders.push_back(prefix / "lib" / (std::string(system.machine) + "-linux-gnu"));
  for (fs::path& folder : folders) folder /= "pmreport/plugins";
  return folders;
}

// A relative XDG_DATA_HOME is to be ignored, says the XDG Base Directory Specification; so is a relative HOME here.
std::vector<fs::path> of_user() {
  fs::path data(environment("XDG_DATA_HOME"));
  if (!data.is_absolute()) data = fs::path(environment("HOME")) / ".local/share";
  if (!data.is_absolute()) return {};
  return {data / "pmreport/plugins"};
}

// A file by what it is, not by what it is called: links to one file are that file. All zero: there is none.
using Identity = std::pair<dev_t, ino_t>;
Identity identity(const fs::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return {};
  return {status.st_dev, status.st_ino};
}

std::vector<fs::path> libraries_in(const fs::path& folder, std::vector<std::string>& refused) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
    if (at->path().extension() == ".so") files.push_back(at->path());
  if (error && error != std::errc::no_such_file_or_directory && error != std::errc::not_a_directory)
    refused.push_back(folder.string() + ": expected a folder that can be read, seen " + error.message() + "; check its permissions");
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<fs::path> search_folders(const std::vector<fs::path>& from_command_line) {
  std::vector<fs::path> folders = from_command_line;
  for (const auto& more : {split(environment("PMREPORT_PLUGIN_PATH")), beside_program(), of_user()})
    folders.insert(folders.end(), more.begin(), more.end());
  return folders;
}

Catalog::Catalog(const std::vector<fs::path>& folders) : folders_(folders) {
  std::set<Identity> seen;
  for (const fs::path& folder : folders)
    for (const fs::path& file : libraries_in(folder, refused_)) {
      if (const Identity id = identity(file); id != Identity{} && !seen.insert(id).second) continue;
      try {
        const PluginFile plugin = load_plugin(file);
        for (const pm_mechanism* mechanism : plugin.mechanisms)
          entries_.push_back({mechanism->name, mechanism, file, plugin.table->build + (plugin.level.empty() ? "" : ", " + plugin.level)});
      } catch (const PluginError& error) {
        refused_.push_back(error.what());
      }
    }
  std::stable_sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) { return a.name < b.name; });
  const auto twin = std::adjacent_find(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) { return a.name == b.name; });
  if (twin != entries_.end())
    refuse("mechanism '" + twin->name + "'", "one plugin of that name", twin->file.string() + " and " + std::next(twin)->file.string(),
           "remove one of them, or name other plugin folders");
}

const Entry* Catalog::find(std::string_view name) const {
  const auto at = std::lower_bound(entries_.begin(), entries_.end(), name, [](const Entry& a, std::string_view n) { return a.name < n; });
  return at != entries_.end() && at->name == name ? &*at : nullptr;
}

}  // namespace pmreport::host
