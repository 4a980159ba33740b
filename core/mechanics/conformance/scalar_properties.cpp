#include <core/mechanics/conformance/scalar_properties.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pmreport::mechanics {

namespace {

template <class Where>
void note(ScalarDeviation::Largest& largest, double deviation, Where&& where) {
  ++largest.evaluations;
  if (deviation <= largest.value) return;
  largest.value = std::isfinite(deviation) ? deviation : std::numeric_limits<double>::infinity();
  largest.where = where();
}

class ScalarComparison {
 public:
  explicit ScalarComparison(const Machine& machine)
      : machine_(machine), dof_(static_cast<std::size_t>(machine.dof())), n_(machine.layout().size()) {}

  // The first `count` poses at once.
  void run(const std::vector<double>& poses, std::size_t count, pm_order order) {
    const std::size_t c = machine_.components(order), in = order == PM_PARTIALS ? 1 : c;
    std::vector<double> one_q(dof_ * in), many_q(dof_ * in * count), one(n_ * c), many(n_ * c * count), one_g(36 * c),
        many_g(36 * c * count);
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t i = 0; i < dof_; ++i)
        for (std::size_t e = 0; e < in; ++e)
          many_q[(i * in + e) * count + k] = poses[k * dof_ + i] * (e == 0                 ? 1.0
                                                                    : order == PM_EXTENDED ? 1e-18
                                                                                           : 0.5 * static_cast<double>(e));
    const pm_status status = machine_.place(order, count, many_q.data(), many.data(), order == PM_EXTENDED ? &found.no_extended : nullptr);
    if (order == PM_EXTENDED && status != PM_OK) return;
    const bool wrenches = order != PM_EXTENDED;
    if (wrenches) machine_.jacobian(order, count, many.data(), many_g.data());
    for (std::size_t k = 0; k < count; ++k) {
      for (std::size_t s = 0; s < dof_ * in; ++s) one_q[s] = many_q[s * count + k];
      machine_.place(order, 1, one_q.data(), one.data());
      compare(one, many, count, k);
      if (wrenches) {
        machine_.jacobian(order, 1, one.data(), one_g.data());
        compare(one_g, many_g, count, k);
      } else {
        extended(one_q, one);
      }
    }
  }

  ScalarDeviation found;

 private:
  void compare(const std::vector<double>& one, const std::vector<double>& many, std::size_t count, std::size_t k) {
    double scale = 1;
    for (const double x : one) scale = std::max(scale, std::abs(x));
    for (std::size_t s = 0; s < one.size(); ++s)
      note(found.lanes, std::abs(one[s] - many[s * count + k]) / scale,
           [&] { return fmt::format("{} poses at once, number {}", count, s); });
  }
  void extended(const std::vector<double>& q2, const std::vector<double>& high_low) {
    std::vector<double> q(q2.size() / 2), x(high_low.size() / 2);
    for (std::size_t i = 0; i < q.size(); ++i) q[i] = q2[2 * i];
    machine_.place(PM_VALUE, 1, q.data(), x.data());
    for (std::size_t s = 0; s < x.size(); ++s)
      note(found.extended, std::abs(x[s] - high_low[2 * s]) / std::max(1.0, std::abs(x[s])), [&] { return fmt::format("number {}", s); });
  }

  const Machine& machine_;
  std::size_t dof_, n_;
};

}  // namespace

ScalarDeviation scalar_deviation(const Machine& machine, const std::vector<double>& poses) {
  ScalarComparison comparison(machine);
  for (const std::size_t count : {std::size_t{2}, std::size_t{7}, std::size_t{16}, std::size_t{61}}) {  // no lane width divides them all
    if (count * static_cast<std::size_t>(machine.dof()) > poses.size()) break;
    for (const pm_order order : {PM_VALUE, PM_JET, PM_PARTIALS, PM_EXTENDED}) comparison.run(poses, count, order);
  }
  return comparison.found;
}

}  // namespace pmreport::mechanics
