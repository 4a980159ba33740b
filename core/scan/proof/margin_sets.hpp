// Sets of margins that are still to be looked at, one bit a margin; and the programs of those margins alone.
#pragma once

#include <core/scan/proof/boxed_margins.hpp>

#include <cstdint>
#include <memory>
#include <span>
#include <unordered_set>
#include <vector>

namespace pmreport::scan {

// Each set once, by the number it had when it came.
class MarginSets {
 public:
  explicit MarginSets(std::size_t margins);
  MarginSets(const MarginSets&) = delete;
  MarginSets& operator=(const MarginSets&) = delete;

  std::size_t words() const { return words_; }
  std::size_t size() const { return size_; }
  std::uint32_t add(std::span<const std::uint64_t> bits);  // `words` of them
  std::uint32_t add_all(std::size_t margins);              // the set of so many
  std::span<const std::uint64_t> bits(std::uint32_t set) const { return {pool_.data() + set * words_, words_}; }

 private:
  struct Hash {
    using is_transparent = void;
    const MarginSets* sets;
    std::size_t operator()(std::span<const std::uint64_t> bits) const;
    std::size_t operator()(std::uint32_t set) const { return (*this)(sets->bits(set)); }
  };
  struct Same {
    using is_transparent = void;
    const MarginSets* sets;
    std::span<const std::uint64_t> of(std::uint32_t set) const { return sets->bits(set); }
    static std::span<const std::uint64_t> of(std::span<const std::uint64_t> bits) { return bits; }
    template <class A, class B>
    bool operator()(const A& a, const B& b) const {
      return std::ranges::equal(of(a), of(b));
    }
  };

  std::size_t words_, size_ = 0;
  std::vector<std::uint64_t> pool_;
  std::unordered_set<std::uint32_t, Hash, Same> numbers_;
};

// What is run for a set: of its margins, or of more.
struct MarginProgram {
  std::vector<std::uint32_t> margins;
  std::vector<std::uint32_t> inputs;       // that they depend on
  program::Program values, with_partials;  // of those margins, as BoxedMargins has them of all
};

// A set that many boxes have gets a program of its own; the others use that of the set they came from. Both must outlive it.
class MarginPrograms {
 public:
  MarginPrograms(const BoxedMargins& margins, const MarginSets& sets) : margins_(margins), sets_(sets) {}

  void inherit(std::uint32_t set, std::uint32_t from);  // set: the next number
  void give_own(std::uint32_t set);                     // unless there are too many, or it has one
  std::uint32_t number(std::uint32_t set) const { return number_[set]; }
  const MarginProgram& program(std::uint32_t number) const { return *programs_[number]; }

 private:
  static constexpr std::size_t most_programs = 2048;

  const BoxedMargins& margins_;
  const MarginSets& sets_;
  std::vector<std::uint32_t> number_;  // of each set
  std::vector<bool> own_;
  std::vector<std::unique_ptr<MarginProgram>> programs_;
};

}  // namespace pmreport::scan
