// Curves and figures that several tests look at.
#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>

#include "reports/figure/figure.hpp"

namespace pmreport::figure::samples {

constexpr double gap = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

inline Series curve(std::string label, int count, double duration, const std::function<double(double)>& y) {
  Series series{std::move(label), {}, {}, -1};
  for (int i = 0; i < count; ++i) {
    const double t = duration * i / (count - 1);
    series.x.push_back(t);
    series.y.push_back(y(t));
  }
  return series;
}

inline Panel panel(std::vector<Series> series) { return {"limb lengths", {"time", "s"}, {"limb length", "mm"}, std::move(series), {}, {}}; }

inline Figure figure(std::vector<Panel> panels) {
  Figure result;
  result.id = "displacement";
  result.panels = std::move(panels);
  return result;
}

// Six panels of five waves each, with bands, a limit line and a gap.
inline Figure six_panels(int count = 200) {
  std::vector<Panel> panels;
  for (int p = 0; p < 6; ++p) {
    Panel one = panel({});
    for (int i = 0; i < 5; ++i) {
      one.series.push_back(curve("l" + std::to_string(i + 1), count, 10,
                                 [=](double t) { return t > 4 && t < 4.5 ? gap : 600 + 30 * std::sin(0.6 * t * (p + 1) + i) + 5 * i; }));
    }
    one.bands = {{1, 2, Band::Kind::limit}, {4, 4.5, Band::Kind::unreachable}};
    one.lines = {{640, "stroke ends"}};
    panels.push_back(std::move(one));
  }
  return figure(std::move(panels));
}

}  // namespace pmreport::figure::samples
