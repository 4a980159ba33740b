#include <core/mechanics/reactions/by_limb/planner.hpp>

#include <core/linear/tolerance.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/model/joint_frame.hpp>
#include <core/mechanics/model/random_poses.hpp>
#include <core/mechanics/reactions/by_limb/kernel.hpp>

#include <algorithm>
#include <functional>
#include <numeric>
#include <ranges>

namespace pmreport::mechanics {

namespace {

using Plan = DynamicsPlan;
using Freedom = Plan::Freedom;

// Sets of bodies that are joined to one another, each known by one of its members.
class Sets {
 public:
  explicit Sets(std::size_t bodies) : parent_(bodies) { std::iota(parent_.begin(), parent_.end(), 0); }
  int of(int body) const {
    while (parent_[static_cast<std::size_t>(body)] != body) body = parent_[static_cast<std::size_t>(body)];
    return body;
  }
  bool join(int a, int b) {
    a = of(a), b = of(b);
    parent_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    return a != b;
  }

 private:
  std::vector<int> parent_;
};

class Planner {
 public:
  explicit Planner(const Machine& machine) : machine_(machine), t_(machine.topology()), layout_(machine.layout()) {}

  std::optional<Plan> plan() {
    p_.size = layout_.size();
    p_.platform = t_.platform;
    p_.platform_at = layout_.body(t_.platform);
    p_.bodies = static_cast<int>(t_.bodies.size());
    p_.joints = static_cast<int>(t_.joints.size());
    p_.actuators = static_cast<int>(t_.actuators.size());
    p_.length = characteristic_length(machine_);
    if (!add_masses()) return std::nullopt;
    add_frames();
    if (!add_groups() || !add_actuators()) return std::nullopt;
    count();
    if (!drop_idle()) return std::nullopt;
    count();
    if (p_.open < 6 || std::ranges::any_of(p_.groups, [](const Plan::Group& g) { return g.open() < 0; })) return std::nullopt;
    if (!holds_somewhere()) return std::nullopt;
    return std::move(p_);
  }

 private:
  const Joint& joint(int j) const { return t_.joints[static_cast<std::size_t>(j)]; }
  bool slender(int body) const { return t_.bodies[static_cast<std::size_t>(body)].slender; }
  bool driven(int j) const {
    return std::ranges::any_of(t_.actuators, [&](const Actuator& a) { return a.joint == j; });
  }

  // About its z axis, but for rounding, as a slender body has to be.
  static bool of_revolution(const Inertia& i) {
    constexpr double rounding = 1e-12;
    const Eigen::Matrix3d& a = i.about_centre;
    return i.centre.head<2>().isZero(0) && a.isDiagonal(rounding) && std::abs(a(0, 0) - a(1, 1)) <= rounding * a(0, 0);
  }

  bool add_masses() {
    for (int b = 1; b < p_.bodies; ++b) {
      const Inertia& i = t_.bodies[static_cast<std::size_t>(b)].inertia;
      Plan::Mass m{b, layout_.body(b), slender(b), i.mass, i.centre, Eigen::Matrix3d::Identity() * (i.about_centre.trace() / 2), {}};
      m.moments -= i.about_centre;
      if (m.slender && !of_revolution(i)) return false;
      for (int k = 0; k < 3; ++k)
        m.column[static_cast<std::size_t>(k)] = i.centre(k) != 0 || !m.moments.row(k).isZero(0) || !m.moments.col(k).isZero(0);
      if (m.mass != 0 || !m.moments.isZero(0)) p_.masses.push_back(m);
    }
    return true;
  }

  void add_frames() {
    const JointFrames frames(machine_);
    for (int j = 0; j < p_.joints; ++j) {
      const JointFrames::Recipe& r = frames.recipe(j);
      Plan::Frame f;
      f.along = layout_.joint(j) + 3;
      if (r.stud >= 0) {
        f.along = layout_.body(r.stud) + (slender(r.stud) ? 3 : 5);
        f.along_step = slender(r.stud) ? 1 : 3;
      }
      f.carried = !r.second_axis;
      f.second = r.second_axis ? layout_.joint(j) + 6 : r.carrier > 0 ? layout_.body(r.carrier) + 3 : 0;
      f.mark = r.mark;
      p_.frames.push_back(f);
    }
  }

  // The groups, lowest body first; then the joints between base and platform, each a group of its own without a body.
  bool add_groups() {
    Sets sets(t_.bodies.size());
    const auto between = [&](int body) { return body != 0 && body != t_.platform; };
    for (const Joint& j : t_.joints)
      if (between(j.a) && between(j.b)) sets.join(j.a, j.b);
    for (int b = 1; b < p_.bodies; ++b) {
      if (!between(b) || sets.of(b) != b) continue;
      std::vector<int> joints;
      for (int j = 0; j < p_.joints; ++j)
        for (const int end : {joint(j).a, joint(j).b})
          if (between(end) && sets.of(end) == b) {
            joints.push_back(j);
            break;
          }
      const auto bodies = static_cast<std::size_t>(
          std::ranges::count_if(std::views::iota(1, p_.bodies), [&](int body) { return between(body) && sets.of(body) == b; }));
      if (!add_group(joints, bodies)) return false;
    }
    for (int j = 0; j < p_.joints; ++j)
      if (!between(joint(j).a) && !between(joint(j).b) && !add_group({j}, 0)) return false;
    return true;
  }

  // The tree takes the driven joints first, whose forces it gives, then those with few freedoms: the more freedoms a joint has that is
  // cut, the fewer are unknowns and equations.
  bool add_group(std::vector<int> joints, std::size_t bodies) {
    Plan::Group g;
    g.first_cut = static_cast<int>(p_.cuts.size());
    std::ranges::stable_sort(joints, std::less(), [&](int j) { return driven(j) ? 0 : freedoms_of(joint(j).kind); });
    Sets sets(t_.bodies.size());
    std::vector<int> tree;
    for (const int j : joints) {
      const bool at_platform = joint(j).a == t_.platform || joint(j).b == t_.platform;
      if (!at_platform && sets.join(joint(j).a, joint(j).b))
        tree.push_back(j);
      else if (driven(j))
        return false;
      else
        add_cut(j);
    }
    g.end_cut = static_cast<int>(p_.cuts.size());
    std::vector<int> reached{0};
    for (std::size_t next = 0; next < reached.size(); ++next)
      for (const int j : tree)
        for (const bool forward : {true, false}) {
          const int parent = forward ? joint(j).a : joint(j).b, child = forward ? joint(j).b : joint(j).a;
          if (parent != reached[next] || std::ranges::find(reached, child) != reached.end()) continue;
          g.trees.push_back({j, layout_.joint(j), joint(j).kind, parent, child, forward ? 1.0 : -1.0});
          reached.push_back(child);
        }
    if (g.trees.size() != bodies) return false;  // the platform alone holds some
    for (std::size_t i = 0; i < g.trees.size(); ++i) find_beyond(g, i);
    p_.groups.push_back(std::move(g));
    return true;
  }

  void add_cut(int j) {
    Plan::Cut c{j, layout_.joint(j), joint(j).kind};
    const bool slides = c.kind == JointKind::prismatic || c.kind == JointKind::cylindrical;
    c.forces = slides ? 2 : 3;
    c.couples = 6 - freedoms_of(c.kind) - c.forces;
    c.platform = joint(j).b == t_.platform ? 1 : joint(j).a == t_.platform ? -1 : 0;
    p_.cuts.push_back(c);
  }

  void find_beyond(Plan::Group& g, std::size_t which) const {
    std::vector<int> bodies{g.trees[which].child};
    for (std::size_t i = which + 1; i < g.trees.size(); ++i)  // parents first
      if (std::ranges::find(bodies, g.trees[i].parent) != bodies.end()) bodies.push_back(g.trees[i].child);
    const auto lies = [&](int body) { return std::ranges::find(bodies, body) != bodies.end() ? 1.0 : 0.0; };
    for (int c = g.first_cut; c < g.end_cut; ++c) {
      const Joint& cut = joint(p_.cuts[static_cast<std::size_t>(c)].joint);
      if (const double sign = lies(cut.b) - lies(cut.a); sign != 0) g.trees[which].beyond.push_back({c, sign});
    }
  }

  // Which freedoms are driven, and which transmit nothing. The ball of a slender body has its spine as one direction: if the body can spin
  // idly, that equation, and no other, says nothing.
  bool add_actuators() {
    for (Plan::Group& g : p_.groups)
      for (Plan::Tree& t : g.trees) {
        for (int i = 0; i < p_.actuators; ++i) {
          const Actuator& a = t_.actuators[static_cast<std::size_t>(i)];
          if (a.joint != t.joint) continue;
          int& drives = a.sense() == Sense::linear ? t.push : t.turn;
          if (drives >= 0) return false;
          drives = i;
        }
        const bool slides = t.kind == JointKind::prismatic || t.kind == JointKind::cylindrical;
        if (t.kind == JointKind::spherical) {
          const int leg = slender(t.child) ? t.child : slender(t.parent) ? t.parent : 0;
          t.spine = leg > 0 ? layout_.body(leg) + 3 : 0;
          t.passive = leg > 0 ? std::vector{Freedom::turn_spine, Freedom::turn_across, Freedom::turn_across_both}
                              : std::vector{Freedom::turn_x, Freedom::turn_y, Freedom::turn_z};
          continue;
        }
        if (slides && t.push < 0) t.passive.push_back(Freedom::slide);
        if (t.kind != JointKind::prismatic && t.turn < 0) t.passive.push_back(Freedom::turn);
        if (t.kind == JointKind::universal) t.passive.push_back(Freedom::turn_second);
      }
    return true;
  }

  void count() {
    p_.unknowns = p_.open = p_.most_equations = p_.most_unknowns = 0;
    p_.vector_numbers = 0;
    for (Plan::Group& g : p_.groups) {
      g.first = p_.unknowns;
      g.unknowns = g.equations = 0;
      for (int c = g.first_cut; c < g.end_cut; ++c) {
        Plan::Cut& cut = p_.cuts[static_cast<std::size_t>(c)];
        cut.first = g.first + g.unknowns;
        g.unknowns += cut.unknowns();
      }
      for (const Plan::Tree& t : g.trees) g.equations += static_cast<int>(t.passive.size());
      g.first_open = p_.open;
      g.vectors = p_.vector_numbers;
      p_.unknowns += g.unknowns;
      p_.open += g.open();
      p_.vector_numbers += static_cast<std::size_t>(std::max(0, g.open()) * g.unknowns);
      p_.most_equations = std::max(p_.most_equations, g.equations);
      p_.most_unknowns = std::max(p_.most_unknowns, g.unknowns);
    }
  }

  // Calls f(placement of order PM_JET) at rest, at home and at random poses, until it answers yes.
  template <class F>
  bool at_poses(F&& f) const {
    std::vector<Eigen::VectorXd> poses = random_poses(machine_, 16, 1);
    poses.insert(poses.begin(), machine_.home());
    std::vector<double> placement(3 * p_.size);
    for (const Eigen::VectorXd& q : poses) {
      std::vector<double> jets(3 * static_cast<std::size_t>(q.size()), 0.0);
      for (int i = 0; i < q.size(); ++i) jets[3 * static_cast<std::size_t>(i)] = q(i);
      if (machine_.place(PM_JET, 1, jets.data(), placement.data()) == PM_OK && f(placement.data())) return true;
    }
    return false;
  }

  // Drops the equations that vanish wherever the mechanism is tried: idle spins.
  bool drop_idle() {
    std::vector<double> largest;
    at_poses([&](const double* placement) {
      const std::vector<double> sizes = equation_sizes(p_, placement);
      largest.resize(sizes.size(), 0.0);
      std::ranges::transform(largest, sizes, largest.begin(), [](double a, double b) { return std::max(a, b); });
      return false;
    });
    int dropped = 0;
    auto size = largest.begin();
    for (Plan::Group& g : p_.groups)
      for (Plan::Tree& t : g.trees)
        dropped += static_cast<int>(std::erase_if(t.passive, [&](Freedom) { return *size++ < linear::rank_tolerance; }));
    return dropped == t_.idle;
  }

  // Whether the equations have full rank, at one pose at least.
  bool holds_somewhere() const {
    const DynamicsKernel kernel = DynamicsKernel::single();
    std::vector<double> memory(kernel.memory(p_)), forces(static_cast<std::size_t>(p_.actuators));
    const double loads[6] = {};
    double regularity = 0;
    DynamicsBatch batch;
    batch.loads = loads;
    batch.actuator_forces = forces.data();
    batch.regularity = &regularity;
    return at_poses([&](const double* placement) {
      batch.placement = placement;
      kernel.solve(p_, batch, memory.data());
      return regularity > linear::part_tolerance;
    });
  }

  const Machine& machine_;
  const Topology& t_;
  const Layout& layout_;
  Plan p_;
};

}  // namespace

std::optional<DynamicsPlan> plan_of(const Machine& machine) { return Planner(machine).plan(); }

}  // namespace pmreport::mechanics
