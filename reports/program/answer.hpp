// The program: what the user typed goes to its command, and what a command throws becomes a sentence and the exit status.
#pragma once

#include <core/chunks/sharing.hpp>

namespace pmreport::program {

// Both give the exit status that README.md promises. The work of the first is done in a process of its own (worker/worker.hpp).
int answer(int argc, char** argv);

// One of several processes that were started with the same arguments and make one report: in this process, for whoever started them looks
// after it. `threads`: where the arguments do not say.
int answer_together(int argc, char** argv, chunks::Dealer& dealer, int threads);

}  // namespace pmreport::program
