// Reading what comes through the plain C of plugin.h. For the files that do, and nobody else.
#pragma once

#include <pmreport/plugin.h>

#include <algorithm>
#include <array>
#include <cfenv>
#include <core/mechanics/machine/mechanism_error.hpp>
#include <core/text/text.hpp>
#include <cstddef>
#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <vector>

namespace pmreport::mechanics::contract {

// What a plugin must keep: a broken one is told by a sentence.
inline void demand(bool condition, const std::string& sentence) {
  if (!condition) throw MechanismError(PM_FAILED, sentence);
}

// Item i of a list, whose items may be longer (a newer plugin) than ours.
template <class T>
T item(const pm_list& list, std::size_t i) {
  T out{};
  std::memcpy(&out, static_cast<const char*>(list.items) + i * list.stride, std::min(list.stride, sizeof(T)));
  return out;
}
// What a list must be before its items are looked at. Whoever cuts a struct between its members keeps to its alignment, as arrays do; a
// stride that does not may leave half a pointer.
template <class T>
void demand_list(const pm_list& list) {
  constexpr std::size_t most = 100'000;  // items: no mechanism has a hundredth of them
  demand(list.count <= most, "declares a list of more items than any mechanism has");
  demand(list.count == 0 || (list.items != nullptr && list.stride > 0), "declares a list that has items but no place for them");
  demand(list.stride % alignof(T) == 0, "declares a list whose stride cuts its items in two");
}
template <class T, class F>
auto map(const pm_list& list, F&& f) {
  demand_list<T>(list);
  std::vector<decltype(f(T{}))> out;
  for (std::size_t i = 0; i < list.count; ++i) out.push_back(f(item<T>(list, i)));
  return out;
}

// What a plugin says goes into files and onto terminals, whose lines and controls are not its business.
inline std::string text_or_empty(const char* s) { return s != nullptr ? one_line(s) : ""; }

// How numbers are rounded, put back at its end.
class Rounding {
 public:
  Rounding() : before_(std::fegetround()) {}
  Rounding(const Rounding&) = delete;
  Rounding& operator=(const Rounding&) = delete;
  ~Rounding() {
    if (changed()) std::fesetround(before_);
  }
  bool changed() const { return std::fegetround() != before_; }

 private:
  const int before_;
};

// Calls a function of the contract. It must neither throw, which plain C cannot carry, nor leave numbers rounded in another way.
template <class F>
pm_status undisturbed(F&& f) {
  const Rounding rounding;
  pm_status status = PM_FAILED;
  try {
    status = f();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    throw MechanismError(PM_FAILED, std::string("a function of the plugin threw an exception: ") + one_line(e.what()));
  } catch (...) {
    throw MechanismError(PM_FAILED, "a function of the plugin threw what is no std::exception");
  }
  demand(!rounding.changed(), "a function of the plugin changed how numbers are rounded (fesetround) and left it so");
  return status;
}

// The same with room for a sentence.
template <class F>
pm_status call(std::string& sentence, F&& f) {
  std::array<char, 512> buffer{};
  pm_text text{buffer.data(), buffer.size()};
  const pm_status status = undisturbed([&] { return f(&text); });
  buffer.back() = '\0';
  if (status != PM_OK) sentence = one_line(buffer.data());
  return status;
}

// Older plugins end before this member.
inline const pm_closed_forms* closed_forms_of(const pm_mechanism& table) {
  return table.struct_size >= offsetof(pm_mechanism, closed_forms) + sizeof(table.closed_forms) ? table.closed_forms : nullptr;
}

inline const pm_elasticity* elasticity_of(const pm_mechanism& table) {
  return table.struct_size >= offsetof(pm_mechanism, elasticity) + sizeof(table.elasticity) ? table.elasticity : nullptr;
}

inline bool records(const pm_mechanism& table) {
  return table.struct_size >= offsetof(pm_mechanism, record) + sizeof(table.record) && table.record != nullptr;
}

}  // namespace pmreport::mechanics::contract
