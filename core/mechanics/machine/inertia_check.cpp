// A body of mass points m at r from its centre of mass has the second moments S and the inertia I about that centre,
//     S = sum m r r^T,    I = tr(S) 1 - S,    hence    S = tr(I) / 2 1 - I                                              (1)
// and S is positive semidefinite. The other way round, to every such S there is a body, with any mass above zero. The principal values of S
// are half of what two principal moments exceed the third by: they say that no principal moment exceeds the sum of the other two, which
// includes that none is negative. A thin plate reaches equality, a thin rod and a mass point are legal, a body without mass has S = 0.
//
// A motor that turns a body about the axis a through a gear is felt there as an inertia J about that axis alone, I + J a a^T. What is
// declared is then possible where some J from 0 to a^T I a leaves a possible body. The least principal value of S - J (1 / 2 - a a^T) is
// concave in J, so the best J is found by sections.
#include <core/mechanics/machine/inertia_check.hpp>

#include <core/linear/eigenvalues.hpp>
#include <core/text/text.hpp>
#include <core/text/units.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace pmreport::mechanics {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Drawings give moments with three digits: half a unit of the last may lift a thin plate over the equality, by a few thousandths. A
// negative moment has no such excuse, for it makes energy negative: it may be one of rounding only.
constexpr double digits_given = 0.01, rounding = 1e-9;

double least_second_moment(const Matrix3d& inertia) {
  return linear::symmetric_eigenvalues(Matrix3d(0.5 * inertia.trace() * Matrix3d::Identity() - inertia)).minCoeff();
}

bool possible(const Matrix3d& inertia, double scale) {
  return least_second_moment(inertia) >= -0.5 * digits_given * scale &&
         linear::symmetric_eigenvalues(inertia).minCoeff() >= -rounding * scale;
}

// Of a body without mass all inertia, of another what no body can have, is that of a rotor about `axis`.
bool possible_with_rotor(const Inertia& body, const Vector3d& axis, double scale) {
  const Matrix3d about = axis * axis.transpose();
  const double most = axis.dot(body.about_centre * axis);
  const auto left = [&](double rotor) { return Matrix3d(body.about_centre - rotor * about); };
  if (body.mass == 0) return most > 0 && left(most).cwiseAbs().maxCoeff() <= rounding * scale;
  double low = 0, high = std::max(0.0, most);
  for (int k = 0; k < 100; ++k) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    if (least_second_moment(left(a)) < least_second_moment(left(b)))
      low = a;
    else
      high = b;
  }
  return possible(left(0.5 * (low + high)), scale);
}

// The axes of rotary actuators in the axes of a body, at home.
std::vector<Vector3d> turned_about(const Machine& machine, int body) {
  std::vector<Vector3d> out;
  for (const Actuator& a : machine.topology().actuators) {
    const Joint& j = machine.topology().joints[static_cast<std::size_t>(a.joint)];
    if (a.sense() != Sense::rotary || (j.a != body && j.b != body)) continue;
    out.push_back(machine.rotation(machine.home_pose(), body).transpose() * machine.axis(machine.home_pose(), a.joint));
  }
  return out;
}

// "leg_cylinder" of the body "leg cylinder 3": what parameters of it begin with.
std::string stem_of(const std::string& body) {
  std::string out;
  for (const char c : body) out += c == ' ' ? '_' : c;
  while (!out.empty() && (out.back() == '_' || (out.back() >= '0' && out.back() <= '9'))) out.pop_back();
  return out;
}

// Masses or inertias that are named after the body, whichever `fault` is about: those that were changed; else others that were changed;
// else those that were not.
std::vector<std::string> parameters_of(const Machine& machine, const std::string& body, const InertiaFault& fault) {
  const std::string stem = stem_of(body);
  std::vector<std::string> ranked[3];
  for (std::size_t i = 0; i < machine.values().size(); ++i) {
    const ParameterInfo& p = machine.info().parameters[i];
    const bool mass = p.unit == "kg", inertia = p.unit == "kg*m^2", meant = mass == fault.of_mass;
    if ((!mass && !inertia) || stem.empty() || p.name.find(stem) == std::string::npos) continue;
    if (machine.values()[i] != p.defaults)
      ranked[meant ? 0 : 1].push_back(p.name);
    else if (meant)
      ranked[2].push_back(p.name);
  }
  const auto found = std::ranges::find_if(ranked, [](const auto& names) { return !names.empty(); });
  return found != std::end(ranked) ? *found : std::vector<std::string>{};
}

std::vector<std::string> changed_parameters(const Machine& machine) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < machine.values().size(); ++i)
    if (machine.values()[i] != machine.info().parameters[i].defaults) out.push_back(machine.info().parameters[i].name);
  return out;
}

}  // namespace

InertiaFault inertia_fault(const Inertia& inertia, std::span<const Vector3d> turned_about) {
  const Matrix3d& i = inertia.about_centre;
  if (!std::isfinite(inertia.mass)) return {"its mass is not a finite number", true};
  if (!inertia.centre.allFinite()) return {"its centre of mass is not finite", false};
  if (!i.allFinite()) return {"its inertia is not finite", false};
  if (inertia.mass < 0) return {fmt::format("its mass is {} kg", format_number(inertia.mass, 6)), true};
  const double scale = i.cwiseAbs().maxCoeff();
  if ((i - i.transpose()).cwiseAbs().maxCoeff() > rounding * scale)
    return {"its inertia is not symmetric: xy and yx, xz and zx, yz and zy must be equal", false};
  if (scale == 0 || (inertia.mass > 0 && possible(i, scale))) return {};
  for (const Vector3d& axis : turned_about)
    if (possible_with_rotor(inertia, axis, scale)) return {};

  const Vector3d moments = linear::symmetric_eigenvalues(i);
  const std::string told = fmt::format("the principal moments of its inertia are {}, {} and {} kg m^2", format_number(moments(0), 4),
                                       format_number(moments(1), 4), format_number(moments(2), 4));
  if (inertia.mass == 0) return {told + ", but its mass is 0; give it a mass, or no inertia", true};
  if (moments(0) < -rounding * scale)
    return {told +
                ", and none can be negative; is a product of inertia too large, a unit wrong, or are they about another point than the "
                "centre of mass?",
            false};
  return {told +
              ", and the largest cannot exceed the sum of the other two; is a unit wrong, or are transverse and axial inertia "
              "exchanged?",
          false};
}

void check_inertias(const Machine& machine, const pm_mechanism& table) {
  const Topology& t = machine.topology();
  for (std::size_t b = 1; b < t.bodies.size(); ++b) {
    const InertiaFault fault = inertia_fault(t.bodies[b].inertia, turned_about(machine, static_cast<int>(b)));
    if (fault.sentence.empty()) continue;
    const std::string& body = t.bodies[b].name;
    const std::vector<std::string> changed = changed_parameters(machine);
    if (changed.empty()) throw MechanismError(PM_FAILED, fmt::format("body {}: {}", body, fault.sentence));
    // What is wrong with the defaults already is the plugin's.
    try {
      const Machine as_it_comes(table, default_values(machine.info()));
    } catch (const MechanismError& e) {
      if (e.status != PM_BAD_ARGUMENT) throw;
    }
    std::vector<std::string> look = parameters_of(machine, body, fault);
    if (look.empty()) look = changed;
    throw MechanismError(PM_BAD_ARGUMENT, fmt::format("{} {} body {} what no body can have: {}", listed(look, "and"),
                                                      look.size() == 1 ? "gives" : "give", body, fault.sentence));
  }
}

}  // namespace pmreport::mechanics
