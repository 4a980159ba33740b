// Small services for sentences to the user.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pmreport {

// The candidate nearest to `word`, if it is at most two edits away (insert, delete, replace, swap neighbours) and shares something with it.
std::optional<std::string> nearest(std::string_view word, const std::vector<std::string>& candidates);

// "; did you mean "samples"?" or nothing.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

// "A1", "A1 and B1", "A1, B1 and C1": `last` stands before the last word; with `quotes`, each word in double quotes.
std::string listed(const std::vector<std::string>& words, const char* last = "and", bool quotes = false);

// The text in double quotes, cut to a readable length and without control characters: nobody's terminal shall obey a scenario.
std::string in_quotes(std::string_view text);
std::string printable(std::string_view text);

// What stands in for a few words of somebody else's, in files as on a terminal: one line of valid UTF-8, printable. Ends of lines and tabs
// become spaces, what is no UTF-8 and no character U+FFFD.
std::string one_line(std::string_view bytes);

// With U+FFFD for what Unicode promises never to be a character, U+FDD0 and the like: valid UTF-8, which Cairo refuses all the same.
std::string without_noncharacters(std::string_view utf8);

// Characters (code points) of UTF-8 text.
std::size_t characters(std::string_view utf8);

std::string_view trim(std::string_view text);

}  // namespace pmreport
