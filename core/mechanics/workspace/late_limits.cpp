#include <core/mechanics/workspace/late_limits.hpp>

#include <core/linear/inverses.hpp>
#include <core/linear/types.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/singularity/singularity.hpp>
#include <core/mechanics/transmission/index_margins.hpp>
#include <core/mechanics/transmission/pressure.hpp>
#include <core/mechanics/transmission/transmission.hpp>
#include <core/program/batches.hpp>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

namespace pmreport::mechanics {

namespace {

using linear::Matrix6d;

// Poses that are judged at a time: some hundred numbers of each stay in the second-level cache.
constexpr std::size_t block = 128;

program::Program wrenches_of(const Machine& machine) {
  std::vector<int> outputs(36);
  std::iota(outputs.begin(), outputs.end(), static_cast<int>(machine.layout().size()));
  return machine.program()->slice(outputs);
}

// Of m' m, three by two or three by three, the root of the largest eigenvalue.
double largest_singular_value(const Eigen::Matrix3d& m, bool two_columns) {
  if (two_columns) {
    const double a = m.col(0).squaredNorm(), b = m.col(0).dot(m.col(1)), c = m.col(1).squaredNorm();
    return std::sqrt(0.5 * (a + c + std::hypot(a - c, 2 * b)));
  }
  if (!m.allFinite()) return std::nan("");
  return std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(m.transpose() * m, Eigen::EigenvaluesOnly).eigenvalues()(2));
}

}  // namespace

struct LateLimits::Work {
  struct Asked {
    enum class Of { reading, pressure, condition, transmission, compliance } of;
    double min, max;
    int reading = 0;
    double drive_stiffness = 0;
    bool horizontal = false;

    bool lower() const { return std::isfinite(min); }
    bool upper() const { return std::isfinite(max); }
    std::size_t ends() const { return (lower() ? 1u : 0u) + (upper() ? 1u : 0u); }
  };
  explicit Work(const Machine& m) : machine(m) {}

  const Machine& machine;
  std::vector<Asked> asked = {};
  program::Batches cosines = {}, wrenches = {};
  double length = 0;
  std::optional<Transmission> transmission = {};

  std::size_t margins() const {
    std::size_t n = 0;
    for (const Asked& a : asked) n += a.ends() * (a.of == Asked::Of::pressure ? cosines.program().outputs().size() : 1);
    return n;
  }
  void judge(std::size_t count, const double* poses, double* out);
  void judge_block(std::size_t count, const double* poses, double* out);
  std::size_t pressures(std::size_t count, const double* poses, const Asked& a, double* out);
  double compliance(const Asked& a, const Matrix6d& inverse) const;
};

LateLimits::LateLimits(const Machine& machine) : work_(std::make_shared<Work>(machine)) {}
LateLimits::~LateLimits() = default;

void LateLimits::add_reading(int reading, double min, double max) { work_->asked.push_back({Work::Asked::Of::reading, min, max, reading}); }

void LateLimits::add_pressure(double min, double max) {
  if (work_->cosines.program().outputs().empty()) work_->cosines.of(squared_pressure_cosines(work_->machine));
  work_->asked.push_back({Work::Asked::Of::pressure, min, max});
}

void LateLimits::add_condition(double min, double max) {
  work_->length = characteristic_length(work_->machine);
  work_->wrenches.of(wrenches_of(work_->machine));
  work_->asked.push_back({Work::Asked::Of::condition, min, max});
}

void LateLimits::add_transmission(double min, double max) {
  if (!work_->transmission) work_->transmission.emplace(work_->machine);
  work_->asked.push_back({Work::Asked::Of::transmission, min, max});
}

void LateLimits::add_compliance(double drive_stiffness, bool horizontal, double min, double max) {
  work_->wrenches.of(wrenches_of(work_->machine));
  work_->asked.push_back({Work::Asked::Of::compliance, min, max, 0, drive_stiffness, horizontal});
}

std::function<void(std::size_t, const double*, double*)> LateLimits::judge() const {
  return [work = work_](std::size_t count, const double* poses, double* out) { work->judge(count, poses, out); };
}

std::optional<program::Guided> LateLimits::over_boxes() const {
  std::vector<IndexLimit> limits;
  for (const Work::Asked& a : work_->asked) {
    if (a.of != Work::Asked::Of::pressure && a.of != Work::Asked::Of::transmission) return {};
    limits.push_back({a.of == Work::Asked::Of::pressure ? IndexLimit::Of::pressure : IndexLimit::Of::transmission, a.min, a.max});
  }
  if (limits.empty()) return {};
  return index_margins(work_->machine, limits);
}

// By squares of cosines: the angle is between 0 and 90 degrees. Gives how many margins were written.
std::size_t LateLimits::Work::pressures(std::size_t count, const double* poses, const Asked& a, double* out) {
  const std::size_t n = cosines.program().outputs().size();
  std::vector<double> squares(n * count);
  cosines.run(count, poses, squares.data());
  const auto squared_cosine = [](double end) {
    const double angle = std::clamp(end, 0.0, std::numbers::pi / 2);
    return std::cos(angle) * std::cos(angle);
  };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < count; ++k) {
      const double square = squares[i * count + k];
      if (a.lower()) out[a.ends() * i * count + k] = squared_cosine(a.min) - square;
      if (a.upper()) out[(a.ends() * i + (a.lower() ? 1 : 0)) * count + k] = square - squared_cosine(a.max);
    }
  return a.ends() * n;
}

double LateLimits::Work::compliance(const Asked& a, const Matrix6d& inverse) const {
  const auto actuated = inverse.leftCols(static_cast<Eigen::Index>(machine.topology().actuators.size())).topRows<3>();
  return largest_singular_value(actuated * actuated.transpose() / a.drive_stiffness, a.horizontal);
}

void LateLimits::Work::judge(std::size_t count, const double* poses, double* out) {
  const auto n = static_cast<std::size_t>(machine.dof());
  const std::size_t all = margins();
  std::vector<double> some(n * block), found(all * block);
  for (std::size_t first = 0; first < count; first += block) {
    const std::size_t size = std::min(block, count - first);
    for (std::size_t i = 0; i < n; ++i) std::copy_n(poses + i * count + first, size, some.data() + i * size);
    judge_block(size, some.data(), found.data());
    for (std::size_t m = 0; m < all; ++m) std::copy_n(found.data() + m * size, size, out + m * count + first);
  }
}

void LateLimits::Work::judge_block(std::size_t count, const double* poses, double* out) {
  const auto n = static_cast<std::size_t>(machine.dof());
  std::vector<double> q(n), rows, inverses;
  Transmission::Work of_transmission;
  TransmissionIndices indices;
  if (!wrenches.program().outputs().empty()) {
    rows.resize(36 * count);
    wrenches.run(count, poses, rows.data());
  }
  const auto matrix = [count](const std::vector<double>& entries, std::size_t k) {
    Matrix6d m;
    for (Eigen::Index e = 0; e < 36; ++e) m(e / 6, e % 6) = entries[static_cast<std::size_t>(e) * count + k];
    return m;
  };
  for (const Asked& a : asked) {
    if (a.of == Asked::Of::pressure) {
      out += pressures(count, poses, a, out) * count;
      continue;
    }
    if (a.of == Asked::Of::compliance && inverses.empty()) {
      inverses.resize(36 * count);
      linear::inverses(count, rows.data(), inverses.data());
    }
    for (std::size_t k = 0; k < count; ++k) {
      double value = std::nan("");
      if (a.of == Asked::Of::compliance) {
        value = compliance(a, matrix(inverses, k));
      } else if (a.of == Asked::Of::condition) {
        if (const Matrix6d g = matrix(rows, k); g.allFinite()) value = conditioning(machine, g, length).condition();
      } else if (a.of == Asked::Of::transmission) {
        for (std::size_t i = 0; i < n; ++i) q[i] = poses[i * count + k];
        if (transmission->at(q, of_transmission, indices)) value = indices.local;
      } else {
        for (std::size_t i = 0; i < n; ++i) q[i] = poses[i * count + k];
        if (const Pose pose = machine.pose(q); pose.status == PM_OK) value = machine.readings(q, pose)[static_cast<std::size_t>(a.reading)];
      }
      if (a.lower()) out[k] = value - a.min;
      if (a.upper()) out[(a.lower() ? count : 0) + k] = a.max - value;
    }
    out += a.ends() * count;
  }
}

}  // namespace pmreport::mechanics
