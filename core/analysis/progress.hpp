// What the program does while a run takes its time: tell, and ask whether to stop (then throw).
#pragma once

#include <core/chunks/sharing.hpp>

#include <functional>
#include <string>

namespace pmreport::analysis {

struct Progress {
  std::function<void(const std::string&)> say = [](const std::string&) {};
  std::function<void()> stop_if_asked = [] {};
  chunks::Sharing sharing = {};  // of work that is cut in chunks
  std::string part = {};         // of the run, which its work is named after
};

}  // namespace pmreport::analysis
