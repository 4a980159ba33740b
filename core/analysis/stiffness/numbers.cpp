#include <core/analysis/stiffness/numbers.hpp>

#include <core/linear/eigenvalues.hpp>

#include <cmath>
#include <limits>

namespace pmreport::analysis {

using mechanics::ElasticPose, mechanics::Machine, mechanics::Matrix6d, mechanics::Vector6d;

const StiffnessRequest* stiffness_request(const scenario::Scenario& scenario) {
  for (const scenario::Section& s : scenario.sections)
    if (const auto* request = dynamic_cast<const StiffnessRequest*>(s.options.get())) return request;
  return nullptr;
}

bool gives_way(const Machine& machine) {
  const mechanics::ElasticSettings& e = machine.elasticity();
  return !machine.topology().elements.empty() || !e.platform.isZero(0) || !e.base.isZero(0);
}

ToolElasticity at_tool(const Machine& machine, const ElasticPose& pose, const double* placement, const StiffnessRequest& request) {
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> r(placement + machine.layout().body(machine.topology().platform) +
                                                                         3);
  const Eigen::Matrix3d axes = request.platform_axes ? Eigen::Matrix3d(r) : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
  ToolElasticity out{mechanics::to_tool(r * request.tool, axes), {}, {}, {}, {}, {}, {}};
  const Matrix6d back = out.to_tool.transpose();
  out.compliance = back * pose.compliance * out.to_tool;
  out.deflection = back * pose.deflection;
  out.by_load = back * pose.by_load;
  out.by_weights = back * pose.by_weights;
  out.by_inertia = back * pose.by_inertia;
  out.by_strain = back * pose.by_strain;
  return out;
}

std::vector<double> frequencies(const ElasticPose& pose, bool limb_inertia, double length) {
  std::vector<double> out;
  if (limb_inertia)
    for (const mechanics::WholeMode& m : mechanics::whole_modes(pose, told_frequencies, false)) out.push_back(m.frequency);
  else
    for (const mechanics::Mode& m : mechanics::modes(pose.compliance, pose.platform_inertia, length)) out.push_back(m.frequency);
  return out;
}

void stiffness_numbers(const Machine& machine, const ElasticPose& pose, const ToolElasticity& tool, const StiffnessRequest& request,
                       double length, bool loaded, const std::function<void(const ColumnId&, double)>& put) {
  const mechanics::DeformationIndices i = mechanics::deformation_indices(tool.compliance);
  put(column_of(OfStiffness::pF_max), i.pF_max), put(column_of(OfStiffness::pF_min), i.pF_min);
  put(column_of(OfStiffness::pT_max), i.pT_max), put(column_of(OfStiffness::pT_min), i.pT_min);
  put(column_of(OfStiffness::PhiT_max), i.PhiT_max), put(column_of(OfStiffness::PhiT_min), i.PhiT_min);
  const std::vector<double> all = frequencies(pose, request.limb_inertia, length);
  for (std::size_t m = 0; m < all.size(); ++m) put(frequency_column(static_cast<int>(m) + 1), all[m]);
  if (!loaded) return;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    put(column_of(OfPlatform::deflection, axis), tool.deflection(static_cast<Eigen::Index>(axis)));
    put(column_of(OfPlatform::deflection_turn, axis), tool.deflection(static_cast<Eigen::Index>(3 + axis)));
  }
  put(column_of(OfStiffness::deflection_size), tool.deflection.head<3>().norm());
  put(column_of(OfStiffness::load_deflection), tool.by_load.head<3>().norm());
  put(column_of(OfStiffness::weight_deflection), tool.by_weights.head<3>().norm());
  put(column_of(OfStiffness::inertia_deflection), tool.by_inertia.head<3>().norm());
  const std::vector<Element>& elements = machine.topology().elements;
  const auto internal = mechanics::beam_forces(pose, elements.size(), pose.forces);
  const auto shares = budget_under_load(machine, pose, tool);
  for (std::size_t e = 0; e < elements.size(); ++e) {
    put(column_of(elements[e], OfElement::share), shares[e]);
    if (elements[e].kind != ElementKind::beam) continue;
    put(column_of(elements[e], OfElement::axial), internal[e].axial);
    put(column_of(elements[e], OfElement::bending), internal[e].bending);
    put(column_of(elements[e], OfElement::torque), internal[e].torque);
    const double critical = mechanics::buckling_load(elements[e], pose.parts.lengths[e]);
    if (internal[e].compression > 0 && std::isfinite(critical))
      put(column_of(elements[e], OfElement::buckling), critical / internal[e].compression);
  }
}

std::vector<double> budget_under_load(const Machine& machine, const ElasticPose& pose, const ToolElasticity& tool) {
  const std::size_t elements = machine.topology().elements.size();
  const double size = tool.deflection.head<3>().norm();
  if (!(size > 0)) return std::vector<double>(elements + 1, std::numeric_limits<double>::quiet_NaN());
  Vector6d along = Vector6d::Zero();
  along.head<3>() = tool.deflection.head<3>() / size;
  std::vector<double> out = mechanics::shares(pose, elements, tool.to_tool * along, pose.loaded, false);
  for (double& x : out) x /= size;
  return out;
}

std::vector<double> budget_of_softest(const Machine& machine, const ElasticPose& pose, const ToolElasticity& tool,
                                      Eigen::Vector3d* direction) {
  const std::size_t elements = machine.topology().elements.size();
  const Eigen::MatrixXd block = tool.compliance.topLeftCorner<3, 3>();
  const linear::SymmetricEigen parts = linear::symmetric_eigen(block);
  Vector6d along = Vector6d::Zero();
  along.head<3>() = parts.vectors.col(2);
  Eigen::Index largest = 0;
  along.cwiseAbs().maxCoeff(&largest);
  if (along(largest) < 0) along = -along;
  if (direction != nullptr) *direction = along.head<3>();
  if (!(parts.values(2) > 0)) return std::vector<double>(elements + 1, std::numeric_limits<double>::quiet_NaN());
  const Vector6d w = tool.to_tool * along;
  std::vector<double> out = mechanics::shares(pose, elements, w, pose.unit * w, false);
  for (double& x : out) x /= parts.values(2);
  return out;
}

}  // namespace pmreport::analysis
