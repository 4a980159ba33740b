// In place (Gauss and Jordan): step k makes column k that of the unit matrix, and what would make the unit matrix that of the inverse takes
// its place. Which rows change places may differ from lane to lane, so rows are compared one after another, and each lane changes its two
// or keeps them. With rows exchanged by S the inverse of S A has come out, A^-1 S^-1; its columns change back in the opposite order.
#include <core/linear/inverses.hpp>

#include <core/vectors.hpp>

#include <algorithm>
#include <cmath>

namespace pmreport::linear {

namespace {

constexpr std::size_t rows = 6, entries = rows * rows;
template <std::size_t width>
struct Lanes {
  using Numbers [[gnu::vector_size(8 * width)]] = double;
};

template <std::size_t width>
class Inverse {
 public:
  using Numbers = typename Lanes<width>::Numbers;
  using Mask = decltype(Numbers() > Numbers());

  [[gnu::always_inline]] void run(std::size_t count, const double* in, double* out) {
    for (std::size_t first = 0; first < count; first += width) {
      const std::size_t n = std::min(width, count - first);
      for (std::size_t e = 0; e < entries; ++e)
        for (std::size_t l = 0; l < width; ++l) m_[e][l] = in[e * count + first + std::min(l, n - 1)];
      invert();
      for (std::size_t e = 0; e < entries; ++e)
        for (std::size_t l = 0; l < n; ++l) out[e * count + first + l] = m_[e][l];
    }
  }

 private:
  Numbers& at(std::size_t row, std::size_t column) { return m_[rows * row + column]; }
  [[gnu::always_inline]] static void exchange(const Mask& where, Numbers& a, Numbers& b) {
    const Numbers x = a, y = b;
    a = where ? y : x;
    b = where ? x : y;
  }

  [[gnu::always_inline]] void invert() {
    for (std::size_t k = 0; k < rows; ++k) {
      for (std::size_t r = k + 1; r < rows; ++r) {
        const Numbers a = at(r, k), b = at(k, k);
        exchanged_[k][r] = (a < 0 ? -a : a) > (b < 0 ? -b : b);
        for (std::size_t c = 0; c < rows; ++c) exchange(exchanged_[k][r], at(k, c), at(r, c));
      }
      const Numbers scale = 1 / at(k, k);
      at(k, k) = Numbers() + 1;
      for (std::size_t c = 0; c < rows; ++c) at(k, c) *= scale;
      for (std::size_t r = 0; r < rows; ++r) {
        if (r == k) continue;
        const Numbers factor = at(r, k);
        at(r, k) = Numbers();
        for (std::size_t c = 0; c < rows; ++c) at(r, c) -= factor * at(k, c);
      }
    }
    for (std::size_t k = rows; k-- > 0;)
      for (std::size_t r = rows; r-- > k + 1;)
        for (std::size_t i = 0; i < rows; ++i) exchange(exchanged_[k][r], at(i, k), at(i, r));
  }

  Numbers m_[entries];
  Mask exchanged_[rows][rows];
};

using Kernel = void (*)(std::size_t, const double*, double*);
[[gnu::flatten]] void invert_plain(std::size_t count, const double* in, double* out) { Inverse<2>().run(count, in, out); }
#if defined(__x86_64__)
[[gnu::flatten, gnu::target("arch=x86-64-v3")]] void invert_v3(std::size_t count, const double* in, double* out) {
  Inverse<4>().run(count, in, out);
}
[[gnu::flatten, gnu::target("arch=x86-64-v4")]] void invert_v4(std::size_t count, const double* in, double* out) {
  Inverse<8>().run(count, in, out);
}
#endif

Kernel kernel() {
#if defined(__x86_64__)
  if (vector_level() >= 4) return invert_v4;
  if (vector_level() >= 3) return invert_v3;
#endif
  return invert_plain;
}

}  // namespace

void inverses(std::size_t count, const double* matrices, double* out) {
  static const Kernel best = kernel();
  best(count, matrices, out);
}

}  // namespace pmreport::linear
