#include <core/mechanics/closed_form.hpp>
#include <core/mechanics/closure.hpp>
#include <core/mechanics/differences.hpp>
#include <core/mechanics/displacement.hpp>
#include <reports/section/analysis.hpp>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

namespace pmreport::section {

using mechanics::State;
using mechanics::Vector6d;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t index_of(Measure m) { return static_cast<std::size_t>(m); }

// Deviation over scale; nothing over nothing agrees.
double relative(double deviation, double scale) { return scale > 0 ? deviation / scale : deviation; }
double largest_of(const Eigen::VectorXd& v) { return v.size() > 0 ? v.cwiseAbs().maxCoeff() : 0; }

using Row = std::array<double, static_cast<std::size_t>(Measure::count)>;

// The work on one sample. Each thread has its own, with the buffers it reuses.
class Worker {
 public:
  Worker(const scenario::Scenario& s, const mechanics::Machine& m, const mechanics::Closure& closure, double length, bool statics)
      : scenario_(s), machine_(m), closure_(closure), forward_(m), length_(length), statics_(statics) {}

  const State& state() const { return state_; }

  // Fills `row` and hands every output number to `put(column, value)`. `previous`: a neighbour of the sample, where forward displacement
  // starts.
  template <class Put>
  Condition sample(int k, int previous, Row& row, Put&& put) {
    const scenario::Motion& motion = scenario_.motion;
    const Eigen::VectorXd q = motion.value.row(k), rate = motion.rate.row(k), acceleration = motion.acceleration.row(k);
    evaluate(machine_, q.data(), rate.data(), acceleration.data(), state_);
    if (state_.status == PM_UNREACHABLE) return Condition::unreachable;
    if (state_.status != PM_OK) return Condition::failed;

    const Topology& t = machine_.topology();
    const mechanics::ClosedForm c = closed_form(machine_, state_, length_);
    const bool regular = c.condition < Analysis::singular, comparable = c.condition < Analysis::comparable;
    const mechanics::BodyState& platform = state_.bodies[static_cast<std::size_t>(t.platform)];
    const Vector6d twist = platform.twist(), twist_rate = platform.twist_rate();
    kinematics(put, platform, c);

    const mechanics::ClosureError e = closure_.error(state_.bodies);
    set(row, Measure::gap, e.gap);
    set(row, Measure::misalignment, e.misalignment);

    const mechanics::GenericModel model = generic_model(machine_, state_);
    const Eigen::VectorXd v = stacked_twists(state_), a = stacked_twist_rates(state_);
    const double v_scale = largest_of(v), a_scale = std::max(largest_of(a), v_scale * v_scale);
    set(row, Measure::velocity, relative(largest_of(model.constraints * v), v_scale));
    set(row, Measure::acceleration, relative(largest_of(model.constraints * a + model.bias), a_scale));
    const Vector6d rates = actuator_rates(state_), accelerations = actuator_accelerations(state_);
    set(row, Measure::jacobian, relative(largest_of(c.jacobian * twist - rates), v_scale));
    set(row, Measure::jacobian_rate, relative(largest_of(c.jacobian * twist_rate + c.jacobian_rate * twist - accelerations), a_scale));

    const mechanics::Deviation d = jets_against_differences(machine_, state_);
    if (d.reachable) {
      set(row, Measure::difference_rate, d.rate);
      set(row, Measure::difference_acceleration, d.acceleration);
    }
    if (comparable) {
      set(row, Measure::forward_velocity, relative(largest_of(forward_velocity(c, rates) - twist), v_scale));
      set(row, Measure::forward_acceleration, relative(largest_of(forward_acceleration(c, accelerations, twist) - twist_rate), a_scale));
      set(row, Measure::round_trip, round_trip(q, motion.value.row(previous)));
    }
    if (!regular) return Condition::singular;
    if (statics_) statics(k, row, put, model, c, twist, comparable);
    return Condition::good;
  }

 private:
  static void set(Row& row, Measure m, double value) {
    row[index_of(m)] = std::isfinite(value) ? value : std::numeric_limits<double>::infinity();
  }

  template <class Put>
  void kinematics(Put&& put, const mechanics::BodyState& platform, const mechanics::ClosedForm& c) {
    const Topology& t = machine_.topology();
    const auto all = [&](const auto& declared, const std::vector<mechanics::Scalar>& values) {
      for (std::size_t i = 0; i < declared.size(); ++i) {
        put(declared[i].name, values[i].value);
        put(declared[i].name + "_rate", values[i].rate);
        put(declared[i].name + "_acceleration", values[i].acceleration);
      }
    };
    all(t.coordinates, state_.coordinates);
    all(t.derived, state_.derived);
    all(t.actuators, state_.actuators);
    for (int i = 0; i < 3; ++i) {
      const std::string axis = std::string("_") + "xyz"[i];
      put("velocity" + axis, platform.velocity(i));
      put("angular_velocity" + axis, platform.angular_velocity(i));
      put("acceleration" + axis, platform.acceleration(i));
      put("angular_acceleration" + axis, platform.angular_acceleration(i));
    }
    put("det_G", c.determinant);
    put("condition", c.condition);
    for (std::size_t i = 0; i < t.joints.size(); ++i)
      if (t.joints[i].kind != JointKind::prismatic) {
        const std::vector<double> motion = closure_.motion(state_.bodies, static_cast<int>(i));
        for (std::size_t n = 0; n < motion.size(); ++n) put(mechanics::joint_column(t.joints[i], n), motion[n]);
      }
  }

  // The guess lies towards the neighbouring sample, at most a tenth of the characteristic length, or 0.1 rad, away.
  double round_trip(const Eigen::VectorXd& q, const Eigen::VectorXd& neighbour) {
    const auto unit = [&](int i) { return machine_.topology().coordinates[static_cast<std::size_t>(i)].unit == "m" ? length_ : 1.0; };
    double far = 0;
    for (int i = 0; i < q.size(); ++i) far = std::max(far, std::abs(neighbour(i) - q(i)) / (0.1 * unit(i)));
    const Eigen::VectorXd guess = q + (neighbour - q) / std::max(far, 1.0);
    mechanics::SmallVector l(machine_.dof());
    for (int i = 0; i < q.size(); ++i) l(i) = state_.actuators[static_cast<std::size_t>(i)].value;
    const mechanics::ForwardSolution s = forward_.solve(l, guess);
    if (s.outcome != mechanics::ForwardOutcome::converged) return nan;
    double worst = 0;
    for (int i = 0; i < q.size(); ++i) worst = std::max(worst, std::abs(s.coordinates(i) - q(i)) / unit(i));
    return worst;
  }

  template <class Put>
  void statics(int k, Row& row, Put&& put, const mechanics::GenericModel& model, const mechanics::ClosedForm& c, const Vector6d& twist,
               bool comparable) {
    const Topology& t = machine_.topology();
    const scenario::Load& load = scenario_.load;
    const Eigen::VectorXd weight = weights(machine_, state_, load.gravity);
    Vector6d wrench;
    wrench << load.force[static_cast<std::size_t>(k)], load.moment[static_cast<std::size_t>(k)];

    // Load by G; weights by virtual work. What the limbs exert on the platform balances its load and its own weight.
    Eigen::VectorXd forces = closed_statics(c, wrench).head(machine_.dof());
    if (!load.gravity.isZero()) forces += weight_forces(machine_, state_, load.gravity);
    const Vector6d on_platform = closed_statics(c, wrench + weight.segment<6>(6 * t.platform - 6));
    for (int i = 0; i < machine_.dof(); ++i) put(t.actuators[static_cast<std::size_t>(i)].name + "_force", forces(i));
    for (std::size_t i = 0; i < t.constraints.size(); ++i) put(t.constraints[i].name, on_platform(machine_.dof() + static_cast<int>(i)));

    if (comparable) {
      Eigen::VectorXd wrenches = weight;
      wrenches.segment<6>(6 * t.platform - 6) += wrench;
      const mechanics::GenericStatics g = generic_statics(model, wrenches);
      set(row, Measure::statics, relative(largest_of(g.actuator_forces - forces), std::max(largest_of(forces), largest_of(wrenches))));
      set(row, Measure::equilibrium, g.residual);
    }
    double power = wrench.dot(twist) + weight.dot(stacked_twists(state_));
    double scale =
        std::max(wrench.cwiseProduct(twist).cwiseAbs().maxCoeff(), weight.cwiseProduct(stacked_twists(state_)).cwiseAbs().maxCoeff());
    for (int i = 0; i < machine_.dof(); ++i) {
      const double p = forces(i) * state_.actuators[static_cast<std::size_t>(i)].rate;
      power += p;
      scale = std::max(scale, std::abs(p));
    }
    set(row, Measure::power, relative(std::abs(power), scale));
  }

  const scenario::Scenario& scenario_;
  const mechanics::Machine& machine_;
  const mechanics::Closure& closure_;
  mechanics::ForwardSolver forward_;
  double length_;
  bool statics_;
  State state_;
};

bool asks_for(const scenario::Scenario& s, std::string_view kind) {
  return std::any_of(s.sections.begin(), s.sections.end(), [&](const auto& r) { return r.kind == kind; });
}

}  // namespace

Analysis::Analysis(const scenario::Scenario& scenario, const mechanics::Machine& machine, const Progress& progress)
    : scenario_(scenario), machine_(machine), length_(characteristic_length(machine)) {
  const Eigen::VectorXd home = machine.home(), still = Eigen::VectorXd::Zero(machine.dof());
  State s;
  evaluate(machine, home.data(), still.data(), still.data(), s);
  mobility_ = mechanics::mobility(machine, s);
  run(progress);
  find_breaches();
}

void Analysis::run(const Progress& progress) {
  const std::size_t n = time().size();
  for (const std::string& section : mechanics::sections_with_columns())
    for (const mechanics::Column& c : mechanics::columns_of(section, machine_.topology())) columns_[c.name].assign(n, nan);
  conditions_.assign(n, Condition::good);
  Row nothing;
  nothing.fill(nan);
  measures_.assign(n, nothing);

  const mechanics::Closure closure(machine_);
  const bool statics = asks_for(scenario_, "statics");
  tbb::enumerable_thread_specific<Worker> workers([&] { return Worker(scenario_, machine_, closure, length_, statics); });
  std::mutex sentences;
  // Blocks, so that a request to stop is heard in time; within a block every sample stands alone and the order does not matter.
  constexpr std::size_t block = 4096;
  for (std::size_t begin = 0; begin < n; begin += block) {
    progress.stop_if_asked();
    tbb::parallel_for(begin, std::min(n, begin + block), [&](std::size_t k) {
      Worker& worker = workers.local();
      const int sample = static_cast<int>(k), neighbour = sample > 0 ? sample - 1 : std::min(1, samples() - 1);
      conditions_[k] = worker.sample(sample, neighbour, measures_[k], [&](const std::string& name, double value) {
        const auto found = columns_.find(name);
        if (found != columns_.end()) found->second[k] = std::isfinite(value) ? value + 0.0 : nan;  // no negative zero
      });
      if (conditions_[k] == Condition::unreachable || conditions_[k] == Condition::failed) {
        const std::scoped_lock lock(sentences);
        why_[sample] = worker.state().why;
      }
    });
  }
  for (std::size_t k = 0; k < n; ++k)
    if (conditions_[k] == Condition::failed)
      throw mechanics::MechanismError(PM_FAILED, "sample " + std::to_string(k + 1) + ": " + why_[static_cast<int>(k)]);
  const std::vector<double>& det = columns_.at("det_G");
  for (std::size_t k = 0; k + 1 < n; ++k)
    if (det[k] * det[k + 1] < 0) crossings_.push_back({static_cast<int>(k)});
}

void Analysis::find_breaches() {
  const Topology& t = machine_.topology();
  const auto look = [&](const std::string& column, const std::string& subject, const std::string& unit, const Range& range, bool stroke) {
    for (const bool above : {false, true}) {
      LimitBreach b{subject, unit, {}, 0, 0, above ? range.max : range.min, above, stroke};
      double worst = 0;
      const std::vector<double>& x = columns_.at(column);
      // A limit that is met exactly is kept: rounding may not break it.
      const double slack = 1e-12 * std::max({1.0, std::abs(range.min), std::abs(range.max)});
      for (int k = 0; k < samples(); ++k) {
        const double value = x[static_cast<std::size_t>(k)], excess = above ? value - range.max : range.min - value;
        if (!(excess > slack)) continue;
        b.samples.push_back(k);
        if (excess > worst) worst = excess, b.worst = k, b.value = value;
      }
      if (!b.samples.empty()) breaches_.push_back(b);
    }
  };
  for (const Actuator& a : t.actuators) look(a.name, a.name + " (" + a.title + ")", a.unit, a.stroke, true);
  for (const Joint& j : t.joints) {
    if (j.kind == JointKind::prismatic) continue;
    for (std::size_t i = 0; i < j.limits.size(); ++i) look(mechanics::joint_column(j, i), "joint " + j.name, "rad", j.limits[i], false);
  }
}

double Analysis::largest(const std::vector<std::string>& columns) const {
  double out = 0;
  for (const std::string& name : columns)
    for (const double x : column(name))
      if (std::isfinite(x)) out = std::max(out, std::abs(x));
  return out;
}

int Analysis::count(Condition c) const { return static_cast<int>(std::count(conditions_.begin(), conditions_.end(), c)); }

const std::string& Analysis::why(int sample) const {
  static const std::string none;
  const auto found = why_.find(sample);
  return found != why_.end() ? found->second : none;
}

Worst Analysis::worst(Measure m) const {
  Worst w;
  for (int k = 0; k < samples(); ++k) {
    const double x = measures_[static_cast<std::size_t>(k)][index_of(m)];
    if (std::isnan(x)) continue;
    ++w.compared;
    if (w.sample < 0 || x > w.value) w.value = x, w.sample = k;
  }
  return w;
}

namespace {
template <class Predicate>
std::vector<Interval> runs(int n, Predicate&& in) {
  std::vector<Interval> out;
  for (int k = 0; k < n; ++k) {
    if (!in(k)) continue;
    if (!out.empty() && out.back().last == k - 1)
      out.back().last = k;
    else
      out.push_back({k, k});
  }
  return out;
}
}  // namespace

std::vector<Interval> Analysis::broken() const {
  std::vector<bool> bad(time().size());
  for (const LimitBreach& b : breaches_)
    for (const int k : b.samples) bad[static_cast<std::size_t>(k)] = true;
  return runs(samples(), [&](int k) { return bad[static_cast<std::size_t>(k)]; });
}

std::vector<Interval> Analysis::unreachable() const {
  return runs(samples(), [&](int k) { return condition(k) == Condition::unreachable; });
}

mechanics::Pose Analysis::pose(int sample) const {
  const Eigen::VectorXd q = scenario_.motion.value.row(sample);
  return machine_.pose({q.data(), static_cast<std::size_t>(q.size())});
}

int Analysis::sample_at(double t) const {
  const auto after = std::lower_bound(time().begin(), time().end(), t);
  if (after == time().end()) return samples() - 1;
  const int k = static_cast<int>(after - time().begin());
  return k > 0 && t - time()[static_cast<std::size_t>(k - 1)] < *after - t ? k - 1 : k;
}

}  // namespace pmreport::section
