// The worker's side: how a process knows that it is one, and what it sets up then.
#pragma once

#include <string>
#include <vector>

namespace pmreport::program {

// Variables by which a process that is started with them knows that it is a worker of this one: where it says its notes, the pipe that
// closes when this process ends, and libraries that crashed while they were loaded, "FILE\nSIGNAL".
std::vector<std::string> marks_of_worker(int notes, int life, const std::vector<std::string>& left_out);

// Where this process makes one report of several.
void end_with_many();

}  // namespace pmreport::program
