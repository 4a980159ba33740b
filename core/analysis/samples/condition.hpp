// How a sample fares.
#pragma once

#include <cstdint>

namespace pmreport::analysis {

enum class Condition : std::uint8_t { good, singular, unreachable, failed };

}  // namespace pmreport::analysis
