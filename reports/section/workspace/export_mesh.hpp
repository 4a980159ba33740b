// A surface as files that other programs read. Coordinates as they are, in metres.
#pragma once

#include <reports/scene/scene.hpp>

#include <string>

namespace pmreport::section {

// Binary STL: 80 bytes of header, the number of triangles, of each its unit normal and its corners as single precision, counted from the
// outside. Neither format keeps more than 2^32 - 1 of anything: std::length_error.
std::string to_stl(const scene::Surface& surface, const std::string& title);
// PLY 1.0, binary, little endian: points in double precision, triangles by their numbers.
std::string to_ply(const scene::Surface& surface, const std::string& title);

}  // namespace pmreport::section
