// The one form of every sentence that refuses a plugin.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace pmreport::host {

// A library that cannot be used: the sentence has its path, what was expected and what was seen.
class PluginError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Throws PluginError: "where: expected ..., seen ...; advice", on one line.
[[noreturn]] void refuse(std::string_view where, std::string_view expected, std::string_view seen, std::string_view advice);

// `text` in quotes, cut to a few words, with every byte that could break the line or the terminal written as \xNN. A null pointer:
// "nothing".
std::string quoted(const char* text);
std::string quoted(std::string_view text);

}  // namespace pmreport::host
