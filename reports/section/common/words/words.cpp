#include <reports/section/common/words/words.hpp>

#include <core/text/digits.hpp>
#include <core/text/text.hpp>
#include <reports/section/common/words/noise.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pmreport::section {

std::string show(double si, std::string_view unit, int digits) { return show(si, display_unit(unit, std::abs(si)), digits); }

std::string show(double si, const DisplayUnit& in, int digits) {
  const std::string number = typeset(format_number(si * in.per_si, digits));
  return in.label.empty() ? number : in.label == "°" ? number + "°" : number + " " + in.label;
}

Apart show_apart(double value, double beside, std::string_view unit, int digits) {
  return show_apart(value, beside, display_unit(unit, std::max(std::abs(value), std::abs(beside))), digits);
}

Apart show_apart(double value, double beside, const DisplayUnit& in, int digits) {
  constexpr int digits_of_difference = 2;
  const double largest = std::max(std::abs(value), std::abs(beside));
  const std::vector<std::string> both =
      format_together({value * in.per_si, beside * in.per_si}, digits, digits_of_difference, noise_of(largest) * in.per_si);
  const std::string behind = in.label.empty() || in.label == "°" ? in.label : " " + in.label;
  return {typeset(both[0]) + behind, typeset(both[1]) + behind};
}

std::string show_time(const Analysis& a, int sample) {
  const std::vector<double>& t = a.time();
  const double step = t.size() > 1 ? (t.back() - t.front()) / static_cast<double>(t.size() - 1) : 1.0;
  const int decimals = std::clamp(static_cast<int>(std::ceil(1.0 - std::log10(step))), 0, 9);
  std::string s = fmt::format("{:.{}f}", t[static_cast<std::size_t>(sample)], decimals);
  if (s.find('.') != std::string::npos) {
    s.erase(s.find_last_not_of('0') + 1);
    if (s.back() == '.') s.pop_back();
  }
  return s + " s";
}

std::string symbol(std::string_view name) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 8> greek{
      {{"alpha", "α"}, {"beta", "β"}, {"gamma", "γ"}, {"theta", "θ"}, {"phi", "φ"}, {"psi", "ψ"}, {"rho", "ρ"}, {"det_G", "det G"}}};
  // A letter p behind the digits stands for a prime: "U6p".
  const bool primed = name.size() > 2 && name.back() == 'p' && name[name.size() - 2] >= '0' && name[name.size() - 2] <= '9';
  if (primed) name.remove_suffix(1);
  const std::size_t digits = name.find_last_not_of("0123456789") + 1;
  std::string_view stem = name.substr(0, digits);
  std::string out(stem);
  for (const auto& [word, letter] : greek)
    if (stem == word) out = letter;
  if (stem == "constraint") out = "Fτ";
  if (primed) out += "′";
  for (const char c : name.substr(digits))
    out += fmt::format("\xE2\x82{}", static_cast<char>('\x80' + (c - '0')));  // subscript digits U+2080..
  return out;
}

namespace {

// The symbol behind its first letter: a Greek one takes two bytes, the first of them 0xCE or 0xCF.
std::string index_of(const std::string& symbol) {
  const bool greek = symbol.size() > 1 && (symbol[0] == '\xCE' || symbol[0] == '\xCF');
  return symbol.substr(std::min<std::size_t>(symbol.size(), greek ? 2 : 1));
}

const char* letter_of(Effort what, const Actuator& x) { return what == Effort::power ? "P" : x.sense() == Sense::linear ? "F" : "τ"; }

}  // namespace

std::string with_dots(const std::string& symbol, int dots) {
  const std::string index = index_of(symbol), mark = dots == 1 ? "\u0307" : dots == 2 ? "\u0308" : "";
  return symbol.substr(0, symbol.size() - index.size()) + mark + index;
}

std::string effort_symbol(const Topology& t, const Actuator& actuator, Effort what) {
  const auto shortest = [what](const Actuator& x) { return letter_of(what, x) + index_of(symbol(x.name)); };
  const auto same = [&](const Actuator& other) { return other.name != actuator.name && shortest(other) == shortest(actuator); };
  if (std::none_of(t.actuators.begin(), t.actuators.end(), same)) return shortest(actuator);
  return fmt::format("{} {}", letter_of(what, actuator), symbol(actuator.name));
}

std::string typeset(std::string number) {
  for (std::size_t at = 0; (at = number.find('-', at)) != std::string::npos; at += 3) number.replace(at, 1, "−");
  return number;
}

std::string typographic(std::string_view unit) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 6> signs{
      {{"deg", "°"}, {"*", "·"}, {"^2", "²"}, {"^3", "³"}, {"um", "\u00b5m"}, {"urad", "\u00b5rad"}}};
  std::string out(unit);
  for (const auto& [plain, sign] : signs)
    for (std::size_t at = 0; (at = out.find(plain, at)) != std::string::npos; at += sign.size()) out.replace(at, plain.size(), sign);
  return out;
}

std::string plural(int n, const std::string& singular, const std::string& many) {
  return fmt::format("{} {}", n, n == 1 ? singular : many.empty() ? singular + "s" : many);
}

std::string span_of(const Analysis& a, int first, int last) {
  return first == last ? "t = " + show_time(a, first) : "t = " + show_time(a, first) + " to " + show_time(a, last);
}

namespace {

// "l" and 12 of "l12"; a name without a number has none.
std::pair<std::string, int> counted(const std::string& name) {
  const std::size_t digits = name.find_last_not_of("0123456789") + 1;
  if (digits == name.size() || name.size() - digits > 6) return {name, -1};
  return {name.substr(0, digits), std::stoi(name.substr(digits))};
}

}  // namespace

std::string names_of(std::vector<std::string> names) {
  std::stable_sort(names.begin(), names.end(), [](const auto& x, const auto& y) { return counted(x) < counted(y); });
  std::vector<std::string> out;
  for (std::size_t first = 0; first < names.size();) {
    std::size_t last = first;
    const auto [stem, number] = counted(names[first]);
    while (last + 1 < names.size() && number >= 0 &&
           counted(names[last + 1]) == std::pair(stem, number + static_cast<int>(last + 1 - first)))
      ++last;
    if (last - first < 2) last = first;
    out.push_back(last == first ? names[first] : names[first] + " to " + names[last]);
    first = last + 1;
  }
  return listed(out);
}

namespace {

std::string reach_sentence(const Analysis& a, const SampleRun& run) {
  return fmt::format("{}: the mechanism cannot be assembled ({}): {}.", span_of(a, run.first, run.last),
                     plural(run.last - run.first + 1, "sample"), a.why(run.first));
}

std::string many_runs(const Analysis& a, const std::vector<SampleRun>& runs) {
  int samples = 0;
  for (const SampleRun& r : runs) samples += r.last - r.first + 1;
  return fmt::format("The mechanism cannot be assembled at {} of {} samples, in {} intervals between t = {} and t = {}; at the first: {}.",
                     samples, a.samples(), runs.size(), show_time(a, runs.front().first), show_time(a, runs.back().last),
                     a.why(runs.front().first));
}

}  // namespace

std::vector<std::string> reach_sentences(const Analysis& a) {
  std::vector<std::string> out;
  std::vector<SampleRun> apart;  // those in which the motion goes on
  for (const SampleRun& i : a.unreachable())
    if (!a.trajectory().value.row(i.first).allFinite())
      out.push_back(fmt::format("The motion {}. {} from {} have no pose.", a.trajectory().ending, plural(i.last - i.first + 1, "sample"),
                                span_of(a, i.first, i.last)));
    else
      apart.push_back(i);
  if (apart.size() > told_one_by_one) {
    out.push_back(many_runs(a, apart));
    return out;
  }
  for (const SampleRun& i : apart) out.push_back(reach_sentence(a, i));
  return out;
}

std::string why_nothing(const Analysis& a) {
  const int unreachable = a.count(Outcome::unreachable), singular = a.count(Outcome::singular);
  if (a.samples() == 0) return "there is no motion";
  const auto why = [&](Outcome outcome) {
    int k = 0;
    while (a.outcome(k) != outcome) ++k;
    return a.why(k).empty() ? "" : " (" + a.why(k) + ")";
  };
  if (unreachable == a.samples()) return "no sample can be assembled" + why(Outcome::unreachable);
  if (singular == a.samples()) return "every sample is singular" + why(Outcome::singular);
  std::vector<std::string> parts;
  if (unreachable > 0)
    parts.push_back(fmt::format("{} of {} samples cannot be assembled{}", unreachable, a.samples(), why(Outcome::unreachable)));
  if (singular > 0) parts.push_back(fmt::format("{} of {} samples are singular{}", singular, a.samples(), why(Outcome::singular)));
  return parts.empty() ? "it could not be computed at any sample" : listed(parts);
}

}  // namespace pmreport::section
