#include <tests/judges/calculix_model.hpp>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace pmreport::judges {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

std::vector<CalculixModel::Answer> CalculixModel::under(std::span<const Vector6d> loads) const {
  std::vector<CalculixDeck::Loads> on_platform;
  for (const Vector6d& w : loads) on_platform.push_back({{platform_, w}});
  std::vector<int> watched{platform_};
  for (const SpringOf& s : springs_) watched.push_back(s.node);
  for (const Beam& beam : beams_)
    for (const Part& part : beam.parts) watched.insert(watched.end(), part.gauges.begin(), part.gauges.end());
  const std::vector<Element>& elements = machine_.topology().elements;
  std::vector<Answer> out;
  for (const Displacements& u : deck_.solve(on_platform, watched)) {
    out.push_back({u.col(0), std::vector<Carried>(elements.size())});
    Index at = 1;
    for (const SpringOf& s : springs_) out.back().carried[static_cast<std::size_t>(s.element)].axial = s.stiffness * u(0, at++);
    for (const Beam& beam : beams_) {
      const Element& e = elements[static_cast<std::size_t>(beam.element)];
      Carried& c = out.back().carried[static_cast<std::size_t>(beam.element)];
      for (const Part& part : beam.parts)
        for (std::size_t k = 0; k < part.gauges.size(); k += 6, at += 6) {
          const double axial = e.material.modulus * e.section.area * u(0, at);
          if (std::abs(axial) > std::abs(c.axial)) c.axial = axial;
          c.torque = std::max(c.torque, std::abs(e.material.shear_modulus * e.section.torsion * u(0, at + 1)));
          if (e.bends == Bending::none) continue;
          for (Index end = 0; end < 2; ++end)
            c.bending = std::max(c.bending, e.material.modulus * std::hypot(e.section.bending[0] * u(0, at + 2 + end),
                                                                            e.section.bending[1] * u(0, at + 4 + end)));
        }
    }
  }
  return out;
}

Matrix6d CalculixModel::compliance() const {
  std::vector<Vector6d> loads;
  for (int k = 0; k < 6; ++k) loads.emplace_back(Vector6d::Unit(k));
  Matrix6d out;
  const std::vector<Answer> answers = under(loads);
  for (int k = 0; k < 6; ++k) out.col(k) = answers[static_cast<std::size_t>(k)].platform;
  return out;
}

Matrix6d CalculixModel::inertia() const {
  std::vector<CalculixDeck::Loads> loads;
  std::vector<int> watched;
  for (int k = 0; k < 6; ++k) loads.push_back({{platform_, Vector6d::Unit(k)}});
  for (const Lump& lump : lumps_) watched.push_back(lump.node);
  const std::vector<Displacements> all = deck_.solve(loads, watched);
  Matrix6d out = Matrix6d::Zero(), u;
  for (std::size_t i = 0; i < lumps_.size(); ++i) {
    for (int k = 0; k < 6; ++k) u.col(k) = all[static_cast<std::size_t>(k)].col(static_cast<Index>(i));
    out += u.transpose() * lumps_[i].inertia * u;
  }
  return out;
}

Vector6d CalculixModel::sag(const Vector3d& gravity) const {
  CalculixDeck::Loads weights;
  for (const Lump& lump : lumps_) weights.push_back({lump.node, lump.inertia.leftCols<3>() * gravity});
  return deck_.solve({weights}, {platform_}).front().col(0);
}

// With F the flexibilities between the lumps and M = L L^T their inertia, F M u = u / omega^2, and for L^T F L y = y / omega^2, symmetric,
// u = omega^2 F L y has u . M u = 1.
std::vector<CalculixModel::Mode> CalculixModel::modes(Platform platform) const {
  CalculixDeck deck = deck_;
  if (platform == Platform::held)
    for (int k = 0; k < 6; ++k) deck.relate({{platform_, k, 1}});
  std::vector<CalculixDeck::Loads> loads;
  std::vector<int> watched;
  for (const Lump& lump : lumps_) {
    watched.push_back(lump.node);
    for (int k = 0; k < 6; ++k) loads.push_back({{lump.node, Vector6d::Unit(k)}});
  }
  const std::vector<Displacements> all = deck.solve(loads, watched);
  const auto n = static_cast<Index>(loads.size());
  MatrixXd flexibility(n, n), root = MatrixXd::Zero(n, n);
  for (std::size_t i = 0; i < lumps_.size(); ++i) {
    const auto at = static_cast<Index>(6 * i);
    for (Index c = 0; c < n; ++c) flexibility.block<6, 1>(at, c) = all[static_cast<std::size_t>(c)].col(static_cast<Index>(i));
    const Eigen::SelfAdjointEigenSolver<Matrix6d> parts(lumps_[i].inertia);
    root.block<6, 6>(at, at) = parts.eigenvectors() * parts.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal();
  }
  const MatrixXd form = root.transpose() * flexibility * root;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> parts(0.5 * (form + form.transpose()));
  std::vector<Mode> out;
  for (Index i = n; i-- > 0;) {
    const double value = parts.eigenvalues()(i);
    if (!(value > 1e-9 * parts.eigenvalues()(n - 1))) break;
    const VectorXd shape = flexibility * (root * parts.eigenvectors().col(i)) / value;
    out.push_back({1 / (2 * std::numbers::pi * std::sqrt(value)), shape.head<6>()});
  }
  return out;
}

}  // namespace pmreport::judges
