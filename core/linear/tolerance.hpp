// When a number counts as zero. Every decision about a rank in this program is made with one of these.
//
// A backward stable factorisation of an m x n matrix of size s leaves errors of some eps s sqrt(m n), 1e-14 s of the largest that occur
// here (hundreds of rows). A regular pose, its rotations per characteristic length and its rows normalised, has pivots above 1e-3; one that
// a reader would call singular, at a distance that a machine could be built to, below 1e-6. What lies between tells poses that are singular
// by their mathematics, but for rounding, from those that are not.
#pragma once

namespace pmreport::linear {

// Of the largest pivot or singular value, or of the size that the caller names: below it a pivot is zero.
constexpr double rank_tolerance = 1e-9;

// As rank_tolerance, of vectors that are themselves projections of a null space: parts of unit vectors, each of which carries the errors
// of the factorisation before, over the smallest of its pivots.
constexpr double part_tolerance = 1e-6;

// Of the largest share of a self-stress: what a joint, or one component of its wrench, carries of it at least. Reactions are good to 1e-10
// or better, and a share that an engineer would call one is far above.
constexpr double carried_share = 1e-7;

// As carried_share, of the rows of constraints while a basis of the self-stresses is reduced: nearer to its rounding.
constexpr double least_part = 1e-8;

// Of the length of a unit wrench: what rounding leaves of each of its entries, which come from a few hundred operations on lengths a few
// times as long as the limb. A determinant that so much could turn over has no sign.
constexpr double entry_rounding = 256 * 2.220446049250313e-16;

// Of det G at home: what is left of it on the singular surface.
constexpr double vanished_determinant = 1e-9;

}  // namespace pmreport::linear
