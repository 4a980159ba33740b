// What the program does while a run takes its time: tell, and ask whether to stop (then throw).
#pragma once

#include <functional>
#include <string>

namespace pmreport::analysis {

struct Progress {
  std::function<void(const std::string&)> say = [](const std::string&) {};
  std::function<void()> stop_if_asked = [] {};
};

}  // namespace pmreport::analysis
