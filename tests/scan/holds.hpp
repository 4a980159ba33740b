// A bracket of a volume against its closed form.
#pragma once

#include <catch2/catch.hpp>
#include <core/scan/proved_volume.hpp>

namespace pmreport::scan {

inline constexpr double of_the_form = 1e-14;  // what a closed form in double precision may be off by, relative

inline void check_holds(const ProvedVolume& proved, double truth) {
  INFO("[" << proved.volume.low << ", " << proved.volume.high << "] for " << truth << " " << proved.why);
  CHECK(proved.volume.low <= truth * (1 + of_the_form));
  CHECK(truth * (1 - of_the_form) <= proved.volume.high);
}

}  // namespace pmreport::scan
