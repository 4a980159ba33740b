#define BOOST_DLL_USE_STD_FS
#include <dlfcn.h>

#include <algorithm>
#include <boost/dll/shared_library.hpp>
#include <core/host/library_file.hpp>
#include <core/host/plugin_file.hpp>
#include <core/host/plugin_table.hpp>
#include <core/host/processor.hpp>
#include <core/host/refusal.hpp>
#include <core/host/surroundings.hpp>
#include <cstring>
#include <map>
#include <mutex>
#include <utility>

namespace pmreport::host {
namespace {

// What the loader had to say. Boost's own text for every failure is "Bad file descriptor"; dlerror knows better, and begins with the path.
std::string loader_sentence(const std::filesystem::path& path) {
  const char* text = dlerror();
  std::string sentence = text != nullptr ? text : "no reason given";
  if (const std::string prefix = path.string() + ": "; sentence.starts_with(prefix)) sentence.erase(0, prefix.size());
  return sentence;
}

// Now, so that a missing symbol is told here and not by the end of the process in the middle of a report; local, so that plugins cannot
// bind to each other's symbols.
boost::dll::shared_library open(const std::filesystem::path& path, const std::string& where) {
  boost::dll::shared_library library;
  std::error_code error;
  library.load(path, boost::dll::load_mode::rtld_now | boost::dll::load_mode::rtld_local, error);
  if (error || !library.is_loaded())
    refuse(where, "a library that loads with all its symbols", loader_sentence(path),
           "link what is missing into the plugin, or install it");
  if (!library.has(PM_PLUGIN_SYMBOL))
    refuse(where, "the exported data symbol '" PM_PLUGIN_SYMBOL "'", "a library without it", "end the source with PMREPORT_PLUGIN(...)");
  return library;
}

struct Registry {
  std::mutex guard;
  std::vector<boost::dll::shared_library> libraries;  // refused ones as well: the unloading of C++ code is not dependable
  std::map<std::filesystem::path, PluginFile> plugins;
  std::map<std::filesystem::path, std::string> left_out;  // and what ended the process that loaded it
  void (*loading)(const std::filesystem::path&, bool) = [](const std::filesystem::path&, bool) {};
};

// Never destroyed: an object of the program that outlives main may still hold a pointer into a library.
Registry& registry() {
  static Registry& one = *new Registry;
  return one;
}

// Told from its beginning to its end, however that comes; what the library changes of the process is put back then.
class Loading {
 public:
  Loading(Registry& known, const std::filesystem::path& file) : known_(known), file_(file) { known.loading(file, true); }
  Loading(const Loading&) = delete;
  Loading& operator=(const Loading&) = delete;
  ~Loading() { end(); }
  // What had to be put back.
  std::vector<std::string> end() {
    if (std::exchange(ended_, true)) return {};
    known_.loading(file_, false);
    return before_.restore();
  }

 private:
  Registry& known_;
  const std::filesystem::path& file_;
  const Surroundings before_;
  bool ended_ = false;
};

// Loads one file, once a process. The registry is locked.
const PluginFile& load(Registry& known, const std::filesystem::path& path) {
  require_plugin_library(path);
  const std::filesystem::path file = std::filesystem::canonical(path);
  if (const auto same = known.plugins.find(file); same != known.plugins.end()) return same->second;
  const std::string where = path.string();
  if (const auto end = known.left_out.find(file); end != known.left_out.end())
    refuse(where, "a library that can be loaded", "a crash as it was: " + end->second, "take the file out of the plugin folder");
  Loading loading(known, file);
  const auto& library = known.libraries.emplace_back(open(file, where));
  if (const std::vector<std::string> changed = loading.end(); !changed.empty())
    refuse(where, "a library that leaves the program as it is", "one that changes " + changed.front() + " as it is loaded",
           "take that out of it, or build it without");
  const auto& table = library.get<const pm_plugin_table>(PM_PLUGIN_SYMBOL);
  require_sound(table, where);
  return known.plugins[file] = {path, {}, &table, {table.mechanisms, table.mechanisms + table.mechanism_count}};
}

// A build for a processor that is left over from another version of the plugin must not speak for it.
void require_same(const PluginFile& plain, const PluginFile& build) {
  const bool same = std::ranges::equal(plain.mechanisms, build.mechanisms, [](const pm_mechanism* a, const pm_mechanism* b) {
    return std::strcmp(a->name, b->name) == 0 && a->dof == b->dof && a->parameters.count == b->parameters.count;
  });
  if (!same || plain.table->abi_minor != build.table->abi_minor)
    refuse(build.path.string(), "the same mechanisms and parameters as in " + plain.path.string(), "others",
           "build both anew, or remove this one");
}

}  // namespace

void watch_loading(void (*loading)(const std::filesystem::path& file, bool begins)) {
  const std::lock_guard lock(registry().guard);
  registry().loading = loading;
}

void leave_out(const std::filesystem::path& file, const std::string& end) {
  const std::lock_guard lock(registry().guard);
  registry().left_out[file] = end;
}

PluginFile load_plugin(const std::filesystem::path& path) {
  Registry& known = registry();
  const std::lock_guard lock(known.guard);
  const PluginFile& plain = load(known, path);
  const std::filesystem::path best = best_build(path);
  if (best == path) return {path, {}, plain.table, plain.mechanisms};
  const PluginFile& build = load(known, best);
  require_same(plain, build);
  return {path, best.parent_path().filename().string(), build.table, build.mechanisms};
}

}  // namespace pmreport::host
