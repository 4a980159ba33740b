// Along the path q(s) = q0 + s (q1 - q0) a quantity x that is smooth changes over a short step h by h (x'(s) + x'(s + h)) / 2, but for
// terms of h^3. Where it does not, the step is halved again and again, on the side where more of the change is: a steep change dissolves, a
// jump stays.
#include <core/mechanics/conformance/jumps.hpp>

#include <core/mechanics/model/state.hpp>

#include <cmath>
#include <numbers>
#include <vector>

namespace pmreport::mechanics {

namespace {

using Eigen::VectorXd;

constexpr int steps = 16, halvings = 45;  // of a step, until rounding

class StraightWalk {
 public:
  StraightWalk(const Machine& machine, const VectorXd& from, const VectorXd& to)
      : machine_(machine), from_(from), way_(to - from), still_(VectorXd::Zero(from.size())) {}

  VectorXd at(double s) const { return from_ + s * way_; }
  // Actuators, then derived quantities, by s. Empty where the pose cannot be assembled.
  std::vector<Scalar> quantities(double s) {
    const VectorXd q = at(s);
    evaluate(machine_, q.data(), way_.data(), still_.data(), state_);
    if (state_.status != PM_OK) return {};
    std::vector<Scalar> out = state_.actuators;
    out.insert(out.end(), state_.derived.begin(), state_.derived.end());
    return out;
  }

 private:
  const Machine& machine_;
  VectorXd from_, way_, still_;
  State state_;
};

}  // namespace

std::optional<Jump> jump_between(const Machine& machine, const VectorXd& from, const VectorXd& to, double length) {
  const Topology& t = machine.topology();
  std::vector<Jump> kinds;
  for (const Actuator& a : t.actuators) kinds.push_back({a.name, a.unit, 0, {}});
  for (const Derived& d : t.derived) kinds.push_back({d.name, d.unit, 0, {}});

  StraightWalk walk(machine, from, to);
  std::vector<Scalar> before = walk.quantities(0);
  for (int k = 1; k <= steps && !before.empty(); ++k) {
    const double s0 = static_cast<double>(k - 1) / steps, s1 = static_cast<double>(k) / steps;
    std::vector<Scalar> after = walk.quantities(s1);
    if (after.empty()) break;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      const double least = kinds[i].unit == "rad" ? std::numbers::pi : length;
      if (kinds[i].unit != "rad" && kinds[i].unit != "m") continue;
      const double unexplained = after[i].value - before[i].value - 0.5 * (s1 - s0) * (before[i].rate + after[i].rate);
      if (!(std::abs(unexplained) > least)) continue;
      double low = s0, high = s1, at_low = before[i].value, at_high = after[i].value;
      for (int h = 0; h < halvings; ++h) {
        const double middle = 0.5 * (low + high);
        const std::vector<Scalar> there = walk.quantities(middle);
        if (there.empty()) break;
        if (std::abs(there[i].value - at_low) > std::abs(at_high - there[i].value))
          high = middle, at_high = there[i].value;
        else
          low = middle, at_low = there[i].value;
      }
      if (!(std::abs(at_high - at_low) > least)) continue;
      Jump jump = kinds[i];
      jump.by = at_high - at_low;
      jump.at = walk.at(high);
      return jump;
    }
    before = std::move(after);
  }
  return std::nullopt;
}

}  // namespace pmreport::mechanics
