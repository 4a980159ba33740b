// The worker's side: how a process knows that it is one, and what it sets up then.
#pragma once

#include <string>
#include <vector>

namespace pmreport::program {

// Variables by which a process that is started with them knows that it is a worker of this one: where it says its notes, the pipe that
// closes when this process ends, and libraries that crashed while they were loaded, "FILE\nSIGNAL".
std::vector<std::string> marks_of_worker(int notes, int life, const std::vector<std::string>& left_out);

// False: this process is none. Else its notes find their way, crashes are told, and it ends when its parent does.
bool begin_as_worker();

}  // namespace pmreport::program
