// What a worker tells its parent through a pipe, so that the parent knows what became of it however it ends.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pmreport::program {

// One letter, a text, a zero byte. Each is written in one piece, which a pipe keeps whole up to 4096 bytes.
enum class Note : char {
  begun = 'B',       // it is at work
  loading = 'O',     // a library is about to be loaded: its file
  loaded = 'o',      // it was
  folder = 'T',      // must not outlive the run: its path; letters as of document::Left
  lock = 'K',        // likewise
  parent = 'W',      // likewise, while it is empty
  removed = 't',     // one of these is gone
  standing = 'S',    // the report is in its place: its folder
  signal = 'G',      // that ends the process: its number
  in_plugin = 'P',   // a crash, or an exit, within a plugin: its file
  in_library = 'L',  // within something else: its file
  no_memory = 'M',   // memory ran out where nothing could be said
  done = 'D'         // the regular end: the exit status
};

// In a worker: whither. Nothing is said before.
void say_notes_to(int descriptor);
// Safe in a signal handler. Where the parent is gone nobody is left to tell.
void say(Note note, const char* text) noexcept;

// What a parent has heard.
struct Heard {
  void take(std::string_view bytes);  // as they come, in pieces of any size

  bool begun = false;
  std::string loading;                                    // the library that is being loaded; empty: none is
  std::vector<std::pair<Note, std::string>> left_behind;  // in the order in which they came
  int signal = 0;                                         // none
  std::string standing, in_plugin, in_library;
  bool no_memory = false;
  int done = -1;  // the exit status; negative: not yet

 private:
  void take_one(Note note, std::string text);
  std::string rest_;
};

}  // namespace pmreport::program
