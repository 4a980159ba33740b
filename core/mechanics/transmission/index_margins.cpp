#include <core/mechanics/transmission/index_margins.hpp>

#include <core/mechanics/transmission/guided_motions.hpp>
#include <core/mechanics/transmission/recorded_drives.hpp>
#include <core/program/batches.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

namespace pmreport::mechanics {

namespace {

constexpr double least_positive = std::numeric_limits<double>::min();

// Of an angle between two vectors, its cosine's absolute value against a limit. Zero vectors are across each other.
Recorded at_least(const Vector3<Recorded>& f, const Vector3<Recorded>& v, double cosine) {
  const Recorded along = f.dot(v);
  return along * along - cosine * cosine * f.dot(f) * v.dot(v) - least_positive;
}
Recorded at_most(const Vector3<Recorded>& f, const Vector3<Recorded>& v, double cosine) {
  const Recorded along = f.dot(v);
  return cosine * cosine * f.dot(f) * v.dot(v) - along * along;
}

class Margins {
 public:
  explicit Margins(const Machine& machine)
      : drives_(machine, static_cast<int>(guides_of_motions(static_cast<std::size_t>(machine.dof())))) {
    const std::size_t n = drives_.size();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t c = 0; c < n; ++c) rates_.push_back(drives_.power(i, c));
    std::vector<Recorded> guides;
    for (std::size_t g = 0; g < guides_of_motions(n); ++g) guides.push_back(drives_.recorder().input(static_cast<int>(n + g)));
    motions_ = guided_motions(rates_, guides, n);
  }

  void pressure(const IndexLimit& limit) {
    const auto cosine_of = [](double angle) { return std::cos(std::clamp(angle, 0.0, std::numbers::pi / 2)); };
    for (std::size_t i = 0; i < drives_.size(); ++i) {
      const Vector3<Recorded> f = drives_.pressure_force(i), v = drives_.pressure_velocity(i, motions_[i]);
      // No angle is less than none, or more than a right one.
      if (std::isfinite(limit.min)) outputs_.push_back(limit.min > 0 ? at_most(f, v, cosine_of(limit.min)) : Recorded(1.0));
      if (std::isfinite(limit.max))
        outputs_.push_back(limit.max < std::numbers::pi / 2 ? at_least(f, v, cosine_of(limit.max)) : Recorded(1.0));
    }
  }

  // The least of all is no less than the lower end where none is, and no more than the upper one where one of them is not.
  void transmission(const IndexLimit& limit) {
    Recorded lower(1.0), upper(-1.0);
    const auto both = [&](const Vector3<Recorded>& f, const Vector3<Recorded>& v) {
      if (limit.min > 0) lower = smaller(lower, at_least(f, v, limit.min));
      if (limit.max >= 0 && std::isfinite(limit.max)) upper = larger(upper, at_most(f, v, limit.max));
    };
    for (std::size_t i = 0; i < drives_.size(); ++i) {
      both(drives_.force(i), drives_.output_velocity(i, motions_[i]));
      both(drives_.force(i), drives_.input_way(i));
    }
    if (std::isfinite(limit.min)) outputs_.push_back(lower);
    if (std::isfinite(limit.max)) outputs_.push_back(upper);
  }

  // Of the matrix of powers alone, by rows.
  program::Program rates() { return drives_.recorder().finish(rates_); }
  program::Program finish() { return drives_.recorder().finish(outputs_); }

 private:
  RecordedDrives drives_;
  std::vector<Recorded> rates_, outputs_;
  std::vector<std::vector<Recorded>> motions_;
};

}  // namespace

program::Guided index_margins(const Machine& machine, std::span<const IndexLimit> limits) {
  const auto n = static_cast<std::size_t>(machine.dof());
  Margins margins(machine);
  for (const IndexLimit& limit : limits) limit.of == IndexLimit::Of::pressure ? margins.pressure(limit) : margins.transmission(limit);
  const program::Program of_all = margins.rates();
  const auto rates = std::make_shared<program::Batches>(program::Program(of_all.steps(), machine.dof(), of_all.outputs()));
  const auto choose = [rates, n](std::size_t count, const double* poses, double* guides) {
    std::vector<double> a(n * n * count);
    rates->run(count, poses, a.data());
    linear::SmallMatrix at(n, n);
    for (std::size_t k = 0; k < count; ++k) {
      for (std::size_t e = 0; e < n * n; ++e) at(static_cast<Eigen::Index>(e / n), static_cast<Eigen::Index>(e % n)) = a[e * count + k];
      const std::vector<double> found = guides_of_motions(at);
      for (std::size_t g = 0; g < found.size(); ++g) guides[g * count + k] = found[g];
    }
  };
  return {margins.finish(), guides_of_motions(n), choose};
}

}  // namespace pmreport::mechanics
