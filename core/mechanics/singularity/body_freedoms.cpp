#include <core/mechanics/singularity/body_freedoms.hpp>

#include <core/linear/singular_values.hpp>
#include <core/linear/subspace.hpp>
#include <core/mechanics/model/constraint_scale.hpp>
#include <core/mechanics/model/random_poses.hpp>

#include <algorithm>
#include <limits>

namespace pmreport::mechanics {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr int looked_at = 8;  // random poses beside home: the rank of a regular pose is the largest

MatrixXd stacked(const std::vector<Eigen::RowVectorXd>& rows, Index columns) {
  MatrixXd out(static_cast<Index>(rows.size()), columns);
  for (std::size_t i = 0; i < rows.size(); ++i) out.row(static_cast<Index>(i)) = rows[i];
  return out;
}

}  // namespace

BodyFreedoms::BodyFreedoms(const Machine& machine) : machine_(machine), length_(characteristic_length(machine)) {
  const Topology& t = machine.topology();
  const auto in_limb = [&](int body) { return t.bodies[static_cast<std::size_t>(body)].limb > 0; };
  // Bodies of limbs that are jointed to one another have one number: the least of their limbs'.
  std::vector<int> joined(t.bodies.size());
  for (std::size_t b = 0; b < t.bodies.size(); ++b) joined[b] = t.bodies[b].limb;
  for (bool changed = true; changed;) {
    changed = false;
    for (const Joint& j : t.joints) {
      int &a = joined[static_cast<std::size_t>(j.a)], &b = joined[static_cast<std::size_t>(j.b)];
      if (!in_limb(j.a) || !in_limb(j.b) || a == b) continue;
      a = b = std::min(a, b), changed = true;
    }
    for (std::size_t b = 1; b < t.bodies.size(); ++b)
      for (std::size_t c = 1; c < t.bodies.size(); ++c)
        if (t.bodies[b].limb > 0 && t.bodies[b].limb == t.bodies[c].limb && joined[b] != joined[c])
          joined[b] = joined[c] = std::min(joined[b], joined[c]), changed = true;
  }
  std::vector<int> numbers;
  group_.assign(t.bodies.size(), -1);
  column_.assign(t.bodies.size(), 0);
  for (std::size_t b = 1; b < t.bodies.size(); ++b) {
    if (!in_limb(static_cast<int>(b))) {
      column_[b] = core_width_, core_width_ += 6;
      continue;
    }
    const auto found = std::ranges::find(numbers, joined[b]);
    group_[b] = static_cast<int>(found - numbers.begin());
    if (found == numbers.end()) numbers.push_back(joined[b]), widths_.push_back(0);
    Index& width = widths_[static_cast<std::size_t>(group_[b])];
    column_[b] = width, width += 6;
  }

  // First what the limbs have, at the best of the poses; then what is left to the core when they have it.
  const State home = state_at_rest(machine, machine.home());
  std::vector<Rows> poses{rows(home)};
  for (const VectorXd& q : random_poses(machine, looked_at, 1))
    if (const State state = state_at_rest(machine, q); state.status == PM_OK) poses.push_back(rows(state));
  expected_.limb.assign(widths_.size(), 0), expected_.limb_locked.assign(widths_.size(), 0);
  for (const Rows& r : poses)
    for (std::size_t g = 0; g < widths_.size(); ++g) {
      expected_.limb[g] = std::max<Index>(expected_.limb[g], linear::rank(r.own[g].topRows(r.passive[g])));
      expected_.limb_locked[g] = std::max<Index>(expected_.limb_locked[g], linear::rank(r.own[g]));
    }
  double unused = 0;
  for (const Rows& r : poses) {
    expected_.free = std::max<Index>(expected_.free, linear::rank(reduced(r, false, unused), 1));
    expected_.locked = std::max<Index>(expected_.locked, linear::rank(reduced(r, true, unused), 1));
  }
  at_home_ = at(home);
}

BodyFreedoms::Rows BodyFreedoms::rows(const State& state) const {
  const Topology& t = machine_.topology();
  const GenericModel model = generic_model(machine_, state);
  const MatrixXd phi = unit_rows(model.constraints, length_), drives = unit_rows(model.actuation, length_);
  const std::size_t groups = widths_.size();
  std::vector<std::vector<Eigen::RowVectorXd>> own(groups), core(groups);
  std::vector<Eigen::RowVectorXd> alone, drives_alone;
  Rows out;
  const auto take = [&](const auto& row, int joint, std::vector<Eigen::RowVectorXd>& of_core) {
    const Joint& j = t.joints[static_cast<std::size_t>(joint)];
    const int g = std::max(group_[static_cast<std::size_t>(j.a)], group_[static_cast<std::size_t>(j.b)]);
    Eigen::RowVectorXd mine = Eigen::RowVectorXd::Zero(g < 0 ? 0 : widths_[static_cast<std::size_t>(g)]),
                       others = Eigen::RowVectorXd::Zero(core_width_);
    for (const int body : {j.a, j.b}) {
      if (body == 0) continue;
      const auto b = static_cast<std::size_t>(body);
      (group_[b] < 0 ? others : mine).segment(column_[b], 6) = row.segment(6 * body - 6, 6);
    }
    if (g < 0) {
      of_core.push_back(others);
    } else {
      own[static_cast<std::size_t>(g)].push_back(mine);
      core[static_cast<std::size_t>(g)].push_back(others);
    }
  };
  for (Index r = 0; r < phi.rows(); ++r) take(phi.row(r), model.joint_of_row[static_cast<std::size_t>(r)], alone);
  for (const auto& list : own) out.passive.push_back(static_cast<Index>(list.size()));
  for (Index r = 0; r < drives.rows(); ++r) take(drives.row(r), t.actuators[static_cast<std::size_t>(r)].joint, drives_alone);
  for (std::size_t g = 0; g < groups; ++g) {
    out.own.push_back(stacked(own[g], widths_[g]));
    out.core.push_back(stacked(core[g], core_width_));
  }
  out.alone = stacked(alone, core_width_);
  out.drives_alone = stacked(drives_alone, core_width_);
  return out;
}

// R of (2), and the least pivot of the groups.
MatrixXd BodyFreedoms::reduced(const Rows& r, bool locked, double& least) const {
  std::vector<MatrixXd> parts{r.alone};
  if (locked) parts.push_back(r.drives_alone);
  for (std::size_t g = 0; g < widths_.size(); ++g) {
    const Index used = locked ? r.own[g].rows() : r.passive[g];
    const linear::Complement e = linear::complement(r.own[g].topRows(used), locked ? expected_.limb_locked[g] : expected_.limb[g]);
    least = std::min(least, e.pivot);
    parts.push_back(e.basis.transpose() * r.core[g].topRows(used));
  }
  Index rows = 0;
  for (const MatrixXd& part : parts) rows += part.rows();
  MatrixXd out(rows, core_width_);
  rows = 0;
  for (const MatrixXd& part : parts) out.middleRows(rows, part.rows()) = part, rows += part.rows();
  return out;
}

BodyFreedoms::Margins BodyFreedoms::margins(const Rows& r) const {
  Margins out;
  out.fill(std::numeric_limits<double>::infinity());
  const MatrixXd when_free = reduced(r, false, out[limb]), when_locked = reduced(r, true, out[limb_locked]);
  const auto last = [](const MatrixXd& m, Index rank) {
    return rank > 0 ? linear::pivots(m)(rank - 1) : std::numeric_limits<double>::infinity();
  };
  out[free] = last(when_free, expected_.free);
  out[locked] = last(when_locked, expected_.locked);
  return out;
}

BodyFreedoms::Margins BodyFreedoms::at(const State& state) const { return margins(rows(state)); }

BodyFreedoms::Margins BodyFreedoms::at(const VectorXd& coordinates) const {
  const State state = state_at_rest(machine_, coordinates);
  if (state.status == PM_OK) return at(state);
  Margins none;
  none.fill(std::numeric_limits<double>::quiet_NaN());
  return none;
}

}  // namespace pmreport::mechanics
