#include <core/mechanics/assembly/assembly.hpp>

#include <core/linear/square.hpp>
#include <core/mechanics/assembly/further.hpp>
#include <core/mechanics/assembly/search.hpp>
#include <core/mechanics/model/closure.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/numbers.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <ranges>
#include <tuple>

namespace pmreport::mechanics {

namespace {

// Every combination of the words of the working-mode choices, the machine's own first.
std::vector<WorkingMode> working_modes(const Machine& machine, bool all) {
  std::vector<WorkingMode> out;
  out.push_back({machine.with(machine.values()), ""});
  std::vector<std::size_t> choices;
  const auto& parameters = machine.info().parameters;
  for (std::size_t i = 0; all && i < parameters.size(); ++i)
    if (parameters[i].working_mode) choices.push_back(i);
  // Counting in a number system whose digits are the words, from the machine's own word as zero.
  std::vector<std::size_t> digits(choices.size(), 0);
  while (true) {
    std::size_t d = 0;
    for (; d < digits.size(); ++d) {
      if (++digits[d] < parameters[choices[d]].choices.size()) break;
      digits[d] = 0;
    }
    if (d == digits.size()) return out;
    ParameterValues values = machine.values();
    std::vector<std::pair<std::string, std::string>> names;  // words, and the choices that they answer
    for (std::size_t k = 0; k < choices.size(); ++k) {
      if (digits[k] == 0) continue;
      const ParameterInfo& p = parameters[choices[k]];
      const std::size_t word = (static_cast<std::size_t>(values[choices[k]][0]) + digits[k]) % p.choices.size();
      values[choices[k]] = {static_cast<double>(word)};
      const auto at = std::ranges::find(names, p.choices[word], &std::pair<std::string, std::string>::first);
      if (at == names.end())
        names.emplace_back(p.choices[word], p.name);
      else
        at->second += ", " + p.name;
    }
    std::string name;
    if (names.size() == 1 && choices.size() > 1 && std::ranges::find(digits, std::size_t{0}) == digits.end())
      name = "all " + names.front().first;
    else
      for (const auto& [word, answered] : names) name += (name.empty() ? "" : "; ") + answered + " " + word;
    try {
      out.push_back({machine.with(std::move(values)), name});
    } catch (const MechanismError&) {
      // This combination has no home pose, or the mechanism does not know it.
    }
  }
}

// Angles of an orientation have two names, such as (a, b, c) and (a + pi, pi - b, c + pi): the mode takes the one with the smaller angles,
// and half a turn the positive sign. Which angle is the middle one is not known, so each is tried, and the name kept if it places the same
// bodies.
void name_plainly(const Machine& m, AssemblyMode& mode, double tolerance) {
  const auto& declared = m.topology().coordinates;
  const auto is_angle = [&](Eigen::Index i) { return declared[static_cast<std::size_t>(i)].sense() == Sense::rotary; };
  const auto length = [&](const Eigen::VectorXd& q) {
    double sum = 0;
    for (Eigen::Index i = 0; i < q.size(); ++i) sum += is_angle(i) ? std::abs(q(i)) : 0;
    return sum;
  };
  for (Eigen::Index middle = 0; middle < mode.coordinates.size(); ++middle)
    for (const double mirror : {pi, 0.0}) {
      if (!is_angle(middle)) continue;
      Eigen::VectorXd q = mode.coordinates;
      for (Eigen::Index i = 0; i < q.size(); ++i)
        if (is_angle(i)) q(i) = std::remainder(i == middle ? mirror - q(i) : q(i) + pi, 2 * pi);
      if (!(length(q) < length(mode.coordinates) - 1e-6)) continue;
      const Pose pose = m.pose({q.data(), static_cast<std::size_t>(q.size())});
      if (pose.status != PM_OK || !AssemblySearch::same_bodies(m, pose, mode.pose, tolerance)) continue;
      mode.coordinates = q;
      mode.pose = pose;
    }
  for (Eigen::Index i = 0; i < mode.coordinates.size(); ++i)
    if (is_angle(i) && mode.coordinates(i) < -pi + 1e-9) mode.coordinates(i) += 2 * pi;
}

bool within_limits(const Machine& machine, const Closure& closure, const std::vector<BodyState>& bodies, const Pose& pose) {
  const Topology& t = machine.topology();
  const auto keeps = [](double x, const Range& r) {  // a limit met exactly is kept: rounding may not break it
    const double slack = 1e-9 * std::max({1.0, std::abs(r.min), std::abs(r.max)});
    return x >= r.min - slack && x <= r.max + slack;
  };
  for (std::size_t i = 0; i < t.actuators.size(); ++i)
    if (!keeps(pose.numbers[machine.layout().actuator(static_cast<int>(i))], t.actuators[i].stroke)) return false;
  for (std::size_t j = 0; j < t.joints.size(); ++j) {
    if (t.joints[j].kind == JointKind::prismatic) continue;
    const std::vector<double> motion = closure.motion(bodies, static_cast<int>(j));
    for (std::size_t k = 0; k < t.joints[j].limits.size(); ++k)
      if (!keeps(motion[k], t.joints[j].limits[k])) return false;
  }
  return true;
}

// Its pose nearest to another, and the one that is farthest from that.
void measure(ModeContinuum& c, const Machine& m, const Pose& there, double length) {
  const auto best = [&](const Pose& from, auto better) {
    std::pair<double, std::size_t> out{distance(m, c.poses.front(), from, length), 0};
    for (std::size_t k = 1; k < c.poses.size(); ++k)
      if (const double d = distance(m, c.poses[k], from, length); better(d, out.first)) out = {d, k};
    return out;
  };
  if (there.status == PM_OK) std::tie(c.distance, c.nearest) = best(there, std::less{});
  std::tie(c.extent, c.farthest) = best(c.poses[c.nearest], std::greater{});
}

// What is told of each mode, and their order. The closure is that of the machine asked about, so that a mode in another working mode is a
// pose of the same bodies with the same joints.
void judge(AssemblyModes& found, const AssemblyTarget& target, const Eigen::VectorXd& reference) {
  const Machine& own = target.machine(0);
  const double length = characteristic_length(own);
  const Pose there = own.pose({reference.data(), static_cast<std::size_t>(reference.size())});
  const Closure closure(own);
  for (AssemblyMode& mode : found.modes) {
    const Machine& m = target.machine(mode.word);
    name_plainly(m, mode, AssemblySearch::same_placement * target.size());
    mode.residual = target.error(Eigen::Map<const Eigen::VectorXd>(mode.pose.numbers.data() + m.layout().actuator(0), m.dof()))
                        .lpNorm<Eigen::Infinity>();
    mode.determinant = linear::determinant(m.jacobian(mode.pose).matrix);
    mode.distance = there.status == PM_OK ? distance(m, mode.pose, there, length) : 0;
    const std::vector<BodyState> bodies = bodies_at_rest(m, mode.pose);
    const ClosureError error = closure.error(bodies);
    mode.gap = error.gap / target.size();
    mode.misalignment = error.misalignment;
    mode.within_limits = within_limits(own, closure, bodies, mode.pose);
  }
  std::ranges::stable_sort(found.modes, {}, &AssemblyMode::distance);
  for (ModeContinuum& c : found.continua) measure(c, target.machine(c.word), there, length);
  std::ranges::stable_sort(found.continua, {}, &ModeContinuum::distance);
}

// Combinations of the words of all working-mode choices.
std::size_t all_words(const Machine& machine) {
  std::size_t n = 1;
  for (const ParameterInfo& p : machine.info().parameters)
    if (p.working_mode) n *= p.choices.size();
  return n;
}

// What the joints alone allow. Modes among it that the search has not found are starts of it, until there are none.
void add_from_joints(AssemblySearch& search, std::span<const std::unique_ptr<Machine>> machines, const Eigen::VectorXd& actuators,
                     const Eigen::VectorXd& reference, int starts, AssemblyModes& found) {
  constexpr int most_rounds = 4;
  int missed = 0, all_starts = 0, all_arrivals = 0;
  for (int round = 0; round < most_rounds; ++round) {
    const std::size_t before = found.modes.size();
    JointSearch joints = search_joints(machines, actuators, reference, found.modes, starts);
    for (const auto& [word, q] : joints.expressed) search.go_on(word, q);
    missed += static_cast<int>(found.modes.size() - before);
    found.further = std::move(joints.further);
    found.further->missed = missed;
    found.further->starts = all_starts += found.further->starts;
    found.further->arrivals = all_arrivals += found.further->arrivals;
    if (found.modes.size() == before) return;
  }
}

}  // namespace

double distance(const Machine& machine, const Pose& a, const Pose& b, double length) {
  const int platform = machine.topology().platform;
  const Eigen::Matrix3d turn = machine.rotation(a, platform).transpose() * machine.rotation(b, platform);
  return std::hypot((machine.origin(a, platform) - machine.origin(b, platform)).norm(), length * Eigen::AngleAxisd(turn).angle());
}

AssemblyModes find_assembly_modes(const Machine& machine, const Eigen::VectorXd& actuators, const Eigen::VectorXd& reference,
                                  const AssemblyOptions& options) {
  AssemblyModes found;
  found.words = working_modes(machine, options.working_modes);
  std::vector<std::unique_ptr<Machine>> machines;
  for (WorkingMode& w : found.words) machines.push_back(std::move(w.machine));
  AssemblySearch search(machines, actuators, options, found);
  search.run(reference);
  if (machine.dof() < 6 && options.joint_starts > 0 && (options.working_modes || found.words.size() == all_words(machine)))
    add_from_joints(search, machines, actuators, reference, options.joint_starts, found);
  search.finish();
  judge(found, search.target(), reference);
  for (std::size_t w = 0; w < machines.size(); ++w) found.words[w].machine = std::move(machines[w]);
  return found;
}

}  // namespace pmreport::mechanics
