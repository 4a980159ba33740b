// Redundant constraints as self-stresses: combinations of joint reactions that leave every body in equilibrium without a load,
// PHI^T lambda = 0, the left null space of PHI. Any basis of it would do; one that an engineer reads has few joints in each, and at its
// first joint a plain couple or force.
#include <core/linear/least_norm.hpp>
#include <core/linear/subspace.hpp>
#include <core/mechanics/mobility/mobility.hpp>
#include <core/mechanics/model/constraint_scale.hpp>

#include <Eigen/Geometry>
#include <algorithm>

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
    const MatrixXd null = scale.cwiseInverse().asDiagonal() * linear::null_space(phi.transpose());
    for (const MatrixXd& block : blocks(null)) refine(block);
    return std::move(out_);
  }

 private:
  // Reduced to row echelon form, vectors of loops that have no joint in common separate; those that share a joint are one block.
  std::vector<MatrixXd> blocks(const MatrixXd& null) const {
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
    std::vector<std::vector<Index>> groups;
    for (Index r = 0; r < rows.rows(); ++r) {
      std::vector<Index> merged{r};
      std::erase_if(groups, [&](const std::vector<Index>& g) {
        const bool shares = std::any_of(g.begin(), g.end(), [&](Index k) { return share_a_joint(rows.row(k), rows.row(r)); });
        if (shares) merged.insert(merged.end(), g.begin(), g.end());
        return shares;
      });
      std::sort(merged.begin(), merged.end());
      groups.push_back(merged);
    }
    std::sort(groups.begin(), groups.end());
    std::vector<MatrixXd> out;
    for (const auto& g : groups) {
      MatrixXd block(rows.cols(), static_cast<Index>(g.size()));
      for (std::size_t k = 0; k < g.size(); ++k) block.col(static_cast<Index>(k)) = rows.row(g[k]).transpose();
      out.push_back(block);
    }
    return out;
  }
  bool share_a_joint(const VectorXd& x, const VectorXd& y) const {
    const auto joints = [&](const VectorXd& v) {
      std::vector<bool> in(topology_.joints.size());
      for (Index r = 0; r < v.size(); ++r)
        if (std::abs(v(r)) > least_part) in[static_cast<std::size_t>(model_.joint_of_row[static_cast<std::size_t>(r)])] = true;
      return in;
    };
    const std::vector<bool> a = joints(x), b = joints(y);
    for (std::size_t j = 0; j < a.size(); ++j)
      if (a[j] && b[j]) return true;
    return false;
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
  std::vector<SelfStress> out_;
};

}  // namespace

std::vector<SelfStress> self_stresses(const Machine& machine, const State& state, const GenericModel& model) {
  return Stresses(machine, state, model).all();
}

}  // namespace pmreport::mechanics
