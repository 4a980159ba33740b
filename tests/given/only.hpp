// A plugin path with one mechanism on it.
#pragma once

#include <core/scenario/loaded.hpp>
#include <pmreport/mechanism.hpp>

#include <string>

namespace pmreport::test {

inline scenario::MechanismSource only(const pm_mechanism& table) {
  return {[&table](const std::string& name) { return name == table.name ? &table : nullptr; }, {table.name}};
}
template <class M>
scenario::MechanismSource only() {
  return only(contract::mechanism<M>);
}

}  // namespace pmreport::test
