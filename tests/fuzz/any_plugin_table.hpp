// A plugin's table as a row of choices makes it: sound where all of them are the first, and as long as it says in every other case too.
// Each struct and list is memory of its own, to the byte, so that a sanitizer sees who looks beyond.
#pragma once

#include <pmreport/plugin.h>
#include <tests/fuzz/choices.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace fuzz {

class PluginTable {
 public:
  explicit PluginTable(std::string_view bytes) : choices_(bytes) {
    pm_plugin_table t{};
    t.struct_size = size(sizeof t);
    t.abi_major = static_cast<std::uint32_t>(PM_ABI_MAJOR + choices_.of(3) / 2);
    t.abi_minor = choices_.take<std::uint8_t>();
    t.build = text("test");
    t.mechanism_count = 1 + choices_.of(4);
    if (t.mechanism_count == 4) t.mechanism_count = 0;
    std::vector<const pm_mechanism*> all;
    for (std::size_t i = 0; i < t.mechanism_count; ++i) all.push_back(may_lack(mechanism()));
    t.mechanisms = may_lack(list(all));
    table_ = put(t, t.struct_size);
  }
  const pm_plugin_table& table() const { return *table_; }

 private:
  // As long as the struct says, with whatever is beyond what we know.
  template <class T>
  const T* put(const T& x, std::size_t bytes) {
    memory_.emplace_back(new char[std::max(bytes, sizeof(std::size_t))]());
    std::memcpy(memory_.back().get(), &x, std::min(std::max(bytes, sizeof(std::size_t)), sizeof x));
    return reinterpret_cast<const T*>(memory_.back().get());
  }
  template <class T>
  const T* list(const std::vector<T>& all) {
    memory_.emplace_back(new char[all.size() * sizeof(T)]);
    if (!all.empty()) std::memcpy(memory_.back().get(), all.data(), all.size() * sizeof(T));
    return reinterpret_cast<const T*>(memory_.back().get());
  }
  // Whole, longer as of a newer version, or cut.
  std::size_t size(std::size_t whole) {
    const std::size_t kind = choices_.of(8);
    return kind == 6 ? whole + choices_.of(32) : kind == 7 ? choices_.of(whole) : whole;
  }
  template <class T>
  T may_lack(T x) {
    return choices_.once_in(32) ? T{} : x;
  }
  const char* text(std::string_view usual) {
    const std::size_t kind = choices_.of(16);
    if (kind == 15) return nullptr;
    std::string out(kind == 14 ? choices_.text(choices_.of(40)) : usual);
    if (kind == 13) out += static_cast<char>('a' + choices_.of(26));
    memory_.emplace_back(new char[out.size() + 1]);
    std::memcpy(memory_.back().get(), out.c_str(), out.size() + 1);
    return memory_.back().get();
  }
  double number(double usual) { return choices_.once_in(16) ? choices_.take<double>() : usual; }
  std::size_t count(std::size_t usual) { return choices_.once_in(16) ? choices_.take<std::size_t>() : usual; }

  pm_parameter parameter(const char* name) {
    pm_parameter p{};
    p.name = text(name), p.title = text("title"), p.unit = text("m"), p.display = text("mm");
    p.kind = static_cast<pm_parameter_kind>(choices_.of(4));
    const double usual = p.kind == PM_CHOICE ? 1 : 0.5;
    std::vector<double> defaults;
    for (std::size_t i = 0, n = 1 + choices_.of(4) / 3; i < n; ++i) defaults.push_back(number(usual));
    if (choices_.once_in(16)) defaults.clear();
    p.defaults = may_lack(list(defaults)), p.default_count = defaults.size();
    p.min = number(0), p.max = number(1), p.count_min = count(1), p.count_max = count(3);
    std::vector<const char*> words;
    for (std::size_t i = 0, n = 2 + choices_.of(3); p.kind == PM_CHOICE && i < n; ++i) words.push_back(text("word"));
    p.choices = may_lack(list(words)), p.choice_count = words.size();
    p.unless = choices_.once_in(4) ? text("b") : nullptr;
    return p;
  }
  pm_list parameters() {
    static constexpr const char* names[] = {"a", "b", "c", "d"};
    const std::size_t n = choices_.of(5), stride = size(sizeof(pm_parameter));
    std::vector<char> bytes(n * stride);
    for (std::size_t i = 0; i < n; ++i) {
      const pm_parameter p = parameter(names[i]);
      std::copy_n(reinterpret_cast<const char*>(&p), std::min(stride, sizeof p), bytes.begin() + static_cast<std::ptrdiff_t>(i * stride));
    }
    return {may_lack(list(bytes)), n, stride};
  }
  // All functions of a facet are there, or one is not. Nobody calls them.
  template <class T>
  const T* facet() {
    T out{};
    out.struct_size = size(sizeof out);
    constexpr std::size_t functions = (sizeof out - sizeof out.struct_size) / sizeof(void*);
    const std::size_t missing = choices_.of(8);
    for (std::size_t k = 0; k < functions; ++k) {
      const std::uintptr_t some = k == missing - 1 ? 0 : 1;
      std::memcpy(reinterpret_cast<char*>(&out) + sizeof out.struct_size + k * sizeof some, &some, sizeof some);
    }
    return put(out, out.struct_size);
  }
  const pm_mechanism* mechanism() {
    pm_mechanism m{};
    m.struct_size = size(sizeof m);
    m.name = text(names_.size() == 1 ? "one" : names_.size() == 2 ? "two" : "three");
    names_.push_back(m.name != nullptr ? m.name : "");
    m.title = text("title"), m.source = text("source");
    m.dof = choices_.once_in(8) ? choices_.take<std::int32_t>() : 6;
    m.parameters = parameters();
    m.create = may_lack([](const pm_value*, std::size_t, pm_instance**, pm_text*) { return pm_status{PM_FAILED}; });
    m.destroy = may_lack([](pm_instance*) {});
    m.kinematics = may_lack(facet<pm_kinematics>()), m.statics = may_lack(facet<pm_statics>());
    m.dynamics = may_lack(facet<pm_dynamics>()), m.appearance = may_lack(facet<pm_appearance>());
    m.closed_forms = may_lack(facet<pm_closed_forms>()), m.elasticity = may_lack(facet<pm_elasticity>());
    return put(m, m.struct_size);
  }

  Choices choices_;
  std::vector<std::unique_ptr<char[]>> memory_;
  std::vector<std::string> names_{""};
  const pm_plugin_table* table_ = nullptr;
};

}  // namespace fuzz
