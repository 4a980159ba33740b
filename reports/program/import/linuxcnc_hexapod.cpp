// LinuxCNC's hexapods.
//
// genhexkins has strut i from b_i on the base, in the world's axes, to a_i on the platform, in the platform's, both shifted along Z by the
// offsets of spindle and tool, and
//     l_i = |P + R a_i - b_i|,     R = Rz(c) Ry(b) Rx(a)
// so that struts 0 to 5 are legs 1 to 6 of mechanism gough, in the same axes. What genhexkins corrects for screws that turn in their nuts
// as the joints tilt is no length between joints, and not taken over.
#include <core/numbers.hpp>
#include <reports/program/import/linuxcnc_files.hpp>

#include <core/text/text.hpp>
#include <core/text/units.hpp>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace pmreport::program::linuxcnc {

using Eigen::Vector3d;
using settings::Setting;

namespace {

// Where LinuxCNC puts the joints of a hexapod that says nothing: a machine of 1.2 m in inches.
constexpr double default_base[6][3] = {{-22.950, 13.250, 0}, {22.950, 13.250, 0}, {22.950, 13.250, 0},
                                       {0, -26.500, 0},      {0, -26.500, 0},     {-22.950, 13.250, 0}};
constexpr double default_platform[6][3] = {{-1, 11.500, 0},    {1, 11.500, 0},      {10.459, -4.884, 0},
                                           {9.459, -6.616, 0}, {-9.459, -6.616, 0}, {-10.459, -4.884, 0}};

struct Hexapod {
  std::array<Vector3d, 6> base, platform;  // machine units, with the offsets
  std::string silent;                      // pins that the HAL leaves at LinuxCNC's own values
  std::size_t told = 0;                    // of 36 coordinates how many the HAL sets
};

Hexapod points_of(Files& m) {
  Hexapod out;
  double shift = 0;
  for (const char* name : {"spindle-offset", "tool-offset"})
    if (const Setting* s = m.pin(name)) shift += m.length(*s, name);
  std::vector<std::string> left;
  for (const bool base : {true, false})
    for (std::size_t i = 0; i < 6; ++i) {
      Vector3d& point = (base ? out.base : out.platform)[i];
      for (int k = 0; k < 3; ++k) {
        const std::string name = fmt::format("{}.{}.{}", base ? "base" : "platform", i, "xyz"[k]);
        const Setting* s = m.pin(name);
        point(k) = s != nullptr ? m.length(*s, m.kins() + "." + name) : (base ? default_base : default_platform)[i][k];
        s != nullptr ? void(++out.told) : left.push_back(name);
      }
      point.z() += shift;
    }
  out.silent = listed(left);
  return out;
}

std::array<double, 6> lengths_at(const Hexapod& h, const Vector3d& p, const Eigen::Matrix3d& r) {
  std::array<double, 6> out{};
  for (std::size_t i = 0; i < 6; ++i) out[i] = (p + r * h.platform[i] - h.base[i]).norm();
  return out;
}

double mean(const std::array<double, 6>& all) { return std::accumulate(all.begin(), all.end(), 0.0) / 6; }

// Over the middle of the base, level, where the struts are as long on average as asked for.
Vector3d home_over_base(const Hexapod& h, double length) {
  Vector3d middle = Vector3d::Zero(), of_platform = Vector3d::Zero();
  for (std::size_t i = 0; i < 6; ++i) middle += h.base[i] / 6, of_platform += h.platform[i] / 6;
  Vector3d level = middle - of_platform;
  for (double& x : level)
    if (std::abs(x) < 1e-9 * length) x = 0;  // but for rounding
  double low = 0, high = length;
  for (int k = 0; k < 60; ++k) {
    const double z = (low + high) / 2;
    (mean(lengths_at(h, level + z * Vector3d::UnitZ(), Eigen::Matrix3d::Identity())) < length ? low : high) = z;
  }
  return level + high * Vector3d::UnitZ();
}

std::string points_in_toml(const std::array<Vector3d, 6>& points, const std::string& unit, const char* what) {
  std::string out = "[\n";
  for (std::size_t i = 0; i < 6; ++i)
    out += fmt::format("  {}, {}, {},  # {} of strut {}\n", quoted(points[i].x(), unit), quoted(points[i].y(), unit),
                       quoted(points[i].z(), unit), what, i);
  return out + "]\n";
}

}  // namespace

Imported hexapod(Files& m) {
  Imported out;
  out.mechanism = "gough";
  const std::string& unit = out.unit = m.unit().name;
  const Hexapod h = points_of(m);
  const Stroke stroke = strokes_of(m, 6);

  // Home: as the machine says, else where its struts are in the middle of what they can.
  Vector3d p;
  Eigen::Matrix3d r = Eigen::Matrix3d::Identity();
  const auto given = home_of(m);
  if (given) {
    out.home = place_of_home(m);
    p = {(*given)[0], (*given)[1], (*given)[2]};
    const double a = (*given)[3] * m.degrees() * deg, b = (*given)[4] * m.degrees() * deg, c = (*given)[5] * m.degrees() * deg;
    r = (Eigen::AngleAxisd(c, Vector3d::UnitZ()) * Eigen::AngleAxisd(b, Vector3d::UnitY()) * Eigen::AngleAxisd(a, Vector3d::UnitX()))
            .toRotationMatrix();
  } else {
    double spread = 0;
    for (std::size_t i = 0; i < 6; ++i) spread = std::max({spread, h.base[i].norm(), (h.base[i] - h.base[0]).norm()});
    const bool both = stroke.lowest && stroke.highest && *stroke.lowest > 0 && *stroke.highest * m.unit().metres < most_metres;
    p = home_over_base(h, both ? (*stroke.lowest + *stroke.highest) / 2 : 1.2 * spread);
    out.told.push_back(
        fmt::format("{}: home is over the base, where the struts are {}.",
                    m.ini("TRAJ", "HOME") != nullptr ? "[TRAJ]HOME is all zeros, in the plane of the base" : "No [TRAJ]HOME was given",
                    both ? "in the middle of their limits" : "somewhat longer than the base is wide"));
  }
  const std::array<double, 6> lengths = lengths_at(h, p, r);
  if (!(*std::ranges::min_element(lengths) > 0))
    settings::refuse(given ? out.home : m.kins_place(), "expected a home where every strut has a length, seen one without");
  const double length = mean(lengths), scale = length / 0.95;  // of the mechanism's own machine

  out.told.insert(out.told.begin(), "Imported from LinuxCNC's genhexkins; its struts 0 to 5 are legs 1 to 6, in the same axes.");
  out.told.emplace_back(
      "Orientations: alpha, beta, gamma are Rz(alpha) Rx(beta) Ry(gamma), where LinuxCNC's a, b, c are Rz(c) Ry(b) Rx(a).");
  tell_unit(m, out);
  if (h.told == 0)
    out.told.emplace_back("The files set no joint at all: the points are those that LinuxCNC has by itself.");
  else if (!h.silent.empty())
    out.told.push_back(fmt::format("Not set by the files, and as LinuxCNC has it by itself: {}.", h.silent));
  out.told.emplace_back("Masses, sizes and stiffness of the parts are the mechanism's own, or in its proportions: no such file has them.");

  std::string& q = out.parameters;
  q += "base_points = " + points_in_toml(h.base, unit, "base joint") +
       "platform_points = " + points_in_toml(h.platform, unit, "platform joint");
  double disc = 0;
  for (const Vector3d& b : h.platform) disc += std::hypot(b.x(), b.y()) / 6;
  q += fmt::format("platform_radius = {}  # of the disc that is drawn\n",
                   quoted(std::max(roughly(disc, guessed), 0.001 / m.unit().metres), unit));
  if (given)
    q += fmt::format("home_position = [{}, {}, {}]  # [TRAJ]HOME\n", quoted(p.x(), unit), quoted(p.y(), unit), quoted(p.z(), unit));
  else
    q += fmt::format("home_position = [{}, {}, {}]\n", quoted(std::stod(format_number(p.x(), 6)), unit),
                     quoted(std::stod(format_number(p.y(), 6)), unit), quoted(std::stod(format_number(p.z(), 4)), unit));
  if (const double beta = std::asin(std::clamp(r(2, 1), -1.0, 1.0)); !r.isIdentity(0))
    q += fmt::format("home_angles = [{}, {}, {}]\n", quoted(std::atan2(-r(0, 1), r(1, 1)) / deg, "deg"), quoted(beta / deg, "deg"),
                     quoted(std::atan2(-r(2, 0), r(2, 2)) / deg, "deg"));
  // Limits that stop nothing, as simulators have them, are no strokes.
  const double shortest = *std::ranges::min_element(lengths), longest = *std::ranges::max_element(lengths);
  const bool low = stroke.lowest && *stroke.lowest > 0, high = stroke.highest && *stroke.highest * m.unit().metres <= most_metres;
  q += fmt::format("stroke_min = {}  # {}\n", quoted(low ? *stroke.lowest : roughly(0.6 * shortest, guessed), unit),
                   low ? stroke.from : "a guess");
  q += fmt::format("stroke_max = {}  # {}\n", quoted(high ? *stroke.highest : roughly(1.5 * longest, guessed), unit),
                   high ? stroke.from : "a guess");
  if (stroke.lowest && !low) out.told.push_back(fmt::format("MIN_LIMIT {} stops no strut.", format_number(*stroke.lowest, 6)));
  if (stroke.highest && !high) out.told.push_back(fmt::format("MAX_LIMIT {} stops no strut.", format_number(*stroke.highest, 6)));
  for (const auto& [name, share] : {std::pair{"cylinder_length", 0.76}, std::pair{"rod_length", 0.7}, std::pair{"cylinder_radius", 0.03},
                                    std::pair{"rod_radius", 0.02}, std::pair{"platform_thickness", 0.03}})
    q += fmt::format("{} = {}\n", name, quoted(roughly(share * scale, guessed), unit));

  if (const Setting* s = m.pin("screw-lead"))
    if (const double lead = m.length(*s, "the screw-lead"); lead != 0) {
      out.tables += fmt::format("[drive]\nlead = {}  # {}\n\n", quoted(std::abs(lead), unit), where(s->place));
      out.kinds.emplace_back("drives");
      out.not_taken.push_back(fmt::format(
          "{}: what the lead corrects of the joints' positions as the joints tilt; actuators here are lengths", where(s->place)));
    }
  if (const Setting* s = m.net("tool-offset"))
    out.not_taken.push_back(fmt::format("{}: the tool's length from signal {}, taken as 0", where(s->place), settings::shown(s->value)));
  put_speeds(m, 6, "rho", out);
  return out;
}

}  // namespace pmreport::program::linuxcnc
