// What the program does while a run takes its time: tell, and ask whether to stop (then throw).
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace pmreport::analysis {

struct Progress {
  std::function<void(const std::string&)> say = [](const std::string&) {};
  std::function<void()> stop_if_asked = [] {};
  std::filesystem::path checkpoints = {};  // folder in which long scans keep what is done; empty: they do not
  bool resume = false;                     // go on with what is there
};

}  // namespace pmreport::analysis
