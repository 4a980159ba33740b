// One mechanism with its parameters, as the analyses see it: the host's side of the contract. Everything that a plugin says is checked here
// once (sizes, indices, finite numbers), so that the analyses may trust it.
#pragma once

#include <pmreport/plugin.h>
#include <Eigen/Core>
#include <memory>
#include <pmreport/topology.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace pmreport::mechanics {

// What the plugin said no to, or said wrong. `status` tells bad parameters (PM_BAD_ARGUMENT, the user's) from a broken plugin (the rest).
class MechanismError : public std::runtime_error {
 public:
  MechanismError(pm_status status, const std::string& sentence) : std::runtime_error(sentence), status(status) {}
  pm_status status;
};

struct ParameterInfo {
  std::string name, title, unit, display;  // unit: SI; display: the unit a reader expects
  pm_parameter_kind kind;                  // PM_NUMBER, PM_NUMBERS, PM_CHOICE
  std::vector<double> defaults;            // SI; of a choice: its index
  double min, max;                         // of every number, inclusive
  std::size_t count_min, count_max;
  std::vector<std::string> choices;
  bool working_mode = false;  // chooses among the solutions of inverse displacement
};

// What can be known of a mechanism before it is made.
struct MechanismInfo {
  std::string name, title, source;
  int dof = 0;
  std::vector<ParameterInfo> parameters;
};
MechanismInfo describe(const pm_mechanism& table);

using ParameterValues = std::vector<std::vector<double>>;  // in the order of the parameters, SI; of a choice: its index
ParameterValues default_values(const MechanismInfo& info);

// Where everything is: the numbers of a placement (plugin.h tells their order) with a reader's access.
struct Pose {
  pm_status status = PM_FAILED;  // PM_OK, PM_UNREACHABLE, PM_FAILED
  std::string why;               // a sentence when not PM_OK
  std::vector<double> numbers;
};

class Machine {
 public:
  // Throws MechanismError: parameters refused, or a declaration that makes no sense (it says which).
  Machine(const pm_mechanism& table, ParameterValues values);
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;
  ~Machine();

  const MechanismInfo& info() const { return info_; }
  const ParameterValues& values() const { return values_; }
  const Topology& topology() const { return topology_; }
  const Layout& layout() const { return layout_; }
  int dof() const { return info_.dof; }
  Eigen::VectorXd home() const;  // coordinates of the home pose
  const Pose& home_pose() const { return home_pose_; }

  Pose pose(std::span<const double> coordinates) const;
  Eigen::Vector3d origin(const Pose& pose, int body) const;
  Eigen::Matrix3d rotation(const Pose& pose,
                           int body) const;  // of a slender body: z along its axis, the others anyhow; of the base: identity
  Eigen::Vector3d centre(const Pose& pose, int joint) const;
  Eigen::Vector3d axis(const Pose& pose, int joint, int k = 0) const;

  // The contract's own functions, for arrays of the caller's. `place` with more than one pose reports each one's reach in the placement.
  pm_status place(pm_order order, std::size_t count, const double* coordinates, double* placement, std::string* why = nullptr) const;
  // The matrices of the source, in the order of topology().matrices; none where the plugin brings none, or gives none at this pose.
  std::vector<Eigen::MatrixXd> matrices(std::span<const double> coordinates, const Pose& pose) const;
  // The readings of the source, in the order of topology().readings; NaN where one is not defined.
  std::vector<double> readings(std::span<const double> coordinates, const Pose& pose) const;
  pm_status jacobian(pm_order order, std::size_t count, const double* placement, double* jacobian, std::string* why = nullptr) const;
  std::size_t components(pm_order order) const;  // doubles per scalar

  // The same mechanism with other values of its parameters. Throws as the constructor does.
  std::unique_ptr<Machine> with(ParameterValues values) const { return std::make_unique<Machine>(*table_, std::move(values)); }

 private:
  const pm_mechanism* table_;
  MechanismInfo info_;
  ParameterValues values_;
  pm_instance* instance_ = nullptr;
  Topology topology_;
  Layout layout_;
  Pose home_pose_;
};

}  // namespace pmreport::mechanics
