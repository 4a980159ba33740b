#include <reports/section/common/stage.hpp>

#include <core/text/units.hpp>
#include <reports/section/common/words/words.hpp>

#include <fmt/core.h>

#include <numbers>

namespace pmreport::section {

View view_at(double azimuth, double elevation) {
  constexpr double per_degree = std::numbers::pi / 180;
  const auto degrees = [](double angle) { return typeset(format_number(angle / per_degree, 4)); };
  return {fmt::format("azimuth {}°, elevation {}°", degrees(azimuth), degrees(elevation)), azimuth, elevation};
}

std::string words(const View& view) { return view.name.starts_with("azimuth") ? "view from " + view.name : view.name + " view"; }

}  // namespace pmreport::section
