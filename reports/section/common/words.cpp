#include <reports/section/common/words.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pmreport::section {

std::string show(double si, std::string_view unit, int digits) {
  const DisplayUnit d = display_unit(unit, std::abs(si));
  const std::string number = typeset(format_number(si * d.per_si, digits));
  return d.label.empty() ? number : d.label == "°" ? number + "°" : number + " " + d.label;
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
  const std::size_t digits = name.find_last_not_of("0123456789") + 1;
  std::string_view stem = name.substr(0, digits);
  std::string out(stem);
  for (const auto& [word, letter] : greek)
    if (stem == word) out = letter;
  if (stem == "constraint") out = "Fτ";
  for (const char c : name.substr(digits))
    out += fmt::format("\xE2\x82{}", static_cast<char>('\x80' + (c - '0')));  // subscript digits U+2080..
  return out;
}

std::string typeset(std::string number) {
  for (std::size_t at = 0; (at = number.find('-', at)) != std::string::npos; at += 3) number.replace(at, 1, "−");
  return number;
}

std::string typographic(std::string_view unit) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 4> signs{{{"deg", "°"}, {"*", "·"}, {"^2", "²"}, {"^3", "³"}}};
  std::string out(unit);
  for (const auto& [plain, sign] : signs)
    for (std::size_t at = 0; (at = out.find(plain, at)) != std::string::npos; at += sign.size()) out.replace(at, plain.size(), sign);
  return out;
}

std::string plural(int n, const std::string& singular, const std::string& many) {
  return fmt::format("{} {}", n, n == 1 ? singular : many.empty() ? singular + "s" : many);
}

namespace {
std::string span_of(const Analysis& a, int first, int last) {
  return first == last ? "t = " + show_time(a, first) : "t = " + show_time(a, first) + " to " + show_time(a, last);
}
}  // namespace

std::string sentence(const Analysis& a, const LimitBreach& b) {
  const std::string what = b.stroke ? fmt::format("its stroke {} at {}", b.above ? "ends" : "begins", show(b.limit, b.unit))
                                    : fmt::format("its limit is {}", show(b.limit, b.unit));
  std::string s =
      fmt::format("{}: {} needs {}, {}", span_of(a, b.samples.front(), b.samples.back()), b.subject, show(b.value, b.unit), what);
  if (b.samples.size() > 1)
    s += fmt::format(" (worst at t = {}, {})", show_time(a, b.worst), plural(static_cast<int>(b.samples.size()), "sample"));
  return s + ".";
}

std::vector<std::string> reach_sentences(const Analysis& a) {
  std::vector<std::string> out;
  const mechanics::Trajectory& motion = a.trajectory();
  for (const SampleRun& i : a.unreachable())
    if (!motion.value.row(i.first).allFinite())
      out.push_back(fmt::format("The motion {}. {} from {} have no pose.", motion.ending, plural(i.last - i.first + 1, "sample"),
                                span_of(a, i.first, i.last)));
    else
      out.push_back(fmt::format("{}: the mechanism cannot be assembled ({}): {}.", span_of(a, i.first, i.last),
                                plural(i.last - i.first + 1, "sample"), a.why(i.first)));
  return out;
}

}  // namespace pmreport::section
