#include <reports/section/check_words.hpp>

#include <core/text/units.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace pmreport::section {

namespace {

DisplayUnit unit_of(const scenario::Check& c, double size) { return unit_written(c.written_in).value_or(display_unit(c.unit, size)); }

double size_of(const Bounds& b) { return std::max(std::abs(b.low), std::abs(b.high)); }

}  // namespace

std::optional<DisplayUnit> unit_written(const std::string& written_in) {
  const auto unit = parse_unit(written_in);
  if (!unit || written_in.empty()) return std::nullopt;
  return DisplayUnit{typographic(written_in), 1 / unit->factor};
}

std::string written(double bound, const scenario::Check& c) {
  constexpr int usual = 6, most = 12;
  const DisplayUnit unit = unit_of(c, std::abs(bound));
  const double shown = bound * unit.per_si;
  int digits = usual;
  while (digits < most && std::abs(std::strtod(format_number(shown, digits).c_str(), nullptr) - shown) > 1e-12 * std::abs(shown)) ++digits;
  return show(bound, unit, digits);
}

Apart measured_words(double value, double bound, const scenario::Check& c) {
  return show_apart(value, bound, unit_of(c, std::max(std::abs(value), std::abs(bound))), 6);
}

std::string known_words(const Bounds& b, const scenario::Check& c) { return bracket(b, unit_of(c, size_of(b))); }

std::string bounds_words(const Bounds& b, const scenario::Check& c) {
  const std::optional<DisplayUnit> own = unit_written(c.written_in);
  return own ? show_bracket({b.low * own->per_si, b.high * own->per_si}, c.written_in) : show_bracket(b, c.unit);
}

}  // namespace pmreport::section
