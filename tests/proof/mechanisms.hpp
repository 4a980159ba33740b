// The mechanisms of the house, and random motions of them.
#pragma once

#include <core/mechanics/machine/machine.hpp>
#include <tests/proof/sine_motion.hpp>

#include <memory>
#include <random>
#include <string>
#include <vector>

namespace pmreport::test {

inline const std::vector<std::string>& names_of_the_house() {
  static const std::vector<std::string> names{"2q-spr", "4sps-spr",    "5pus-upu",       "delta",  "gough",
                                              "par4",   "p2prpu-prps", "parallel-cross", "stewart"};
  return names;
}
std::unique_ptr<mechanics::Machine> mechanism_of_the_house(const std::string& name);

// A sine in each coordinate about home, of a share of its box between these two, one to three turns in `duration`.
std::vector<Sine> random_sines(const mechanics::Machine& machine, std::mt19937_64& random, double least_share, double largest_share,
                               double duration);

}  // namespace pmreport::test
