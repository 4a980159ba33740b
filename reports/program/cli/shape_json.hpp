// What may stand in a scenario, as JSON Schema.
#pragma once

#include <core/scenario/section/key.hpp>

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace pmreport::program {

using Json = nlohmann::ordered_json;

// Names that a mechanism has, by what they are: "coordinates", "actuators", "joints", "parameters". Empty: of no mechanism in particular.
using NamesByKind = std::map<std::string, std::vector<std::string>>;

Json json_of(const scenario::Shape& shape, const NamesByKind& names);

// An object that has these keys and no others.
Json json_of_keys(const std::vector<scenario::Key>& keys, const NamesByKind& names);

}  // namespace pmreport::program
