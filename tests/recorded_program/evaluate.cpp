// A program on every kind of number is the formula on that kind of number.
#include <tests/recorded_program/recording.hpp>

#include <catch2/catch.hpp>
#include <core/program/evaluate.hpp>
#include <pmreport/jet.hpp>
#include <pmreport/lanes.hpp>
#include <pmreport/partials.hpp>
#include <pmreport/placement.hpp>

using namespace recording;
using functions::Random;

namespace {

constexpr int tries = 20;

// As the contract stores it: its components, of every lane.
template <class T>
constexpr std::size_t lanes = std::is_same_v<T, Lanes> || std::is_same_v<T, Jet<Lanes>> ? Lanes::width : 1;
template <class T>
std::vector<double> stored(const T& x) {
  std::vector<double> out(Codec<T>::components * lanes<T>);
  Codec<T>::store(out.data(), lanes<T>, x);
  return out;
}
template <class T>
T random_scalar(Random& random, double min, double max) {
  std::vector<double> numbers(Codec<T>::components * lanes<T>);
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = i < lanes<T> ? random.within(min, max) : random.within(-1e-18, 1e-18);
  if constexpr (!std::is_same_v<T, long double>)
    for (std::size_t i = lanes<T>; i < numbers.size(); ++i) numbers[i] *= 1e18;
  return Codec<T>::load(numbers.data(), lanes<T>);
}

// Sums that are taken in another order, and products of another association, differ by roundings: a few units in the last place of each
// component, and those of a Jet's acceleration add up.
template <class T>
void check(const T& seen, const T& expected) {
  const std::vector<double> a = stored(seen), b = stored(expected);
  const double rounding = std::is_same_v<T, long double> ? 1e-18 : 1e-14;
  for (std::size_t i = 0; i < a.size(); ++i) CHECK(a[i] == Approx(b[i]).epsilon(1e-14).margin(rounding));
}

template <class T>
void check_everything(std::uint64_t seed) {
  Random random(seed);
  functions::each_of_one([&](const char* name, double min, double max, auto f) {
    const Program p = recorded_of_one(f);
    program::Evaluator<T> evaluator(p);
    for (int i = 0; i < tries; ++i) {
      const std::vector<T> x{random_scalar<T>(random, min, max)};
      std::vector<T> y(1);
      evaluator.run(x, y);
      CAPTURE(name, seed, i);
      check(y[0], T(f(x[0])));
    }
  });
  functions::each_of_two([&](const char* name, double min, double max, auto f) {
    const Program p = recorded_of_two(f);
    program::Evaluator<T> evaluator(p);
    for (int i = 0; i < tries; ++i) {
      const std::vector<T> x{random_scalar<T>(random, min, max), random_scalar<T>(random, min, max)};
      std::vector<T> y(1);
      evaluator.run(x, y);
      CAPTURE(name, seed, i);
      check(y[0], T(f(x[0], x[1])));
    }
  });
  const Program p = everything();
  program::Evaluator<T> evaluator(p);
  for (int i = 0; i < tries; ++i) {
    std::vector<T> q, y(p.outputs().size());
    for (int k = 0; k < Everything::inputs; ++k) q.push_back(random_scalar<T>(random, -1, 1));
    evaluator.run(q, y);
    const std::vector<T> expected = Everything()(q);
    for (std::size_t o = 0; o < y.size(); ++o) {
      CAPTURE(seed, i, o);
      check(y[o], expected[o]);
    }
  }
}

}  // namespace

TEST_CASE("a program on plain numbers is the formula") { check_everything<double>(11); }
TEST_CASE("a program in extended precision is the formula in extended precision") { check_everything<long double>(12); }
TEST_CASE("a program on jets is the formula on jets") { check_everything<Jet<double>>(13); }
TEST_CASE("a program on partials is the formula on partials") { check_everything<Partials<double, 3>>(14); }
TEST_CASE("a program in lanes takes in each lane the branch of that lane") { check_everything<Lanes>(15); }
TEST_CASE("a program on jets of lanes is the formula on them") { check_everything<Jet<Lanes>>(16); }
