#include <core/mechanics/assembly/further.hpp>

#include <core/linear/least_norm.hpp>
#include <core/linear/subspace.hpp>
#include <core/mechanics/assembly/loops.hpp>
#include <core/mechanics/assembly/tolerances.hpp>
#include <core/mechanics/model/closure.hpp>
#include <core/mechanics/model/generic_model.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <numbers>
#include <optional>
#include <random>
#include <ranges>

namespace pmreport::mechanics {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

constexpr int newton_steps = 40;
constexpr double longest = 0.3;
constexpr double converged = 1e-13;  // error of the loop equations
constexpr double misaligned = 1e-6;  // [rad]: an axis turned over is far beyond
constexpr double fitted = 1e-7;      // of the platform's numbers, when coordinates are fitted to it
constexpr std::size_t guesses = 3;
constexpr double same = 1e-5;  // of the characteristic length: two places of the platform that are one

// How far joints are apart at home [m].
double size_of(const Machine& machine) {
  double size = 0;
  for (int i = 0; i < static_cast<int>(machine.topology().joints.size()); ++i)
    size = std::max(size, (machine.centre(machine.home_pose(), i) - machine.centre(machine.home_pose(), 0)).norm());
  return size > 0 ? size : 1;
}

class Search {
 public:
  Search(std::span<const std::unique_ptr<Machine>> words, const VectorXd& actuators, const std::vector<AssemblyMode>& modes)
      : words_(words),
        machine_(*words.front()),
        actuators_(actuators),
        modes_(modes),
        length_(characteristic_length(machine_)),
        platform_(static_cast<std::size_t>(machine_.topology().platform)),
        size_(size_of(machine_)),
        equations_(machine_, size_),
        closure_(machine_) {
    shares();
  }
  JointSearch run(const Pose& reference, int starts);

 private:
  using Bodies = std::vector<BodyState>;

  void shares();
  Bodies start();
  std::optional<double> close(Bodies& bodies, int held) const;
  std::optional<VectorXd> fit(const Machine& m, const BodyState& platform, VectorXd q, double most) const;
  std::optional<std::pair<std::size_t, VectorXd>> expressed(const BodyState& platform) const;
  double apart(const BodyState& a, const Vector3d& origin, const Matrix3d& rotation) const {
    return std::hypot((a.origin - origin).norm(), length_ * Eigen::AngleAxisd(Matrix3d(a.rotation.transpose() * rotation)).angle());
  }

  std::span<const std::unique_ptr<Machine>> words_;
  const Machine& machine_;
  const VectorXd& actuators_;
  const std::vector<AssemblyMode>& modes_;
  double length_;
  std::size_t platform_;
  double size_;
  LoopEquations equations_;
  Closure closure_;
  std::vector<double> share_;  // of the platform's displacement that a body takes part in
  std::mt19937_64 random_{1};
};

// By the number of joints between a body and the base, and the platform.
void Search::shares() {
  const Topology& t = machine_.topology();
  const auto joints_from = [&](std::size_t first) {
    std::vector<int> steps(t.bodies.size(), -1);
    std::deque<std::size_t> next{first};
    steps[first] = 0;
    for (; !next.empty(); next.pop_front())
      for (const Joint& j : t.joints) {
        const auto a = static_cast<std::size_t>(j.a), b = static_cast<std::size_t>(j.b);
        if (a != next.front() && b != next.front()) continue;
        const std::size_t other = a == next.front() ? b : a;
        if (steps[other] >= 0) continue;
        steps[other] = steps[next.front()] + 1;
        next.push_back(other);
      }
    return steps;
  };
  const std::vector<int> from_base = joints_from(0), from_platform = joints_from(platform_);
  for (std::size_t i = 0; i < t.bodies.size(); ++i)
    share_.push_back(from_base[i] <= 0 ? 0 : static_cast<double>(from_base[i]) / (from_base[i] + std::max(0, from_platform[i])));
}

Search::Bodies Search::start() {
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto anywhere = [&] { return Vector3d(unit(random_), unit(random_), unit(random_)); };
  const Pose& from = modes_.empty() ? machine_.home_pose() : modes_[random_() % modes_.size()].pose;
  Bodies bodies = bodies_at_rest(machine_, from);
  const Vector3d pivot = bodies[platform_].origin;
  Vector3d way = 2 * size_ * std::abs(unit(random_)) * anywhere();
  if (random_() % 2 == 0) way -= pivot;  // about the base's origin: as far from a mode as from what mirrors it
  Vector3d axis = anywhere();
  while (!(axis.norm() > 0.1 && axis.norm() <= 1)) axis = anywhere();
  const double angle = std::numbers::pi * unit(random_);
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    const Matrix3d part = Eigen::AngleAxisd(share_[i] * angle, axis.normalized()).toRotationMatrix();
    bodies[i].origin = pivot + part * (bodies[i].origin - pivot) + share_[i] * way;
    bodies[i].rotation = part * bodies[i].rotation;
  }
  return bodies;
}

// To where all joints close and the actuators have their values; what is left of the equations. The platform stands still in the first so
// many steps, while the limbs go to where they are least apart from it: then it does not follow limbs that point elsewhere.
std::optional<double> Search::close(Bodies& bodies, int held) const {
  double best = std::numeric_limits<double>::infinity();
  for (int k = 0; k < held + newton_steps; ++k) {
    LoopEquations::Value v = equations_.at(bodies, actuators_);
    const double miss = v.error.lpNorm<Eigen::Infinity>();
    if (!std::isfinite(miss)) return {};
    if (miss <= converged || (best <= mode_error && miss >= best)) {
      best = miss;
      break;
    }
    best = miss;
    if (k < held) v.slope.middleCols(6 * static_cast<Eigen::Index>(platform_) - 6, 6).setZero();
    VectorXd step = linear::least_norm_solution(v.slope, -v.error, truncated_pivot);
    if (const double most = step.lpNorm<Eigen::Infinity>(); most > longest) step *= longest / most;
    equations_.displace(bodies, step);
  }
  if (!(best <= mode_error)) return {};
  const ClosureError e = closure_.error(bodies);
  if (!(e.gap <= 100 * mode_error * size_ && e.misalignment <= misaligned)) return {};
  return best;
}

// Coordinates, by Gauss and Newton's method from a guess, at which a machine's platform stands there and its actuators have their values.
// Steps are no longer than `most`: short ones stay where the pose can be assembled, one long step gets across where it cannot.
std::optional<VectorXd> Search::fit(const Machine& m, const BodyState& platform, VectorXd q, double most) const {
  const Topology& t = m.topology();
  const auto n = static_cast<Eigen::Index>(m.dof());
  const std::size_t components = m.components(PM_PARTIALS), first = m.layout().body(t.platform);
  VectorXd scale(n), target(12);
  for (Eigen::Index j = 0; j < n; ++j) scale(j) = t.coordinates[static_cast<std::size_t>(j)].sense() == Sense::rotary ? 1 : size_;
  target << platform.origin / size_, platform.rotation.row(0).transpose(), platform.rotation.row(1).transpose(),
      platform.rotation.row(2).transpose();
  std::vector<double> placement(m.layout().size() * components);
  for (int k = 0; k < 30; ++k) {
    if (m.place(PM_PARTIALS, 1, q.data(), placement.data()) != PM_OK) return {};
    VectorXd error = target;
    Eigen::MatrixXd slope(12, n);
    for (Eigen::Index i = 0; i < 12; ++i) {
      const double* at = placement.data() + (first + static_cast<std::size_t>(i)) * components;
      const double by = i < 3 ? 1 / size_ : 1;
      error(i) -= at[0] * by;
      for (Eigen::Index j = 0; j < n; ++j) slope(i, j) = at[1 + j] * by * scale(j);
    }
    if (!error.allFinite() || !slope.allFinite()) return {};
    if (error.norm() < fitted) {
      for (Eigen::Index i = 0; i < n; ++i) {
        const double off = actuators_(i) - placement[m.layout().actuator(static_cast<int>(i)) * components];
        const bool turns = t.actuators[static_cast<std::size_t>(i)].sense() == Sense::rotary;
        if (!(std::abs(turns ? std::remainder(off, 2 * std::numbers::pi) : off / size_) < std::sqrt(fitted))) return {};
      }
      return q;
    }
    VectorXd step = linear::least_norm_solution(slope, error, truncated_pivot);
    if (const double longest_of = step.lpNorm<Eigen::Infinity>(); longest_of > most) step *= most / longest_of;
    q += step.cwiseProduct(scale);
  }
  return {};
}

// Where `place` has the platform there, in any working mode: from home, and from the modes nearest to it.
std::optional<std::pair<std::size_t, VectorXd>> Search::expressed(const BodyState& platform) const {
  std::vector<std::pair<double, std::size_t>> near;
  for (std::size_t k = 0; k < modes_.size(); ++k)
    near.emplace_back(apart(platform, machine_.origin(modes_[k].pose, static_cast<int>(platform_)),
                            machine_.rotation(modes_[k].pose, static_cast<int>(platform_))),
                      k);
  std::ranges::sort(near);
  near.resize(std::min(near.size(), guesses));
  for (std::size_t w = 0; w < words_.size(); ++w)
    for (const double most : {longest, std::numeric_limits<double>::infinity()}) {
      if (auto q = fit(*words_[w], platform, words_[w]->home(), most)) return std::pair{w, *q};
      for (const auto& [distance, k] : near)
        if (auto q = fit(*words_[w], platform, modes_[k].coordinates, most)) return std::pair{w, *q};
    }
  return {};
}

JointSearch Search::run(const Pose& reference, int starts) {
  JointSearch found;
  FurtherModes& out = found.further;
  std::vector<BodyState> known;  // places of the platform that `place` has
  for (const AssemblyMode& m : modes_) known.push_back(bodies_at_rest(machine_, m.pose)[platform_]);
  std::vector<bool> reached(known.size(), false);
  for (; out.starts < starts; ++out.starts) {
    Bodies bodies = start();
    const std::optional<double> error = close(bodies, random_() % 2 == 0 ? 12 : 0);
    if (!error) continue;
    ++out.arrivals;
    const BodyState& platform = bodies[platform_];
    const auto old =
        std::ranges::find_if(known, [&](const BodyState& k) { return apart(platform, k.origin, k.rotation) < same * length_; });
    if (old != known.end()) {
      reached[static_cast<std::size_t>(old - known.begin())] = true;
      continue;
    }
    if (std::ranges::any_of(out.poses, [&](const FurtherPose& f) { return apart(platform, f.origin, f.rotation) < same * length_; }))
      continue;
    if (auto mode = expressed(platform)) {
      known.push_back(platform);
      reached.push_back(true);
      found.expressed.push_back(std::move(*mode));
      continue;
    }
    FurtherPose pose{platform.origin, platform.rotation, 0, *error, true};
    const Eigen::MatrixXd null = linear::null_space(equations_.at(bodies, actuators_).slope);
    if (null.cols() > 0) {
      const Eigen::MatrixXd of_platform = null.middleRows(6 * static_cast<Eigen::Index>(platform_) - 6, 6);
      pose.isolated = !(of_platform.norm() > linear::part_tolerance);
    }
    if (reference.status == PM_OK)
      pose.distance = apart(platform, machine_.origin(reference, machine_.topology().platform),
                            machine_.rotation(reference, machine_.topology().platform));
    out.poses.push_back(pose);
  }
  out.seen = static_cast<int>(std::ranges::count(reached, true));
  std::ranges::stable_sort(out.poses, {}, &FurtherPose::distance);
  return found;
}

}  // namespace

JointSearch search_joints(std::span<const std::unique_ptr<Machine>> words, const VectorXd& actuators, const VectorXd& reference,
                          const std::vector<AssemblyMode>& known, int starts) {
  Search search(words, actuators, known);
  return search.run(words.front()->pose({reference.data(), static_cast<std::size_t>(reference.size())}), starts);
}

}  // namespace pmreport::mechanics
