#include <reports/program/worker/notes.hpp>

#include <limits.h>
#include <unistd.h>
#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace pmreport::program {

namespace {

int whither = -1;

}  // namespace

void say_notes_to(int descriptor) { whither = descriptor; }

void say(Note note, const char* text) noexcept {
  if (whither < 0) return;
  char record[PIPE_BUF];
  const std::size_t length = std::min(std::strlen(text), sizeof record - 2);
  record[0] = static_cast<char>(note);
  std::memcpy(record + 1, text, length);
  record[length + 1] = '\0';
  for (int attempt = 0; attempt < 3; ++attempt)  // an interruption, or a moment without memory
    if (write(whither, record, length + 2) > 0) return;
}

void Heard::take(std::string_view bytes) {
  rest_ += bytes;
  std::size_t from = 0;
  for (std::size_t end = 0; (end = rest_.find('\0', from)) != std::string::npos; from = end + 1)
    if (end > from) take_one(static_cast<Note>(rest_[from]), rest_.substr(from + 1, end - from - 1));
  rest_.erase(0, from);
}

void Heard::take_one(Note note, std::string text) {
  switch (note) {
    case Note::begun:
      begun = true;
      break;
    case Note::loading:
      loading = std::move(text);
      break;
    case Note::loaded:
      loading.clear();
      break;
    case Note::folder:
    case Note::lock:
    case Note::parent:
      left_behind.emplace_back(note, std::move(text));
      break;
    case Note::removed:
      std::erase_if(left_behind, [&](const auto& one) { return one.second == text; });
      break;
    case Note::signal:
      signal = std::atoi(text.c_str());
      break;
    case Note::standing:
      standing = std::move(text);
      break;
    case Note::in_plugin:
      in_plugin = std::move(text);
      break;
    case Note::in_library:
      in_library = std::move(text);
      break;
    case Note::no_memory:
      no_memory = true;
      break;
    case Note::done:
      done = std::atoi(text.c_str());
      break;
  }
}

}  // namespace pmreport::program
