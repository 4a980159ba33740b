// One mechanism with its parameters, as the analyses see it: the host's side of the contract. Everything that a plugin says is checked here
// once (sizes, indices, finite numbers), so that the analyses may trust it.
#pragma once

#include <pmreport/plugin.h>
#include <Eigen/Core>
#include <core/linear/types.hpp>
#include <core/mechanics/machine/elastic_settings.hpp>
#include <core/mechanics/machine/mechanism_error.hpp>
#include <limits>
#include <memory>
#include <pmreport/topology.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace pmreport::program {
class Program;
}

namespace pmreport::mechanics {

struct ParameterInfo {
  std::string name, title, unit, display;  // unit: SI; display: the unit a reader expects
  pm_parameter_kind kind;                  // PM_NUMBER, PM_NUMBERS, PM_CHOICE
  std::vector<double> defaults;            // SI; of a choice: its index
  double min, max;                         // of every number, inclusive
  std::size_t count_min, count_max;
  std::vector<std::string> choices;
  bool working_mode = false;  // chooses among the solutions of inverse displacement
  std::string unless;         // the parameter that, once given, stands in the place of this one; empty: there is none
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
  pm_status status = PM_FAILED;  // PM_OK; PM_UNREACHABLE; PM_SINGULAR: the geometry has no finite numbers there; PM_FAILED
  std::string why;               // a sentence when not PM_OK
  std::vector<double> numbers;   // layout().size() of them, SI; without meaning when not PM_OK
};

// The plugin's overall Jacobian G at one pose, in its own units.
struct Jacobian {
  pm_status status = PM_FAILED;  // PM_OK; PM_SINGULAR: G has no value there; PM_FAILED
  std::string why;               // a sentence when not PM_OK
  linear::Matrix6d matrix = linear::Matrix6d::Constant(std::numeric_limits<double>::quiet_NaN());  // NaN when not PM_OK

  bool known() const { return status == PM_OK; }
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
  Eigen::VectorXd home() const;  // coordinates of the home pose, dof numbers [m], [rad]
  const Pose& home_pose() const { return home_pose_; }

  // The pose at dof coordinates [m], [rad]. Failure is told by its status.
  Pose pose(std::span<const double> coordinates) const;
  // G at a pose that is PM_OK; PM_SINGULAR also where the plugin's numbers are not finite.
  Jacobian jacobian(const Pose& pose) const;
  Jacobian jacobian(const double* placement) const;  // of the plain numbers of a placement in reach
  // Of a pose that is PM_OK, base axes. Bodies count from 0, the base; joints and axes from 0.
  Eigen::Vector3d origin(const Pose& pose, int body) const;            // p_A [m]; of the base: zero
  Eigen::Matrix3d rotation(const Pose& pose, int body) const;          // R_A; of a slender body: z along its axis, the others anyhow
  Eigen::Vector3d centre(const Pose& pose, int joint) const;           // p_C [m]
  Eigen::Vector3d axis(const Pose& pose, int joint, int k = 0) const;  // unit; k < axes_of(kind)

  // The contract's own functions, for arrays of the caller's. A scalar of order `order` is c = components(order) doubles: its value
  // (PM_VALUE); value, rate, acceleration (PM_JET); value and dof partials (PM_PARTIALS); high and low part (PM_EXTENDED). Component e of
  // scalar s of pose k stands at [(c s + e) count + k]. Neither throws; `why` gets a sentence when the answer is not PM_OK.
  //
  // Where everything is. `coordinates`: dof scalars a pose, with PM_PARTIALS plain values; `placement`: layout().size() scalars. Of one
  // pose PM_UNREACHABLE when it cannot be assembled, PM_SINGULAR when its numbers are not finite, as of a limb without length; of several
  // each one's reach, negative then, is the first scalar of its placement, and the numbers of such a pose mean nothing.
  pm_status place(pm_order order, std::size_t count, const double* coordinates, double* placement, std::string* why = nullptr) const;
  // The plugin's overall Jacobian G of a placement that is in reach: 36 scalars a pose, row-major, G V = (actuator rates, 0), V the twist
  // of the platform about its reference point. Not of PM_EXTENDED. A row of an actuator has [m/s] or [rad/s] by [m/s, rad/s]. Not finite,
  // or PM_SINGULAR, where G has no value: on some singular surfaces. All NaN when the answer is not PM_OK.
  pm_status jacobian(pm_order order, std::size_t count, const double* placement, double* jacobian, std::string* why = nullptr) const;
  std::size_t components(pm_order order) const;  // doubles per scalar

  // The geometry as a program: inputs the coordinates; outputs the numbers of a placement, as of layout(), then the 36 of G. Made when
  // first asked for, by whatever thread. nullptr: there is none; `why` then gets a sentence.
  const program::Program* program(std::string* why = nullptr) const;
  // The mechanism offers to record its geometry: plugins may not, and could not before contract 1.3.
  bool records() const;

  // The matrices of the source, in the order of topology().matrices; none where the plugin brings none, or gives none at this pose.
  std::vector<Eigen::MatrixXd> matrices(std::span<const double> coordinates, const Pose& pose) const;
  // The readings of the source, in the order of topology().readings; NaN where one is not defined.
  std::vector<double> readings(std::span<const double> coordinates, const Pose& pose) const;

  // What gives way: topology().elements under these settings, which are those of the mechanism until `give` is called. Their elements and
  // names must fit the topology (fault_of).
  const ElasticSettings& elasticity() const { return elasticity_; }
  void give(ElasticSettings settings);

  // The same mechanism, and the same settings, with other values of its parameters. Throws as the constructor does.
  std::unique_ptr<Machine> with(ParameterValues values) const;

 private:
  pm_status place_extended(std::size_t count, const double* coordinates, double* placement, std::string* why) const;
  pm_status finite_or_singular(pm_order order, const double* placement, std::string* why) const;

  const pm_mechanism* table_;
  MechanismInfo info_;
  ParameterValues values_;
  pm_instance* instance_ = nullptr;
  Topology topology_;
  std::vector<Element> declared_;  // elements, before settings
  ElasticSettings elasticity_;
  Layout layout_;
  Pose home_pose_;
  struct Recording;
  std::unique_ptr<Recording> recording_;
};

}  // namespace pmreport::mechanics
