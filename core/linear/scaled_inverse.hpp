// The inverse of a square matrix of at most six rows times its last pivot: what the columns of the inverse point to, also where there is no
// inverse.
//
// With complete pivoting P a Q = L U, U = [U1 u; 0 s], and s is the last pivot, the smallest,
//     T = Q [s U1^-1, -U1^-1 u; 0, 1] L^-1 P,   a T = s I                                    (1)
// which has no division by s. Of a regular matrix T / s is the inverse. Where the rank falls by one, s is zero and each column of T is what
// the inverse's grew towards, a multiple of the null vector; a column of zeros belongs to a row of `a` that the others do not depend on.
// The adjugate has the same columns but for a factor, yet as sums of products that all but cancel. Where the rank falls by more T is zero.
#pragma once

#include <core/linear/types.hpp>

namespace pmreport::linear {

struct ScaledInverse {
  SmallMatrix columns;  // T
  double scale = 0;     // s, of either sign
};
ScaledInverse scaled_inverse(const SmallMatrix& a);

}  // namespace pmreport::linear
