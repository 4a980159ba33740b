#include <core/mechanics/conformance/properties.hpp>

#include <fmt/core.h>
#include <core/mechanics/conformance/diagnosis.hpp>
#include <core/mechanics/conformance/dynamics_properties.hpp>
#include <core/mechanics/conformance/jumps.hpp>
#include <core/mechanics/conformance/property_list.hpp>
#include <core/mechanics/conformance/recorded_properties.hpp>
#include <core/mechanics/conformance/rest_properties.hpp>
#include <core/mechanics/conformance/scalar_properties.hpp>
#include <core/mechanics/conformance/wrench_properties.hpp>
#include <core/mechanics/displacement/displacement.hpp>
#include <core/mechanics/mobility/mobility_count.hpp>
#include <core/mechanics/model/closed_form.hpp>
#include <core/mechanics/model/closure.hpp>
#include <core/mechanics/model/differences.hpp>
#include <core/mechanics/model/effort.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/statics/statics.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace pmreport::mechanics {

namespace {

using Eigen::VectorXd;

// The larger of two deviations, where a NaN is the largest of all.
double larger_or_nan(double worst, double x) { return x <= worst || std::isnan(worst) ? worst : x; }

class Suite {
 public:
  Suite(const Machine& machine, const PropertyOptions& options)
      : machine_(machine),
        closure_(machine),
        forward_(machine),
        frames_(machine),
        length_(characteristic_length(machine)),
        random_(options.seed),
        p_(machine, length_, options) {}

  std::vector<Property> run(const PropertyOptions& options) {
    const VectorXd home = machine_.home();
    std::vector<VectorXd> beside;
    for (int k = 0; k < 5; ++k) beside.push_back(home + 0.03 * scaled(1.0));
    look_at_home(machine_, beside, length_, p_);
    limits();
    look_at(home, "home");
    VectorXd last = home;
    for (const VectorXd& q : options.at_first) {
      if (look_at(q, describe(q))) path(last, q);
      last = q;
    }
    int lost = 0;
    for (int k = 1; k <= options.poses; ++k) {
      const VectorXd q = random_pose();
      if (!look_at(q, describe(q)))
        ++lost;
      else if (k % 10 == 1)
        path(home, q);
      if (k % 50 == 0) look_at_rest(machine_, q, length_, p_);
    }
    if (options.poses > 0)
      note(*p_.reach, static_cast<double>(lost) / options.poses, fmt::format("{} of {} poses out of reach", lost, options.poses));
    const ScalarDeviation d = scalar_deviation(machine_, batch_);
    take(*p_.lanes, d.lanes);
    take(*p_.extended, d.extended);
    p_.extended->unexamined = d.no_extended;
    look_at_recording(machine_, batch_, p_);
    p_.stresses->applies = p_.redundant->evaluations == 0 || p_.stresses->evaluations > 0;
    for (Property& p : p_.all)
      if (p.verdict() == Verdict::not_examined && p.unexamined.empty()) p.unexamined = why_unexamined(options);
    return p_.all;
  }

 private:
  // Looks at a pose with random rates. False where it is out of reach.
  bool look_at(const VectorXd& q, const std::string& label) {
    label_ = label;
    const VectorXd rate = scaled(1.0), acceleration = scaled(3.0);
    evaluate(machine_, q.data(), rate.data(), acceleration.data(), state_);
    if (state_.status == PM_UNREACHABLE) return false;
    if (state_.status == PM_OK) {
      pose();
      batch_.insert(batch_.end(), q.data(), q.data() + q.size());
    } else {
      note(*p_.units, std::numeric_limits<double>::quiet_NaN(), state_.why);
    }
    return true;
  }
  std::string why_unexamined(const PropertyOptions& options) const {
    if (options.poses == 0 && regular_poses_ > 0) return "no pose but home was asked for";
    if (regular_poses_ == 0)
      return fmt::format("the overall Jacobian is singular, or nearly (condition above {:.0e}), at every pose", singular_condition);
    return "there was no pose at which it can be looked at";
  }

  static void take(Property& p, const ScalarDeviation::Largest& largest) {
    p.worst = largest.value, p.where = largest.where, p.evaluations = largest.evaluations;
  }
  auto here() const {
    return [this] { return label_; };
  }
  auto at_joint(int joint) const {
    return [this, joint] { return joint < 0 ? label_ : in_words(machine_, joint) + " at " + label_; };
  }
  std::string describe(const VectorXd& q) const { return pose_in_words(machine_, q); }
  VectorXd random_pose() {
    VectorXd q(machine_.dof());
    for (int i = 0; i < q.size(); ++i) {
      const Range& box = machine_.topology().coordinates[static_cast<std::size_t>(i)].box;
      q(i) = std::uniform_real_distribution(box.min, box.max)(random_);
    }
    return q;
  }
  VectorXd scaled(double s) {  // random rates: about a size, or a radian, a second
    VectorXd v(machine_.dof());
    for (int i = 0; i < v.size(); ++i)
      v(i) = s * std::uniform_real_distribution(-1.0, 1.0)(random_) *
             size_of(machine_.topology().coordinates[static_cast<std::size_t>(i)].sense(), length_);
    return v;
  }
  void pose() {
    const Topology& t = machine_.topology();
    double off = 0;
    for (std::size_t i = 1; i < state_.bodies.size(); ++i) {
      const auto& r = state_.bodies[i].rotation;
      const double z = std::abs(Eigen::Vector3d(state_.placement_jets[3 * machine_.layout().body(static_cast<int>(i)) + 9],
                                                state_.placement_jets[3 * machine_.layout().body(static_cast<int>(i)) + 12],
                                                state_.placement_jets[3 * machine_.layout().body(static_cast<int>(i)) + 15])
                                    .norm() -
                                1.0);
      off = t.bodies[i].slender ? z
                                : (r.transpose() * r - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() + std::abs(r.determinant() - 1.0);
      note(*p_.units, off, here(), [&] { return about_body(machine_, state_, static_cast<int>(i)); });
    }
    for (std::size_t i = 0; i < t.joints.size(); ++i)
      for (int k = 0; k < axes_of(t.joints[i].kind); ++k)
        note(*p_.units, std::abs(state_.joints[i].axis[k].norm() - 1.0), here(),
             [&] { return about_axis(machine_, state_, static_cast<int>(i), k); });

    const ClosureError e = closure_.error(state_.bodies);
    note(*p_.gap, e.gap, at_joint(e.gap_joint), [&] { return about_gap(machine_, state_, e.gap_joint, e.gap); });
    note(*p_.turn, e.misalignment, at_joint(e.misalignment_joint),
         [&] { return about_misalignment(machine_, e.misalignment_joint, e.misalignment); });

    const GenericModel model = generic_model(machine_, state_);
    const VectorXd v = stacked_twists(state_), a = stacked_twist_rates(state_);
    const double v_scale = std::max(v.lpNorm<Eigen::Infinity>(), 1e-6), a_scale = std::max(a.lpNorm<Eigen::Infinity>(), v_scale * v_scale);
    const VectorXd wrong_v = model.constraints * v, wrong_a = model.constraints * a + model.bias;
    for (int r = 0; r < wrong_v.size(); ++r) {
      const int joint = model.joint_of_row[static_cast<std::size_t>(r)];
      const double v_share = std::abs(wrong_v(r)) / v_scale, a_share = std::abs(wrong_a(r)) / a_scale;
      note(*p_.velocity, v_share, at_joint(joint), [&] { return about_forbidden_motion(machine_, joint, v_share); });
      note(*p_.acceleration, a_share, at_joint(joint), [&] { return about_forbidden_motion(machine_, joint, a_share); });
    }
    const VectorXd driven = model.actuation * v;
    for (int i = 0; i < driven.size(); ++i)
      note(*p_.drives, std::abs(driven(i) - state_.actuators[static_cast<std::size_t>(i)].rate) / v_scale, here(),
           [&] { return about_drive(machine_, state_, i, driven(i)); });

    const ClosedForm c = closed_form(machine_, state_, length_);
    const BodyState& platform = state_.bodies[static_cast<std::size_t>(t.platform)];
    const auto worst_row = [this](const Vector6d& off) {
      Eigen::Index row = 0;
      off.cwiseAbs().maxCoeff(&row);
      return about_row(machine_, static_cast<int>(row));
    };
    const Vector6d off_v = c.jacobian * platform.twist() - actuator_rates(state_);
    const Vector6d off_a = c.jacobian * platform.twist_rate() + c.jacobian_rate * platform.twist() - actuator_accelerations(state_);
    note(*p_.jacobian, off_v.lpNorm<Eigen::Infinity>() / v_scale, here(), [&] { return worst_row(off_v); });
    note(*p_.jacobian_rate, off_a.lpNorm<Eigen::Infinity>() / a_scale, here(), [&] { return worst_row(off_a); });

    if (p_.wrenches->applies) {
      const WrenchDeviation unit = unit_deviation(machine_, c.jacobian);
      note(*p_.wrenches, unit.value, here(), [&] { return about_wrench(machine_, c.jacobian, unit.row); });
    }
    if (away_from_the_edge()) {
      const Deviation d = jets_against_differences(machine_, state_);
      if (d.reachable) {
        note(*p_.rates, d.rate, here());
        note(*p_.accelerations, d.acceleration, here());
      }
    }
    if (p_.matrices->applies) {
      const SourceDeviation source = source_deviation(machine_, state_);
      note(*p_.matrices, source.value, [&] {
        return (source.matrix < 0 ? "the plugin gives none" : "matrix " + t.matrices[static_cast<std::size_t>(source.matrix)].name) +
               " at " + label_;
      });
    }
    partials();
    if (c.condition < singular_condition) {
      round_trip(c.condition);
      statics(model, c, platform.twist());
      if (regular_poses_++ % 10 == 0) dynamics(c.condition);
    }
  }

  // At the edge of reach square roots end, sqrt(d) with d the way to go. The differences take steps h of a thousandth of a size, whose
  // truncation there is some 10 (h / d)^8: at a tenth of a size it is rounding.
  bool away_from_the_edge() const {
    double speed = 0;  // sizes a second
    for (std::size_t i = 0; i < state_.coordinates.size(); ++i) {
      const Scalar& c = state_.coordinates[i];
      const double size = size_of(machine_.topology().coordinates[i].sense(), length_);
      speed = std::max({speed, std::abs(c.rate) / size, std::sqrt(std::abs(c.acceleration) / size)});
    }
    for (const double t : {-0.1 / speed, 0.1 / speed}) {
      VectorXd q(machine_.dof());
      for (int i = 0; i < q.size(); ++i) {
        const Scalar& c = state_.coordinates[static_cast<std::size_t>(i)];
        q(i) = c.value + t * (c.rate + 0.5 * t * c.acceleration);
      }
      if (machine_.pose({q.data(), static_cast<std::size_t>(q.size())}).status == PM_UNREACHABLE) return false;
    }
    return true;
  }

  void partials() {
    const std::size_t dof = state_.coordinates.size(), n = machine_.layout().size();
    std::vector<double> q(dof), x(n * (1 + dof));
    for (std::size_t i = 0; i < dof; ++i) q[i] = state_.coordinates[i].value;
    machine_.place(PM_PARTIALS, 1, q.data(), x.data());
    double scale = 0, worst = 0;
    for (std::size_t s = 1; s < n; ++s) {
      double rate = 0;
      for (std::size_t i = 0; i < dof; ++i) rate += x[s * (1 + dof) + 1 + i] * state_.coordinates[i].rate;
      scale = std::max(scale, std::abs(state_.placement_jets[3 * s + 1]));
      worst = larger_or_nan(worst, std::abs(rate - state_.placement_jets[3 * s + 1]));
    }
    note(*p_.partials, scale > 0 ? worst / scale : worst, here());
  }

  // Beside a singular surface another solution lies as near as the pose itself: the basin of the pose is as wide as its distance from the
  // surface, of which the condition number is the reciprocal, in sizes of the mechanism. There, what actuator values are rounded by moves
  // the pose by as many times that: it cannot be recovered nearer, and that much is not held against it.
  void round_trip(double condition) {
    VectorXd q(machine_.dof()), l(machine_.dof());
    for (int i = 0; i < machine_.dof(); ++i) {
      q(i) = state_.coordinates[static_cast<std::size_t>(i)].value;
      l(i) = state_.actuators[static_cast<std::size_t>(i)].value;
    }
    const VectorXd guess = q + std::min(0.01, 1 / condition) * scaled(1.0);
    if (machine_.pose({guess.data(), static_cast<std::size_t>(guess.size())}).status != PM_OK) return;
    const ForwardSolution s = forward_.solve(l, guess);
    double worst = 0;
    for (int i = 0; i < q.size(); ++i)
      worst = larger_or_nan(worst, std::abs(s.coordinates(i) - q(i)) /
                                       size_of(machine_.topology().coordinates[static_cast<std::size_t>(i)].sense(), length_));
    double longest = 1;
    for (int i = 0; i < l.size(); ++i)
      longest = std::max(longest, std::abs(l(i)) / size_of(machine_.topology().actuators[static_cast<std::size_t>(i)].sense(), length_));
    constexpr double roundings = 16;  // of an actuator value, by a dozen operations before its root
    const double rounding = roundings * std::numeric_limits<double>::epsilon() * longest * condition;
    worst = worst <= rounding ? 0 : worst - rounding;
    note(*p_.round_trip, s.outcome == Outcome::good ? worst : std::numeric_limits<double>::infinity(),
         [&] { return s.why.empty() ? label_ : s.why + " at " + label_; });
  }

  void statics(const GenericModel& model, const ClosedForm& c, const Vector6d& twist) {
    Vector6d load;
    for (int i = 0; i < 6; ++i) load(i) = std::uniform_real_distribution(-1.0, 1.0)(random_) * (i < 3 ? 1.0 : length_);
    const Vector6d forces = closed_statics(c, load);
    // The generic system costs a thousand times the closed form: every tenth pose.
    if (regular_poses_ % 10 == 0) {
      const GenericStatics g = generic_statics(machine_, model, load);
      const double scale = std::max(1.0, forces.lpNorm<Eigen::Infinity>());
      double worst = 0;
      for (int i = 0; i < machine_.dof(); ++i) worst = larger_or_nan(worst, std::abs(g.actuator_forces(i) - forces(i)));
      note(*p_.statics, worst / scale, here());
    }
    double power = load.dot(twist), size = load.cwiseProduct(twist).lpNorm<Eigen::Infinity>();
    for (int i = 0; i < machine_.dof(); ++i) {
      const double p = forces(i) * state_.actuators[static_cast<std::size_t>(i)].rate;
      power += p;
      size = std::max(size, std::abs(p));
    }
    if (size > 0) note(*p_.power, std::abs(power) / size, here());
  }

  void dynamics(double condition) {
    Loading loading;
    for (int i = 0; i < 6; ++i) loading.platform(i) = std::uniform_real_distribution(-100.0, 100.0)(random_) * (i < 3 ? 1.0 : length_);
    for (double& g : loading.gravity) g = std::uniform_real_distribution(-10.0, 10.0)(random_);
    const Tangent t = tangent(machine_, state_);
    const ForceShares forces = virtual_work(machine_, state_, t, loading);
    if (p_.mass->applies)
      note(*p_.mass, mass_matrix_deviation(machine_, state_, t, length_), here(),
           [] { return std::string("look at masses and inertias: is a body forgotten that only one coordinate moves?"); });
    if (const auto energy = energy_deviation(machine_, state_, forces, loading, condition, length_)) note(*p_.energy, *energy, here());
    if (regular_poses_ % 100 != 1) return;  // what follows takes as long as all else at fifty poses
    const FreeBodyDeviation d = free_body_deviation(machine_, state_, frames_, forces, loading, length_);
    note(*p_.virtual_work, d.forces, here());
    note(*p_.bodies, d.balance, here());
    if (d.stresses > 0) note(*p_.stresses, d.stress, here());
    const int redundant = mobility(machine_, state_).redundant;
    note(*p_.redundant, std::abs(d.stresses - redundant), here(),
         [&] { return fmt::format("{} self-stresses, {} redundant constraints", d.stresses, redundant); });
  }

  void path(const VectorXd& from, const VectorXd& to) {
    const std::optional<Jump> jump = jump_between(machine_, from, to, length_);
    note(*p_.jumps, jump ? 1 : 0, [&] {
      return fmt::format("{} jumps by {:.4g} {} at {}{}", jump->quantity, jump->by, jump->unit, describe(jump->at),
                         jump->unit == "rad" ? ": a turn; look at the cut of the arc tangent that place takes" : "");
    });
  }

  void limits() {
    const Topology& t = machine_.topology();
    const std::vector<BodyState> home = bodies_at_rest(machine_, machine_.home_pose());
    const auto finite = [&](double x, const char* what, const std::string& name) {
      note(*p_.limits, std::isfinite(x) ? 0 : 1, [&] { return what + name; });
    };
    for (std::size_t i = 0; i < t.joints.size(); ++i)
      for (const double x : closure_.motion(home, static_cast<int>(i))) finite(x, "motion of joint ", t.joints[i].name);
    for (const Actuator& a : t.actuators) finite(a.stroke.min + a.stroke.max, "stroke of ", a.name);
    for (const Joint& j : t.joints)
      for (const Range& r : j.limits) finite(r.min + r.max, "limit of joint ", j.name);
  }

  const Machine& machine_;
  Closure closure_;
  ForwardSolver forward_;
  JointFrames frames_;
  double length_;
  std::mt19937_64 random_;
  State state_;
  std::string label_;
  std::vector<double> batch_;
  int regular_poses_ = 0;
  PropertyList p_;
};

}  // namespace

std::vector<Property> check_properties(const Machine& machine, const PropertyOptions& options) {
  return Suite(machine, options).run(options);
}

}  // namespace pmreport::mechanics
