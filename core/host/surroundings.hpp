// What belongs to the whole process, and which a plugin must leave as it is: the locale, the working folder, how numbers are rounded.
#pragma once

#include <cfenv>
#include <filesystem>
#include <string>
#include <vector>

namespace pmreport::host {

class Surroundings {
 public:
  Surroundings();  // as they are now

  // Puts back what has changed since, and tells it: "the locale".
  std::vector<std::string> restore() const;

 private:
  std::string locale_;
  std::filesystem::path folder_;
  std::fenv_t numbers_;
};

}  // namespace pmreport::host
