// Random numbers without a state: a function of a key and a counter.
#pragma once

#include <array>
#include <cstdint>

namespace pmreport::scan {

// Philox4x32-10 (Salmon, Moraes, Dror and Shaw 2011), which passes all of TestU01: ten rounds of two products of 32 bits whose halves
// change places.
constexpr std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key) {
  constexpr auto product = [](std::uint32_t a, std::uint32_t b) { return std::uint64_t{a} * b; };
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t p = product(0xD2511F53u, counter[0]), q = product(0xCD9E8D57u, counter[2]);
    counter = {static_cast<std::uint32_t>(q >> 32) ^ counter[1] ^ key[0], static_cast<std::uint32_t>(q),
               static_cast<std::uint32_t>(p >> 32) ^ counter[3] ^ key[1], static_cast<std::uint32_t>(p)};
    key[0] += 0x9E3779B9u;
    key[1] += 0xBB67AE85u;
  }
  return counter;
}

// Two numbers of pose k, each a multiple of 2^-53 from zero to below one: of axes 2 pair and 2 pair + 1.
constexpr std::array<double, 2> uniform(std::uint64_t seed, std::uint64_t k, std::uint32_t pair) {
  const auto halves = [](std::uint64_t x) { return std::array{static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(x >> 32)}; };
  const auto bits = philox({halves(k)[0], halves(k)[1], pair, 0}, halves(seed));
  const auto number = [](std::uint32_t low, std::uint32_t high) {
    return static_cast<double>((std::uint64_t{high} << 32 | low) >> 11) * 0x1p-53;
  };
  return {number(bits[0], bits[1]), number(bits[2], bits[3])};
}

}  // namespace pmreport::scan
