// What moves the machine in the page, as one program: where everything is, and how it moves to first order.
#pragma once

#include <core/mechanics/machine/machine.hpp>
#include <core/program/program.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace pmreport::section {

struct LiveGeometry {
  // Inputs: the coordinates. Outputs: the reach; of each body but the base its origin and rotation, row by row, of a slender one its axis;
  // then as told here. With q the coordinates, m of them:
  program::Program program;
  std::vector<std::size_t> bodies;  // first output of each; of the base, which stays where it is, 0
  struct Guide {                    // of a slender body whose turn about its own axis a joint's axis tells
    int body;
    std::size_t at;  // the joint's axis, 3 numbers
  };
  std::vector<Guide> guides;
  std::size_t actuators = 0;  // m values
  std::size_t derived = 0;    // as many as there are
  std::size_t jacobian = 0;   // 36 numbers of G, row by row
  struct Motion {             // of a joint, judged by a limit
    int joint, limit;
    std::size_t at;
  };
  std::vector<Motion> motions;
  std::size_t rates = 0;   // d actuators / dq, m rows of m
  std::size_t twist = 0;   // (d origin / dq; angular displacement by dq) of the platform, 6 rows of m
  std::size_t masses = 0;  // d (sum of mass times centre of mass over all bodies) / dq, 3 rows of m
};

// Nothing where the mechanism records no program.
std::optional<LiveGeometry> live_geometry(const mechanics::Machine& machine);

}  // namespace pmreport::section
