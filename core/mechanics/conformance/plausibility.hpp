// What of a mechanism's data looks odd. Numbers may be wrong although everything fits together: a length in mm where m were meant, a mass
// forgotten, a centre of mass on the wrong side. No law of mechanics forbids them, so nothing here fails: it is remarked, with the reason.
//
// Seen are the data at home: where the joints stand on their bodies, masses and inertias, what is drawn, strokes and limits. The order of
// the platform's turns, or which of two sound shapes was meant, cannot be seen in them.
#pragma once

#include <core/mechanics/machine/machine.hpp>

#include <string>
#include <vector>

namespace pmreport::mechanics {

struct Remark {
  std::vector<std::string> of;  // bodies, joints, limbs or actuators by name; several that are odd in the same way
  std::string seen;             // "the centre of mass lies 200 mm outside its joints ...": of several, with the worst named
  std::string usual;            // "a part's centre of mass lies between its ends"
  std::string reason;           // what may be wrong, and what it spoils
};

std::vector<Remark> plausibility(const Machine& machine);

// "cylinder 1 and cylinder 2: SEEN. Usually USUAL: REASON."
std::string sentence(const Remark& remark);

}  // namespace pmreport::mechanics
