#include <core/mechanics/workspace/late_limits.hpp>

#include <core/linear/square.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/singularity/singularity.hpp>
#include <core/mechanics/workspace/limb_line.hpp>
#include <core/program/batch.hpp>
#include <core/program/derivative.hpp>

#include <fmt/format.h>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>

namespace pmreport::mechanics {

namespace {

using linear::Matrix6d;

// Poses that are judged at a time: some hundred numbers of each stay in the second-level cache.
constexpr std::size_t block = 128;

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
    const auto between = [&](int from, int to) { return holds(line->from, from) && holds(line->to, to); };
    const bool telescopic = slide.kind == JointKind::prismatic && line && limb == t.bodies[static_cast<std::size_t>(slide.a)].limb &&
                            (between(slide.a, slide.b) || between(slide.b, slide.a));
    if (!telescopic) {
      if (why != nullptr) *why = fmt::format("the pressure angle of {} is not known: it is no drive along a limb that is a line", a.name);
      return std::nullopt;
    }
    out.push_back({line->from, line->to});
  }
  return out;
}

// Outputs: the actuators, then of each drive its near and its far end, then the partials of all of these.
program::Program motions_of_drives(const Machine& machine, const std::vector<Drive>& drives) {
  const Layout& layout = machine.layout();
  std::vector<int> outputs;
  for (std::size_t i = 0; i < drives.size(); ++i) outputs.push_back(static_cast<int>(layout.actuator(static_cast<int>(i))));
  for (const Drive& d : drives)
    for (const int joint : {d.near, d.far})
      for (int k = 0; k < 3; ++k) outputs.push_back(static_cast<int>(layout.joint(joint)) + k);
  std::vector<int> by(static_cast<std::size_t>(machine.dof()));
  std::iota(by.begin(), by.end(), 0);
  return program::partials(machine.program()->slice(outputs), by);
}

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

// Batches of one program, lent to one thread at a time: to make one costs more than a few poses.
class Batches {
 public:
  void of(program::Program program) { program_ = std::move(program); }
  const program::Program& program() const { return program_; }
  void run(std::size_t count, const double* in, double* out) {
    std::unique_ptr<program::Batch> batch;
    {
      const std::scoped_lock lock(mutex_);
      if (!idle_.empty()) batch = std::move(idle_.back()), idle_.pop_back();
    }
    if (!batch) batch = std::make_unique<program::Batch>(program_);
    batch->run(count, in, out);
    const std::scoped_lock lock(mutex_);
    idle_.push_back(std::move(batch));
  }

 private:
  program::Program program_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<program::Batch>> idle_;
};

}  // namespace

bool pressure_known(const Machine& machine, std::string* why) { return drives_of(machine, why).has_value(); }

struct LateLimits::Work {
  struct Asked {
    enum class Of { reading, pressure, condition, compliance } of;
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
  std::vector<Drive> drives = {};
  Batches motions = {}, wrenches = {};
  double length = 0;

  std::size_t margins() const {
    std::size_t n = 0;
    for (const Asked& a : asked) n += a.ends() * (a.of == Asked::Of::pressure ? drives.size() : 1);
    return n;
  }
  void judge(std::size_t count, const double* poses, double* out);
  void judge_block(std::size_t count, const double* poses, double* out);
  std::size_t pressures(std::size_t count, const double* poses, const Asked& a, double* out);
  double index(const Asked& a, const Matrix6d& g) const;
};

LateLimits::LateLimits(const Machine& machine) : work_(std::make_shared<Work>(machine)) {}
LateLimits::~LateLimits() = default;

void LateLimits::add_reading(int reading, double min, double max) { work_->asked.push_back({Work::Asked::Of::reading, min, max, reading}); }

void LateLimits::add_pressure(double min, double max) {
  if (work_->drives.empty()) {
    work_->drives = drives_of(work_->machine, nullptr).value_or(std::vector<Drive>());
    work_->motions.of(motions_of_drives(work_->machine, work_->drives));
  }
  work_->asked.push_back({Work::Asked::Of::pressure, min, max});
}

void LateLimits::add_condition(double min, double max) {
  work_->length = characteristic_length(work_->machine);
  work_->wrenches.of(wrenches_of(work_->machine));
  work_->asked.push_back({Work::Asked::Of::condition, min, max});
}

void LateLimits::add_compliance(double drive_stiffness, bool horizontal, double min, double max) {
  work_->wrenches.of(wrenches_of(work_->machine));
  work_->asked.push_back({Work::Asked::Of::compliance, min, max, 0, drive_stiffness, horizontal});
}

std::function<void(std::size_t, const double*, double*)> LateLimits::judge() const {
  return [work = work_](std::size_t count, const double* poses, double* out) { work->judge(count, poses, out); };
}

// By cosines: the angle is between 0 and 90 degrees. Gives how many margins were written.
std::size_t LateLimits::Work::pressures(std::size_t count, const double* poses, const Asked& a, double* out) {
  const std::size_t n = drives.size(), values = n + 6 * n;
  std::vector<double> numbers(motions.program().outputs().size() * count);
  motions.run(count, poses, numbers.data());
  const auto value = [&](std::size_t o, std::size_t k) { return numbers[o * count + k]; };
  const auto partial = [&](std::size_t o, std::size_t by, std::size_t k) { return numbers[(values + o * n + by) * count + k]; };
  for (std::size_t k = 0; k < count; ++k) {
    // Of five freedoms the sixth row and column are those of the unit matrix, and stand aside.
    Matrix6d rates = Matrix6d::Identity();
    for (std::size_t r = 0; r < n; ++r)
      for (std::size_t c = 0; c < n; ++c) rates(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)) = partial(r, c, k);
    const Matrix6d moved = linear::inverse_of_jacobian(rates);
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
      if (a.lower()) out[a.ends() * i * count + k] = std::cos(a.min) - cosine;
      if (a.upper()) out[(a.ends() * i + (a.lower() ? 1 : 0)) * count + k] = cosine - std::cos(a.max);
    }
  }
  return a.ends() * n;
}

double LateLimits::Work::index(const Asked& a, const Matrix6d& g) const {
  if (!g.allFinite()) return std::nan("");
  if (a.of == Asked::Of::condition) return conditioning(machine, g, length).condition();
  const Matrix6d moved = linear::inverse_of_jacobian(g);
  const auto actuated = moved.leftCols(static_cast<Eigen::Index>(machine.topology().actuators.size())).topRows<3>();
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
  std::vector<double> q(n), rows;
  if (!wrenches.program().outputs().empty()) {
    rows.resize(36 * count);
    wrenches.run(count, poses, rows.data());
  }
  for (const Asked& a : asked) {
    if (a.of == Asked::Of::pressure) {
      out += pressures(count, poses, a, out) * count;
      continue;
    }
    for (std::size_t k = 0; k < count; ++k) {
      double value = std::nan("");
      if (a.of == Asked::Of::reading) {
        for (std::size_t i = 0; i < n; ++i) q[i] = poses[i * count + k];
        if (const Pose pose = machine.pose(q); pose.status == PM_OK) value = machine.readings(q, pose)[static_cast<std::size_t>(a.reading)];
      } else {
        Matrix6d g;
        for (Eigen::Index e = 0; e < 36; ++e) g(e / 6, e % 6) = rows[static_cast<std::size_t>(e) * count + k];
        value = index(a, g);
      }
      if (a.lower()) out[k] = value - a.min;
      if (a.upper()) out[(a.lower() ? count : 0) + k] = a.max - value;
    }
    out += a.ends() * count;
  }
}

}  // namespace pmreport::mechanics
