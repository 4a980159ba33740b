// The properties of one mechanism while they are looked at.
#pragma once

#include <core/mechanics/conformance/properties.hpp>

#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

namespace pmreport::mechanics {

// Next to a singular pose neither of two ways has an answer to compare.
inline constexpr double singular_condition = 1e6;  // of G

// "x = 0.1, alpha = -0.2": coordinates, as a diagnosis names a pose.
std::string pose_in_words(const Machine& machine, const Eigen::VectorXd& coordinates);

// All of them, in the order in which they are told. A member points into `all`, which does not grow.
struct PropertyList {
  PropertyList(const Machine& machine, double length, const PropertyOptions& options);
  PropertyList(const PropertyList&) = delete;
  PropertyList& operator=(const PropertyList&) = delete;

  std::vector<Property> all;
  Property *reach, *home, *units, *gap, *turn, *velocity, *acceleration, *drives, *mobility, *jacobian, *jacobian_rate, *regular, *wrenches,
      *limb_wrenches, *jumps, *rates, *accelerations, *matrices, *partials, *lanes, *extended, *recorded, *recorded_rates,
      *recorded_partials, *round_trip, *statics, *power, *mass, *energy, *virtual_work, *bodies, *stresses, *redundant, *limits;
};

// A deviation that was found. `where` gives the words of the place; it is asked of the worst alone.
template <class Where>
void note(Property& p, double deviation, Where&& where) {
  ++p.evaluations;
  if (deviation <= p.worst) return;
  p.worst = std::isfinite(deviation) ? deviation : std::numeric_limits<double>::infinity();
  if constexpr (std::is_invocable_v<Where>)
    p.where = where();
  else
    p.where = where;
}
// Where it fails, what to look at is added.
template <class Where, class Diagnosis>
void note(Property& p, double deviation, Where&& where, Diagnosis&& diagnosis) {
  const double before = p.worst;
  note(p, deviation, std::forward<Where>(where));
  if (p.worst != before && p.worst > p.tolerance) p.where += ": " + diagnosis();
}

}  // namespace pmreport::mechanics
