#include <algorithm>
#include <reports/figure/palette.hpp>
#include <reports/scene/look.hpp>

namespace pmreport::scene {

namespace {

// Of the curve's colour: a part that the actuator itself moves takes most, what else belongs to the limb so much that one sees whose it is.
constexpr float share_of_driven = 0.80f, share_of_limb = 0.30f;

}  // namespace

// A drive between two bodies drives the one that is farther from the base by the order of its declaration, b, and the other holds it. On
// the base only b moves. What has no drive of its own belongs to its limb's actuator, where there is one and no more.
std::vector<Drive> drives_of_bodies(const Topology& t) {
  std::vector<Drive> out(t.bodies.size());
  const auto inner = [&](int body) { return body != 0 && body != t.platform; };
  const auto claim = [&](int body, int actuator, bool driven) {
    Drive& d = out[static_cast<std::size_t>(body)];
    if (inner(body) && (d.actuator < 0 || (driven && !d.driven))) d = {actuator, driven};
  };
  for (std::size_t i = 0; i < t.actuators.size(); ++i) {
    const Joint& joint = t.joints[static_cast<std::size_t>(t.actuators[i].joint)];
    const bool turned = !inner(joint.b);
    claim(turned ? joint.a : joint.b, static_cast<int>(i), true);
    claim(turned ? joint.b : joint.a, static_cast<int>(i), false);
  }
  const std::vector<Drive> direct = out;
  for (std::size_t body = 0; body < out.size(); ++body) {
    const int limb = t.bodies[body].limb;
    if (limb == 0 || out[body].actuator >= 0) continue;
    std::vector<int> its;
    for (std::size_t other = 0; other < out.size(); ++other)
      if (const int i = direct[other].actuator; t.bodies[other].limb == limb && i >= 0 && std::ranges::find(its, i) == its.end())
        its.push_back(i);
    if (its.size() == 1) out[body] = {its.front(), false};
  }
  return out;
}

Color curve_color(int actuator) {
  const figure::Colour c = figure::line_style(actuator).colour;
  return {static_cast<float>(c.red), static_cast<float>(c.green), static_cast<float>(c.blue), 1};
}

Color tinted(const Color& plain, const Drive& drive) {
  if (drive.actuator < 0) return plain;
  const Color curve = curve_color(drive.actuator);
  const float s = drive.driven ? share_of_driven : share_of_limb;
  return {plain.r + s * (curve.r - plain.r), plain.g + s * (curve.g - plain.g), plain.b + s * (curve.b - plain.b), plain.a};
}

}  // namespace pmreport::scene
