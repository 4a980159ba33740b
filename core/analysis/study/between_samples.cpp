#include <core/analysis/study/between_samples.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace pmreport::analysis {

namespace {

constexpr std::size_t orders = 3;  // value, rate, acceleration
// How far something may go between samples, of all that it moves. A sine that is sampled seven times a period goes a twentieth beyond.
// Rates and accelerations are allowed more: they waver more, and those of measured points with the noise of these.
constexpr std::array<double, orders> allowed{0.05, 0.25, 0.25};
constexpr double shown_well = 0.01;  // the same, where the number of samples is enough
constexpr double rounding = 1e-12;   // of a value, or of the mechanism's size: what moves less does not move
constexpr double beside = 1e-9;      // of what moves most: what moves less beside it is what an integration, or rounding, leaves
// Where a stretch is looked at. No ends: they may be knots, which are of neither side.
constexpr std::array<double, 3> places{1.0 / 6, 0.5, 5.0 / 6};

// One order of one coordinate.
struct Look {
  double low = std::numeric_limits<double>::infinity(), high = -low;  // between the samples
  double sample_low = low, sample_high = high;                        // at the samples
  double beyond = 0, time = 0;
  double curvature = 0;  // largest second derivative of it

  void see(double x) { low = std::min(low, x), high = std::max(high, x); }
};

// The steps of an integration are not longer than a share of the whole, whatever its samples are.
std::vector<double> divided(const std::vector<double>& t) {
  constexpr std::size_t fewest = 2000;
  const std::size_t parts = (fewest + t.size() - 2) / (t.size() - 1);
  std::vector<double> out{t.front()};
  for (std::size_t k = 1; k < t.size(); ++k)
    for (std::size_t n = 1; n <= parts; ++n)
      out.push_back(t[k - 1] + (t[k] - t[k - 1]) * static_cast<double>(n) / static_cast<double>(parts));
  return out;
}

using Numbers = std::vector<double>;  // of every quantity its orders

// Looks at a number of quantities, of each at its value alone or at all three orders.
struct Quantities {
  std::size_t count, orders;
  std::vector<double> steps;
  std::function<bool(double t, Numbers& out)> at;            // false where they have none
  std::function<bool(std::size_t sample, Numbers& out)> of;  // the same at a sample
};

class Looker {
 public:
  Looker(const std::vector<double>& times, const Quantities& quantities)
      : times_(times), q_(quantities), looks_(q_.orders * q_.count), left_(looks_.size()), right_(looks_.size()) {}

  const std::vector<Look>& look() {
    for (std::size_t k = 0; k < times_.size(); ++k)
      if (q_.of(k, right_))
        for (std::size_t i = 0; i < looks_.size(); ++i) {
          looks_[i].sample_low = std::min(looks_[i].sample_low, right_[i]);
          looks_[i].sample_high = std::max(looks_[i].sample_high, right_[i]);
        }
    for (std::size_t i = 1; i < q_.steps.size(); ++i) {
      const double from = std::max(q_.steps[i - 1], times_.front()), to = std::min(q_.steps[i], times_.back());
      if (from < to) stretch(from, to);
    }
    return looks_;
  }

 private:
  // A rate that turns between two samples is shown by their accelerations: the cubic that has both rates and both accelerations.
  double foretold(std::size_t i, double time) const {
    const double from = times_[interval_], h = times_[interval_ + 1] - from, u = (time - from) / h, v = 1 - u;
    return v * v * (1 + 2 * u) * left_[i] + u * u * (1 + 2 * v) * right_[i] + h * u * v * (v * left_[i + 1] - u * right_[i + 1]);
  }

  // The samples around a time, which only rises.
  void come_to(double time) {
    while (interval_ + 2 < times_.size() && times_[interval_ + 1] < time) ++interval_;
    if (interval_ == known_) return;
    known_ = interval_;
    between_ = q_.of(interval_, left_);
    between_ = q_.of(interval_ + 1, right_) && between_;
  }

  // Within it all is a matter of a few points.
  void stretch(double from, double to) {
    std::array<Numbers, places.size()> x;
    bool whole = true;
    for (std::size_t p = 0; p < places.size(); ++p) {
      const double time = from + places[p] * (to - from);
      x[p].resize(looks_.size());
      if (!q_.at(time, x[p])) {
        whole = false;
        continue;
      }
      come_to(time);
      for (std::size_t i = 0; i < looks_.size(); ++i) {
        looks_[i].see(x[p][i]);
        double beyond = std::max(x[p][i] - std::max(left_[i], right_[i]), std::min(left_[i], right_[i]) - x[p][i]);
        if (i % q_.orders == 1) beyond = std::min(beyond, std::abs(x[p][i] - foretold(i, time)));
        if (between_ && beyond > looks_[i].beyond) looks_[i].beyond = beyond, looks_[i].time = time;
      }
    }
    if (!whole) return;
    const double h = (places[1] - places[0]) * (to - from);
    for (std::size_t i = 0; i < looks_.size(); ++i)
      for (std::size_t p = 1; p + 1 < places.size(); ++p)
        looks_[i].curvature = std::max(looks_[i].curvature, std::abs(x[p - 1][i] - 2 * x[p][i] + x[p + 1][i]) / (h * h));
  }

  const std::vector<double>& times_;
  const Quantities& q_;
  std::vector<Look> looks_;
  Numbers left_, right_;
  std::size_t interval_ = 0;                                     // of the samples around the time
  std::size_t known_ = std::numeric_limits<std::size_t>::max();  // the interval whose samples left_ and right_ are
  bool between_ = false;                                         // both have a pose
};

Quantities moved(const Analysis& a) {
  const mechanics::Trajectory& m = a.trajectory();
  const scenario::MotionRequest& motion = *a.scenario().motion;
  const auto dof = static_cast<std::size_t>(a.machine().dof());
  const mechanics::Path path = motion.prescribed ? motion.prescribed : m.at;
  const auto at = [=](double t, Numbers& out) {
    Numbers value(dof), rate(dof), acceleration(dof);
    if (!path(t, value.data(), rate.data(), acceleration.data())) return false;
    for (std::size_t i = 0; i < dof; ++i) out[orders * i] = value[i], out[orders * i + 1] = rate[i], out[orders * i + 2] = acceleration[i];
    return true;
  };
  const auto of = [=, &m, &motion](std::size_t k, Numbers& out) {
    if (!m.reaches(static_cast<int>(k))) return false;
    if (motion.by_actuators()) return at(m.time[k], out);
    for (std::size_t i = 0; i < dof; ++i) {
      const auto row = static_cast<Eigen::Index>(k), column = static_cast<Eigen::Index>(i);
      out[orders * i] = m.value(row, column), out[orders * i + 1] = m.rate(row, column), out[orders * i + 2] = m.acceleration(row, column);
    }
    return true;
  };
  return {dof, orders, motion.steps.size() > 1 ? motion.steps : divided(m.time), at, of};
}

Quantities loads(const Analysis& a) {
  const scenario::Load& load = a.scenario().load;
  const auto at = [&load](double t, Numbers& out) {
    const Eigen::Matrix<double, 6, 1> wrench = load.at(t);
    std::copy_n(wrench.data(), 6, out.data());
    return true;
  };
  const auto of = [&load](std::size_t k, Numbers& out) {
    std::copy_n(load.force[k].data(), 3, out.data());
    std::copy_n(load.moment[k].data(), 3, out.data() + 3);
    return true;
  };
  return {6, 1, load.steps, at, of};
}

// Between samples h apart an extreme is missed by h^2 / 8 times its curvature at most. Rounded up to a number that one would write.
double samples_for(double span, double share, const Look& look) {
  const double intervals = span * std::sqrt(look.curvature / (8 * share * (look.high - look.low)));
  const double power = std::pow(10, std::floor(std::log10(intervals)));
  for (const double nice : {1.0, 2.0, 5.0})
    if (nice * power >= intervals) return nice * power + 1;
  return 10 * power + 1;
}

}  // namespace

std::vector<Unseen> unseen_between_samples(const Analysis& a) {
  std::vector<Unseen> out;
  if (!a.scenario().motion || a.samples() < 2) return out;
  const scenario::MotionRequest& motion = *a.scenario().motion;
  const Asked asked = asked_by(a.scenario());
  const std::array<bool, orders> counts{true, asked.velocity_evidence || asked.acceleration_evidence || asked.forces,
                                        asked.acceleration_evidence || asked.forces};
  const double span = a.time().back() - a.time().front();
  const double pace = static_cast<double>(std::max(motion.steps.size(), a.time().size())) / span;
  // The lowest order that counts and is hidden, among all of one quantity.
  const auto add = [&](const Look* own, std::size_t count, const std::string& name, const std::string& unit,
                       const std::array<double, orders>& floor) {
    const double largest = std::max(std::abs(own->low), std::abs(own->high));
    for (std::size_t k = 0; k < count; ++k) {
      const Look& x = own[k];
      const double moves = x.high - x.low;
      if (!counts[k] || !(moves > std::max(rounding * largest * std::pow(pace, static_cast<double>(k)), floor[k])) ||
          !(x.beyond > allowed[k] * moves))
        continue;
      const char* per[] = {"", "/s", "/s^2"};
      out.push_back({name, unit + per[k], static_cast<OfMotion>(k), x.beyond, x.time, moves, std::max(x.sample_high - x.sample_low, 0.0),
                     samples_for(span, shown_well, x)});
      return;
    }
  };
  const Topology& topology = a.machine().topology();
  const Quantities motions = moved(a);
  Looker at_motion(a.time(), motions);
  const std::vector<Look>& looks = at_motion.look();
  // Angles count as ways at the characteristic length.
  const auto size = [&](std::size_t i) {
    return (motion.by_actuators() ? topology.actuators[i].sense() : topology.coordinates[i].sense()) == Sense::rotary ? a.length() : 1.0;
  };
  std::array<double, orders> most{};
  for (std::size_t i = 0; i < motions.count; ++i)
    for (std::size_t k = 0; k < orders; ++k) {
      const double moves = (looks[orders * i + k].high - looks[orders * i + k].low) * size(i);
      if (std::isfinite(moves)) most[k] = std::max(most[k], moves);
    }
  for (std::size_t i = 0; i < motions.count; ++i) {
    std::array<double, orders> floor{};
    for (std::size_t k = 0; k < orders; ++k)
      floor[k] = std::max(beside * most[k], rounding * a.length() * std::pow(pace, static_cast<double>(k))) / size(i);
    if (motion.by_actuators())
      add(&looks[orders * i], orders, topology.actuators[i].name, topology.actuators[i].unit, floor);
    else
      add(&looks[orders * i], orders, topology.coordinates[i].name, topology.coordinates[i].unit, floor);
  }
  if ((asked.statics || asked.forces) && a.scenario().load.steps.size() > 1) {
    const Quantities wrench = loads(a);
    Looker at_load(a.time(), wrench);
    const std::vector<Look>& seen = at_load.look();
    for (std::size_t c = 0; c < 6; ++c)
      add(&seen[c], 1, std::string("the load's ") + (c < 3 ? "force along " : "moment about ") + "xyz"[c % 3], c < 3 ? "N" : "N*m", {});
  }
  std::stable_sort(out.begin(), out.end(), [](const Unseen& x, const Unseen& y) { return x.beyond * y.moves > y.beyond * x.moves; });
  return out;
}

}  // namespace pmreport::analysis
