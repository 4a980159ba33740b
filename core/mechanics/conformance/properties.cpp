#include <core/mechanics/conformance/properties.hpp>

#include <fmt/core.h>
#include <core/mechanics/conformance/diagnosis.hpp>
#include <core/mechanics/conformance/dynamics_properties.hpp>
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

// Rounding of one evaluation is some 1e-15; sums over bodies, divisions by limb lengths and poses near the edge of the box cost a few
// digits.
constexpr double rounding = 1e-10;

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
        random_(options.seed) {
    const auto add = [this](const char* claim, const char* how, double tolerance, const char* unit) -> Property& {
      properties_.push_back({claim, how, 0, tolerance, unit, ""});
      return properties_.back();
    };
    properties_.reserve(32);
    reach_ = &add("poses are in reach", "share of random poses in the box of the coordinates that cannot be assembled", 0.5, "");
    units_ = &add("axes and rotations are unit", "deviation of axes from unit length, of rotations from orthonormal", rounding, "");
    gap_ = &add("joints close", "joint centres carried from home by both bodies", rounding * length_, "m");
    turn_ = &add("joint axes agree", "joint axes carried from home by both bodies", rounding, "rad");
    velocity_ = &add("relative velocities are allowed", "twists by jets in the generic constraints", rounding, "");
    acceleration_ = &add("relative accelerations are allowed", "twist rates by jets in the differentiated constraints", rounding, "");
    drives_ = &add("actuators measure their joints", "actuator rates by jets against the relative motion at their joints", rounding, "");
    mobility_ = &add("mobility is as declared", "degrees of freedom and idle freedoms by rank of the generic model", 0, "");
    jacobian_ = &add("jacobian gives the actuator rates", "G times twist against jets", rounding, "");
    jacobian_rate_ = &add("jacobian gives the actuator accelerations", "G times twist rate plus G' times twist against jets", rounding, "");
    rates_ = &add("rates are exact", "jets against differences in extended precision", 1e-12, "");
    accelerations_ = &add("accelerations are exact", "jets against second differences in extended precision", 1e-10, "");
    matrices_ = &add("matrices of the source hold", "relations that the source states, with rates by jets", rounding, "");
    partials_ = &add("partials are exact", "partials times coordinate rates against jets", rounding, "");
    lanes_ = &add("lanes equal doubles", "poses many at once against one at a time, all scalar types", 1e-11, "");
    extended_ = &add("extended precision agrees", "extended against double precision", 1e-12, "");
    round_trip_ = &add("forward inverts inverse displacement",
                       "coordinates recovered from actuator values, guess a hundredth of the size away", 1e-8, "");
    statics_ = &add("closed-form statics equal the generic model's", "actuator forces by G and by the system over all bodies", 1e-8, "");
    power_ = &add("virtual power balances", "actuator forces times rates plus load times twist", 1e-8, "");
    inertias_ = &add("masses and inertias are not negative", "masses, and principal inertias about the centres of mass", rounding, "");
    mass_ = &add("mass matrix is positive definite", "asymmetry; 1 where a motion has no kinetic energy, or a negative one", rounding, "");
    energy_ =
        &add("energy balances", "change of kinetic and potential energy by differences against the power of actuators and load", 1e-8, "");
    virtual_work_ = &add("virtual work equals Newton and Euler", "actuator forces by partials and by the free bodies", 1e-8, "");
    bodies_ = &add("every body is in balance", "unbalanced force or moment of the free bodies", 1e-8, "");
    stresses_ = &add("self-stresses balance", "unbalanced force or moment of the bodies under each self-stress alone", 1e-8, "");
    redundant_ = &add("self-stresses are as many as redundant constraints",
                      "null space of the reactions against the rank of the constraints", 0, "");
    limits_ = &add("limits are finite", "strokes, joint limits and their motions that are not finite", 0, "");
  }

  std::vector<Property> run(int poses) {
    const int dof = machine_.dof();
    still(machine_.home());
    limits();
    int lost = 0;
    for (int k = 0; k <= poses; ++k) {
      VectorXd q = k == 0 ? machine_.home() : random_pose();
      label_ = k == 0 ? "home" : describe(q);
      const VectorXd rate = scaled(1.0), acceleration = scaled(3.0);
      evaluate(machine_, q.data(), rate.data(), acceleration.data(), state_);
      if (state_.status == PM_UNREACHABLE) {
        ++lost;
        continue;
      }
      if (state_.status != PM_OK) {
        note(*units_, std::numeric_limits<double>::quiet_NaN(), state_.why);
        continue;
      }
      pose();
      if (k % 50 == 0) still(q);
      batch_.insert(batch_.end(), q.data(), q.data() + dof);
    }
    note(*reach_, poses > 0 ? static_cast<double>(lost) / poses : 0, fmt::format("{} of {} poses out of reach", lost, poses));
    lanes();
    return properties_;
  }

 private:
  void note(Property& p, double deviation, const std::string& where) {
    if (!(deviation <= p.worst)) {
      p.worst = std::isfinite(deviation) ? deviation : std::numeric_limits<double>::infinity();
      p.where = where;
    }
  }
  // Where it fails, what to look at is added.
  template <class Diagnosis>
  void note(Property& p, double deviation, const std::string& where, Diagnosis&& diagnosis) {
    if (deviation <= p.worst) return;
    note(p, deviation, where);
    if (!p.passed()) p.where += ": " + diagnosis();
  }
  std::string at(const std::string& what) const { return what.empty() ? label_ : what + " at " + label_; }
  std::string describe(const VectorXd& q) const {
    std::string s;
    for (int i = 0; i < q.size(); ++i)
      s += fmt::format("{}{} = {:.4g}", i > 0 ? ", " : "", machine_.topology().coordinates[static_cast<std::size_t>(i)].name, q(i));
    return s;
  }
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
  std::string joint_name(int joint) const { return joint < 0 ? "" : in_words(machine_, joint); }

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
      note(*units_, off, at(""), [&] { return about_body(machine_, state_, static_cast<int>(i)); });
    }
    for (std::size_t i = 0; i < t.joints.size(); ++i)
      for (int k = 0; k < axes_of(t.joints[i].kind); ++k)
        note(*units_, std::abs(state_.joints[i].axis[k].norm() - 1.0), at(""),
             [&] { return about_axis(machine_, state_, static_cast<int>(i), k); });

    const ClosureError e = closure_.error(state_.bodies);
    note(*gap_, e.gap, at(joint_name(e.gap_joint)), [&] { return about_gap(machine_, state_, e.gap_joint, e.gap); });
    note(*turn_, e.misalignment, at(joint_name(e.misalignment_joint)),
         [&] { return about_misalignment(machine_, e.misalignment_joint, e.misalignment); });

    const GenericModel model = generic_model(machine_, state_);
    const VectorXd v = stacked_twists(state_), a = stacked_twist_rates(state_);
    const double v_scale = std::max(v.lpNorm<Eigen::Infinity>(), 1e-6), a_scale = std::max(a.lpNorm<Eigen::Infinity>(), v_scale * v_scale);
    const VectorXd wrong_v = model.constraints * v, wrong_a = model.constraints * a + model.bias;
    for (int r = 0; r < wrong_v.size(); ++r) {
      const int joint = model.joint_of_row[static_cast<std::size_t>(r)];
      const double v_share = std::abs(wrong_v(r)) / v_scale, a_share = std::abs(wrong_a(r)) / a_scale;
      if (!(v_share <= velocity_->worst))
        note(*velocity_, v_share, at(joint_name(joint)), [&] { return about_forbidden_motion(machine_, joint, v_share); });
      if (!(a_share <= acceleration_->worst))
        note(*acceleration_, a_share, at(joint_name(joint)), [&] { return about_forbidden_motion(machine_, joint, a_share); });
    }
    const VectorXd driven = model.actuation * v;
    for (int i = 0; i < driven.size(); ++i)
      note(*drives_, std::abs(driven(i) - state_.actuators[static_cast<std::size_t>(i)].rate) / v_scale, at(""),
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
    note(*jacobian_, off_v.lpNorm<Eigen::Infinity>() / v_scale, at(""), [&] { return worst_row(off_v); });
    note(*jacobian_rate_, off_a.lpNorm<Eigen::Infinity>() / a_scale, at(""), [&] { return worst_row(off_a); });

    const Deviation d = jets_against_differences(machine_, state_);
    if (d.reachable) {
      note(*rates_, d.rate, at(""));
      note(*accelerations_, d.acceleration, at(""));
    }
    const SourceDeviation source = source_deviation(machine_, state_);
    if (source.value > 0)
      note(*matrices_, source.value,
           at(source.matrix < 0 ? "the plugin gives none" : "matrix " + t.matrices[static_cast<std::size_t>(source.matrix)].name));
    partials();
    if (c.condition < 1e6) {  // next to a singular pose neither has an answer to compare
      round_trip(c.condition);
      statics(model, c, platform.twist());
      if (regular_poses_++ % 10 == 0) dynamics(c.condition);
    }
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
    note(*partials_, scale > 0 ? worst / scale : worst, at(""));
  }

  // Beside a singular surface another solution lies as near as the pose itself: the basin of the pose is as wide as its distance from the
  // surface, of which the condition number is the reciprocal, in sizes of the mechanism.
  void round_trip(double condition) {
    VectorXd q(machine_.dof()), l(machine_.dof());
    for (int i = 0; i < machine_.dof(); ++i) {
      q(i) = state_.coordinates[static_cast<std::size_t>(i)].value;
      l(i) = state_.actuators[static_cast<std::size_t>(i)].value;
    }
    const VectorXd guess = q + std::min(0.01, 1 / condition) * scaled(1.0);
    if (machine_.pose({guess.data(), static_cast<std::size_t>(guess.size())}).status == PM_UNREACHABLE) return;
    const ForwardSolution s = forward_.solve(l, guess);
    double worst = 0;
    for (int i = 0; i < q.size(); ++i)
      worst = std::max(worst, std::abs(s.coordinates(i) - q(i)) /
                                  size_of(machine_.topology().coordinates[static_cast<std::size_t>(i)].sense(), length_));
    note(*round_trip_, s.outcome == Outcome::good ? worst : std::numeric_limits<double>::infinity(), at(s.why));
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
      note(*statics_, worst / scale, at(""));
    }
    double power = load.dot(twist), size = load.cwiseProduct(twist).lpNorm<Eigen::Infinity>();
    for (int i = 0; i < machine_.dof(); ++i) {
      const double p = forces(i) * state_.actuators[static_cast<std::size_t>(i)].rate;
      power += p;
      size = std::max(size, std::abs(p));
    }
    if (size > 0) note(*power_, std::abs(power) / size, at(""));
  }

  void dynamics(double condition) {
    Loading loading;
    for (int i = 0; i < 6; ++i) loading.platform(i) = std::uniform_real_distribution(-100.0, 100.0)(random_) * (i < 3 ? 1.0 : length_);
    for (double& g : loading.gravity) g = std::uniform_real_distribution(-10.0, 10.0)(random_);
    const Tangent t = tangent(machine_, state_);
    const ForceShares forces = virtual_work(machine_, state_, t, loading);
    note(*mass_, mass_matrix_deviation(machine_, state_, t, length_), at(""),
         [] { return std::string("look at masses and inertias: is a body forgotten that only one coordinate moves?"); });
    note(*energy_, energy_deviation(machine_, state_, forces, loading, condition, length_), at(""));
    if (regular_poses_ % 100 != 1) return;  // what follows takes as long as all else at fifty poses
    const FreeBodyDeviation d = free_body_deviation(machine_, state_, frames_, forces, loading, length_);
    note(*virtual_work_, d.forces, at(""));
    note(*bodies_, d.balance, at(""));
    note(*stresses_, d.stress, at(""));
    const int redundant = mobility(machine_, state_).redundant;
    note(*redundant_, std::abs(d.stresses - redundant), at(""),
         [&] { return fmt::format("{} self-stresses, {} redundant constraints", d.stresses, redundant); });
  }

  void still(const VectorXd& q) {  // rank needs a pose, no motion
    const VectorXd zero = VectorXd::Zero(machine_.dof());
    State s;
    evaluate(machine_, q.data(), zero.data(), zero.data(), s);
    if (s.status != PM_OK) return;
    const Mobility m = mobility(machine_, s);
    note(*mobility_, std::abs(m.freedoms - machine_.dof()) + std::abs(m.idle - machine_.topology().idle), describe(q),
         [&] { return about_mobility(machine_, s, m); });
  }

  void limits() {
    const Topology& t = machine_.topology();
    const InertiaDeviation inertia = inertia_deviation(t);
    note(*inertias_, inertia.value, inertia.body < 0 ? "" : "body " + t.bodies[static_cast<std::size_t>(inertia.body)].name);
    const std::vector<BodyState> home = bodies_at_rest(machine_, machine_.home_pose());
    for (std::size_t i = 0; i < t.joints.size(); ++i)
      for (const double x : closure_.motion(home, static_cast<int>(i)))
        if (!std::isfinite(x)) note(*limits_, 1, "motion of joint " + t.joints[i].name);
    for (const Actuator& a : t.actuators)
      if (!std::isfinite(a.stroke.min + a.stroke.max)) note(*limits_, 1, "stroke of " + a.name);
    for (const Joint& j : t.joints)
      for (const Range& r : j.limits)
        if (!std::isfinite(r.min + r.max)) note(*limits_, 1, "limit of joint " + j.name);
  }

  // All poses met so far at once, in every order of scalars, against one at a time; a count that no lane width divides included.
  void lanes() {
    const std::size_t dof = static_cast<std::size_t>(machine_.dof()), n = machine_.layout().size();
    for (const std::size_t count : {std::size_t{2}, std::size_t{7}, std::size_t{16}, std::size_t{61}}) {
      if (count * dof > batch_.size()) break;
      for (const pm_order order : {PM_VALUE, PM_JET, PM_PARTIALS, PM_EXTENDED}) {
        const std::size_t c = machine_.components(order), in = order == PM_PARTIALS ? 1 : c;
        std::vector<double> one_q(dof * in), many_q(dof * in * count), one(n * c), many(n * c * count), one_g(36 * c),
            many_g(36 * c * count);
        for (std::size_t k = 0; k < count; ++k)
          for (std::size_t i = 0; i < dof; ++i)
            for (std::size_t e = 0; e < in; ++e)
              many_q[(i * in + e) * count + k] = batch_[k * dof + i] * (e == 0                 ? 1.0
                                                                        : order == PM_EXTENDED ? 1e-18
                                                                                               : 0.5 * static_cast<double>(e));
        machine_.place(order, count, many_q.data(), many.data());
        machine_.jacobian(order, count, many.data(), many_g.data());
        for (std::size_t k = 0; k < count; ++k) {
          for (std::size_t s = 0; s < dof * in; ++s) one_q[s] = many_q[s * count + k];
          machine_.place(order, 1, one_q.data(), one.data());
          machine_.jacobian(order, 1, one.data(), one_g.data());
          compare(one, many, count, k);
          compare(one_g, many_g, count, k);
          if (order == PM_EXTENDED) extended(one_q, one);
        }
      }
    }
  }
  void compare(const std::vector<double>& one, const std::vector<double>& many, std::size_t count, std::size_t k) {
    double scale = 1;
    for (const double x : one) scale = std::max(scale, std::abs(x));
    for (std::size_t s = 0; s < one.size(); ++s)
      note(*lanes_, std::abs(one[s] - many[s * count + k]) / scale, fmt::format("{} poses at once, number {}", count, s));
  }
  void extended(const std::vector<double>& q2, const std::vector<double>& high_low) {
    std::vector<double> q(q2.size() / 2), x(high_low.size() / 2);
    for (std::size_t i = 0; i < q.size(); ++i) q[i] = q2[2 * i];
    machine_.place(PM_VALUE, 1, q.data(), x.data());
    for (std::size_t s = 0; s < x.size(); ++s)
      note(*extended_, std::abs(x[s] - high_low[2 * s]) / std::max(1.0, std::abs(x[s])), fmt::format("number {}", s));
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
  std::vector<Property> properties_;
  Property *reach_, *units_, *gap_, *turn_, *velocity_, *acceleration_, *drives_, *mobility_, *jacobian_, *jacobian_rate_, *rates_,
      *accelerations_, *matrices_, *partials_, *lanes_, *extended_, *round_trip_, *statics_, *power_, *inertias_, *mass_, *energy_,
      *virtual_work_, *bodies_, *stresses_, *redundant_, *limits_;
};

}  // namespace

std::vector<Property> check_properties(const Machine& machine, const PropertyOptions& options) {
  return Suite(machine, options).run(options.poses);
}

}  // namespace pmreport::mechanics
