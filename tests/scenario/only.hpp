// A plugin path with one mechanism on it.
#pragma once

#include <core/scenario/loaded.hpp>
#include <pmreport/mechanism.hpp>

#include <string>

namespace pmreport::test {

template <class M>
scenario::MechanismSource only() {
  return {[](const std::string& name) { return name == M::name ? &contract::mechanism<M> : nullptr; }, {M::name}};
}

}  // namespace pmreport::test
