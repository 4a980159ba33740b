// Pressure angles of all drives, as a program.
//
// The output twist of actuator i is the platform's twist where it moves with unit rate and all others are held. With the actuators' values
// r(q), A = dr/dq, the coordinates then move with column i of A^-1. The pressure angle of a telescopic drive is the acute angle between its
// line f and the velocity v, under that twist, of the joint at its far end from that at its near end, which of a leg on the base stands
// still; of any other drive f is the force of its row of G, and v the velocity of the point where its limb holds the platform
// (transmission_paths.hpp):
//     cos = |f . v| / |v|,   0 where v = 0
// (Glazunov et al. 2008; definitions of transmission as in Takeda and Funabashi 1995). How fast it moves does not matter, so the cofactors
// of A's row i stand for column i of A^-1, which they are but for det A: nothing is divided by, and no row is picked as a pivot.
//
// Over a box of poses intervals bound it too widely to decide anything: a cofactor of five rows is a sum of 120 products that all but
// cancel. What bounds it there is index_margins.hpp.
#pragma once

#include <core/mechanics/machine/machine.hpp>
#include <core/program/program.hpp>

#include <string>

namespace pmreport::mechanics {

// Whether every actuator has one; else `why` gets a sentence.
bool pressure_known(const Machine& machine, std::string* why = nullptr);

// Inputs: the coordinates. Outputs: of every actuator the square of the cosine of its pressure angle, which must be known.
program::Program squared_pressure_cosines(const Machine& machine);

}  // namespace pmreport::mechanics
