#include <core/scan/judge/tile.hpp>

#include <algorithm>

namespace pmreport::scan {

std::size_t Tile::longest() const {
  std::size_t out = 0;
  for (std::size_t a = 1; a < begin.size(); ++a)
    if (end[a] - begin[a] > end[out] - begin[out]) out = a;
  return out;
}

Tile Tile::whole(const Scan& scan) {
  Tile out;
  for (const Axis& a : scan.points) {
    out.begin.push_back(0);
    out.end.push_back(a.count);
  }
  return out;
}

Tiling::Tiling(const Scan& scan, std::size_t most) {
  for (const Axis& a : scan.points) counts_.push_back(a.count);
  shape_ = counts_;
  const auto points = [this] {
    std::size_t n = 1;
    for (const std::size_t c : shape_) n *= c;
    return n;
  };
  while (points() > std::max<std::size_t>(most, 1)) {
    std::size_t& longest = *std::ranges::max_element(shape_);
    longest = (longest + 1) / 2;
  }
  for (std::size_t a = 0; a < counts_.size(); ++a) {
    tiles_.push_back((counts_[a] + shape_[a] - 1) / shape_[a]);
    size_ *= tiles_.back();
  }
}

Tile Tiling::tile(std::size_t number) const {
  Tile out{std::vector<std::size_t>(counts_.size()), std::vector<std::size_t>(counts_.size())};
  for (std::size_t a = counts_.size(); a-- > 0;) {
    out.begin[a] = number % tiles_[a] * shape_[a];
    out.end[a] = std::min(counts_[a], out.begin[a] + shape_[a]);
    number /= tiles_[a];
  }
  return out;
}

}  // namespace pmreport::scan
