// One length against the rest, as a radius in mm where m were meant leaves it; strokes that home is not in; angles in degrees where radians
// were meant.
#include <core/mechanics/conformance/oddities.hpp>

#include <core/text/units.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace pmreport::mechanics {

namespace {

std::string size_words(double x, const std::string& unit) { return unit == "rad" ? angle_words(x) : length_words(x); }

// Base, platform and limbs of a machine are of one size, within a hundred times.
void look_at_sizes(const AtHome& home, std::vector<Oddity>& out) {
  struct Size {
    std::string name;
    double length;
  };
  std::vector<Size> sizes;
  const int platform = home.topology().platform;
  for (const int i : {0, platform}) sizes.push_back({home.body(i).name, home.apart(home.joints_of(i))});
  for (const auto& group : home.alike())
    for (const int limb : group) sizes.push_back({fmt::format("limb {}", limb), home.joints_apart(limb)});
  std::erase_if(sizes, [](const Size& s) { return !(s.length > 0); });
  if (sizes.size() < 3) return;
  std::vector<double> lengths;
  for (const Size& s : sizes) lengths.push_back(s.length);
  std::nth_element(lengths.begin(), lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2), lengths.end());
  const double middle = lengths[lengths.size() / 2];
  constexpr double most = 100;
  for (const Size& s : sizes) {
    const double ratio = std::max(s.length / middle, middle / s.length);
    if (ratio < most) continue;
    out.push_back(
        {"size",
         ratio,
         {{s.name},
          fmt::format("its joints are {} apart at home, those of most other parts about {}", length_words(s.length), length_words(middle)),
          fmt::format("base, platform and limbs are of one size, within {:.0f} times", most),
          "one of the lengths may be in mm where m were meant, or the other way round"}});
  }
}

// Two joints of one body almost, and not quite, in one place.
void look_at_spacing(const AtHome& home, std::vector<Oddity>& out) {
  constexpr double least = 1e-3, none = 1e-6;  // of all that the joints span; nearer than `none` they are one point, but for rounding
  for (int i = 0; i < home.bodies(); ++i) {
    double nearest = least * home.span();
    int one = -1, other = -1;
    for (const int a : home.joints_of(i))
      for (const int b : home.joints_of(i))
        if (const double apart = (home.centre(a) - home.centre(b)).norm(); apart > none * home.span() && apart < nearest)
          nearest = apart, one = a, other = b;
    if (one < 0) continue;
    out.push_back({"spacing",
                   home.span() / nearest,
                   {{home.body(i).name},
                    fmt::format("its joints {} and {} are {} apart, all joints of the mechanism {}", home.joint(one).name,
                                home.joint(other).name, length_words(nearest), length_words(home.span())),
                    "joints of one part stand in one point, or well apart",
                    "the length between them may be in another unit"}});
  }
}

void look_at_strokes(const AtHome& home, std::vector<Oddity>& out) {
  const Topology& t = home.topology();
  for (std::size_t i = 0; i < t.actuators.size(); ++i) {
    const Actuator& a = t.actuators[i];
    const double at = home.actuator(static_cast<int>(i)), width = a.stroke.max - a.stroke.min, rounding = 1e-9 * width;
    if (at >= a.stroke.min - rounding && at <= a.stroke.max + rounding) continue;
    out.push_back({"stroke",
                   std::max(a.stroke.min - at, at - a.stroke.max) / width,
                   {{a.name},
                    fmt::format("it stands at {} at home, its stroke goes from {} to {}", size_words(at, a.unit),
                                size_words(a.stroke.min, a.unit), size_words(a.stroke.max, a.unit)),
                    "home is within every stroke",
                    "a length of the geometry, a stroke or home itself is that of another machine, or in another unit"}});
  }
}

void look_at_angles(const AtHome& home, std::vector<Oddity>& out) {
  const Topology& t = home.topology();
  const auto degrees = [&](const std::string& name, double angle, double most, const char* what, const std::string& usual) {
    out.push_back({"degrees",
                   angle / most,
                   {{name},
                    fmt::format("{} is {} rad, {}", what, format_number(angle, 4), angle_words(angle)),
                    usual,
                    "angles are in radians: degrees may have been meant"}});
  };
  for (const Coordinate& c : t.coordinates)
    if (const double most = std::max(std::abs(c.box.min), std::abs(c.box.max)); c.unit == "rad" && most > whole_turn)
      degrees(c.name, most, whole_turn, "the end of its range", "a platform turns by less than a whole turn");
  for (int j = 0; j < static_cast<int>(t.joints.size()); ++j) {
    const Joint& joint = home.joint(j);
    if (joint.kind == JointKind::prismatic) continue;
    const bool ball = joint.kind == JointKind::spherical;
    // A rounded pi may be a little more than pi.
    const double most = 1.01 * (ball ? whole_turn / 2 : 2 * whole_turn);
    double farthest = 0;
    for (const Range& r : joint.limits) farthest = std::max({farthest, std::abs(r.min), std::abs(r.max)});
    if (farthest > most)
      degrees(joint.name, farthest, most, "its limit",
              ball ? "a ball deflects by at most half a turn" : "a hinge with limits turns less than twice about");
    // What a direction was declared for is to be within its own cone at home.
    if (!ball || joint.from.isZero() || joint.limits.empty()) continue;
    const Eigen::Vector3d stud = home.in_socket(j, home.stud(j));
    const double at = std::atan2(stud.cross(joint.from).norm(), stud.dot(joint.from));
    if (at > joint.limits.front().max + 1e-9)
      out.push_back({"cone",
                     at,
                     {{joint.name},
                      fmt::format("it stands {} off the direction from which its limit of {} counts, at home already", angle_words(at),
                                  angle_words(joint.limits.front().max)),
                      "home is within every limit",
                      "the direction is in axes of the body that is not the stud; look at its sign, and which body is the stud"}});
  }
}

}  // namespace

std::vector<Oddity> odd_lengths(const AtHome& home) {
  std::vector<Oddity> out;
  look_at_sizes(home, out);
  look_at_spacing(home, out);
  look_at_strokes(home, out);
  look_at_angles(home, out);
  return out;
}

}  // namespace pmreport::mechanics
