// The parameters of a mechanism: declared as constants, so that they can be listed without running a line of the plugin.
#pragma once

#include <pmreport/plugin.h>
#include <pmreport/topology.hpp>

#include <array>
#include <charconv>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace pmreport {

// A parameter as an author declares it. `default_number` is storage: `info(p)` makes the contract's view of it.
struct Parameter {
  const char *name, *title, *unit, *display;
  pm_parameter_kind kind;
  double default_number;
  std::span<const double> default_numbers;
  double min, max;
  std::size_t count_min, count_max;
  std::span<const char* const> choices;
  bool chooses_working_mode = false;
  const char* replaced_by = nullptr;

  // One number. `unit` is SI, `display` the unit that a reader expects; default and range are SI, the range inclusive.
  static constexpr Parameter number(const char* name, double value, Range range, const char* unit, const char* display, const char* title) {
    return {name, title, unit, display, PM_NUMBER, value, {}, range.min, range.max, 1, 1, {}};
  }
  // The usual ones, with the units that a reader expects.
  static constexpr Parameter length(const char* name, double value, const char* title, Range range = {0, 100}) {
    return number(name, value, range, "m", "mm", title);
  }
  static constexpr Parameter angle(const char* name, double value, const char* title, Range range = {-7, 7}) {
    return number(name, value, range, "rad", "deg", title);
  }
  static constexpr Parameter mass(const char* name, double value, const char* title, Range range = {0, 1e6}) {
    return number(name, value, range, "kg", "kg", title);
  }
  static constexpr Parameter inertia(const char* name, double value, const char* title, Range range = {0, 1e6}) {
    return number(name, value, range, "kg*m^2", "kg*m^2", title);
  }
  // A list of numbers (points as x y z x y z ...), `count.min` to `count.max` long. The array of defaults must be a constant.
  static constexpr Parameter numbers(const char* name, std::span<const double> values, Range range, std::size_t count_min,
                                     std::size_t count_max, const char* unit, const char* display, const char* title) {
    return {name, title, unit, display, PM_NUMBERS, 0, values, range.min, range.max, count_min, count_max, {}};
  }
  // One of several words; the default is the one at `index`.
  static constexpr Parameter choice(const char* name, std::span<const char* const> words, std::size_t index, const char* title) {
    return {name, title, "", "", PM_CHOICE, static_cast<double>(index), {}, 0, static_cast<double>(words.size() - 1), 1, 1, words};
  }
  // Such a choice among the solutions of inverse displacement: elbow in or out, slider above or below.
  static constexpr Parameter working_mode(const char* name, std::span<const char* const> words, std::size_t index, const char* title) {
    Parameter p = choice(name, words, index, title);
    p.chooses_working_mode = true;
    return p;
  }
  // A parameter that says nothing once `other` is given, as a radius of points that are listed: a scenario that gives both is refused.
  constexpr Parameter unless(const char* other) const {
    Parameter p = *this;
    p.replaced_by = other;
    return p;
  }
};

constexpr pm_parameter info(const Parameter& p) {
  const bool many = p.kind == PM_NUMBERS;
  return {p.name,
          p.title,
          p.unit,
          p.display,
          p.kind,
          many ? p.default_numbers.data() : &p.default_number,
          many ? p.default_numbers.size() : 1,
          p.min,
          p.max,
          p.count_min,
          p.count_max,
          p.choices.data(),
          p.choices.size(),
          p.chooses_working_mode ? 1 : 0,
          p.replaced_by};
}

// A sentence for the user from words and numbers, six digits each, whatever the locale.
template <class... Part>
std::string sentence(const Part&... parts) {
  std::string out;
  const auto add = [&out](const auto& part) {
    if constexpr (std::is_floating_point_v<std::decay_t<decltype(part)>>) {
      std::array<char, 32> digits{};
      out.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), part, std::chars_format::general, 6).ptr);
    } else {
      out += part;
    }
  };
  (add(parts), ...);
  return out;
}

// Refuses the parameters with such a sentence.
template <class... Part>
[[noreturn]] void refuse(const Part&... parts) {
  throw std::invalid_argument(sentence(parts...));
}

// Validated values of a mechanism's parameters, by name, SI.
class Parameters {
 public:
  Parameters(std::span<const Parameter> declared, std::span<const pm_value> values) : declared_(declared), values_(values) {}

  double operator[](std::string_view name) const { return value(name).numbers[0]; }
  std::span<const double> numbers(std::string_view name) const { return {value(name).numbers, value(name).count}; }
  std::string_view choice(std::string_view name) const {
    return declared_[index(name)].choices[static_cast<std::size_t>(value(name).numbers[0])];
  }

 private:
  std::size_t index(std::string_view name) const {
    for (std::size_t i = 0; i < declared_.size(); ++i)
      if (name == declared_[i].name) return i;
    throw std::logic_error("the mechanism asks for parameter '" + std::string(name) + "', which it does not declare");
  }
  const pm_value& value(std::string_view name) const { return values_[index(name)]; }

  std::span<const Parameter> declared_;
  std::span<const pm_value> values_;
};

}  // namespace pmreport
