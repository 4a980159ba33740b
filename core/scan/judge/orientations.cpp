#include <core/program/batch.hpp>
#include <core/scan/judge/orientations.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pmreport::scan {

Orientations::Orientations(const Plan& plan, std::size_t first, std::size_t count)
    : plan_(plan), first_(first), width_(plan.width()), numbers_(count) {
  std::iota(numbers_.begin(), numbers_.end(), first);
  const auto& list = plan.scan.orientations;
  for (std::size_t i = 0; i < plan.scan.turned.size() && !list.empty(); ++i) {
    const auto [low, high] = std::ranges::minmax_element(list, {}, [i](const std::vector<double>& o) { return o[i]; });
    whole_.push_back((*high)[i] - (*low)[i]);
  }
  nodes_.push_back({0, count, 0, 1});
  halve(0);
  fill();
  hulls_.resize(nodes_.size() * width_);
  enclose(0);
}

// How far the orientations differ, and in which coordinate.
double Orientations::spread(std::size_t begin, std::size_t end, std::size_t* widest) const {
  double out = 0;
  for (std::size_t i = 0; i < whole_.size(); ++i) {
    if (!(whole_[i] > 0)) continue;
    double low = plan_.scan.orientations[numbers_[begin]][i], high = low;
    for (std::size_t k = begin; k < end; ++k) {
      const double x = plan_.scan.orientations[numbers_[k]][i];
      low = std::min(low, x), high = std::max(high, x);
    }
    if ((high - low) / whole_[i] > out) out = (high - low) / whole_[i], *widest = i;
  }
  return out;
}

void Orientations::halve(int n) {
  const auto [begin, end, children, share] = node(n);
  std::size_t across = 0;
  nodes_[static_cast<std::size_t>(n)].share = spread(begin, end, &across);
  if (end - begin < 2) return;
  const std::size_t middle = begin + (end - begin) / 2;
  if (!whole_.empty()) {
    const auto& list = plan_.scan.orientations;
    const auto at = [this](std::size_t k) { return numbers_.begin() + static_cast<std::ptrdiff_t>(k); };
    std::nth_element(at(begin), at(middle), at(end), [&](std::size_t a, std::size_t b) {
      return list[a][across] != list[b][across] ? list[a][across] < list[b][across] : a < b;
    });
  }
  const int child = static_cast<int>(nodes_.size());
  nodes_[static_cast<std::size_t>(n)].children = child;
  nodes_.push_back({begin, middle, 0, 1});
  nodes_.push_back({middle, end, 0, 1});
  halve(child);
  halve(child + 1);
}

void Orientations::fill() {
  const Scan& scan = plan_.scan;
  const std::size_t inputs = scan.at.size(), n = size(), handed = plan_.outer.outputs().size();
  std::vector<double> poses(inputs * n), out(handed * n);
  for (std::size_t i = 0; i < inputs; ++i) std::fill_n(poses.begin() + static_cast<std::ptrdiff_t>(i * n), n, scan.at[i]);
  if (!scan.orientations.empty())
    for (std::size_t i = 0; i < scan.turned.size(); ++i)
      for (std::size_t k = 0; k < n; ++k) poses[static_cast<std::size_t>(scan.turned[i]) * n + k] = scan.orientations[numbers_[k]][i];
  program::Batch(plan_.outer).run(n, poses.data(), out.data());
  rows_.resize(n * width_);
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < inputs; ++i) rows_[k * width_ + i] = poses[i * n + k];
    for (std::size_t h = 0; h < handed; ++h) rows_[k * width_ + inputs + h] = out[h * n + k];
  }
}

void Orientations::enclose(int n) {
  const Node& here = node(n);
  program::Bounds* out = hulls_.data() + static_cast<std::size_t>(n) * width_;
  if (here.children == 0) {
    // A number that is infinite, or none, is not bounded.
    for (std::size_t i = 0; i < width_; ++i)
      if (const double x = others(here.begin)[i]; std::isfinite(x)) out[i] = program::Bounds::exactly(x);
    return;
  }
  enclose(here.children);
  enclose(here.children + 1);
  for (std::size_t i = 0; i < width_; ++i) out[i] = hull(bounds(here.children)[i], bounds(here.children + 1)[i]);
}

std::vector<int> Orientations::parts(std::uint64_t most) const {
  std::vector<int> out;
  add_parts(0, most, out);
  return out;
}

void Orientations::add_parts(int n, std::uint64_t most, std::vector<int>& out) const {
  const Node& here = node(n);
  if (here.end - here.begin <= most || here.children == 0) {
    out.push_back(n);
    return;
  }
  add_parts(here.children, most, out);
  add_parts(here.children + 1, most, out);
}

}  // namespace pmreport::scan
