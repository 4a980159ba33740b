// Limbs alike are made alike and stand in a regular pattern, or in none; what breaks it in one place alone is odd.
//
// On base or platform, n joints of limbs alike are looked at about each axis of that body through its origin: radius, height, azimuth. With
// equal radii and heights, and the gaps between neighbours in azimuth g_1 ... g_n, the pattern is regular of period p, p a divisor of n,
// when
//     g_(i+p) = g_i                                                                                                                 (1)
// p = 1 for joints all around, 2 for pairs. From three repetitions on it can be told when (1) holds but for one joint, or one gap.
#include <core/mechanics/conformance/oddities.hpp>

#include <core/text/text.hpp>
#include <core/text/units.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace pmreport::mechanics {

using Eigen::Vector3d;

namespace {

// Of the size of what is compared: coordinates are rounded to three digits; what is off by less than a hundredth may be meant.
constexpr double equal = 2e-3, off = 1e-2;

bool same(double a, double b, double size) { return std::abs(a - b) <= equal * size; }

struct Polar {
  double radius, height, azimuth;  // [m], [m], [rad] from 0 to a turn
};

Polar polar(const Vector3d& p, Eigen::Index axis) {
  const double x = p((axis + 1) % 3), y = p((axis + 2) % 3), angle = std::atan2(y, x);
  return {std::hypot(x, y), p(axis), angle < 0 ? angle + whole_turn : angle};
}

// From each azimuth to the next, the last to the first; sorted azimuths.
std::vector<double> gaps(const std::vector<double>& azimuths) {
  std::vector<double> out;
  for (std::size_t i = 0; i < azimuths.size(); ++i)
    out.push_back(i + 1 < azimuths.size() ? azimuths[i + 1] - azimuths[i] : azimuths.front() + whole_turn - azimuths.back());
  return out;
}

bool level(const std::vector<Polar>& points, double size) {
  return std::all_of(points.begin(), points.end(), [&](const Polar& p) {
    return same(p.radius, points.front().radius, size) && same(p.height, points.front().height, size);
  });
}

std::vector<double> sorted_azimuths(const std::vector<Polar>& points) {
  std::vector<double> out;
  for (const Polar& p : points) out.push_back(p.azimuth);
  std::sort(out.begin(), out.end());
  return out;
}

// (1), of any period.
bool regular(const std::vector<Polar>& points, double size) {
  if (!level(points, size)) return false;
  const std::vector<double> g = gaps(sorted_azimuths(points));
  for (std::size_t p = 1; p < g.size(); ++p) {
    if (g.size() % p != 0) continue;
    bool repeats = true;
    for (std::size_t i = 0; i < g.size(); ++i) repeats = repeats && same(g[i], g[i % p], 1);
    if (repeats) return true;
  }
  return false;
}

// Where a further point would complete `points` to a regular pattern of `n` = points + 1; azimuths may allow several places.
std::vector<Polar> completions(const std::vector<Polar>& points, double size) {
  std::vector<Polar> out;
  if (!level(points, size)) return out;
  const std::vector<double> azimuths = sorted_azimuths(points), g = gaps(azimuths);
  const std::size_t n = points.size() + 1;
  for (std::size_t p = 1; 3 * p <= n; ++p) {
    if (n % p != 0) continue;
    for (std::size_t hole = 0; hole < g.size(); ++hole) {  // gap `hole` is cut in two
      std::vector<double> of_class(p, -1);
      bool repeats = true;
      for (std::size_t i = 0; i < g.size(); ++i) {
        if (i == hole) continue;
        double& known = of_class[(i < hole ? i : i + 1) % p];
        if (known < 0) known = g[i];
        repeats = repeats && same(known, g[i], 1);
      }
      const double first = of_class[hole % p], second = of_class[(hole + 1) % p];
      if (repeats && first >= 0 && second >= 0 && same(first + second, g[hole], 1))
        out.push_back({points.front().radius, points.front().height, std::fmod(azimuths[hole] + first, whole_turn)});
    }
  }
  return out;
}

double distance(const Polar& a, const Polar& b) {
  return Vector3d(a.radius * std::cos(a.azimuth) - b.radius * std::cos(b.azimuth),
                  a.radius * std::sin(a.azimuth) - b.radius * std::sin(b.azimuth), a.height - b.height)
      .norm();
}

// The steps between equal radii that repeat but for one gap, which a slightly other step would close.
struct OpenSteps {
  double period, closed, gap;  // what repeats, what would close the circle, and the gap that is left [rad]
};
std::optional<OpenSteps> open_steps(const std::vector<Polar>& points, double size) {
  if (!level(points, size)) return {};
  const std::vector<double> g = gaps(sorted_azimuths(points));
  const std::size_t n = g.size();
  for (std::size_t p = 1; 3 * p <= n; ++p) {
    if (n % p != 0) continue;
    for (std::size_t odd = 0; odd < n; ++odd) {
      double period = 0;
      bool repeats = true;
      for (std::size_t c = 0; c < p; ++c) {
        double known = -1;
        for (std::size_t i = c; i < n; i += p) {
          if (i == odd) continue;
          if (known < 0) known = g[i];
          repeats = repeats && same(known, g[i], 1);
        }
        period += known;
      }
      // Near the step that would close: farther off, as of a T, or where corners of a polygon are left out, it is meant.
      const double repeated = static_cast<double>(n) / static_cast<double>(p), closed = whole_turn / repeated;
      const double wrong = std::abs(period / closed - 1), missing = whole_turn / period - repeated;
      const bool polygon = missing > 0.5 && std::abs(missing - std::round(missing)) < off;
      if (repeats && !polygon && wrong > off && wrong < 0.2) return OpenSteps{period, closed, g[odd]};
    }
  }
  return {};
}

// Whether a joint of some other limb stands there: then the pattern is whole, and the joint in question stands apart from it.
bool taken(const AtHome& home, int body, const Polar& place, Eigen::Index axis, double size) {
  const std::vector<int>& joints = home.joints_of(body);
  return std::any_of(joints.begin(), joints.end(), [&](int j) { return distance(polar(home.seat(j, body), axis), place) <= off * size; });
}

void look_at_places(const AtHome& home, const std::vector<int>& joints, int body, std::vector<Oddity>& out) {
  const std::size_t n = joints.size();
  std::vector<Vector3d> at;
  std::vector<std::string> names;
  double size = 0;
  for (const int j : joints) {
    at.push_back(home.seat(j, body)), names.push_back(home.joint(j).name);
    size = std::max(size, at.back().norm());
  }
  if (!(size > 0)) return;
  std::optional<Oddity> found;
  for (const Eigen::Index axis : {2, 1, 0}) {
    std::vector<Polar> points;
    for (const Vector3d& p : at) points.push_back(polar(p, axis));
    if (regular(points, size)) return;
    const std::string about = std::string(1, static_cast<char>((body == 0 ? 'X' : 'x') + axis));
    if (const auto steps = open_steps(points, size); steps && !found)
      found = {"steps",
               std::abs(steps->period / steps->closed - 1),
               {names,
                fmt::format("on {} they repeat every {} about {}, which leaves a gap of {}", home.body(body).name,
                            angle_words(steps->period), about, angle_words(steps->gap)),
                fmt::format("limbs alike stand all around, every {}", angle_words(steps->closed)), "look at the step of their azimuths"}};
    for (std::size_t i = 0; i < n; ++i) {
      std::vector<Polar> others = points;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
      const std::vector<Polar> places = completions(others, size);
      if (places.empty() || found) continue;
      const Polar nearest = *std::min_element(
          places.begin(), places.end(), [&](const Polar& a, const Polar& b) { return distance(a, points[i]) < distance(b, points[i]); });
      const double away = distance(nearest, points[i]);
      if (away < off * size || taken(home, body, nearest, axis, size)) continue;
      std::vector<std::string> rest = names;
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
      found = {"place",
               away / size,
               {{names[i]},
                fmt::format("on {} it stands {} away from where it would complete the regular pattern of {}: at radius {}, azimuth {}, "
                            "height {} about {}, for {}, {}, {}",
                            home.body(body).name, length_words(away), listed(rest), length_words(points[i].radius),
                            angle_words(points[i].azimuth), length_words(points[i].height), about, length_words(nearest.radius),
                            angle_words(nearest.azimuth), length_words(nearest.height)),
                "limbs alike stand in one pattern",
                "look at the coordinates of this one"}};
    }
  }
  if (found) out.push_back(*found);
}

// What one number of each of several limbs is, and what it says: "mass" in "kg".
struct Data {
  std::string what, unit;
  std::vector<std::string> names;
  std::vector<double> values;
};

std::string words(double x, const std::string& unit) {
  return unit == "m" ? length_words(x) : unit == "rad" ? angle_words(x) : format_number(x, 4) + " " + unit;
}

// The one that differs where all others are equal.
void look_at_one(const Data& d, std::vector<Oddity>& out) {
  for (std::size_t i = 0; i < d.values.size(); ++i) {
    const double other = d.values[i == 0 ? 1 : 0], size = std::max(std::abs(other), std::abs(d.values[i]));
    bool alike = true;
    for (std::size_t k = 0; k < d.values.size(); ++k) alike = alike && (k == i || std::abs(d.values[k] - other) <= 1e-9 * size);
    if (!alike || std::abs(d.values[i] - other) <= off * size) continue;
    out.push_back({"",
                   1,
                   {{d.names[i]},
                    fmt::format("its {} is {}, that of all {} others of its make {}", d.what, words(d.values[i], d.unit),
                                d.values.size() - 1, words(other, d.unit)),
                    "limbs alike are made alike",
                    "one number of one limb may be mistyped"}});
    return;
  }
}

void look_at_data(const AtHome& home, const std::vector<int>& limbs, std::vector<Oddity>& out) {
  for (std::size_t k = 0; k < home.bodies_of(limbs.front()).size(); ++k) {
    Data mass{"mass", "kg", {}, {}}, centre{"centre of mass, from its origin,", "m", {}, {}},
        inertia{"inertia, the sum about three axes,", "kg*m^2", {}, {}};
    for (const int limb : limbs) {
      const Body& b = home.body(home.bodies_of(limb)[k]);
      for (Data* d : {&mass, &centre, &inertia}) d->names.push_back(b.name);
      mass.values.push_back(b.inertia.mass);
      centre.values.push_back(b.inertia.centre.norm());
      inertia.values.push_back(b.inertia.about_centre.trace());
    }
    // A part of another mass has another inertia too.
    const std::size_t before = out.size();
    look_at_one(mass, out);
    if (out.size() == before) look_at_one(centre, out), look_at_one(inertia, out);
  }
  for (std::size_t k = 0; k < home.joints_of_limb(limbs.front()).size(); ++k) {
    const Joint& first = home.joint(home.joints_of_limb(limbs.front())[k]);
    const std::string unit = first.kind == JointKind::prismatic ? "m" : "rad";
    for (std::size_t r = 0; r < first.limits.size(); ++r) {
      Data least{"lower limit", unit, {}, {}}, most{"upper limit", unit, {}, {}};
      for (const int limb : limbs) {
        const Joint& j = home.joint(home.joints_of_limb(limb)[k]);
        if (j.limits.size() <= r) break;
        for (Data* d : {&least, &most}) d->names.push_back(j.name);
        least.values.push_back(j.limits[r].min), most.values.push_back(j.limits[r].max);
      }
      if (least.values.size() == limbs.size()) look_at_one(least, out), look_at_one(most, out);
    }
    Data least{"lower end of stroke", unit, {}, {}}, most{"upper end of stroke", unit, {}, {}};
    for (const int limb : limbs)
      for (const Actuator& a : home.topology().actuators) {
        if (a.joint != home.joints_of_limb(limb)[k]) continue;
        for (Data* d : {&least, &most}) d->names.push_back(a.name);
        least.values.push_back(a.stroke.min), most.values.push_back(a.stroke.max);
      }
    if (least.values.size() == limbs.size()) look_at_one(least, out), look_at_one(most, out);
  }
}

}  // namespace

std::vector<Oddity> odd_layouts(const AtHome& home) {
  std::vector<Oddity> out;
  for (const auto& limbs : home.alike()) {
    if (limbs.size() < 3) continue;
    look_at_data(home, limbs, out);
    std::vector<int> told;  // bodies: several joints of each limb may stand in one broken pattern
    for (std::size_t k = 0; k < home.joints_of_limb(limbs.front()).size(); ++k) {
      std::vector<int> joints;
      for (const int limb : limbs) joints.push_back(home.joints_of_limb(limb)[k]);
      const Joint& first = home.joint(joints.front());
      for (const int body : {first.a, first.b}) {
        if (home.body(body).limb != 0 || std::find(told.begin(), told.end(), body) != told.end()) continue;
        const std::size_t before = out.size();
        look_at_places(home, joints, body, out);
        if (out.size() > before) told.push_back(body);
      }
    }
  }
  return out;
}

}  // namespace pmreport::mechanics
