// Section `reactions`: the wrench in every joint, and how far to trust it.
#include <core/analysis/stiffness/request.hpp>
#include <reports/figure/palette.hpp>
#include <reports/section/common/plots.hpp>
#include <reports/section/common/words/limits.hpp>
#include <reports/section/common/words/singular_words.hpp>
#include <reports/section/common/words/words.hpp>
#include <reports/section/dynamics/dynamics.hpp>
#include <reports/section/mobility/mobility.hpp>
#include <reports/section/reactions/reactions.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <core/mechanics/model/generic_model.hpp>
#include <map>
#include <optional>

namespace pmreport::section {

using document::Paragraph;
using mechanics::Vector6d;

namespace {

constexpr std::size_t most_curves = 12;

int bits(unsigned x) { return __builtin_popcount(x); }

struct Count {
  int components = 0;             // transmitted by all joints
  int doubtful = 0, elastic = 0;  // of these: determined by nothing, determined by elasticity alone
};
Count count(const Analysis& a, const std::vector<JointLoad>& loads) {
  Count n;
  for (std::size_t j = 0; j < loads.size(); ++j) {
    for (int c = 0; c < 6; ++c) n.components += analysis::transmits(a.machine().topology().joints[j].kind, c);
    n.doubtful += bits(loads[j].doubtful);
    n.elastic += bits(loads[j].elastic);
  }
  return n;
}

std::string definition(const Analysis& a) {
  const bool dynamics = a.scenario().asks_for(dynamics_kind());
  return fmt::format(
      "The reaction of a joint is the wrench that its body a exerts on its body b: a force and a moment about the joint's centre, by "
      "Newton "
      "and Euler on every body, {}. The force of an actuator is no part of it{}. Joint axis 1 lies along the joint's own axis, of a ball "
      "along "
      "its leg; 2 and 3 lie across. Data files have base axes too.",
      a.scenario().load.gravity.isZero() ? "with inertia and without weights, for the scenario gives no gravity"
                                         : "with weights and inertia",
      dynamics ? "; it stands in section dynamics" : "");
}

// What elasticity adds, and what the least-norm solution had missed.
std::string elastic_verdict(const Analysis& a, const Count& n) {
  const analysis::ElasticReactions& e = a.elastic_reactions();
  const auto joint = [&](int j) { return a.machine().topology().joints[static_cast<std::size_t>(j)].name; };
  std::string out = fmt::format(
      "Of the {} components that the joints transmit, {} are unique by the balance of the bodies alone. The joints hold the bodies in {} "
      "more "
      "than needed; {} more components are unique by elasticity: of all reactions that balance the loads those with the least energy of "
      "the elastic "
      "elements, {}, are shown.",
      n.components, n.components - n.doubtful - n.elastic, plural(a.self_stresses(), "way"), n.elastic,
      analysis::stiffness_request(a.scenario()) != nullptr ? "which section stiffness lists"
                                                           : "as the mechanism and the scenario declare them");
  std::vector<std::string> missed;
  if (e.force > 0)
    missed.push_back(
        fmt::format("the force in joint {} by {} at t = {}", joint(e.force_joint), show(e.force, "N", 3), show_time(a, e.force_sample)));
  if (e.moment > 0)
    missed.push_back(fmt::format("the moment in joint {} by {} at t = {}", joint(e.moment_joint), show(e.moment, "N*m", 3),
                                 show_time(a, e.moment_sample)));
  if (!missed.empty())
    out += fmt::format(" The solution of least norm, which has no self-stress in it, misses {} at most.", listed(missed, "and"));
  if (n.doubtful > 0)
    out += fmt::format(
        " {} that no element gives energy leave {} components indeterminate, marked {}: shown without those self-stresses, no prediction.",
        plural(e.open, "self-stress", "self-stresses"), n.doubtful, least_norm_mark);
  return out;
}

std::string verdict(const Analysis& a, const Count& n) {
  if (a.elastic_reactions().stresses > 0) return elastic_verdict(a, n);
  if (n.doubtful == 0)
    return fmt::format("All {} components that the joints transmit are unique: the balance of the bodies alone determines them.",
                       n.components);
  return fmt::format(
      "Of the {} components that the joints transmit, {} are unique: the balance of the bodies alone determines them. The other {} are "
      "indeterminate. The joints hold the bodies in {} more than needed, and so reactions that balance one another, self-stresses, can be "
      "in them without any load. Rigid bodies do not tell how much: stiffness, play and the errors of making and mounting decide. What is "
      "shown of such components, marked {}, is the least-norm solution: it has no self-stress in it and is no prediction. Their sums over "
      "the joints that share them are right.",
      n.components, n.components - n.doubtful, n.doubtful, plural(a.self_stresses(), "way"), least_norm_mark);
}

void add_stresses(document::Section& s, const Analysis& a, int sample) {
  const mechanics::State state = state_of(a, sample);
  const std::vector<mechanics::SelfStress> stresses = self_stresses(a.machine(), state, generic_model(a.machine(), state));
  if (stresses.empty()) return;
  document::Table table = stress_table(surroundings(a.machine(), state, a.length()), stresses);
  table.caption = fmt::format(
      "Self-stresses at t = {}: wrenches of any size that the joints may carry beside what is shown, around a loop and back, without a "
      "load.",
      show_time(a, sample));
  s.blocks.push_back(std::move(table));
}

// Sizes of forces or moments against time, a panel for each limb.
class JointFigure {
 public:
  JointFigure(const Analysis& a, const std::vector<JointLoad>& loads, const ReactionsOptions& request, bool moment)
      : a_(a), loads_(loads), moment_(moment) {
    for (int j = 0; j < static_cast<int>(loads.size()); ++j) {
      const bool asked = request.joints.empty() || std::find(request.joints.begin(), request.joints.end(), j) != request.joints.end();
      if (asked && size_of(j).sample >= 0) joints_.push_back(j);
    }
    all_ = joints_.size();
    std::stable_sort(joints_.begin(), joints_.end(), [&](int x, int y) { return size_of(x).peak > size_of(y).peak; });
    if (request.joints.empty() && joints_.size() > most_curves) joints_.resize(most_curves);
    std::sort(joints_.begin(), joints_.end());
  }

  bool any() const { return !joints_.empty(); }

  figure::Figure figure() const {
    constexpr std::size_t few = 4;
    const bool apart = joints_.size() > few;
    figure::Figure f{moment_ ? "joint-moments" : "joint-forces",
                     fmt::format("Size of the {} in the joints{}.", moment_ ? "moments about the joints' centres" : "forces",
                                 apart ? ", limb by limb" : ""),
                     "data/reactions.csv",
                     figure::Width::full,
                     2,
                     {}};
    if (joints_.size() < all_) f.caption += fmt::format(" The {} largest of {}.", joints_.size(), all_);
    std::map<int, std::vector<int>> by_limb;
    for (const int j : joints_) by_limb[apart ? limb_of(j) : 0].push_back(j);
    bool marked = false;
    for (const auto& [limb, joints] : by_limb) {
      f.panels.push_back(panel_of(limb, joints));
      for (const int j : joints) marked |= doubtful(j);
    }
    if (marked) f.caption += fmt::format(" {}, dotted or finely dashed: least-norm values.", least_norm_mark);
    return f;
  }

 private:
  const Joint& joint(int j) const { return a_.machine().topology().joints[static_cast<std::size_t>(j)]; }
  const JointLoad::Size& size_of(int j) const {
    const JointLoad& l = loads_[static_cast<std::size_t>(j)];
    return moment_ ? l.moment : l.force;
  }
  bool doubtful(int j) const {
    const JointLoad& l = loads_[static_cast<std::size_t>(j)];
    return moment_ ? l.doubtful_moment() : l.doubtful_force();
  }
  double limit(int j) const {
    const mechanics::MotionLimits& limits = a_.scenario().limits;
    const std::vector<double>& list = moment_ ? limits.joint_moment : limits.joint_force;
    return list.empty() ? mechanics::MotionLimits::none : list[static_cast<std::size_t>(j)];
  }
  // Where limbs are joined to one another, that of the later one.
  int limb_of(int j) const {
    const auto& bodies = a_.machine().topology().bodies;
    return std::max(bodies[static_cast<std::size_t>(joint(j).a)].limb, bodies[static_cast<std::size_t>(joint(j).b)].limb);
  }

  figure::Panel panel_of(int limb, const std::vector<int>& joints) const {
    const std::string unit = moment_ ? "N*m" : "N", word = moment_ ? "moment" : "force";
    std::vector<Trace> curves;
    for (const int j : joints)
      curves.push_back(
          {column_of(joint(j), moment_ ? OfJoint::moment : OfJoint::force), joint(j).name + (doubtful(j) ? least_norm_mark : "")});
    figure::Panel p = panel(a_,
                            limb > 0                          ? fmt::format("limb {}", limb)
                            : joints_.size() == joints.size() ? "joints"
                                                              : "beside the limbs",
                            word, unit, curves);
    set_styles(p, joints);
    add_limits(p, joints, unit_of(a_, unit, curves).per_si);
    return p;
  }

  // Colours in their order; dashes that tell at a glance which values are no prediction.
  void set_styles(figure::Panel& p, const std::vector<int>& joints) const {
    constexpr std::array<int, 4> unique{0, 4, 2, 7}, least_norm{3, 5, 8, 1};
    std::size_t firm = 0, soft = 0;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const int dash = doubtful(joints[i]) ? least_norm[soft++ % least_norm.size()] : unique[firm++ % unique.size()];
      const int colour = static_cast<int>(i) % figure::colours;
      p.series[i].style = figure::style_of(colour, dash);
    }
  }

  void add_limits(figure::Panel& p, const std::vector<int>& joints, double per_si) const {
    std::map<double, std::vector<std::string>> limits;
    for (const int j : joints)
      if (std::isfinite(limit(j))) limits[limit(j)].push_back(joint(j).name);
    for (const auto& [value, names] : limits)
      p.lines.push_back({value * per_si, names.size() == joints.size() ? "limit" : "limit of " + listed(names)});
  }

  const Analysis& a_;
  const std::vector<JointLoad>& loads_;
  bool moment_;
  std::vector<int> joints_;
  std::size_t all_ = 0;  // joints that could be drawn
};

// Every self-stress at some samples, in the free bodies of all: no load, no actuator force, no inertia.
document::Evidence stresses_in_balance(const Analysis& a, const std::vector<int>& samples) {
  double worst = 0;
  int looked = 0;
  for (const int k : samples) {
    const mechanics::State state = state_of(a, k);
    for (const auto& stress : self_stresses(a.machine(), state, generic_model(a.machine(), state))) {
      const Eigen::VectorXd none = Eigen::VectorXd::Zero(6 * (static_cast<Eigen::Index>(state.bodies.size()) - 1));
      worst = std::max(worst, free_body_residual(a.machine(), state, at_joints(state, stress), Eigen::VectorXd::Zero(a.machine().dof()),
                                                 none, a.length()));
      ++looked;
    }
  }
  return {"Self-stresses leave every body in balance",
          fmt::format("{} at {} spread over the motion: largest unbalanced force or moment of any body, relative to the stress",
                      plural(looked, "self-stress", "self-stresses"), plural(static_cast<int>(samples.size()), "sample")),
          looked > 0 ? worst : std::numeric_limits<double>::quiet_NaN(), 1e-9, ""};
}

}  // namespace

Result reactions_section(const Analysis& a, const ReactionsOptions& request, const Stage& stage) {
  Result out{{"reactions", "reactions", "Joint reactions", {}}, {}, {}, {}};
  document::Section& s = out.section;
  const auto tell = [&](const std::string& text, Paragraph::Tone tone = Paragraph::Tone::plain) {
    s.blocks.emplace_back(Paragraph{tone, text});
  };
  for (const std::string& line : singularity_sentences(a)) tell(line, Paragraph::Tone::warning);
  for (const std::string& line : joint_limit_sentences(a)) tell(line, Paragraph::Tone::warning);

  const std::vector<int> spread = samples_with_forces(a, 5);
  if (spread.empty()) {
    tell("No sample of the motion has forces: no reaction can be given.", Paragraph::Tone::warning);
    return out;
  }
  const std::vector<JointLoad> loads = joint_loads(a);
  const Count n = count(a, loads);
  double force = 0, moment = 0;
  for (const JointLoad& l : loads) force = std::max(force, l.force.peak), moment = std::max(moment, l.moment.peak);
  std::optional<Stage::Ordered> picture;
  if (force > 0) picture = reaction_picture(a, loads, stage);
  tell(definition(a));
  tell(verdict(a, n));
  if (n.doubtful + n.elastic > 0) add_stresses(s, a, spread.front());

  for (const bool moment : {false, true})
    if (const JointFigure f(a, loads, request, moment); f.any()) s.blocks.push_back(f.figure());
  if (picture) s.blocks.push_back(document::Gallery{{picture->wait()}, ""});
  s.blocks.push_back(bearing_table(a, loads));
  s.blocks.push_back(direction_table(a, loads));
  s.blocks.push_back(component_table(a, loads));

  const LimbWrenches limbs(a, spread);
  if (limbs.any()) {
    s.blocks.push_back(limb_figure(a, limbs));
    s.blocks.push_back(limb_table(a, limbs));
  }
  for (document::Block& b : limb_formula(a, limbs)) s.blocks.push_back(std::move(b));

  document::Proof p = proof(
      a, {{Measure::free_body, "Every free body balances",
           "reactions, actuator forces, load and weight against the rate of momentum of each body: largest unbalanced force or moment, "
           "relative to the largest of them",
           1e-9, ""},
          {Measure::judge, "Limb by limb equals the system over all bodies",
           "reactions by elimination in each limb against one factorisation over all bodies, relative to the largest", 1e-8, "",
           "the platform does not cut this mechanism into limbs, and the factorisation over all bodies is the only way"}});
  if (n.doubtful + n.elastic > 0) p.lines.push_back(stresses_in_balance(a, spread));
  if (limbs.any()) p.lines.push_back(platform_in_balance(limbs));
  s.blocks.push_back(std::move(p));

  out.values = {{"reactions", "peak_force", "N", force},
                {"reactions", "peak_moment", "N*m", moment},
                {"reactions", "indeterminate", "", double(n.doubtful)},
                {"reactions", "by_elasticity", "", double(n.elastic)},
                {"reactions", "self_stresses", "", double(a.self_stresses())}};
  return out;
}

}  // namespace pmreport::section
