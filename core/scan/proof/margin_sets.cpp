#include <core/scan/proof/margin_sets.hpp>

#include <algorithm>

namespace pmreport::scan {

MarginSets::MarginSets(std::size_t margins) : words_((margins + 63) / 64), numbers_(16, Hash{this}, Same{this}) {}

std::size_t MarginSets::Hash::operator()(std::span<const std::uint64_t> bits) const {
  std::uint64_t h = 0x9e3779b97f4a7c15;
  for (const std::uint64_t word : bits) {
    h = (h ^ word) * 0xbf58476d1ce4e5b9;
    h ^= h >> 31;
  }
  return h;
}

std::uint32_t MarginSets::add(std::span<const std::uint64_t> bits) {
  if (const auto found = numbers_.find(bits); found != numbers_.end()) return *found;
  const auto number = static_cast<std::uint32_t>(size_++);
  pool_.insert(pool_.end(), bits.begin(), bits.end());
  numbers_.insert(number);
  return number;
}

std::uint32_t MarginSets::add_all(std::size_t margins) {
  std::vector<std::uint64_t> all(words_);
  for (std::size_t m = 0; m < margins; ++m) all[m / 64] |= std::uint64_t{1} << m % 64;
  return add(all);
}

void MarginPrograms::inherit(std::uint32_t set, std::uint32_t from) {
  number_.push_back(number_.empty() ? 0 : number_[from]);
  own_.push_back(false);
  if (programs_.empty()) give_own(set);
}

void MarginPrograms::give_own(std::uint32_t set) {
  if (own_[set] || programs_.size() >= most_programs) return;
  const std::span<const std::uint64_t> bits = sets_.bits(set);
  const std::size_t all = margins_.margins(), axes = margins_.axes().size();
  auto p = std::make_unique<MarginProgram>();
  std::vector<int> outputs;
  for (std::size_t m = 0; m < all; ++m)
    if (bits[m / 64] >> m % 64 & 1) {
      p->margins.push_back(static_cast<std::uint32_t>(m));
      outputs.push_back(static_cast<int>(m));
    }
  p->values = margins_.values().slice(outputs);
  for (const std::uint32_t m : p->margins)
    for (std::size_t q = 0; q < axes; ++q) outputs.push_back(static_cast<int>(all + m * axes + q));
  p->with_partials = margins_.with_partials().slice(outputs);
  for (const program::Step& step : p->with_partials.steps())
    if (step.operation == program::Operation::input) p->inputs.push_back(static_cast<std::uint32_t>(step.a));
  number_[set] = static_cast<std::uint32_t>(programs_.size());
  own_[set] = true;
  programs_.push_back(std::move(p));
}

}  // namespace pmreport::scan
