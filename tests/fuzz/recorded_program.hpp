// What holds for every program that a plugin may record: it is refused with a reason, or what runs it agrees: many poses at a time have the
// digits of one, bounds hold the numbers of all poses of their box, and derivatives tell how these differ (mean value theorem).
#pragma once

#include <core/program/batch.hpp>
#include <core/program/derivative.hpp>
#include <core/program/evaluate.hpp>
#include <core/program/print.hpp>
#include <core/program/print_javascript.hpp>
#include <tests/fuzz/any_recording.hpp>

#include <bit>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

namespace fuzz {

template <class T>
std::vector<T> numbers_of(const program::Program& p, const std::vector<double>& pose) {
  const std::vector<T> in(pose.begin(), pose.end());
  std::vector<T> out(p.outputs().size());
  program::Evaluator<T>(p).run(in, out);
  return out;
}

inline std::string broken_by_numbers(const program::Program& p, const Box& box) {
  std::vector<double> in, batch(2 * p.outputs().size());
  for (std::size_t i = 0; i < box.first.size(); ++i) in.insert(in.end(), {box.first[i], box.second[i]});
  program::Batch(p).run(2, in.data(), batch.data());
  const std::vector<Bounds> bounds = box.of(p);
  for (std::size_t k = 0; k < 2; ++k) {
    const auto& pose = k == 0 ? box.first : box.second;
    const std::vector<double> one = numbers_of<double>(p, pose);
    // Rounded as little as can be: sums, products and roots that are rounded at all stay within their bounds.
    const std::vector<long double> exact = numbers_of<long double>(p, pose);
    for (std::size_t o = 0; o < one.size(); ++o) {
      const double many = batch[2 * o + k];
      if (std::bit_cast<std::uint64_t>(many) != std::bit_cast<std::uint64_t>(one[o]) && !(std::isnan(many) && std::isnan(one[o])))
        return "many poses at a time are not those of one";
      if (bounds[o].bounded() && !(bounds[o].low <= exact[o] && exact[o] <= bounds[o].high)) return "bounds that do not hold a number";
    }
  }
  return {};
}

// f(second) - f(first) is a sum of derivatives somewhere between the two, times how far they are apart.
inline std::string broken_by_derivatives(const program::Program& p, const program::Program& with_partials, const Box& box) {
  const std::vector<Bounds> first = Box::of(p, box.first), second = Box::of(p, box.second), all = box.of(with_partials);
  const std::size_t outputs = first.size(), inputs = box.first.size();
  for (std::size_t o = 0; o < outputs; ++o) {
    Bounds differ{second[o].low - first[o].high, second[o].high - first[o].low}, told{0, 0};
    double size = std::abs(first[o].low) + std::abs(second[o].low);
    for (std::size_t i = 0; i < inputs; ++i) {
      const Bounds& d = all[outputs + o * inputs + i];
      const double by = box.second[i] - box.first[i], a = d.low * by, b = d.high * by;
      told = {told.low + std::min(a, b), told.high + std::max(a, b)};
      size += std::abs(a) + std::abs(b) + std::abs(d.low * box.first[i]) + std::abs(d.high * box.first[i]);
    }
    const double rounding = 1e-12 * size + 1e-300;
    if (std::isfinite(size) && all[o].bounded() && differ.bounded() && told.bounded() &&
        (differ.low > told.high + rounding || differ.high < told.low - rounding))
      return "a number that changes by more than its derivative";
  }
  return {};
}

inline std::string broken_by_recorded_program(const std::string& bytes) {
  Choices choices(bytes);
  const auto inputs = static_cast<int>(1 + choices.of(3));
  const Box box(choices, static_cast<std::size_t>(inputs));
  const std::vector<pm_step> recorded = any_steps(choices, inputs);
  std::vector<int> outputs;
  for (std::size_t i = recorded.size(); i-- > 0 && outputs.size() < 4;)
    if (recorded[i].operation < PM_OP_LESS || recorded[i].operation == PM_OP_CHOOSE) outputs.push_back(static_cast<int>(i));
  std::optional<program::Program> p;
  try {
    p.emplace(program::steps_of(recorded), inputs, outputs);
  } catch (const program::ProgramError& e) {
    return std::string(e.what()).empty() ? "a refusal without a reason" : "";
  }
  std::vector<int> by(static_cast<std::size_t>(inputs));
  std::iota(by.begin(), by.end(), 0);
  const program::Program partials = program::partials(*p, by);
  for (const program::Program& q : {*p, partials}) {
    if (std::string broken = broken_by_numbers(q, box); !broken.empty()) return broken;
    const std::size_t numbers = q.steps().size() + q.outputs().size();
    if (program::print(q).size() > 100 + 100 * numbers) return "a text that grows faster than its program";
    if (program::print_javascript(q).size() > 1000 + 100 * numbers) return "a script that grows faster than its program";
  }
  return broken_by_derivatives(*p, partials, box);
}

}  // namespace fuzz
