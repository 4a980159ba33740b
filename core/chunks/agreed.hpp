// A decision that may be another one elsewhere, such as what the clock says, made once for all who share work.
#pragma once

#include <core/chunks/sharing.hpp>

#include <cstdint>
#include <functional>
#include <string>

namespace pmreport::chunks {

// What `decide` says here, or at the one who was asked first. `meaning` with `name`: as of a Work, so that no other decision is taken for
// it. Of the watch it is only asked whether to stop. Throws what `run` throws.
bool agreed(const Sharing& sharing, std::string name, std::uint64_t meaning, const std::function<bool()>& decide, const Watch& watch = {});

}  // namespace pmreport::chunks
