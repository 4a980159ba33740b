// Other parameters of a mechanism, at which its properties are to hold as well: a mistake may show with another choice, working mode or
// size alone.
#pragma once

#include <core/mechanics/machine/machine.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace pmreport::mechanics {

struct Setting {
  std::string words;  // how it differs: "elbow1 = in, elbow3 = in"
  std::unique_ptr<Machine> machine;
};

struct Settings {
  std::vector<Setting> taken;
  int refused = 0;      // settings that the mechanism refused, each with a reason
  std::string example;  // of the first of them: "arm_highest must be less than arm_lowest"
};

// Other words for the choices, working modes among them: every combination when there are at most `most`, else each word alone. Numbers
// stay as they are. Throws MechanismError when the plugin breaks at one.
Settings other_choices(const Machine& machine, std::size_t most = 256);

// Other numbers, choices staying. `draws` times all of them at once, within a third of their own size; three tries each. Then each alone
// towards either end of its range, to ten times its own size at most, for with sizes more unlike the rounding would be judged: to the end,
// or half, a quarter, an eighth of the way, the farthest that the mechanism takes. Parameters of no number stay empty. Throws as above.
Settings other_numbers(const Machine& machine, int draws, std::uint64_t seed);

}  // namespace pmreport::mechanics
