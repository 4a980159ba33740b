// Builds of one plugin for newer processors. Beside `plugins/gough.so`, which runs on every x86-64, may stand `plugins/x86-64-v3/gough.so`
// and `plugins/x86-64-v4/gough.so`: the same source, with the vectors of that level of the x86-64 psABI. The best one that this processor
// runs is loaded in its place; numbers agree to rounding.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pmreport::host {

// The levels that this processor runs, best first: "x86-64-v4", "x86-64-v3", or nothing. PMREPORT_PROCESSOR in the environment, "x86-64" or
// one of these, says to go no higher: with "x86-64" every x86-64 gives the same digits.
std::vector<std::string> processor_levels();
// What is wrong with PMREPORT_PROCESSOR, a sentence without its full stop; empty: nothing.
std::string fault_of_processor();

// The file to load for `plugin`: itself, or its best build.
std::filesystem::path best_build(const std::filesystem::path& plugin, const std::vector<std::string>& levels = processor_levels());

}  // namespace pmreport::host
