// Arrays as NumPy reads them: NPY version 1.0, C order, little endian.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace pmreport::section {

// The last index moves fastest. std::invalid_argument where the shape does not have as many places as there are values.
std::string to_npy(const std::vector<std::size_t>& shape, const std::vector<std::uint32_t>& values);
std::string to_npy(const std::vector<std::size_t>& shape, const std::vector<double>& values);

}  // namespace pmreport::section
