#include <core/mechanics/assembly/further.hpp>

#include <core/linear/least_norm.hpp>
#include <core/linear/subspace.hpp>
#include <core/mechanics/assembly/loops.hpp>
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

constexpr int most_steps = 40;
constexpr double longest = 0.3, truncated = 1e-9;
constexpr double converged = 1e-13, verified = 1e-10;  // errors of the loop equations
constexpr double misaligned = 1e-6;                    // [rad]: an axis turned over is far beyond
constexpr double same = 1e-5;                          // of the characteristic length: two places of the platform that are one

class Search {
 public:
  Search(const Machine& machine, const VectorXd& actuators, const AssemblyModes& found)
      : machine_(machine),
        actuators_(actuators),
        found_(found),
        length_(characteristic_length(machine)),
        platform_(static_cast<std::size_t>(machine.topology().platform)),
        equations_(machine, length_),
        closure_(machine) {
    shares();
  }
  FurtherModes run(const Pose& reference, int starts);

 private:
  using Bodies = std::vector<BodyState>;

  void shares();
  Bodies start();
  std::optional<double> close(Bodies& bodies) const;
  bool expressed(const BodyState& platform) const;
  double apart(const BodyState& a, const Vector3d& origin, const Matrix3d& rotation) const {
    return std::hypot((a.origin - origin).norm(), length_ * Eigen::AngleAxisd(Matrix3d(a.rotation.transpose() * rotation)).angle());
  }

  const Machine& machine_;
  const VectorXd& actuators_;
  const AssemblyModes& found_;
  double length_;
  std::size_t platform_;
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
  const Pose& from = found_.modes.empty() ? machine_.home_pose() : found_.modes[random_() % found_.modes.size()].pose;
  Bodies bodies = bodies_at_rest(machine_, from);
  const Vector3d pivot = bodies[platform_].origin;
  const Vector3d way = length_ * unit(random_) * Vector3d(unit(random_), unit(random_), unit(random_));
  Vector3d axis(unit(random_), unit(random_), unit(random_));
  while (!(axis.norm() > 0.1 && axis.norm() <= 1)) axis = Vector3d(unit(random_), unit(random_), unit(random_));
  const double angle = std::numbers::pi * unit(random_);
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    const Matrix3d turn = Eigen::AngleAxisd(share_[i] * angle, axis.normalized()).toRotationMatrix();
    bodies[i].origin = pivot + turn * (bodies[i].origin - pivot) + share_[i] * way;
    bodies[i].rotation = turn * bodies[i].rotation;
  }
  return bodies;
}

// To where all joints close and the actuators have their values; what is left of the equations.
std::optional<double> Search::close(Bodies& bodies) const {
  double best = std::numeric_limits<double>::infinity();
  for (int k = 0; k < most_steps; ++k) {
    const LoopEquations::Value v = equations_.at(bodies, actuators_);
    const double miss = v.error.lpNorm<Eigen::Infinity>();
    if (!std::isfinite(miss)) return {};
    if (miss <= converged || (best <= verified && miss >= best)) {
      best = miss;
      break;
    }
    best = miss;
    VectorXd step = linear::least_norm_solution(v.slope, -v.error, truncated);
    if (const double most = step.lpNorm<Eigen::Infinity>(); most > longest) step *= longest / most;
    equations_.displace(bodies, step);
  }
  if (!(best <= verified)) return {};
  const ClosureError e = closure_.error(bodies);
  if (!(e.gap <= verified * 100 * length_ && e.misalignment <= misaligned)) return {};
  return best;
}

// Whether `place` has the platform there, with these actuator values, in any working mode: coordinates are fitted to the platform's place.
bool Search::expressed(const BodyState& platform) const {
  for (const WorkingMode& word : found_.words) {
    const Machine& m = *word.machine;
    const auto n = static_cast<Eigen::Index>(m.dof());
    const std::size_t components = m.components(PM_PARTIALS), first = m.layout().body(m.topology().platform);
    const auto is_angle = [&](Eigen::Index j) { return m.topology().coordinates[static_cast<std::size_t>(j)].sense() == Sense::rotary; };
    std::vector<VectorXd> guesses{m.home()};
    for (const AssemblyMode& mode : found_.modes) guesses.push_back(mode.coordinates);
    std::vector<double> placement(m.layout().size() * components);
    VectorXd target(12);
    target << platform.origin / length_, platform.rotation.row(0).transpose(), platform.rotation.row(1).transpose(),
        platform.rotation.row(2).transpose();
    for (VectorXd q : guesses)
      for (int k = 0; k < 30; ++k) {
        if (m.place(PM_PARTIALS, 1, q.data(), placement.data()) != PM_OK) break;
        VectorXd error = target;
        Eigen::MatrixXd slope(12, n);
        for (Eigen::Index i = 0; i < 12; ++i) {
          const double* at = placement.data() + (first + static_cast<std::size_t>(i)) * components;
          const double scale = i < 3 ? 1 / length_ : 1;
          error(i) -= at[0] * scale;
          for (Eigen::Index j = 0; j < n; ++j) slope(i, j) = at[1 + j] * scale * (is_angle(j) ? 1 : length_);
        }
        if (!error.allFinite() || !slope.allFinite()) break;
        if (error.norm() < same) {
          double miss = 0;
          for (Eigen::Index i = 0; i < n; ++i) {
            const double off = actuators_(i) - placement[m.layout().actuator(static_cast<int>(i)) * components];
            const bool turns = m.topology().actuators[static_cast<std::size_t>(i)].sense() == Sense::rotary;
            miss = std::max(miss, std::abs(turns ? std::remainder(off, 2 * std::numbers::pi) : off / length_));
          }
          if (miss < 100 * same) return true;
          break;
        }
        VectorXd step = linear::least_norm_solution(slope, error, truncated);
        if (const double most = step.lpNorm<Eigen::Infinity>(); most > longest) step *= longest / most;
        for (Eigen::Index j = 0; j < n; ++j) q(j) += step(j) * (is_angle(j) ? 1 : length_);
      }
  }
  return false;
}

FurtherModes Search::run(const Pose& reference, int starts) {
  FurtherModes out;
  std::vector<BodyState> known;  // places of the platform that `place` has
  for (const AssemblyMode& m : found_.modes) known.push_back(bodies_at_rest(machine_, m.pose)[platform_]);
  for (; out.starts < starts; ++out.starts) {
    Bodies bodies = start();
    const std::optional<double> error = close(bodies);
    if (!error) continue;
    ++out.arrivals;
    const BodyState& platform = bodies[platform_];
    if (std::ranges::any_of(known, [&](const BodyState& k) { return apart(platform, k.origin, k.rotation) < same * length_; })) continue;
    if (std::ranges::any_of(out.poses, [&](const FurtherPose& f) { return apart(platform, f.origin, f.rotation) < same * length_; }))
      continue;
    if (expressed(platform)) {
      known.push_back(platform);
      ++out.missed;
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
  std::ranges::stable_sort(out.poses, {}, &FurtherPose::distance);
  return out;
}

}  // namespace

FurtherModes find_further_modes(const Machine& machine, const VectorXd& actuators, const VectorXd& reference, const AssemblyModes& found,
                                int starts) {
  Search search(machine, actuators, found);
  return search.run(machine.pose({reference.data(), static_cast<std::size_t>(reference.size())}), starts);
}

}  // namespace pmreport::mechanics
