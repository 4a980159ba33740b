// What a report takes of memory at its peak, told by what its scenario asks for before any of that is done.
//
// Numbers of a sample stand in the run's columns, and for a while as x and y of the curves of a section. Pictures are held as
// pixels until they are packed; what a kind of section holds besides, it says itself. The factors were measured, over mechanisms of three
// to six degrees of freedom and 501 to 100 001 samples, and stand a tenth or two above what was seen: an estimate may refuse what would
// have fitted, and not the other way round.
#pragma once

#include <core/scenario/loaded.hpp>

#include <string>
#include <vector>

namespace pmreport::section {

struct MemoryNeed {
  struct Part {
    double bytes;
    std::string what;  // "100001 samples of 310 columns"
    std::string less;  // what makes it smaller: "fewer samples"; empty: nothing does
  };
  std::vector<Part> parts;  // the largest first

  double bytes() const;
};

MemoryNeed memory_need(const scenario::Loaded& loaded);

// "1.9 GB", "340 MB".
std::string memory_words(double bytes);

}  // namespace pmreport::section
