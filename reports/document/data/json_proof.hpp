// The part of results.json that tells what was proved for every instant.
#pragma once

#include <nlohmann/json.hpp>
#include <reports/document/every_instant.hpp>

namespace pmreport::document {

using Json = nlohmann::ordered_json;

// Brackets are pairs [low, high], SI; an end of which nothing is known is null.
Json json_of(const EveryInstant& proof);

}  // namespace pmreport::document
