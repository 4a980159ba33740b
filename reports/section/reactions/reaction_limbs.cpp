// What the limbs exert on the platform, and what a 6 x 6 formula takes them to exert.
//
// The overall Jacobian G of a mechanism tells what massless limbs can exert on the platform: a multiple of each of its rows. Fed with all
// that the platform needs, w = inertia - load - weight, G^T f = w gives one force f_i for each actuator and each constraint wrench, and
// with limbs that have mass their sum is still right. Yet such a limb is no two-force member: its weight and inertia come out at both of
// its ends, in directions that no row of G has. What one limb exerts on the platform is then not its rows times f, and the constraint force
// that the formula gives is not the force of any joint.
#include <reports/section/common/plots.hpp>
#include <reports/section/common/screw_words.hpp>
#include <reports/section/common/words.hpp>
#include <reports/section/reactions/reactions.hpp>

#include <core/mechanics/model/closed_form.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace pmreport::section {

using document::Paragraph;
using Eigen::Index;
using mechanics::Vector6d;

namespace {

std::string limbs_words(const std::vector<int>& limbs) {
  std::vector<std::string> names;
  for (const int n : limbs) names.push_back(std::to_string(n));
  return limbs.size() == 1 ? "limb " + names[0] : "limbs " + listed(names) + " together";
}

double size_of(const Vector6d& w, double length) { return std::max(w.head<3>().norm(), w.tail<3>().norm() / length); }

// Between the platform and a body of no limb.
bool is_beside_limbs(const Topology& t, const Joint& joint) {
  if (joint.a != t.platform && joint.b != t.platform) return false;
  return t.bodies[static_cast<std::size_t>(joint.a == t.platform ? joint.b : joint.a)].limb == 0;
}

// Of the joints that stand between the platform and a body of no limb: what they and their actuators exert on the platform, about its
// reference point.
Vector6d beside_limbs(const Analysis& a, const mechanics::State& state, int sample) {
  const Topology& t = a.machine().topology();
  const auto k = static_cast<std::size_t>(sample);
  Vector6d out = Vector6d::Zero();
  for (std::size_t j = 0; j < t.joints.size(); ++j) {
    const Joint& joint = t.joints[j];
    if (!is_beside_limbs(t, joint)) continue;
    Vector6d w = Vector6d::Zero();
    for (int c = 0; c < (joint.kind == JointKind::spherical ? 3 : 6); ++c) w(c) = a.column(analysis::reaction_column(joint, c, true))[k];
    for (const Actuator& x : t.actuators)
      if (x.joint == static_cast<int>(j))
        w.segment<3>(x.unit == "m" ? 0 : 3) += a.column(x.name + "_dynamic_force")[k] * state.joints[j].axis[0];
    w.tail<3>() += (state.joints[j].centre - state.bodies[static_cast<std::size_t>(t.platform)].origin).cross(w.head<3>());
    out += joint.b == t.platform ? w : Vector6d(-w);
  }
  return out;
}

}  // namespace

LimbWrenches::LimbWrenches(const Analysis& a, const std::vector<int>& checked) : a_(a) {
  const Topology& t = a.machine().topology();
  for (const Joint& joint : t.joints)
    if (joint.a == t.platform || joint.b == t.platform)
      if (const int limb = t.bodies[static_cast<std::size_t>(joint.a == t.platform ? joint.b : joint.a)].limb; limb > 0)
        limbs_.push_back(limb);
  std::sort(limbs_.begin(), limbs_.end());
  limbs_.erase(std::unique(limbs_.begin(), limbs_.end()), limbs_.end());

  doubtful_.assign(limbs_.empty() ? 0 : static_cast<std::size_t>(limbs_.back()), 0);
  for (const int sample : checked) {
    const mechanics::State state = state_of(a, sample);
    for (const auto& stress : self_stresses(a.machine(), state, generic_model(a.machine(), state))) {
      mechanics::JointReactions r;
      r.actuator_forces = Eigen::VectorXd::Zero(a.machine().dof());
      r.joints = at_joints(state, stress);
      double largest = 0;
      for (const Vector6d& w : r.joints) largest = std::max(largest, size_of(w, a.length()));
      const std::vector<Vector6d> shares = limb_wrenches(a.machine(), state, r);
      for (std::size_t i = 0; i < shares.size() && i < doubtful_.size(); ++i)
        for (int c = 0; c < 6; ++c)
          if (std::abs(shares[i](c)) > 1e-7 * largest * (c < 3 ? 1 : a.length())) doubtful_[i] |= 1U << c;
    }
  }
  judge();
}

Vector6d LimbWrenches::bodies(int limb, int sample) const {
  Vector6d w;
  for (int c = 0; c < 6; ++c) w(c) = a_.column(analysis::limb_column(limb, c))[static_cast<std::size_t>(sample)];
  return w;
}

// Limbs that carry an actuator's force to the platform: that of its joint, or those that stand on the body of no limb that it drives.
std::vector<int> LimbWrenches::carriers(int actuator) const {
  const Topology& t = a_.machine().topology();
  const auto limb_of = [&](int body) { return t.bodies[static_cast<std::size_t>(body)].limb; };
  const Joint& driven = t.joints[static_cast<std::size_t>(t.actuators[static_cast<std::size_t>(actuator)].joint)];
  std::vector<int> out, reached;
  for (const int body : {driven.a, driven.b}) {
    if (limb_of(body) > 0) out.push_back(limb_of(body));
    if (limb_of(body) == 0 && body != 0 && body != t.platform) reached.push_back(body);
  }
  for (std::size_t next = 0; next < reached.size(); ++next)
    for (const Joint& joint : t.joints) {
      if (joint.a != reached[next] && joint.b != reached[next]) continue;
      const int other = joint.a == reached[next] ? joint.b : joint.a;
      if (limb_of(other) > 0)
        out.push_back(limb_of(other));
      else if (other != 0 && other != t.platform && std::find(reached.begin(), reached.end(), other) == reached.end())
        reached.push_back(other);
    }
  return out;
}

// Limbs that hold the same constraint wrench share it, and so do those that stand on one driven body its force: only together do they exert
// the rows of G.
std::vector<LimbWrenches::Group> LimbWrenches::groups(int sample) const {
  const mechanics::Machine& machine = a_.machine();
  const mechanics::State state = state_of(a_, sample);
  const std::vector<mechanics::LimbSystem> systems = limb_systems(machine, state, generic_model(machine, state));
  if (std::any_of(systems.begin(), systems.end(), [](const auto& l) { return !l.alone; })) return {};
  const mechanics::ClosedForm c = closed_form(machine, state, a_.length());

  const auto dof = static_cast<std::size_t>(machine.dof());
  std::vector<std::vector<int>> carried;
  for (int i = 0; i < machine.dof(); ++i) carried.push_back(carriers(i));
  std::vector<std::vector<std::size_t>> holders(6);  // of each row of G: indices into systems
  for (std::size_t i = 0; i < systems.size(); ++i)
    for (std::size_t row = 0; row < 6; ++row) {
      const bool holds = row < dof ? std::find(carried[row].begin(), carried[row].end(), systems[i].limb) != carried[row].end()
                                   : outside({systems[i].constraints.origin, c.jacobian.row(static_cast<Index>(row)).transpose()},
                                             systems[i].constraints, a_.length()) < 1e-6;
      if (holds) holders[row].push_back(i);
    }
  std::vector<std::size_t> root(systems.size());  // of each limb the group that it belongs to
  for (std::size_t i = 0; i < root.size(); ++i) root[i] = i;
  for (const auto& together : holders)
    for (const std::size_t i : together) {
      const std::size_t from = root[i], to = root[together.front()];
      std::replace(root.begin(), root.end(), from, to);
    }
  std::vector<Group> out;
  for (std::size_t g = 0; g < root.size(); ++g) {
    Group group;
    for (std::size_t i = 0; i < root.size(); ++i)
      if (root[i] == g) group.limbs.push_back(systems[i].limb);
    bool constrains = false;
    for (std::size_t row = 0; row < 6; ++row)
      if (!holders[row].empty() && root[holders[row].front()] == g) group.rows.push_back(static_cast<int>(row)), constrains |= row >= dof;
    if (constrains) out.push_back(std::move(group));
  }
  return out;
}

void LimbWrenches::judge() {
  const mechanics::Machine& machine = a_.machine();
  const Topology& t = machine.topology();
  const std::vector<int> first = samples_with_forces(a_, 1);
  if (first.empty()) return;
  // What is shared with a joint that belongs to no limb cannot be allotted to the limbs.
  const bool limbs_alone = std::none_of(t.joints.begin(), t.joints.end(), [&](const Joint& joint) { return is_beside_limbs(t, joint); });
  const std::vector<Group> together = t.constraints.empty() || !limbs_alone ? std::vector<Group>{} : groups(first.front());
  mechanics::Loading loading;
  loading.gravity = a_.scenario().load.gravity;
  double largest_difference = 0;
  for (const int k : samples_with_forces(a_, a_.samples())) {
    const mechanics::State state = state_of(a_, k);
    loading.platform << a_.scenario().load.force[static_cast<std::size_t>(k)], a_.scenario().load.moment[static_cast<std::size_t>(k)];
    const Index at = 6 * t.platform - 6;
    const Vector6d inertia = inertial_wrenches(machine, state).segment<6>(at),
                   applied = applied_wrenches(machine, state, loading).segment<6>(at);
    Vector6d sum = applied - inertia + beside_limbs(a_, state, k);
    double scale = std::max(size_of(inertia, a_.length()), size_of(applied, a_.length()));
    for (const int limb : limbs_) {
      sum += bodies(limb, k);
      scale = std::max(scale, size_of(bodies(limb, k), a_.length()));
    }
    const double residual = scale > 0 ? size_of(sum, a_.length()) / scale : 0;
    if (!(residual <= imbalance_)) imbalance_ = residual;

    if (together.empty()) continue;
    const mechanics::ClosedForm c = closed_form(machine, state, a_.length());
    const Vector6d f = closed_statics(c, applied - inertia);
    for (const Group& g : together) {
      Vector6d formula = Vector6d::Zero(), actual = Vector6d::Zero();
      for (const int row : g.rows) formula += c.jacobian.row(row).transpose() * f(row);
      for (const int limb : g.limbs) actual += bodies(limb, k);
      const double difference = size_of(actual - formula, a_.length());
      if (difference <= largest_difference) continue;
      largest_difference = difference;
      difference_ = difference / std::max(size_of(actual, a_.length()), size_of(formula, a_.length()));
      worst_ = g, worst_sample_ = k, by_formula_ = formula, by_bodies_ = actual;
      constraints_.clear();
      for (const int row : g.rows)
        if (row >= machine.dof()) constraints_.emplace_back(row, f(row));
    }
  }
}

figure::Figure LimbWrenches::figure() const {
  figure::Figure f{"limb-wrenches",
                   "What each limb exerts on the platform: force, and moment about the reference point, in base axes.",
                   "data/reactions.csv",
                   figure::Width::full,
                   2,
                   {}};
  bool any_doubtful = false;
  for (const int axis : {0, 1, 2})
    for (const int c : {axis, axis + 3}) {
      std::vector<Curve> curves;
      for (const int limb : limbs_) {
        curves.push_back({analysis::limb_column(limb, c), fmt::format("limb {}{}", limb, doubtful(limb, c) ? least_norm_mark : "")});
        any_doubtful |= doubtful(limb, c);
      }
      f.panels.push_back(panel(a_, fmt::format("{} along {}", c < 3 ? "force" : "moment", "XYZ"[axis]), c < 3 ? "force" : "moment",
                               c < 3 ? "N" : "N*m", curves));
    }
  if (any_doubtful) f.caption += fmt::format(" {} marks least-norm values.", least_norm_mark);
  return f;
}

document::Table LimbWrenches::table() const {
  std::vector<JointLoad::Size> forces, moments;
  double force = 0, moment = 0;
  for (const int limb : limbs_) {
    JointLoad::Size f, m;
    for (int k = 0; k < a_.samples(); ++k) {
      const Vector6d w = bodies(limb, k);
      if (const double x = w.head<3>().norm(); x > f.peak || (f.sample < 0 && std::isfinite(x))) f.peak = x, f.sample = k;
      if (const double x = w.tail<3>().norm(); x > m.peak || (m.sample < 0 && std::isfinite(x))) m.peak = x, m.sample = k;
    }
    forces.push_back(f), moments.push_back(m);
    force = std::max(force, f.peak), moment = std::max(moment, m.peak);
  }
  const DisplayUnit in = display_unit("N", force), about = display_unit("N*m", moment);
  document::Table out{"Largest wrenches of the limbs on the platform.",
                      {"limb", "force [" + in.label + "]", "at", "moment [" + about.label + "]", "at"},
                      {true, true, true, true, true},
                      {}};
  for (std::size_t i = 0; i < limbs_.size(); ++i) {
    const unsigned bits = doubtful_[static_cast<std::size_t>(limbs_[i] - 1)];
    const auto cells = [&](const JointLoad::Size& s, const DisplayUnit& unit, bool mark) {
      return std::vector<std::string>{s.sample < 0 ? "–" : (mark ? least_norm_mark : "") + typeset(format_number(s.peak * unit.per_si, 4)),
                                      s.sample < 0 ? "–" : show_time(a_, s.sample)};
    };
    std::vector<std::string> row{std::to_string(limbs_[i])};
    for (const std::string& cell : cells(forces[i], in, (bits & 7) != 0)) row.push_back(cell);
    for (const std::string& cell : cells(moments[i], about, (bits & 56) != 0)) row.push_back(cell);
    out.rows.push_back(std::move(row));
  }
  return out;
}

std::vector<document::Block> LimbWrenches::formula() const {
  if (worst_sample_ < 0 || difference_ < 1e-6) return {};
  const Topology& t = a_.machine().topology();
  std::vector<std::string> values;
  for (const auto& [row, value] : constraints_) {
    const Constraint& c = t.constraints[static_cast<std::size_t>(row - a_.machine().dof())];
    values.push_back(fmt::format("{} = {}", c.name, show(value, c.unit)));
  }
  const bool one = constraints_.size() == 1;
  std::vector<document::Block> out;
  out.push_back(Paragraph{
      Paragraph::Tone::note,
      fmt::format("A constraint wrench is not the reaction of a joint. The 6 × 6 formula G⁻ᵀ, with which section statics finds {}, takes "
                  "every limb for massless, so that it can exert on the platform only what the rows of G say. A limb with mass hands its "
                  "own weight and inertia on to the platform as well, in other directions. The sum over all limbs is the same, and so "
                  "are the totals that the platform feels; what a single limb exerts, and so what its joints carry, is another. They "
                  "differ most at t = {} in {}, by {} % of the wrench: fed with load, weight and inertia of the platform, the formula "
                  "gives {}. Choose bearings by the reactions in this section, not by {}.",
                  one ? "it" : "them", show_time(a_, worst_sample_), limbs_words(worst_.limbs), format_number(100 * difference_, 3),
                  listed(values), one ? "this number" : "these numbers")});
  const DisplayUnit force = display_unit("N", std::max(by_formula_.head<3>().norm(), by_bodies_.head<3>().norm())),
                    moment = display_unit("N*m", std::max(by_formula_.tail<3>().norm(), by_bodies_.tail<3>().norm()));
  document::Table table{fmt::format("What {} on the platform at t = {}, base axes; forces in {}, moments about the reference point in {}.",
                                    limbs_words(worst_.limbs) + (worst_.limbs.size() == 1 ? " exerts" : " exert"),
                                    show_time(a_, worst_sample_), force.label, moment.label),
                        {"by", "force X", "Y", "Z", "moment X", "Y", "Z"},
                        {false, true, true, true, true, true, true},
                        {}};
  const auto add = [&](const std::string& by, const Vector6d& w) {
    std::vector<std::string> row{by};
    for (int c = 0; c < 6; ++c) {
      const double largest = c < 3 ? w.head<3>().norm() : w.tail<3>().norm();
      row.push_back(typeset(format_number(rounded(w(c), largest) * (c < 3 ? force : moment).per_si, 4)));
    }
    table.rows.push_back(std::move(row));
  };
  add("6 × 6 formula, massless limbs", by_formula_);
  add("Newton and Euler on every body", by_bodies_);
  add("difference", by_bodies_ - by_formula_);
  out.push_back(std::move(table));
  return out;
}

document::Evidence LimbWrenches::platform_in_balance() const {
  // Rounding of a few sums of columns; the reactions themselves are good to 1e-10 or better.
  return {"The limbs carry the platform",
          "wrenches of all limbs, load and weight against the platform's own inertia, largest over the samples, relative to the largest of "
          "them",
          imbalance_, 1e-9, ""};
}

}  // namespace pmreport::section
