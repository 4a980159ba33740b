// The elasticity of one sample of a motion: the columns of section `stiffness`, and the residuals that prove them.
#pragma once

#include <core/analysis/residuals.hpp>
#include <core/analysis/stiffness/numbers.hpp>
#include <core/mechanics/trajectory/trajectory.hpp>
#include <core/scenario/load.hpp>

#include <functional>
#include <vector>

namespace pmreport::analysis {

// Each thread has its own, with the buffers it reuses.
class SampleStiffness {
 public:
  // `length`: characteristic length [m].
  SampleStiffness(const mechanics::Trajectory& trajectory, const scenario::Load& load, const mechanics::Machine& m,
                  const StiffnessRequest& request, double length)
      : trajectory_(trajectory), load_(load), machine_(m), request_(request), length_(length), statics_(m), placement_(m.layout().size()) {}

  using Put = std::function<void(const ColumnId& column, double value)>;

  // Of a sample that is good. `judged`: by the system over all bodies as well. `compliance` stays as it is where there is none.
  void run(int sample, bool judged, Row& row, const Put& put, mechanics::Matrix6d& compliance);

 private:
  void prove(int sample, const mechanics::Vector6d& load, const mechanics::ElasticPose& pose, Row& row);
  void prove_drives(const mechanics::ElasticPose& pose, Row& row) const;

  const mechanics::Trajectory& trajectory_;
  const scenario::Load& load_;
  const mechanics::Machine& machine_;
  const StiffnessRequest& request_;
  double length_;
  mechanics::Elastostatics statics_;
  std::vector<double> placement_;
  std::vector<mechanics::ElasticPose> poses_;
};

}  // namespace pmreport::analysis
