// Elasticity at every sample: the columns of section `stiffness`, and their residuals.
#include <core/analysis/analysis.hpp>
#include <core/analysis/stiffness/numbers.hpp>
#include <core/mechanics/dynamics/momentum.hpp>
#include <core/mechanics/stiffness/whole_system.hpp>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pmreport::analysis {

namespace {

using mechanics::ElasticPose, mechanics::Matrix6d, mechanics::Vector6d;

// Largest deviation of two compliances, rotations scaled by a length, relative to the largest number.
double deviation(const Matrix6d& a, const Matrix6d& b, double length) {
  const Vector6d s = (Vector6d() << 1, 1, 1, Eigen::Vector3d::Constant(1 / length)).finished();
  const Matrix6d d = s.asDiagonal() * (a - b) * s.asDiagonal(), all = s.asDiagonal() * b * s.asDiagonal();
  return relative(d.cwiseAbs().maxCoeff(), all.cwiseAbs().maxCoeff());
}

class Worker {
 public:
  Worker(const mechanics::Machine& m, const mechanics::Trajectory& motion, const scenario::Load& load, const StiffnessRequest& request,
         double length)
      : machine_(m), motion_(motion), load_(load), request_(request), length_(length), statics_(m), placement_(m.layout().size()) {}

  void run(int sample, bool judged, Row& row, ColumnStore& columns, Matrix6d& compliance) {
    const auto k = static_cast<std::size_t>(sample);
    const auto dof = static_cast<std::size_t>(machine_.dof());
    std::vector<double> jets(3 * dof), loads(6);
    std::vector<double> q(dof);
    for (std::size_t i = 0; i < dof; ++i) {
      const auto at = static_cast<Eigen::Index>(i);
      q[i] = jets[3 * i] = motion_.value(sample, at);
      jets[3 * i + 1] = motion_.rate(sample, at);
      jets[3 * i + 2] = motion_.acceleration(sample, at);
    }
    if (machine_.place(PM_VALUE, 1, q.data(), placement_.data()) != PM_OK) return;
    for (std::size_t c = 0; c < 3; ++c) {
      loads[c] = load_.force[k](static_cast<Eigen::Index>(c));
      loads[3 + c] = load_.moment[k](static_cast<Eigen::Index>(c));
    }
    statics_.solve(1, jets.data(), loads.data(), load_.gravity, {true, request_.limb_inertia}, poses_);
    const ElasticPose& pose = poses_[0];
    if (!pose.known) return;
    const ToolElasticity tool = at_tool(machine_, pose, placement_.data(), request_);
    compliance = tool.compliance;
    stiffness_numbers(machine_, pose, tool, request_, length_, true, [&](const ColumnId& id, double value) { columns.put(id, k, value); });
    prove(sample, judged, Eigen::Map<const Vector6d>(loads.data()), pose, row);
  }

 private:
  void prove(int sample, bool judged, const Vector6d& load, const ElasticPose& pose, Row& row) {
    if (!judged) return;
    prove_drives(pose, row);
    if (!machine_.elasticity().platform.isZero(0) || !machine_.elasticity().base.isZero(0) || pose.compliance.isZero(0)) return;
    mechanics::State state;
    const Eigen::VectorXd q = motion_.value.row(sample), rate = motion_.rate.row(sample), acceleration = motion_.acceleration.row(sample);
    evaluate(machine_, q.data(), rate.data(), acceleration.data(), state);
    if (state.status != PM_OK) return;
    const mechanics::WholeSystem whole(statics_.plan(), state);
    const Eigen::Index platform = 6 * machine_.topology().platform - 6;
    set(row, Measure::elastic_judge, deviation(pose.compliance, whole.under_unit_wrenches().middleRows<6>(platform), length_));
    // What acts on the bodies, less what their motion takes, along the displacements of all of them; and the energy of the springs.
    const Eigen::VectorXd wrenches = applied_wrenches(machine_, state, {load, load_.gravity}) - inertial_wrenches(machine_, state);
    const double work = wrenches.dot(Eigen::VectorXd(whole.displacements(wrenches)));
    double energy = 0;
    for (std::size_t i = 0; i < pose.parts.springs.size(); ++i)
      energy += pose.parts.springs[i].compliance * std::pow(pose.loaded(static_cast<Eigen::Index>(i)), 2);
    set(row, Measure::elastic_work, relative(std::abs(work - energy), std::max(work, energy)));
  }

  // The part of the drives in the compliance, by their forces and by G: G^-1 diag(1/k) G^-T.
  void prove_drives(const ElasticPose& pose, Row& row) const {
    const mechanics::Jacobian g = machine_.jacobian(placement_.data());
    if (!g.known()) return;
    Matrix6d seen = Matrix6d::Zero(), compliances = Matrix6d::Zero();
    for (std::size_t i = 0; i < pose.parts.springs.size(); ++i) {
      const Spring& s = pose.parts.springs[i];
      if (s.kind != Spring::Kind::drive) continue;
      const Vector6d q = pose.unit.row(static_cast<Eigen::Index>(i)).transpose();
      seen += s.compliance * q * q.transpose();
      compliances(s.actuator, s.actuator) += s.compliance;
    }
    if (compliances.isZero(0)) return;
    const Matrix6d inverse = g.matrix.inverse();
    set(row, Measure::elastic_drives, deviation(seen, inverse * compliances * inverse.transpose(), length_));
  }

  using Spring = mechanics::Spring;
  const mechanics::Machine& machine_;
  const mechanics::Trajectory& motion_;
  const scenario::Load& load_;
  const StiffnessRequest& request_;
  double length_;
  mechanics::Elastostatics statics_;
  std::vector<double> placement_;
  std::vector<ElasticPose> poses_;
};

}  // namespace

void Analysis::run_stiffness(const Progress& progress) {
  const StiffnessRequest* request = stiffness_request(scenario_);
  if (request == nullptr || samples() == 0 || !gives_way(machine_)) return;
  for (const Column& c : stiffness_columns(machine_.topology())) columns_.add(c, time().size());
  compliances_.assign(time().size(), Matrix6d::Constant(std::numeric_limits<double>::quiet_NaN()));
  tbb::enumerable_thread_specific<Worker> workers([&] { return Worker(machine_, trajectory_, scenario_.load, *request, length_); });
  constexpr int judged = 8;  // spread evenly
  const int every = std::max(1, samples() / judged);
  constexpr int block = 1024;
  for (int begin = 0; begin < samples(); begin += block) {
    progress.stop_if_asked();
    tbb::parallel_for(begin, std::min(samples(), begin + block), [&](int k) {
      const auto at = static_cast<std::size_t>(k);
      if (outcome(k) == Outcome::good) workers.local().run(k, k % every == every / 2, residuals_[at], columns_, compliances_[at]);
    });
  }
}

}  // namespace pmreport::analysis
