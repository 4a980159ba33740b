#include <core/mechanics/forward_dynamics/forward_dynamics.hpp>

#include <core/assertion.hpp>
#include <core/mechanics/forward_dynamics/forced_motion.hpp>
#include <core/mechanics/forward_dynamics/motion_bounds.hpp>
#include <core/mechanics/forward_dynamics/motion_track.hpp>
#include <core/mechanics/model/effort.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/numbers.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <memory>

namespace pmreport::mechanics {

namespace {

constexpr double longest_step = 1.0 / 2000;  // of the whole motion
constexpr double first_step = 1e-6;          // of the whole motion; it grows fivefold a step
constexpr double absolute_share = 1e-2;      // of the tolerance: motions much smaller than the mechanism count too
constexpr std::size_t patience = 20'000;     // evaluations that must lead on by
constexpr double least_progress = 1e-4;      // of the whole motion: else a million would not lead far
constexpr double resolution = 1e-9;          // [s], or of the whole motion if that is shorter: of the time of an end

// What is integrated: coordinates and rates in lengths of the mechanism or radians, then the work of actuators and load in joules of it
// moving at a length, or a radian, a second. So one tolerance does for all.
using Numbers = std::vector<double>;
using Stepper = boost::numeric::odeint::runge_kutta_dopri5<Numbers>;

class Integration {
 public:
  Integration(const Machine& machine, const ForwardProblem& problem);
  ForwardMotion run();

 private:
  struct Step {
    TrackPoint from, to;
    double end = 0;  // where the motion goes on to within it: `to`, or earlier
  };

  Numbers derivative(const Numbers& x, double t);
  TrackPoint point(const Numbers& x, const Numbers& slope, double t) const;
  bool advance();
  void finish(double reached);
  void bound(Step& step);
  double crossing(const Step& step, Eigen::Index bound, double outside) const;
  std::optional<Eigen::VectorXd> margins(const Step& step, double t) const;
  void account();
  void sample(const Step& step);
  void stop(Outcome outcome, double t, const std::string& how);
  void out_of_reach(double t, const std::string& why);

  const Machine& machine_;
  const ForwardProblem& problem_;
  const Eigen::Index dof_;
  const double begin_, span_, resolution_;
  ForcedMotion forced_, sampling_;  // of the steps, and of the times wanted, which do not count as evaluations
  MotionBounds bounds_;
  SmallVector unit_;
  double energy_unit_ = 1;

  boost::numeric::odeint::controlled_runge_kutta<Stepper> stepper_;
  double time_, next_;  // [s]: where it stands, and the step to try
  Numbers now_, slope_, then_, slope_then_;
  Eigen::VectorXd margins_;  // where it stands
  double energy_at_start_ = 0, potential_at_start_ = 0, largest_energy_ = 0;
  std::size_t sampled_ = 0;
  std::size_t look_back_ = patience;  // at this number of evaluations: how far they have led
  double time_looked_back_;
  std::shared_ptr<MotionTrack> track_ = std::make_shared<MotionTrack>();
  ForwardMotion out_;
};

Integration::Integration(const Machine& machine, const ForwardProblem& problem)
    : machine_(machine),
      problem_(problem),
      dof_(machine.dof()),
      begin_(problem.times.front()),
      span_(problem.times.back() - begin_),
      resolution_(resolution * std::min(1.0, span_)),
      forced_(machine, problem),
      sampling_(machine, problem),
      bounds_(machine),
      unit_(machine.dof()),
      stepper_(boost::numeric::odeint::default_error_checker<double, boost::numeric::odeint::range_algebra,
                                                             boost::numeric::odeint::default_operations>(absolute_share * problem.tolerance,
                                                                                                         problem.tolerance)),
      time_(begin_),
      next_(first_step * span_),
      time_looked_back_(begin_) {
  const double length = characteristic_length(machine);
  for (Eigen::Index i = 0; i < dof_; ++i) unit_(i) = size_of(machine.topology().coordinates[static_cast<std::size_t>(i)].sense(), length);
}

Numbers Integration::derivative(const Numbers& x, double t) {
  const Eigen::Map<const Eigen::VectorXd> numbers(x.data(), 2 * dof_);
  const SmallVector q = numbers.head(dof_).cwiseProduct(unit_), rate = numbers.tail(dof_).cwiseProduct(unit_);
  const ForcedMotion::Answer answer = forced_.at(t, q, rate);
  Numbers out(x.size());
  Eigen::Map<Eigen::VectorXd>(out.data(), 2 * dof_) << numbers.tail(dof_), answer.acceleration.cwiseQuotient(unit_);
  out.back() = answer.power / energy_unit_;
  return out;
}

TrackPoint Integration::point(const Numbers& x, const Numbers& slope, double t) const {
  const Eigen::Map<const Eigen::VectorXd> numbers(x.data(), 2 * dof_), rates(slope.data(), 2 * dof_);
  return {t, numbers.head(dof_).cwiseProduct(unit_), numbers.tail(dof_).cwiseProduct(unit_), rates.tail(dof_).cwiseProduct(unit_)};
}

ForwardMotion Integration::run() {
  const auto rows = static_cast<Eigen::Index>(problem_.times.size());
  for (Eigen::MatrixXd* m : {&out_.value, &out_.rate, &out_.acceleration}) m->setConstant(rows, dof_, nan);
  out_.work.assign(problem_.times.size(), nan);
  out_.energy = out_.work;

  const SmallVector q = problem_.start, rate = problem_.start_rate;
  bounds_.begin(q);
  margins_ = *bounds_.margins(q);
  now_.assign(static_cast<std::size_t>(2 * dof_ + 1), 0);
  then_ = slope_then_ = now_;
  Eigen::Map<Eigen::VectorXd>(now_.data(), 2 * dof_) << q.cwiseQuotient(unit_), rate.cwiseQuotient(unit_);
  try {
    energy_unit_ = forced_.energy(q, unit_).kinetic;
    if (!(energy_unit_ > 0)) energy_unit_ = 1;  // a mechanism without mass, as the next line tells
    slope_ = derivative(now_, begin_);
    const ForcedMotion::Energy energy = forced_.energy(q, rate);
    energy_at_start_ = energy.total(), potential_at_start_ = energy.potential;
    largest_energy_ = energy.kinetic;
  } catch (const NoMotion& e) {
    throw MechanismError(PM_BAD_ARGUMENT, e.what());
  }
  track_->add(point(now_, slope_, begin_));
  out_.ended = begin_;
  sample({track_->at(begin_), track_->at(begin_), begin_});
  while (out_.outcome == Outcome::good && time_ < problem_.times.back())
    if (!advance()) break;
  if (out_.outcome == Outcome::good) out_.ended = problem_.times.back();

  out_.evaluations = forced_.evaluations();
  out_.drift_share = largest_energy_ > 0 ? out_.drift / largest_energy_ : 0;
  out_.at = [track = std::shared_ptr<const MotionTrack>(track_), &machine = machine_,
             problem = std::make_shared<const ForwardProblem>(problem_), begin = begin_,
             end = out_.ended](double t, double* value, double* rate_there, double* acceleration) {
    if (!(t >= begin && t <= end)) return false;
    const TrackPoint p = track->at(t);
    try {
      const SmallVector a = ForcedMotion(machine, *problem).at(t, p.value, p.rate).acceleration;
      std::copy_n(a.data(), a.size(), acceleration);
    } catch (const NoMotion&) {
      return false;
    }
    std::copy_n(p.value.data(), p.value.size(), value);
    std::copy_n(p.rate.data(), p.rate.size(), rate_there);
    return true;
  };
  return std::move(out_);
}

// One step, as long as the tolerance and the mechanism allow. False when none leads on.
bool Integration::advance() {
  namespace odeint = boost::numeric::odeint;
  const double last = problem_.times.back(), shortest = 0.1 * resolution_;
  const auto system = [this](const Numbers& x, Numbers& slope, double t) { slope = derivative(x, t); };
  for (;;) {
    if (forced_.evaluations() >= problem_.evaluations) {
      stop(Outcome::failed, time_, fmt::format("{} evaluations of the equations of motion lead no farther", problem_.evaluations));
      return false;
    }
    if (forced_.evaluations() >= look_back_) {
      if (time_ - time_looked_back_ < least_progress * span_) {
        stop(Outcome::failed, time_, "forces jump to and fro there, or grow without bound");
        return false;
      }
      look_back_ += patience, time_looked_back_ = time_;
    }
    const double step = std::min({next_, longest_step * span_, last - time_});
    double t = time_;
    next_ = step;
    try {
      if (step <= shortest && step < last - time_) {
        // A force that jumps leaves an error that no shorter step makes small enough; at this length it is small anyhow.
        stepper_.stepper().do_step(system, now_, slope_, t, then_, slope_then_, step);
        next_ = 10 * shortest;
        t += step;
      } else if (stepper_.try_step(system, now_, slope_, t, then_, slope_then_, next_) != odeint::success) {
        next_ = std::max(next_, shortest);
        continue;
      }
    } catch (const NoMotion& e) {
      next_ = 0.25 * step;
      if (next_ > shortest) continue;
      e.outcome == Outcome::unreachable ? out_of_reach(time_, e.what()) : stop(e.outcome, time_, e.what());
      return false;
    }
    finish(step == last - time_ ? last : t);
    return true;
  }
}

void Integration::finish(double reached) {
  Step step{point(now_, slope_, time_), point(then_, slope_then_, reached), reached};
  bound(step);
  track_->add(step.to);
  sample(step);
  std::swap(now_, then_), std::swap(slope_, slope_then_);
  time_ = reached;
  ++out_.steps;
  if (out_.outcome == Outcome::good) account();
}

std::optional<Eigen::VectorXd> Integration::margins(const Step& step, double t) const {
  return bounds_.margins(t == step.to.time ? step.to.value : between(step.from, step.to, t).value);
}

// The first bound that the step goes beyond ends it. A margin that is left at both ends of the step may have been none between them: the
// parabola through both ends and the middle tells where it is least.
void Integration::bound(Step& step) {
  const double a = step.from.time, b = step.to.time, h = b - a;
  const auto middle = margins(step, a + 0.5 * h), end = margins(step, b);
  if (!middle || !end) {  // the ends of the step can be assembled, what is between them cannot
    step.end = a;
    out_of_reach(a, "");
    return;
  }
  double first = b;
  Eigen::Index bound = -1;
  const auto meets = [&](Eigen::Index i, double outside) {
    const double t = crossing(step, i, outside);
    if (bound < 0 || t < first) first = t, bound = i;
  };
  for (Eigen::Index i = 0; i < end->size(); ++i) {
    const double left = margins_(i), half = (*middle)(i), right = (*end)(i);
    if (half < 0) {
      meets(i, a + 0.5 * h);
    } else if (right < 0) {
      meets(i, b);
    } else if (half <= left && half <= right) {
      const double curvature = left - 2 * half + right, lowest = a + 0.5 * h + 0.25 * h * (left - right) / std::max(curvature, 1e-300);
      const auto there = lowest > a && lowest < b ? margins(step, lowest) : std::nullopt;
      if (there && (*there)(i) < 0) meets(i, lowest);
    }
  }
  margins_ = *end;
  if (bound < 0) return;
  step.end = first;
  if (bounds_.outcome(bound) == Outcome::singular) {
    stop(Outcome::singular, first, "");
    out_.ending = fmt::format("meets a singular surface at t = {:.6g} s: there the actuators do not hold the platform", first);
  } else {
    stop(Outcome::at_limit, first, bounds_.subject(bound) + " reaches " + bounds_.edge(bound));
  }
}

// The last time within the bound, to a tenth of the resolution.
double Integration::crossing(const Step& step, Eigen::Index bound, double outside) const {
  double inside = step.from.time;
  while (outside - inside > 0.1 * resolution_) {
    const double t = 0.5 * (inside + outside);
    if (!(t > inside && t < outside)) break;
    const auto there = margins(step, t);
    (there && (*there)(bound) >= 0 ? inside : outside) = t;
  }
  return inside;
}

// (3): what the integration has lost or gained until here. Potential energy counts from that of the start: where it is zero says nothing.
void Integration::account() {
  const TrackPoint here = point(now_, slope_, time_);
  const ForcedMotion::Energy energy = forced_.energy(here.value, here.rate);
  const double work = now_.back() * energy_unit_;
  out_.drift = std::max(out_.drift, std::abs(energy.total() - energy_at_start_ - work));
  largest_energy_ = std::max({largest_energy_, energy.kinetic, std::abs(energy.potential - potential_at_start_), std::abs(work)});
}

// The times wanted that lie within the step.
void Integration::sample(const Step& step) {
  Numbers there(now_.size());
  for (; sampled_ < problem_.times.size() && problem_.times[sampled_] <= step.end; ++sampled_) {
    const double t = problem_.times[sampled_];
    const auto row = static_cast<Eigen::Index>(sampled_);
    const TrackPoint p = step.from.time == step.to.time ? step.from : between(step.from, step.to, t);
    if (step.from.time == step.to.time)
      there = now_;
    else
      stepper_.stepper().calc_state(t, there, now_, slope_, step.from.time, then_, slope_then_, step.to.time);
    try {
      out_.acceleration.row(row) = sampling_.at(t, p.value, p.rate).acceleration;
    } catch (const NoMotion& e) {  // between two points that have accelerations
      stop(e.outcome, std::max(step.from.time, problem_.times[sampled_ - 1]), e.what());
      return;
    }
    out_.value.row(row) = p.value;
    out_.rate.row(row) = p.rate;
    out_.work[sampled_] = there.back() * energy_unit_;
    out_.energy[sampled_] = sampling_.energy(p.value, p.rate).total();
  }
}

void Integration::stop(Outcome outcome, double t, const std::string& how) {
  out_.outcome = outcome;
  out_.ended = t;
  out_.ending = fmt::format("ends at t = {:.6g} s: {}", t, how);
}

void Integration::out_of_reach(double t, const std::string& why) {
  stop(Outcome::unreachable, t, why);
  out_.ending = fmt::format("runs out of reach at t = {:.6g} s: beyond it the mechanism cannot be assembled{}", t,
                            why.empty() ? "" : " (" + why + ")");
}

}  // namespace

ForwardMotion forward_dynamics(const Machine& machine, const ForwardProblem& problem) {
  PMREPORT_ASSERT(problem.start.size() == machine.dof() && problem.start_rate.size() == machine.dof(),
                  "the start has dof coordinates and rates");
  PMREPORT_ASSERT(!problem.times.empty() && problem.actuator_forces, "there are times, and forces");
  return Integration(machine, problem).run();
}

}  // namespace pmreport::mechanics
