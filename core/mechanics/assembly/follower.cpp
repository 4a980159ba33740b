#include <core/mechanics/assembly/follower.hpp>

#include <core/linear/singular_values.hpp>
#include <core/linear/square.hpp>
#include <core/mechanics/assembly/tolerances.hpp>

#include <algorithm>
#include <cmath>

namespace pmreport::mechanics {

namespace {

constexpr double instant = 1.0 / (1 << 20);  // of the time between two samples: how exactly the time of a mode's end is known
constexpr double near = 0.15;                // of the characteristic length: the farthest that a mode goes in one step
constexpr double next_word = 0.02;           // likewise, from one word of the working mode into the next
constexpr double meeting = 0.02;             // likewise, between modes that are about to meet
constexpr double roughly = 0.01;             // likewise, and of axes

}  // namespace

ModeFollower::ModeFollower(const std::vector<WorkingMode>& words, const std::vector<double>& times, const PoseAt& motion, double length)
    : words_(words), times_(times), motion_(motion), length_(length) {
  for (const WorkingMode& w : words) solvers_.push_back(std::make_unique<ForwardSolver>(*w.machine));
  for (const double t : times) poses_.push_back(motion(t));
  const auto& coordinates = words.front().machine->topology().coordinates;
  scale_.resize(static_cast<Eigen::Index>(coordinates.size()));
  for (std::size_t i = 0; i < coordinates.size(); ++i)
    scale_(static_cast<Eigen::Index>(i)) = coordinates[i].sense() == Sense::rotary ? 1 : length;
}

SmallVector ModeFollower::actuators(const Pose& pose) const {
  const Machine& own = *words_.front().machine;
  return Eigen::Map<const Eigen::VectorXd>(pose.numbers.data() + own.layout().actuator(0), own.dof());
}

double ModeFollower::apart(const Pose& a, const Pose& b) const { return distance(*words_.front().machine, a, b, length_); }

// One platform pose may have limbs in several ways: the other bodies must agree as well, if only roughly.
bool ModeFollower::one(const Pose& a, const Pose& b) const {
  if (!(apart(a, b) < same * length_)) return false;
  const Machine& m = *words_.front().machine;
  for (int i = 1; i < static_cast<int>(m.topology().bodies.size()); ++i)
    if ((m.origin(a, i) - m.origin(b, i)).norm() > roughly * length_ ||
        (m.rotation(a, i).col(2) - m.rotation(b, i).col(2)).norm() > roughly)
      return false;
  return true;
}

std::optional<ModePlace> ModeFollower::solve(const ModePlace& from, const SmallVector& actuators, std::size_t word, double reach) {
  const ForwardSolution s = solvers_[word]->solve(actuators, from.q);
  if (s.outcome != Outcome::good) return {};
  ModePlace to{word, s.coordinates, words_[word].machine->pose({s.coordinates.data(), static_cast<std::size_t>(s.coordinates.size())})};
  if (to.pose.status != PM_OK || !(apart(from.pose, to.pose) <= reach * length_)) return {};
  return to;
}

std::optional<ModePlace> ModeFollower::from_afar(const ModePlace& from, int sample) {
  return solve(from, actuators(pose(sample)), from.word, std::numeric_limits<double>::infinity());
}

// A limb that comes to the edge of its reach goes on in its other solution: words that differ in one choice.
bool ModeFollower::neighbours(std::size_t a, std::size_t b) const {
  const ParameterValues &x = words_[a].machine->values(), &y = words_[b].machine->values();
  int different = 0;
  for (std::size_t i = 0; i < x.size(); ++i) different += x[i] != y[i];
  return different == 1;
}

// From the mode at time t to that at time `to`. False where it ends before; t is then when.
bool ModeFollower::step(ModePlace& place, double& t, double to) {
  const double least = std::abs(to - t) * instant, edge = std::abs(to - t) / 256;
  double h = to - t;
  while (t != to) {
    const double next = std::abs(to - t) <= std::abs(h) ? to : t + h;
    const Pose there = motion_(next);
    std::optional<ModePlace> found;
    if (there.status == PM_OK) {
      const SmallVector l = actuators(there);
      found = solve(place, l, place.word, near);
      // Close to the edge, and not too close: the other word's slopes grow without bound there.
      if (!found && std::abs(h) <= edge && leaves_reach(place, t, to))
        for (std::size_t w = 0; w < words_.size() && !found; ++w)
          if (neighbours(place.word, w)) found = solve(place, l, w, next_word);
    }
    if (found) {
      place = std::move(*found);
      t = next;
      h *= 2;
    } else if (std::abs(h) <= least) {
      return false;
    } else {
      h = (next - t) / 2;
    }
  }
  return true;
}

// Slopes of the actuators by coordinates in numbers.
SmallMatrix ModeFollower::slope(std::size_t word, const SmallVector& u) const {
  const Machine& m = *words_[word].machine;
  const Eigen::Index n = m.dof();
  const SmallVector q = u.cwiseProduct(scale_);
  std::vector<double> placement(m.layout().size() * m.components(PM_PARTIALS));
  SmallMatrix s = SmallMatrix::Constant(n, n, std::numeric_limits<double>::quiet_NaN());
  if (m.place(PM_PARTIALS, 1, q.data(), placement.data()) != PM_OK) return s;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double* at = placement.data() + m.layout().actuator(static_cast<int>(i)) * m.components(PM_PARTIALS);
    for (Eigen::Index j = 0; j < n; ++j) s(i, j) = at[1 + j] * scale_(j);
  }
  return s;
}

// Where two modes are about to meet, the slopes S have a small singular value s with w^T S v = s, and along v it changes by c a unit way:
// w^T S v = 0 is the fold, half way to the other mode, which is found from -2 s / c on.
std::optional<ModePlace> ModeFollower::beyond_the_fold(const ModePlace& place, double t) {
  const Pose there = motion_(t);
  if (there.status != PM_OK) return {};
  const SmallVector u = place.q.cwiseQuotient(scale_);
  const SmallMatrix s = slope(place.word, u);
  if (!s.allFinite()) return {};
  const linear::LeftSingular left = linear::left_singular(s), right = linear::left_singular(s.transpose());
  const Eigen::Index last = left.values.size() - 1;
  const SmallVector w = left.vectors.col(last), v = right.vectors.col(last);
  const SmallMatrix change = slope(place.word, u + slope_probe * v) - slope(place.word, u - slope_probe * v);
  const double c = w.dot(change * v) / (2 * slope_probe), to_the_other = -2 * w.dot(s * v) / c;
  if (!(std::abs(to_the_other) < near)) return {};
  for (const double share : {1.0, 1.5, 0.75}) {
    ModePlace guess = place;
    guess.q += share * to_the_other * v.cwiseProduct(scale_);
    const std::optional<ModePlace> other = solve(guess, actuators(there), place.word, near);
    // Closer than two modes are elsewhere, and yet two: they stand on either side.
    if (other && (other->q.cwiseQuotient(scale_) - u).norm() > 0.25 * std::abs(to_the_other)) return other;
  }
  return {};
}

// Whether the way on at the mode's velocity goes out of reach.
bool ModeFollower::leaves_reach(const ModePlace& place, double t, double to) {
  const double h = 4 * instant * (to - t);
  const Pose now = motion_(t), next = motion_(t + h);
  if (now.status != PM_OK || next.status != PM_OK) return false;
  const SmallMatrix s = slope(place.word, place.q.cwiseQuotient(scale_));
  if (!s.allFinite()) return true;
  const SmallVector step = linear::SmallFactors(s).solve(actuators(next) - actuators(now)).cwiseProduct(scale_);
  for (const double way : {1.0, 4.0, 16.0, 64.0, 256.0}) {
    const SmallVector q = place.q + way * step;
    if (!q.allFinite() || words_[place.word].machine->pose({q.data(), static_cast<std::size_t>(q.size())}).status != PM_OK) return true;
  }
  return false;
}

// When two modes meet that are apart at one time and one at another, by bisection; `b` nothing: the motion's own.
double ModeFollower::meeting_time(ModePlace a, std::optional<ModePlace> b, double from, double to) {
  for (int k = 0; k < 24; ++k) {
    const double middle = 0.5 * (from + to);
    ModePlace next_a = a;
    std::optional<ModePlace> next_b = b;
    double t = from, u = from;
    if (!step(next_a, t, middle)) return t;
    if (next_b && !step(*next_b, u, middle)) return u;
    const Pose other = next_b ? next_b->pose : motion_(middle);
    if (other.status != PM_OK) return middle;
    if (one(next_a.pose, other)) {
      to = middle;
    } else {
      from = middle, a = std::move(next_a), b = std::move(next_b);
    }
  }
  return to;
}

// `other` nothing: the motion's own.
bool ModeFollower::near_at(const Stop& stop, const std::optional<ModePlace>& other) {
  double t = times_[static_cast<std::size_t>(stop.sample)];
  std::optional<ModePlace> there = other;
  if (there && !step(*there, t, stop.end.time) &&
      std::abs(t - stop.end.time) > 1e-3 * std::abs(t - times_[static_cast<std::size_t>(stop.sample)]))
    return false;
  const Pose pose = there ? there->pose : motion_(stop.end.time);
  return pose.status == PM_OK && apart(stop.last.pose, pose) < meeting * length_;
}

ModeFollower::Stop ModeFollower::run(ModePlace place, int sample, int direction, Places& places, const std::vector<Places>& others) {
  const auto at = [](int k) { return static_cast<std::size_t>(k); };
  places[at(sample)] = place;
  Stop stop{{ModeEnd::How::beyond, times_[at(sample)], no_track}, sample, {}, {}};
  for (int k = sample + direction; k >= 0 && k < samples(); k += direction) {
    if (pose(k).status != PM_OK) return stop;
    double t = times_[at(k - direction)];
    ModePlace next = place;
    if (!step(next, t, times_[at(k)])) {
      stop.end.time = t;
      if (std::optional<ModePlace> other = beyond_the_fold(next, t)) {
        stop.end.how = ModeEnd::How::meets;
        if (step(*other, t, times_[at(k - direction)])) stop.partner = std::move(other);
      } else {
        stop.end.how = leaves_reach(next, t, times_[at(k)]) ? ModeEnd::How::reach : ModeEnd::How::lost;
      }
      stop.last = std::move(next);
      return stop;
    }
    std::size_t met = is_own(next.pose, k) ? own_mode : no_track;
    for (std::size_t j = 0; j < others.size() && met == no_track; ++j)
      if (others[j][at(k)] && one(next.pose, others[j][at(k)]->pose)) met = j;
    const bool own = met == own_mode;
    if (met != no_track && (own || others[met][at(k - direction)])) {
      const double before = times_[at(k - direction)];
      stop.end = {ModeEnd::How::meets, meeting_time(place, own ? std::nullopt : others[met][at(k - direction)], before, times_[at(k)]),
                  met};
      return stop;
    }
    if (met != no_track) {  // the other was followed back to here and no further: it is this one
      stop.end = {ModeEnd::How::beyond, times_[at(k)], met};
      return stop;
    }
    place = std::move(next);
    places[at(k)] = place;
    stop.sample = k;
    stop.end.time = times_[at(k)];
  }
  return stop;
}

}  // namespace pmreport::mechanics
