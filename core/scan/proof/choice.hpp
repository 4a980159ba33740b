// Which boxes to look at more closely, so that the bracket of a volume is as narrow as asked with the fewest.
#pragma once

#include <core/scan/proof/open_boxes.hpp>

#include <cstddef>
#include <cstdint>
#include <map>

namespace pmreport::scan {

// Gaps of boxes, counted in classes an eighth of an octave wide.
class Gaps {
 public:
  Gaps(const OpenBoxes& boxes, std::size_t axes);

  // Boxes whose gap is greater are to be halved, so that in the end no more than `allowed` is left; and no more than `most` boxes at once.
  double threshold(double allowed, std::size_t most) const;
  // Boxes whose gap is not greater are `count` or a few more, or all.
  double of_the_least(std::size_t count) const;

 private:
  struct Class {
    std::size_t count = 0;
    double sum = 0;
  };
  std::map<std::uint64_t, Class> classes_;  // by the leading bits of the gap
  std::size_t axes_;
  double total_ = 0;
};

}  // namespace pmreport::scan
