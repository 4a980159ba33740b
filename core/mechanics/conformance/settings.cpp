#include <core/mechanics/conformance/settings.hpp>

#include <core/text/units.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <random>

namespace pmreport::mechanics {

namespace {

constexpr double near_by = 1.0 / 3, farthest = 10;

std::string value_in_words(const ParameterInfo& p, const std::vector<double>& value) {
  if (p.kind == PM_CHOICE) return p.choices[static_cast<std::size_t>(value[0])];
  const std::optional<Unit> unit = parse_unit(p.display);
  std::string out;
  for (const double x : value) out += (out.empty() ? "" : ", ") + format_number(unit ? x / unit->factor : x, 4);
  if (p.kind == PM_NUMBERS) out = "[" + out + "]";
  return p.display.empty() ? out : out + " " + p.display;
}

std::string difference_in_words(const Machine& machine, const ParameterValues& values) {
  std::string out;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (values[i] != machine.values()[i])
      out += fmt::format("{}{} = {}", out.empty() ? "" : ", ", machine.info().parameters[i].name,
                         value_in_words(machine.info().parameters[i], values[i]));
  return out;
}

// Adds the setting, or counts it as refused. A plugin that breaks there is told with it.
bool add(Settings& settings, const Machine& machine, const ParameterValues& values) {
  const std::string words = difference_in_words(machine, values);
  try {
    settings.taken.push_back({words, machine.with(values)});
    return true;
  } catch (const MechanismError& e) {
    if (e.status != PM_BAD_ARGUMENT) throw MechanismError(e.status, fmt::format("with {}: {}", words, e.what()));
    if (settings.refused++ == 0) settings.example = e.what();
    return false;
  }
}

// What a number of each unit is like: the median size of those that are not zero. For numbers that are.
std::map<std::string, double> usual_sizes(const Machine& machine) {
  std::map<std::string, std::vector<double>> sizes;
  for (std::size_t i = 0; i < machine.values().size(); ++i)
    for (const double x : machine.values()[i])
      if (x != 0) sizes[machine.info().parameters[i].unit].push_back(std::abs(x));
  std::map<std::string, double> out;
  for (auto& [unit, all] : sizes) {
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    std::nth_element(all.begin(), middle, all.end());
    out[unit] = *middle;
  }
  return out;
}

class Numbers {
 public:
  Numbers(const Machine& machine, std::uint64_t seed) : machine_(machine), sizes_(usual_sizes(machine)), random_(seed) {}

  bool varies(std::size_t i) const { return info(i).kind != PM_CHOICE && !machine_.values()[i].empty() && info(i).max > info(i).min; }

  // All numbers, some way off. A list changes by one factor, for what belongs together, as an inertia, would not stay possible else. One of
  // zeros, which has no size and may stand for "as usual", changes entry by entry, or not.
  ParameterValues all_at_once(bool zeros_too) {
    ParameterValues values = machine_.values();
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!varies(i)) continue;
      const double factor = 1 + near_by * symmetric();
      const bool zeros = std::ranges::all_of(values[i], [](double x) { return x == 0; });
      if (zeros && !zeros_too) continue;
      for (double& x : values[i]) x = std::clamp(zeros ? near_by * size(i, 0) * symmetric() : x * factor, info(i).min, info(i).max);
    }
    return values;
  }

  // Parameter `i` by a share of the way to its largest, or least.
  ParameterValues towards(std::size_t i, bool up, double share) const {
    ParameterValues values = machine_.values();
    for (double& x : values[i]) {
      const bool massive = info(i).unit == "kg" || info(i).unit == "kg*m^2";
      const bool magnitude = massive || (x > 0 && info(i).min >= 0 && info(i).unit != "rad");  // it can shrink, and not turn its sign
      const double most = (farthest - 1) * size(i, x), least = magnitude ? x * (1 - 1 / farthest) : most;
      if (info(i).kind == PM_NUMBERS && x == 0) continue;
      x = up ? std::min(info(i).max, x + share * std::min(most, info(i).max - x))
             : std::max(info(i).min, x - share * std::min(least, x - info(i).min));
    }
    return values;
  }

 private:
  const ParameterInfo& info(std::size_t i) const { return machine_.info().parameters[i]; }
  double symmetric() { return 2 * static_cast<double>(random_() >> 11) * 0x1p-53 - 1; }  // the same on every machine
  double size(std::size_t i, double x) const {
    if (x != 0) return std::abs(x);
    const auto usual = sizes_.find(info(i).unit);
    return usual != sizes_.end() ? usual->second : std::min(1.0, info(i).max - info(i).min);
  }

  const Machine& machine_;
  std::map<std::string, double> sizes_;
  std::mt19937_64 random_;
};

}  // namespace

Settings other_choices(const Machine& machine, std::size_t most) {
  std::vector<std::size_t> choices;
  std::size_t combinations = 1;
  for (std::size_t i = 0; i < machine.info().parameters.size(); ++i)
    if (const std::size_t words = machine.info().parameters[i].choices.size(); words > 1) {
      choices.push_back(i);
      combinations = std::min(most + 1, combinations * words);
    }
  Settings out;
  if (combinations <= most) {
    ParameterValues values = machine.values();
    for (const std::size_t i : choices) values[i] = {0};
    for (bool more = true; more;) {
      if (values != machine.values()) add(out, machine, values);
      more = false;
      for (const std::size_t i : choices) {  // counts up, the first choice fastest
        values[i][0] += 1;
        if (values[i][0] < static_cast<double>(machine.info().parameters[i].choices.size())) {
          more = true;
          break;
        }
        values[i][0] = 0;
      }
    }
    return out;
  }
  for (const std::size_t i : choices)
    for (std::size_t word = 0; word < machine.info().parameters[i].choices.size(); ++word) {
      ParameterValues values = machine.values();
      values[i] = {static_cast<double>(word)};
      if (values != machine.values()) add(out, machine, values);
    }
  return out;
}

Settings other_numbers(const Machine& machine, int draws, std::uint64_t seed) {
  Settings out;
  Numbers numbers(machine, seed);
  constexpr int tries = 3;
  for (int k = 0; k < draws; ++k)
    for (int n = 0; n < tries; ++n) {
      const ParameterValues values = numbers.all_at_once(k % 2 == 0);
      if (values == machine.values() || add(out, machine, values)) break;
    }
  for (std::size_t i = 0; i < machine.values().size(); ++i)
    for (const bool up : {false, true}) {
      if (!numbers.varies(i)) continue;
      for (const double share : {1.0, 0.5, 0.25, 0.125}) {
        const ParameterValues values = numbers.towards(i, up, share);
        if (values == machine.values() || add(out, machine, values)) break;
      }
    }
  return out;
}

}  // namespace pmreport::mechanics
