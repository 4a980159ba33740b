// Which mechanisms there are. Folders are searched in this order: --plugin-path, PMREPORT_PLUGIN_PATH (folders with colons between), beside
// the program (../lib/pmreport/plugins of its own folder, in a build tree as when installed; lib64 and Debian's lib/<machine>-linux-gnu
// likewise), then the user's ($XDG_DATA_HOME or ~/.local/share)/pmreport/plugins. Never the working directory by default.
// Two files with a mechanism of the same name are an error; one file met twice, by a link for one, is not.
#pragma once

#include <core/host/plugin_file.hpp>
#include <optional>
#include <string_view>

namespace pmreport::host {

std::vector<std::filesystem::path> search_folders(const std::vector<std::filesystem::path>& from_command_line);

struct Entry {
  std::string name;
  const pm_mechanism* mechanism;
  std::filesystem::path file;
  std::string build;
};

class Catalog {
 public:
  // Loads every *.so of the folders, in the order of their names. Missing folders are skipped. A file that cannot be loaded does not stop
  // the others: it is told in `refused`. Throws PluginError for duplicates, naming both files.
  explicit Catalog(const std::vector<std::filesystem::path>& folders);

  const std::vector<Entry>& entries() const { return entries_; }  // by name
  const std::vector<std::string>& refused() const { return refused_; }
  const std::vector<std::filesystem::path>& folders() const { return folders_; }
  const Entry* find(std::string_view name) const;

 private:
  std::vector<Entry> entries_;
  std::vector<std::string> refused_;
  std::vector<std::filesystem::path> folders_;
};

}  // namespace pmreport::host
