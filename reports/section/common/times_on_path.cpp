#include <reports/section/common/times_on_path.hpp>

#include <core/text/units.hpp>
#include <reports/section/common/words/words.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace pmreport::section {

namespace {

using Eigen::Vector3d;

// A round step, 1, 2 or 5 times a power of ten, of which `most` at the utmost go into `span`.
double round_step(double span, int most) {
  const double decade = std::pow(10.0, std::floor(std::log10(span / most)));
  for (const double step : {1.0, 2.0, 5.0})
    if (span / (step * decade) <= most) return step * decade;
  return 10 * decade;
}

Vector3d platform_at(const Analysis& a, int sample) { return a.machine().origin(a.pose(sample), a.machine().topology().platform); }

// Nothing where a sample beside that time is out of reach.
std::optional<Vector3d> platform_at(const Analysis& a, double time) {
  const std::vector<double>& t = a.time();
  const auto after = static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(std::lower_bound(t.begin(), t.end(), time) - t.begin(), 1, static_cast<std::ptrdiff_t>(t.size()) - 1));
  const int before = static_cast<int>(after) - 1, next = static_cast<int>(after);
  if (a.outcome(before) == Outcome::unreachable || a.outcome(next) == Outcome::unreachable) return std::nullopt;
  const double s = std::clamp((time - t[after - 1]) / (t[after] - t[after - 1]), 0.0, 1.0);
  const Vector3d from = platform_at(a, before), to = platform_at(a, next);
  return Vector3d(from + s * (to - from));
}

}  // namespace

std::vector<scene::Mark> times_on_path(const Analysis& a, const std::vector<int>& shown) {
  constexpr int most = 8;
  constexpr double together = 0.04;  // of the overall size
  const std::vector<double>& t = a.time();
  if (t.size() < 2) return {};
  const double near = together * scene::overall_size(a.machine());
  std::vector<scene::Mark> marks;
  const auto put = [&](const Vector3d& at, const std::string& text, bool of_pose) {
    const auto same = std::ranges::find_if(marks, [&](const scene::Mark& m) { return (m.at - at).norm() < near; });
    if (same == marks.end())
      marks.push_back({at, text, of_pose});
    else if (same->of_pose == of_pose)
      same->text += ", " + text;
  };
  const auto without_unit = [](std::string time) { return time.erase(time.find(' ')); };
  for (const int k : shown) put(platform_at(a, k), without_unit(show_time(a, k)), true);
  const double step = round_step(t.back() - t.front(), most);
  for (double k = std::ceil(t.front() / step - 1e-9); k * step <= t.back() + 1e-9 * step; ++k)
    if (const auto at = platform_at(a, k * step)) put(*at, format_number(k * step, 6), false);
  if (marks.size() < 2) return {};
  for (scene::Mark& m : marks) m.text += " s";
  return marks;
}

}  // namespace pmreport::section
