// Loading one plugin library. A library stays loaded until the process ends: pointers into it never dangle.
#pragma once

#include <pmreport/plugin.h>

#include <core/host/refusal.hpp>
#include <filesystem>
#include <string>
#include <vector>

namespace pmreport::host {

struct PluginFile {
  std::filesystem::path path;  // as asked for
  std::string level;           // of the processor that the loaded build is for, "x86-64-v3" (processor.hpp); empty: any
  const pm_plugin_table* table;
  std::vector<const pm_mechanism*> mechanisms;
};

// Loads and checks `path`, or its best build for this processor: a shared library, the symbol, ABI, struct sizes, no null function, sane
// names. Does not make an instance. A build for a processor must have the same mechanisms as the plain one.
PluginFile load_plugin(const std::filesystem::path& path);

// What a library runs as it is loaded may end the process. Whoever lives on can know which it was: `loading` is called before each load and
// after it.
void watch_loading(void (*loading)(const std::filesystem::path& file, bool begins));
// Such a library, which is refused from now on without being loaded. `end`: what ended the process, "Segmentation fault (signal 11)".
void leave_out(const std::filesystem::path& file, const std::string& end);

}  // namespace pmreport::host
