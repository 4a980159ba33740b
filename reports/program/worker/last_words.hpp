// What a worker still says when it is ended from within: by a signal, by exit(), by an exception that nobody takes.
#pragma once

namespace pmreport::program {

// Of this process, for good. Who is to blame is told by the stack: the innermost function that belongs to a plugin.
void leave_last_words();
// The regular end has come: from here on nothing is said.
void keep_silent();

// A library that is a plugin, from now on. Safe from several threads.
void name_plugin(const char* file);

}  // namespace pmreport::program
