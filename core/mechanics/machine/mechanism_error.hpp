// What a plugin can do wrong.
#pragma once

#include <pmreport/plugin.h>

#include <stdexcept>
#include <string>

namespace pmreport::mechanics {

// What the plugin said no to, or said wrong. `status` tells bad parameters (PM_BAD_ARGUMENT, the user's) from a broken plugin (the rest).
class MechanismError : public std::runtime_error {
 public:
  MechanismError(pm_status status, const std::string& sentence) : std::runtime_error(sentence), status(status) {}
  pm_status status;
};

}  // namespace pmreport::mechanics
