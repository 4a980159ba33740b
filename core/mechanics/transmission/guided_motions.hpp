// The ways in which the coordinates move with one actuator alone, so that they stay sharp over boxes of poses.
//
// With A = dr/dq, r the actuators' values, each row times any number, the coordinates move along column i of A^-1 where actuator i moves
// and all others are held. Over a box of poses its cofactors are sums of products that all but cancel, and elimination divides by intervals
// that hold zero. So A is first made nearly the unit matrix, by regular matrices that come from its factors at the middle of the box, P A Q
// = L U with complete pivoting:
//     M = R A S,   R = L^-1 P,   S = Q U'^-1                                             (1)
// U' is U with the last pivot, the smallest, replaced by the one before it, so that S is regular where A is not: M is nearly
// diag(1, ..., 1, d). With M = [B b; c d] and y = R e_i = (y1; y2),
//     w = (s B^-1 y1 - z B^-1 b; z),   z = y2 - c B^-1 y1,   s = d - c B^-1 b             M w = s y
//     u_i = S w                                                                         A u_i = s e_i      (2)
// has no division by s, as scaled_inverse.hpp has none: where A is singular u_i points to what the inverse's column grew towards. (2) holds
// for all regular R and S; only the length of u_i depends on them.
//
// That they are regular is proved, not hoped: a matrix X is where some Y has ||X Y - I|| < 1. 1/2 leaves more room than the product loses
// in doubles: with complete pivoting no entry of L is above 1, so that |X| |Y| is below 2^5 6, and six terms of it lose less than 1e-12.
// Where it cannot be shown both are the unit matrix.
#pragma once

#include <core/linear/types.hpp>
#include <pmreport/recorded.hpp>

#include <cstddef>
#include <vector>

namespace pmreport::mechanics {

// R, then S, by rows: 2 n^2 numbers.
constexpr std::size_t guides_of_motions(std::size_t n) { return 2 * n * n; }
std::vector<double> guides_of_motions(const linear::SmallMatrix& a);

// u_i of (2), one list a column; `a` by rows, of n^2 numbers.
std::vector<std::vector<Recorded>> guided_motions(const std::vector<Recorded>& a, const std::vector<Recorded>& guides, std::size_t n);

}  // namespace pmreport::mechanics
