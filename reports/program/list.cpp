#include <core/text/text.hpp>
#include <reports/program/commands.hpp>
#include <reports/program/terminal.hpp>

#include <fmt/core.h>

namespace pmreport::program {

void tell_refused(const host::Catalog& catalog) {
  for (const std::string& sentence : catalog.refused()) tell("warning: {}\n", sentence);
}

// A mechanism by name, or those of a library file given by its path.
std::vector<const pm_mechanism*> mechanisms_named(const host::Catalog& catalog, const std::string& name) {
  if (name.find('/') != std::string::npos || name.ends_with(".so")) return host::load_plugin(name).mechanisms;
  if (const host::Entry* e = catalog.find(name)) return {e->mechanism};
  std::string known;
  for (const host::Entry& e : catalog.entries()) known += (known.empty() ? "" : ", ") + e.name;
  throw host::PluginError(fmt::format("no mechanism is called '{}'; known: {}", name, known.empty() ? "none" : known));
}

scenario::MechanismSource source_of(const host::Catalog& catalog) {
  scenario::MechanismSource source;
  source.find = [&catalog](const std::string& name) {
    const host::Entry* entry = catalog.find(name);
    return entry != nullptr ? entry->mechanism : nullptr;
  };
  for (const host::Entry& e : catalog.entries()) source.names.push_back(e.name);
  return source;
}

int list(const Options& options) {
  const host::Catalog catalog(host::search_folders(options.plugin_path));
  tell_refused(catalog);
  for (const host::Entry& e : catalog.entries())
    put("{:<16} {}\n{:<16} {}\n", e.name, one_line(e.mechanism->title), "", printable(e.file.string()));
  if (catalog.entries().empty()) {
    tell("no mechanism found; searched:\n");
    for (const std::filesystem::path& f : catalog.folders()) tell("  {}\n", f.string());
    return plugin_failed;
  }
  return all_well;
}

}  // namespace pmreport::program
