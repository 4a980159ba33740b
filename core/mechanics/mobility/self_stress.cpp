// Redundant constraints as self-stresses: combinations of joint reactions that leave every body in equilibrium without a load,
// PHI^T lambda = 0, the left null space of PHI. Any basis of it would do; one that an engineer reads has few joints in each, and at its
// first joint a plain couple or force. So loop by loop, the smallest first, those are taken that the loop has by itself, the null space of
// the rows of its joints, less what smaller loops have; what is left takes several loops together.
#include <core/linear/least_norm.hpp>
#include <core/linear/subspace.hpp>
#include <core/mechanics/mobility/mobility.hpp>
#include <core/mechanics/model/constraint_scale.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <set>

namespace pmreport::mechanics {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

using linear::least_part;

class Stresses {
 public:
  Stresses(const Machine& machine, const State& state, const GenericModel& model)
      : topology_(machine.topology()), state_(state), model_(model), length_(characteristic_length(machine)) {}

  std::vector<SelfStress> all() {
    MatrixXd phi = per_length(model_.constraints, length_);
    const VectorXd scale = phi.rowwise().norm();
    phi = scale.cwiseInverse().asDiagonal() * phi;
    const MatrixXd null = linear::null_space(phi.transpose());
    MatrixXd told(null.rows(), 0);
    const auto take = [&](const MatrixXd& candidates) {
      const MatrixXd beyond = candidates - told * (told.transpose() * candidates);
      const MatrixXd fresh = candidates * linear::column_space(beyond.transpose(), 1);
      if (fresh.cols() == 0) return;
      MatrixXd both(told.rows(), told.cols() + fresh.cols());
      both << told, fresh;
      told = linear::orthonormalised(both);
      refine(scale.cwiseInverse().asDiagonal() * fresh);
    };
    if (null.cols() == 0) return {};
    for (Loop& loop : loops(topology_)) {
      if (told.cols() == null.cols()) break;
      loop_ = std::move(loop);
      take(of_joints(phi, loop_.joints));
    }
    loop_ = {};
    for (const VectorXd& one : sparse(null)) take(one);
    return std::move(out_);
  }

 private:
  // Reactions of these joints alone that balance, orthonormal.
  MatrixXd of_joints(const MatrixXd& phi, const std::vector<int>& joints) const {
    std::vector<Index> rows;
    for (Index r = 0; r < phi.rows(); ++r)
      if (std::find(joints.begin(), joints.end(), model_.joint_of_row[static_cast<std::size_t>(r)]) != joints.end()) rows.push_back(r);
    const MatrixXd null = linear::null_space(phi(rows, Eigen::all).transpose());
    MatrixXd out = MatrixXd::Zero(phi.rows(), null.cols());
    out(rows, Eigen::all) = null;
    return out;
  }

  // The same space by vectors with many zeros, those with the fewest joints first: reduced to row echelon form.
  std::vector<VectorXd> sparse(const MatrixXd& null) const {
    MatrixXd rows = null.transpose();
    Index next = 0;
    for (Index c = 0; c < rows.cols() && next < rows.rows(); ++c) {
      Index pivot;
      if (rows.col(c).tail(rows.rows() - next).cwiseAbs().maxCoeff(&pivot) < least_part) continue;
      rows.row(next).swap(rows.row(next + pivot));
      rows.row(next) /= rows(next, c);
      for (Index r = 0; r < rows.rows(); ++r)
        if (r != next) rows.row(r) -= rows(r, c) * rows.row(next);
      ++next;
    }
    std::vector<VectorXd> out;
    for (Index r = 0; r < rows.rows(); ++r) out.push_back(rows.row(r).transpose().normalized());
    std::stable_sort(out.begin(), out.end(), [&](const VectorXd& x, const VectorXd& y) { return joints_in(x) < joints_in(y); });
    return out;
  }
  std::size_t joints_in(const VectorXd& reactions) const {
    std::set<int> joints;
    for (Index r = 0; r < reactions.size(); ++r)
      if (std::abs(reactions(r)) > least_part) joints.insert(model_.joint_of_row[static_cast<std::size_t>(r)]);
    return joints.size();
  }

  // What joint j exerts on its body b, about the base's origin, for each column of reactions.
  MatrixXd at_joint(int j, const MatrixXd& reactions) const {
    const Joint& joint = topology_.joints[static_cast<std::size_t>(j)];
    const int body = joint.b > 0 ? joint.b : joint.a;
    const Vector3d o = state_.bodies[static_cast<std::size_t>(body)].origin;
    MatrixXd w = MatrixXd::Zero(6, reactions.cols());
    for (std::size_t r = 0; r < model_.joint_of_row.size(); ++r)
      if (model_.joint_of_row[r] == j) {
        Vector6d row = model_.constraints.block<1, 6>(static_cast<Index>(r), 6 * body - 6).transpose();
        if (body != joint.b) row = -row;
        row.tail<3>() += o.cross(row.head<3>());
        w += row * reactions.row(static_cast<Index>(r));
      }
    return w;
  }

  // The joint that tells most of the block apart speaks for it, in a readable basis of the wrenches that it carries; what does not pass
  // through that joint is a smaller block.
  void refine(const MatrixXd& block) {
    if (block.cols() == 0) return;
    int best = -1, most = 0;
    std::vector<int> taking_part;
    MatrixXd best_wrenches;
    for (int j = 0; j < static_cast<int>(topology_.joints.size()); ++j) {
      MatrixXd w = at_joint(j, block);
      w.bottomRows(3) /= length_;
      if (w.cwiseAbs().maxCoeff() < least_part) continue;
      taking_part.push_back(j);
      if (const int r = linear::rank(w); r > most) most = r, best = j, best_wrenches = w;
    }
    if (best < 0) return;
    MatrixXd basis = linear::column_space(best_wrenches);
    basis.bottomRows(3) *= length_;
    for (const NamedWrench& w : readable_basis({Vector3d::Zero(), basis}, landmarks_of(topology_, state_, taking_part), length_)) {
      Vector6d wanted = w.wrench;
      wanted.tail<3>() /= length_;
      add(block * linear::least_norm_solution(best_wrenches, wanted), w, best);
    }
    refine(block * linear::null_space(best_wrenches));
  }

  void add(const VectorXd& reactions, const NamedWrench& first, int speaker) {
    SelfStress s;
    s.at_first = first;
    s.loop = loop_;
    const auto scaled = [&](Vector6d w) {
      w.tail<3>() /= length_;
      return w;
    };
    const double size = scaled(first.wrench).norm();
    for (int j = 0; j < static_cast<int>(topology_.joints.size()); ++j) {
      const Vector6d w = at_joint(j, reactions);
      const double share = scaled(w).norm();
      if (share < 1e-6 * size) continue;
      s.shares.push_back({j, w});
      s.same = s.same && std::min(scaled(w - first.wrench).norm(), scaled(w + first.wrench).norm()) < 1e-6 * size;
    }
    std::stable_partition(s.shares.begin(), s.shares.end(), [&](const SelfStress::Share& x) { return x.joint == speaker; });
    out_.push_back(std::move(s));
  }

  const Topology& topology_;
  const State& state_;
  const GenericModel& model_;
  double length_;
  Loop loop_;  // whose self-stresses are being told; empty: of several together
  std::vector<SelfStress> out_;
};

}  // namespace

std::vector<SelfStress> self_stresses(const Machine& machine, const State& state, const GenericModel& model) {
  return Stresses(machine, state, model).all();
}

}  // namespace pmreport::mechanics
