#include <core/mechanics/workspace/late_limits.hpp>

#include <core/linear/singular_values.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/model/overall_jacobian.hpp>
#include <core/mechanics/workspace/limb_line.hpp>
#include <core/program/batch.hpp>
#include <core/program/derivative.hpp>

#include <fmt/format.h>
#include <Eigen/LU>

#include <cmath>
#include <numeric>

namespace pmreport::mechanics {

namespace {

struct Drive {
  int near = 0, far = 0;  // joints at its ends
};

// The drives of all actuators; nothing where one is no telescopic drive.
std::optional<std::vector<Drive>> drives_of(const Machine& machine, std::string* why) {
  const Topology& t = machine.topology();
  std::vector<Drive> out;
  for (const Actuator& a : t.actuators) {
    const Joint& slide = t.joints[static_cast<std::size_t>(a.joint)];
    const int limb = t.bodies[static_cast<std::size_t>(slide.b)].limb;
    const auto holds = [&](int joint, int body) {
      const Joint& j = t.joints[static_cast<std::size_t>(joint)];
      return j.a == body || j.b == body;
    };
    const std::optional<LimbLine> line = limb_line(machine, limb);
    const bool telescopic =
        slide.kind == JointKind::prismatic && line && limb == t.bodies[static_cast<std::size_t>(slide.a)].limb &&
        ((holds(line->from, slide.a) && holds(line->to, slide.b)) || (holds(line->from, slide.b) && holds(line->to, slide.a)));
    if (!telescopic) {
      if (why != nullptr) *why = fmt::format("the pressure angle of {} is not known: it is no drive along a limb that is a line", a.name);
      return std::nullopt;
    }
    out.push_back({line->from, line->to});
  }
  return out;
}

// Outputs: the actuators, then of each drive its far end from its near end, then the partials of all of these.
program::Program motions_of_drives(const Machine& machine, const std::vector<Drive>& drives) {
  const program::Program& geometry = *machine.program();
  const Layout& layout = machine.layout();
  std::vector<int> outputs;
  for (std::size_t i = 0; i < drives.size(); ++i) outputs.push_back(static_cast<int>(layout.actuator(static_cast<int>(i))));
  for (const Drive& d : drives)
    for (const int joint : {d.near, d.far})
      for (int k = 0; k < 3; ++k) outputs.push_back(static_cast<int>(layout.joint(joint)) + k);
  std::vector<int> by(static_cast<std::size_t>(machine.dof()));
  std::iota(by.begin(), by.end(), 0);
  return program::partials(geometry.slice(outputs), by);
}

}  // namespace

bool pressure_known(const Machine& machine, std::string* why) { return drives_of(machine, why).has_value(); }

struct LateLimits::Work {
  struct Asked {
    enum class Of { reading, pressure, condition } of;
    int reading;
    double min, max;
  };
  const Machine& machine;
  std::vector<Asked> asked;
  std::vector<Drive> drives = {};
  program::Program motions = {};
  double length = 0;

  void judge(std::size_t count, const double* poses, double* out) const;
  std::size_t pressures(std::size_t count, const double* poses, const Asked& a, double* out) const;
};

LateLimits::LateLimits(const Machine& machine) : work_(std::make_shared<Work>(Work{machine, {}})) {}
LateLimits::~LateLimits() = default;

void LateLimits::add_reading(int reading, double min, double max) { work_->asked.push_back({Work::Asked::Of::reading, reading, min, max}); }

void LateLimits::add_pressure(double min, double max) {
  if (work_->drives.empty()) {
    work_->drives = drives_of(work_->machine, nullptr).value_or(std::vector<Drive>());
    work_->motions = motions_of_drives(work_->machine, work_->drives);
  }
  work_->asked.push_back({Work::Asked::Of::pressure, 0, min, max});
}

void LateLimits::add_condition(double min, double max) {
  work_->length = characteristic_length(work_->machine);
  work_->asked.push_back({Work::Asked::Of::condition, 0, min, max});
}

std::function<void(std::size_t, const double*, double*)> LateLimits::judge() const {
  return [work = work_](std::size_t count, const double* poses, double* out) { work->judge(count, poses, out); };
}

// By cosines: the angle is between 0 and 90 degrees. Gives how many margins were written.
std::size_t LateLimits::Work::pressures(std::size_t count, const double* poses, const Asked& a, double* out) const {
  const std::size_t n = drives.size(), values = n + 6 * n;
  program::Batch batch(motions);
  std::vector<double> numbers(motions.outputs().size() * count);
  batch.run(count, poses, numbers.data());
  const auto value = [&](std::size_t o, std::size_t k) { return numbers[o * count + k]; };
  const auto partial = [&](std::size_t o, std::size_t by, std::size_t k) { return numbers[(values + o * n + by) * count + k]; };
  const bool lower = std::isfinite(a.min), upper = std::isfinite(a.max);
  const std::size_t ends = (lower ? 1 : 0) + (upper ? 1 : 0);
  linear::SmallMatrix rates(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t r = 0; r < n; ++r)
      for (std::size_t c = 0; c < n; ++c) rates(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)) = partial(r, c, k);
    const linear::SmallMatrix moved = rates.inverse();
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t near = n + 6 * i, far = near + 3;
      Eigen::Vector3d line, v = Eigen::Vector3d::Zero();
      for (std::size_t x = 0; x < 3; ++x) {
        line(static_cast<Eigen::Index>(x)) = value(far + x, k) - value(near + x, k);
        for (std::size_t c = 0; c < n; ++c)
          v(static_cast<Eigen::Index>(x)) +=
              (partial(far + x, c, k) - partial(near + x, c, k)) * moved(static_cast<Eigen::Index>(c), static_cast<Eigen::Index>(i));
      }
      const double speed = v.norm(), cosine = speed > 0 ? std::abs(line.dot(v)) / (line.norm() * speed) : speed == 0 ? 0 : std::nan("");
      if (lower) out[(ends * i) * count + k] = std::cos(a.min) - cosine;
      if (upper) out[(ends * i + (lower ? 1 : 0)) * count + k] = cosine - std::cos(a.max);
    }
  }
  return ends * n;
}

void LateLimits::Work::judge(std::size_t count, const double* poses, double* out) const {
  const auto n = static_cast<std::size_t>(machine.dof());
  std::vector<double> q(n);
  for (const Asked& a : asked) {
    if (a.of == Asked::Of::pressure) {
      out += pressures(count, poses, a, out) * count;
      continue;
    }
    const bool lower = std::isfinite(a.min), upper = std::isfinite(a.max);
    for (std::size_t k = 0; k < count; ++k) {
      for (std::size_t i = 0; i < n; ++i) q[i] = poses[i * count + k];
      double value = std::nan("");
      if (const Pose pose = machine.pose(q); pose.status == PM_OK) {
        if (a.of == Asked::Of::reading) {
          value = machine.readings(q, pose)[static_cast<std::size_t>(a.reading)];
        } else if (const Jacobian g = machine.jacobian(pose); g.known()) {
          const linear::Vector6d s = linear::singular_values(dimensionless(machine, g.matrix, length));
          value = s(0) / s(5);
        }
      }
      if (lower) out[k] = value - a.min;
      if (upper) out[(lower ? count : 0) + k] = a.max - value;
    }
    out += ((lower ? 1u : 0u) + (upper ? 1u : 0u)) * count;
  }
}

}  // namespace pmreport::mechanics
