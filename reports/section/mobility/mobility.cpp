// Section `mobility`: how many freedoms, which, why, and whether they last.
#include <core/mechanics/machine/joint_words.hpp>
#include <core/mechanics/mobility/mobility.hpp>
#include <core/mechanics/mobility/mobility_count.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/model/random_poses.hpp>
#include <core/mechanics/singularity/singularity.hpp>
#include <reports/section/common/words/words.hpp>
#include <reports/section/mobility/mobility.hpp>

#include <fmt/core.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace pmreport::section {

using document::Paragraph;
using document::Table;
using mechanics::Mobility;

namespace {

constexpr std::uint64_t seed = 1;

int largest_difference(const std::vector<MobilityAt>& all, int MobilityAt::*number, int expected) {
  int worst = 0;
  for (const MobilityAt& m : all) worst = std::max(worst, std::abs(m.*number - expected));
  return worst;
}

double largest(const std::vector<MobilityAt>& all, double MobilityAt::*number) {
  double worst = 0;
  for (const MobilityAt& m : all) worst = std::max(worst, m.*number);
  return worst;
}

// "3T2R".
std::string freedom_symbol(int translations, int rotations) {
  return (translations > 0 ? fmt::format("{}T", translations) : "") + (rotations > 0 ? fmt::format("{}R", rotations) : "");
}

std::string verdict(const Mobility& home, const std::vector<MobilityAt>& poses) {
  const auto same = std::count_if(poses.begin(), poses.end(), [&](const MobilityAt& m) { return m.rank == home.rank; });
  std::string s = fmt::format("The {} that the joints impose have rank {} at home", plural(home.rows, "constraint"), home.rank);
  if (poses.empty()) return s + ".";
  s += fmt::format(" and at {} of {} random poses of the coordinates' box", same, poses.size());
  if (same == static_cast<std::ptrdiff_t>(poses.size()))
    return s + ": the mobility is that of the mechanism, full-cycle, and not of one pose.";
  return s + ": the mobility changes from pose to pose, and the count below holds at home alone.";
}

Table joint_table(const Topology& t) {
  Table table{"Joints and their freedoms.", {"joint", "freedoms f", "number", "Σf"}, {false, true, true, true}, {}};
  constexpr JointKind kinds[] = {JointKind::revolute, JointKind::prismatic, JointKind::universal, JointKind::cylindrical,
                                 JointKind::spherical};
  int joints = 0, sum = 0;
  for (const JointKind kind : kinds) {
    const int n = static_cast<int>(std::count_if(t.joints.begin(), t.joints.end(), [&](const Joint& j) { return j.kind == kind; }));
    const int f = freedoms_of(kind);
    if (n > 0) table.rows.push_back({mechanics::word_and_letter(kind), std::to_string(f), std::to_string(n), std::to_string(n * f)});
    joints += n, sum += n * f;
  }
  table.rows.push_back({"all", "", std::to_string(joints), std::to_string(sum)});
  return table;
}

Table count_table(const Mobility& m, const Topology& t) {
  return {"Mobility by declaration and by rank.",
          {"quantity", "by declaration", "by rank at home"},
          {false, true, true},
          {{"links n, base included", std::to_string(m.bodies), "–"},
           {"joints g", std::to_string(m.joints), "–"},
           {"sum of the joints' freedoms Σf", std::to_string(m.freedoms_sum), "–"},
           {"idle freedoms ζ: spins of links that move nothing else", std::to_string(t.idle), std::to_string(m.idle)},
           {"constraints, 6g − Σf", std::to_string(6 * m.joints - m.freedoms_sum), fmt::format("rank {}", m.rank)},
           {"redundant constraints ν", "–", std::to_string(m.redundant)},
           {"degrees of freedom M", std::to_string(t.coordinates.size()), std::to_string(m.freedoms)}}};
}

std::string count_sentence(const Mobility& m, const Topology& t) {
  return fmt::format("Grübler–Kutzbach: M = 6 (n − g − 1) + Σf − ζ + ν = 6 ({} − {} − 1) + {} − {} + {} = {}.", m.bodies, m.joints,
                     m.freedoms_sum, t.idle, m.redundant, m.gruebler + m.redundant);
}

document::Proof proof_of(const Analysis& a, const Mobility& home, const std::vector<MobilityAt>& all) {
  const int dof = a.machine().dof();
  const std::string where = fmt::format("home and {}", plural(static_cast<int>(all.size()) - 1, "random pose"));
  document::Proof p;
  p.lines.push_back({"The degrees of freedom are those declared", fmt::format("by rank at {} against {}, largest difference", where, dof),
                     double(largest_difference(all, &MobilityAt::freedoms, dof)), 0, ""});
  p.lines.push_back({"The idle freedoms are those declared", "spins by rank at the same poses, largest difference",
                     double(largest_difference(all, &MobilityAt::idle, a.machine().topology().idle)), 0, ""});
  p.lines.push_back({"The count agrees with the rank", "Grübler–Kutzbach with the redundant constraints that the rank shows",
                     std::abs(double(home.gruebler + home.redundant - home.freedoms)), 0, ""});
  // Sines of angles between spaces of systems of up to a hundred rows, whose condition numbers stay below 1e4.
  constexpr double tolerance = 1e-9;
  if (dof < 6)
    p.lines.push_back(
        {"The closed form has the same constraint wrenches",
         "constraint rows of G against the wrenches that do no work on the platform's motions in the generic model, largest sine "
         "of an angle between them, at the same poses",
         largest(all, &MobilityAt::closed_form), tolerance, ""});
  if (all[0].limbs_compared)
    p.lines.push_back({"The limbs together hold what the whole mechanism holds",
                       "constraint wrenches of the platform against those of the single limbs, largest sine, at the same poses",
                       largest(all, &MobilityAt::limbs), tolerance, ""});
  return p;
}

}  // namespace

MobilityAt mobility_at(const mechanics::Machine& machine, const mechanics::State& state, double length) {
  const mechanics::GenericModel model = generic_model(machine, state);
  const Mobility m = mobility(machine, state);
  MobilityAt at;
  at.rank = m.rank, at.freedoms = m.freedoms, at.idle = m.idle;
  at.platform = platform_freedoms(machine, state, model);
  mechanics::ScrewSystem together{at.platform.constraints.origin, Eigen::MatrixXd(6, 0)};
  std::vector<mechanics::LimbSystem> limbs = limb_systems(machine, state, model);
  // Limbs that share a body, or stand on one another, constrain the platform in other ways than one by one.
  const auto& bodies = machine.topology().bodies;
  const auto shared = std::count_if(bodies.begin(), bodies.end(), [](const Body& b) { return b.limb == 0; }) > 2;
  at.limbs_compared = !limbs.empty() && !shared;
  for (mechanics::LimbSystem& l : limbs) {
    at.limbs_compared = at.limbs_compared && l.alone;
    const Eigen::Index old = together.basis.cols();
    together.basis.conservativeResize(6, old + l.constraints.dimension());
    together.basis.rightCols(l.constraints.dimension()) = l.constraints.basis;
    at.wrenches.push_back(readable_basis(l.constraints, landmarks_of(machine.topology(), state, l.joints), length));
    at.limb_systems.push_back(std::move(l));
  }
  if (at.limbs_compared) at.limbs = outside(at.platform.constraints, together, length);
  if (machine.dof() < 6) {
    std::vector<double> q;
    for (const mechanics::Scalar& x : state.coordinates) q.push_back(x.value);
    const mechanics::Jacobian g = machine.jacobian(machine.pose(q));
    const Eigen::MatrixXd rows = g.matrix.bottomRows(6 - machine.dof());
    at.closed_form = g.known() ? outside({at.platform.constraints.origin, rows.transpose()}, at.platform.constraints, length)
                               : std::numeric_limits<double>::infinity();
  }
  return at;
}

Result mobility_section(const Analysis& a, const MobilityOptions& r) {
  const mechanics::Machine& machine = a.machine();
  const Topology& t = machine.topology();
  const mechanics::State home_state = state_at_rest(machine, machine.home());
  const Mobility& home = a.mobility();

  const std::vector<Eigen::VectorXd> poses = mechanics::random_poses(machine, r.random_poses, seed);
  std::vector<MobilityAt> all(1 + poses.size());
  tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t k) {
    all[k] = mobility_at(machine, k == 0 ? home_state : state_at_rest(machine, poses[k - 1]), a.length());
  });
  const std::vector<MobilityAt> elsewhere(all.begin() + 1, all.end());
  const int translations = static_cast<int>(all[0].platform.translations.cols()),
            rotations = static_cast<int>(all[0].platform.rotations.cols());

  Result out;
  document::Section& s = out.section = {"mobility", "mobility", "Mobility", {}};
  const auto tell = [&](const std::string& text) { s.blocks.push_back(Paragraph{Paragraph::Tone::plain, text}); };
  tell(fmt::format("The platform has {} at home: {} and {}, {}. ", plural(home.freedoms, "degree of freedom", "degrees of freedom"),
                   plural(translations, "translation"), plural(rotations, "rotation"), freedom_symbol(translations, rotations)) +
       verdict(home, elsewhere));
  tell(count_sentence(home, t));
  s.blocks.push_back(count_table(home, t));
  s.blocks.push_back(joint_table(t));
  const Surroundings around = surroundings(machine, home_state, a.length());
  for (const std::string& text : freedom_sentences(around, all[0], elsewhere)) tell(text);
  if (!all[0].limb_systems.empty()) s.blocks.push_back(limb_table(around, all[0], elsewhere));
  for (const std::string& text : limb_sentences(machine, all[0])) tell(text);
  const std::vector<mechanics::SelfStress> stresses = self_stresses(machine, home_state, generic_model(machine, home_state));
  if (stresses.empty())
    tell("No constraint is redundant: no joint carries a reaction without a load.");
  else
    s.blocks.push_back(stress_table(around, stresses));
  s.blocks.push_back(proof_of(a, home, all));

  const std::pair<const char*, int> numbers[] = {{"links", home.bodies},
                                                 {"joints", home.joints},
                                                 {"freedoms_sum", home.freedoms_sum},
                                                 {"gruebler", home.gruebler},
                                                 {"rows", home.rows},
                                                 {"rank", home.rank},
                                                 {"idle", home.idle},
                                                 {"redundant", home.redundant},
                                                 {"freedoms", home.freedoms},
                                                 {"translations", translations},
                                                 {"rotations", rotations}};
  for (const auto& [name, value] : numbers) out.values.push_back({"mobility", name, "", double(value)});
  return out;
}

}  // namespace pmreport::section
