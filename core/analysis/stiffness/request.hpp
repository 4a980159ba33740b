// What a section `stiffness` asks.
#pragma once

#include <core/analysis/study/pose_map.hpp>
#include <core/scenario/scenario.hpp>
#include <core/scenario/section/kind.hpp>

#include <optional>
#include <string>
#include <vector>

namespace pmreport::analysis {

struct StiffnessRequest : scenario::Options {
  Eigen::Vector3d tool = Eigen::Vector3d::Zero();  // whose displacements are told, platform axes [m]
  bool platform_axes = false;                      // of matrices, displacements and the load at the tool; else the base's
  bool limb_inertia = true;                        // in frequencies
  std::vector<double> times;                       // of poses whose matrices are shown [s]
  std::vector<Eigen::VectorXd> poses;              // and these
  std::optional<PoseMap> map;
  std::vector<scenario::Column> shown;  // over the map
};

// Of the first such section; nullptr: there is none.
const StiffnessRequest* stiffness_request(const scenario::Scenario& scenario);

}  // namespace pmreport::analysis
