#include <reports/document/html/figure_words.hpp>
#include <reports/document/html/series_data.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <reports/figure/curve.hpp>
#include <reports/figure/layout/offsets.hpp>
#include <reports/figure/layout/range.hpp>

namespace pmreport::document {

namespace {

using figure::Panel;
using figure::Point;
using figure::Series;

constexpr std::size_t most_points = 401;
constexpr double page_width = 480, page_height = 100;  // [pt] about what a panel has
constexpr double column = 0.25;                        // [pt] as curves are drawn
constexpr double finest = 0.01;                        // [pt] a ten-thousandth of the axis, the last digit that the cursor tells

using Samples = std::vector<Point>;  // y NaN: a gap

Samples samples_of(const Series& series) {
  Samples samples;
  for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i)
    if (std::isfinite(series.x[i])) samples.push_back({series.x[i], std::isfinite(series.y[i]) ? series.y[i] : std::nan("")});
  return samples;
}

// Each run between two gaps thinned out and simplified as on the page; one missing sample stands for each gap.
Samples simplified(const Samples& samples, double tolerance) {
  double left = samples.front().x, right = left, low = INFINITY, high = -INFINITY;
  for (const Point& p : samples) {
    left = std::min(left, p.x), right = std::max(right, p.x);
    if (std::isfinite(p.y)) low = std::min(low, p.y), high = std::max(high, p.y);
  }
  const double across = right > left ? page_width / (right - left) : 0, up = high > low ? page_height / (high - low) : 0;
  Samples kept;
  for (std::size_t i = 0; i < samples.size();) {
    if (!std::isfinite(samples[i].y)) {
      if (kept.empty() || std::isfinite(kept.back().y)) kept.push_back(samples[i]);
      ++i;
      continue;
    }
    const std::size_t begin = i;
    figure::Stroke run;
    for (; i < samples.size() && std::isfinite(samples[i].y); ++i)
      run.push_back({(samples[i].x - left) * across, (samples[i].y - low) * up});
    std::size_t at = begin;
    for (const Point& p : figure::simplify(figure::decimate(run, column), tolerance)) {
      while (run[at - begin].x != p.x || run[at - begin].y != p.y) ++at;
      kept.push_back(samples[at]);
    }
  }
  return kept;
}

Samples few(const Series& series) {
  const Samples all = samples_of(series);
  Samples kept = all;
  for (double tolerance = finest; kept.size() > most_points && tolerance < page_height; tolerance *= 2) kept = simplified(all, tolerance);
  return kept;
}

std::string six_digits(double value) { return fmt::format("{:.6g}", value == 0 ? 0 : value); }

// Evenly spaced ones, as samples of a motion are, by their ends and how many they are.
std::string times_of(const Samples& samples) {
  const std::size_t n = samples.size();
  if (n > 2) {
    const double first = samples.front().x, step = (samples.back().x - first) / static_cast<double>(n - 1);
    bool even = true;
    for (std::size_t i = 0; i < n; ++i)
      even = even && std::abs(samples[i].x - first - step * static_cast<double>(i)) <= 1e-6 * std::abs(step);
    if (even) return fmt::format("{{\"from\":{},\"to\":{},\"n\":{}}}", six_digits(first), six_digits(samples.back().x), n);
  }
  std::string out = "[";
  for (const Point& p : samples) out.append(out.size() > 1 ? "," : "").append(six_digits(p.x));
  return out + "]";
}

// A step is a fine share of the axis, and what counts is by how many steps each sample differs from the one before: a third of the digits.
struct Steps {
  double low, size;
};
constexpr double steps_of_axis = 20000, most_steps = 1e9;

std::string values_of(const Samples& samples, const Steps& steps) {
  std::string out = "[";
  long long before = 0;
  for (const Point& p : samples) {
    out.append(out.size() > 1 ? "," : "");
    const double count = std::round((p.y - steps.low) / steps.size);
    if (!(std::abs(count) < most_steps)) {
      out.append("null");
      continue;
    }
    const auto now = static_cast<long long>(count);
    out.append(std::to_string(now - before));
    before = now;
  }
  return out + "]";
}

// A string of a user inside <script>: nothing in it may close the element.
std::string quoted(const std::string& text) {
  std::string out;
  for (const char c : nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace))
    c == '<' ? out += "\\u003c" : out += c;
  return out;
}

std::string rows(const std::vector<std::string>& names) {
  std::string out;
  for (const std::string& name : names) out.append(out.empty() ? "" : ",").append(quoted(name));
  return "[" + out + "]";
}

}  // namespace

std::string series_data(const figure::Figure& figure) {
  const figure::Figure drawn = figure::set_off(figure);
  std::vector<std::string> lists;
  std::string panels;
  bool any = false;
  for (std::size_t p = 0; p < drawn.panels.size(); ++p) {
    const Panel& panel = drawn.panels[p];
    const bool time = (panel.x.label == "time" || panel.x.label == "t") && panel.x.unit == "s";
    const std::string letter = drawn.panels.size() > 1 && !drawn.multiples ? "(" + figure::panel_letter(p) + ")" : "";
    const figure::Interval axis = figure::y_range(panel);
    const Steps steps{axis.low, (axis.high - axis.low) / steps_of_axis};
    std::string series;
    for (std::size_t i = 0; i < panel.series.size(); ++i) {
      const Series& s = panel.series[i];
      any = true;
      series += (series.empty() ? "" : ",") + std::string("{\"label\":") + quoted(curve_name(drawn, p, i));
      if (s.points) series += ",\"points\":true";
      if (time) {
        const Samples samples = few(s);
        const std::string x = times_of(samples);
        const auto known = std::find(lists.begin(), lists.end(), x);
        series += ",\"x\":" + std::to_string(known - lists.begin()) + ",\"y\":" + values_of(samples, steps);
        if (known == lists.end()) lists.push_back(x);
      }
      series += "}";
    }
    panels += (panels.empty() ? "" : ",\n") + std::string("{\"name\":") +
              quoted(letter + (letter.empty() || panel.title.empty() ? "" : " ") + panel.title) + ",\"time\":" + (time ? "true" : "false") +
              ",\"unit\":" + quoted(panel.y.unit);
    if (time) panels += fmt::format(",\"low\":{},\"step\":{}", steps.low, steps.size);
    if (!panel.y.names.empty()) panels += ",\"rows\":" + rows(panel.y.names);
    panels += ",\"series\":[" + series + "]}";
  }
  if (!any) return "";
  std::string x;
  for (const std::string& one : lists) x.append(x.empty() ? "" : ",").append(one);
  const std::string table =
      drawn.multiples ? ",\n\"rows\":" + rows(drawn.multiples->rows) + ",\"columns\":" + rows(drawn.multiples->columns) : "";
  return "{\"x\":[" + x + "],\n\"panels\":[" + panels + "]" + table + "}";
}

}  // namespace pmreport::document
