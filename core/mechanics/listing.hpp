// Names in a sentence.
#pragma once

#include <string>
#include <vector>

namespace pmreport::mechanics {

// "A1", "A1 and B1", "A1, B1 and C1"; `last` stands before the last of them.
inline std::string listed(const std::vector<std::string>& names, const std::string& last = "and") {
  std::string out;
  for (std::size_t i = 0; i < names.size(); ++i) out += (i == 0 ? "" : i + 1 == names.size() ? " " + last + " " : ", ") + names[i];
  return out;
}

}  // namespace pmreport::mechanics
