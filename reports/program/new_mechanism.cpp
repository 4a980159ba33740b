#include <reports/program/commands.hpp>
#include <reports/program/scaffold.hpp>
#include <reports/program/terminal.hpp>

#include <fmt/core.h>

namespace pmreport::program {

int new_mechanism(const Options& options) {
  const std::string& name = options.names.front();
  if (const std::string fault = fault_of_name(name); !fault.empty()) throw ScaffoldError(fault);
  const host::Catalog catalog(host::search_folders(options.plugin_path));
  if (const host::Entry* e = catalog.find(name))
    throw ScaffoldError(fmt::format("there is a mechanism '{}' already, {}; choose another name", name, e->file.string()));
  const std::filesystem::path made = write_scaffold(name, options.folder);
  put("{}: mechanism.cpp, CMakeLists.txt, scenario.toml; README.md tells the three commands that build, check and report\n", made.string());
  return all_well;
}

}  // namespace pmreport::program
