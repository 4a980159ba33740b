#include <core/scan/proof/choice.hpp>

#include <bit>
#include <cmath>
#include <limits>

namespace pmreport::scan {

namespace {

constexpr int dropped_bits = 49;  // of a number's 64: sign, exponent and three bits of the fraction stay

std::uint64_t class_of(double gap) { return std::bit_cast<std::uint64_t>(gap) >> dropped_bits; }
double end_of(std::uint64_t number) { return std::bit_cast<double>(((number + 1) << dropped_bits) - 1); }  // the greatest gap of the class

}  // namespace

Gaps::Gaps(const OpenBoxes& boxes, std::size_t axes) : axes_(axes) {
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const double gap = boxes.gap(k);
    Class& c = classes_[class_of(gap > 0 ? gap : 0)];
    ++c.count;
    c.sum += gap;
    total_ += gap;
  }
}

// A box on a smooth face has a gap g of order h^(d + 1): of order h^2 of the h^(d - 1) that the face measures in it. Halved along all axes
// n times it leaves 2^(n (d - 1)) boxes on the face, of g / 2^(n (d + 1)) each; down to a gap of t these are (g / t)^((d - 1) / (d + 1))
// boxes. The least work is where all end with the same t, which is the greatest with
//     sum over g <= t of g + sum over g > t of t (g / t)^((d - 1) / (d + 1)) <= allowed.
double Gaps::threshold(double allowed, std::size_t most) const {
  const double power = static_cast<double>(axes_ - 1) / static_cast<double>(axes_ + 1);
  std::size_t above = 0;
  double best = std::numeric_limits<double>::infinity();
  double left = total_;
  double powers_above = 0;  // sum of g^power
  for (auto c = classes_.rbegin(); c != classes_.rend(); ++c) {
    const double t = end_of(c->first);  // all the classes before are above it
    best = t;
    if (above > 0 && (left + powers_above * std::pow(t, 1 - power) <= allowed || above >= most)) break;
    above += c->second.count;
    left -= c->second.sum;
    powers_above += static_cast<double>(c->second.count) * std::pow(c->second.sum / static_cast<double>(c->second.count), power);
    best = 0;
  }
  return best;
}

double Gaps::of_the_least(std::size_t count) const {
  std::size_t n = 0;
  for (const auto& [number, c] : classes_)
    if ((n += c.count) >= count) return end_of(number);
  return std::numeric_limits<double>::infinity();
}

}  // namespace pmreport::scan
