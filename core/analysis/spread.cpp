#include <core/analysis/spread.hpp>

#include <core/assertion.hpp>

namespace pmreport::analysis {

namespace {

double mirrored(std::size_t k, std::size_t base) {
  double out = 0, digit = 1;
  for (; k > 0; k /= base) {
    digit /= static_cast<double>(base);
    out += digit * static_cast<double>(k % base);
  }
  return out;
}

}  // namespace

std::vector<std::vector<double>> spread(std::size_t count, std::size_t n) {
  static constexpr std::size_t primes[most_variables] = {2, 3, 5, 7, 11, 13, 17, 19};
  PMREPORT_ASSERT(n <= most_variables, "a spread has no more coordinates than it has primes");
  std::vector<std::vector<double>> out(count, std::vector<double>(n));
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t i = 0; i < n; ++i) out[k][i] = mirrored(k + 1, primes[i]);
  return out;
}

}  // namespace pmreport::analysis
