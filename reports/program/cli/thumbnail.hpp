// A picture made small.
#pragma once

#include <filesystem>
#include <string>

namespace pmreport::program {

// The PNG in a file, at most `width` pixels wide, as a PNG; empty where it cannot be read.
std::string thumbnail(const std::filesystem::path& png, int width);

}  // namespace pmreport::program
