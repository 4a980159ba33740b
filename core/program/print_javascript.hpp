// A program as JavaScript: the same operations on the same numbers, to be run in the page of a report.
//
// + - * / and sqrt are the operations of IEEE 754 in both languages, and come out equal to the last bit; so do comparisons, choices and
// what is made of them. sin, cos, tan, asin, acos and atan2 are those of the browser. Its Math.hypot may be two units of the last place
// off, so that a program that needs one brings its own.
#pragma once

#include <core/program/program.hpp>

#include <string>

namespace pmreport::program {

// An expression whose value is a function (x, y): x has a number an input, y gets one an output; they may be one array. Nothing else is
// read or written. A step that is used once stands where it is used, any other has a name, "v3".
std::string print_javascript(const Program& program);

// The function hypot(a, b) that such a program brings where it needs one, an expression too: a root off by no more than one unit of the
// last place, infinite where either number is, without overflow or underflow on the way.
std::string javascript_hypot();

}  // namespace pmreport::program
