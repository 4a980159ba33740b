// Limits on pressure angles and on the local transmission index, as margins that intervals can bound.
//
// By squares and without a division: with u_i of guided_motions.hpp, v the velocity under it of the point where a force f acts, an angle of
// cosine |f . v| / (|f| |v|) is no more than its limit where
//     (f . v)^2 - cos^2 (f . f) (v . v) >= 0
// and of the input transmission v is the way of the drive. Where v = 0 the cosine is 0 (transmission.hpp) and this margin too: of what must
// be no less than something positive the least positive number is taken off, which no other pose notices.
#pragma once

#include <core/mechanics/machine/machine.hpp>
#include <core/program/guided.hpp>

#include <span>

namespace pmreport::mechanics {

struct IndexLimit {
  enum class Of { pressure, transmission } of;  // of every actuator's pressure angle [rad]; of the local transmission index
  double min, max;                              // an infinite end makes no margin
};

// One margin an end, lower ends first; of pressure angles so many for each actuator. Indices that the mechanism must have, and it must
// record its geometry. Throws program::ProgramError: more operations than there is room for.
program::Guided index_margins(const Machine& machine, std::span<const IndexLimit> limits);

}  // namespace pmreport::mechanics
