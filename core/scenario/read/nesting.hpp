// How deep a text nests its tables and lists, seen before anything walks into them: whoever reads or frees a tree recurses.
#pragma once

#include <core/scenario/read/diagnostics.hpp>
#include <optional>
#include <string_view>

namespace pmreport::scenario {

constexpr int deepest_nesting = 40;  // no scenario needs ten

// Where a TOML text nests deeper than that: by brackets, or by a key of so many parts, a.a.a. Whether it is sound TOML is no matter.
std::optional<Place> too_deep(std::string_view text);

}  // namespace pmreport::scenario
