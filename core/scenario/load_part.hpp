// [load]
#pragma once

#include <core/scenario/load.hpp>
#include <core/scenario/read/reader.hpp>
#include <optional>
#include <string>
#include <vector>

namespace pmreport::scenario {

// All but its samples: what a motion from forces feels must be known at any time before there is one.
struct LoadPart {
  struct Component {
    std::string key;
    Place place;
    Expression expression;
  };
  Load load;
  std::vector<std::optional<Component>> components;  // force, moment; nothing: zero, or wrong
};
LoadPart read_load(const Entry* entry, const Reader& reader);
// The load at every sample; told where it has no finite value.
Load sampled(LoadPart part, const std::vector<double>& time, Diagnostics& diagnostics);

}  // namespace pmreport::scenario
