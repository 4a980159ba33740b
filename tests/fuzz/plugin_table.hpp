// What holds for every table of a plugin that is as long as it says: it is refused in one line, or it is sound, and nothing beyond its
// ends was looked at (the sanitizers see to that: each struct and list is memory of its own, to the byte).
#pragma once

#include <core/host/plugin_table.hpp>
#include <core/host/refusal.hpp>
#include <tests/fuzz/any_plugin_table.hpp>
#include <tests/fuzz/scratch.hpp>

#include <cstddef>
#include <set>
#include <string>

namespace fuzz {

inline std::string broken_by_plugin_table(const std::string& bytes) {
  const PluginTable plugin(bytes);
  const pm_plugin_table& t = plugin.table();
  try {
    pmreport::host::require_sound(t, "p.so");
  } catch (const pmreport::host::PluginError& e) {
    const std::string sentence = e.what();
    if (!sentence.starts_with("p.so")) return "a refusal that does not say of what";
    return has_control(sentence, "") ? "a refusal of more lines than one, or with a control character" : "";
  }
  std::set<std::string> names;
  for (std::size_t i = 0; i < t.mechanism_count; ++i) {
    const pm_mechanism& m = *t.mechanisms[i];
    if (!names.insert(m.name).second) return "two mechanisms of one name";
    if (m.dof < 1 || m.dof > 6) return "a mechanism of no such freedom";
    for (std::size_t k = 0; k < m.parameters.count; ++k) {
      pm_parameter p{};
      std::memcpy(&p, static_cast<const char*>(m.parameters.items) + k * m.parameters.stride, offsetof(pm_parameter, choice_count));
      if (std::string(p.name).empty() || p.title == nullptr || p.unit == nullptr || p.display == nullptr)
        return "a parameter without words";
      for (std::size_t d = 0; d < p.default_count; ++d)
        if (p.kind != PM_CHOICE && !(p.defaults[d] >= p.min && p.defaults[d] <= p.max)) return "a default out of its range";
    }
  }
  return {};
}

}  // namespace fuzz
