// Power has no closed integral, so it is added up by a pair of Gauss and Kronrod rules: seven points give exact integrals of polynomials to
// degree 13, eight more to degree 22, and the difference tells how far the interval must be halved. Kinks (of a motion whose jerk jumps, of
// the power that turns its sign where only the negative part counts) cost a few halvings where they stand.
#include <core/analysis/samples/motion_probe.hpp>
#include <core/analysis/study/motion_work.hpp>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>

namespace pmreport::analysis {

namespace {

// R. Piessens et al., QUADPACK, 1983: abscissae on [-1, 1], weights of the 15 points, and of the seven among them.
constexpr std::array<double, 8> abscissa{0.991455371120812639206854697526329, 0.949107912342758524526189684047851,
                                         0.864864423359769072789712788640926, 0.741531185599394439863864773280788,
                                         0.586087235467691130294144691693013, 0.405845151377397166906606412076961,
                                         0.207784955007898467600689403773245, 0.0};
constexpr std::array<double, 8> kronrod{0.022935322010529224963732008058970, 0.063092092629978553290700663189204,
                                        0.104790010322250183839876322541518, 0.140653259715525918745189590510238,
                                        0.169004726639267902826583426598550, 0.190350578064785409913256402421014,
                                        0.204432940075298892414161999234649, 0.209482141084727828012999174891714};
constexpr std::array<double, 4> gauss{0.129484966168869693270611432679082, 0.279705391489276667901467771423780,
                                      0.381830050505118944950369775488975, 0.417959183673469387755102040816327};

constexpr int base_panels = 32, most_halvings = 20;
constexpr int most_intervals = 512;         // of a base panel: a kink takes some forty; where all is rounding, halving has no end
constexpr double smooth_tolerance = 1e-12;  // error of an interval's total work, of all that flows: far below what the evidence asks
constexpr double part_tolerance = 1e-7;     // of negative power alone: finer than anyone reads it

class Quadrature {
 public:
  Quadrature(MotionProbe& probe, double flow) : probe_(probe), flow_(flow) {}

  // Adds the integrals over [from, to]: of each actuator's power, of its negative part, of the load's power.
  bool add(double from, double to, std::vector<double>& sums, int halvings = 0) {
    const double middle = (from + to) / 2, half = (to - from) / 2;
    std::vector<double> fine, coarse;
    for (std::size_t i = 0; i < abscissa.size(); ++i)
      for (const double side : {-1.0, 1.0}) {
        if (abscissa[i] == 0 && side > 0) continue;
        if (!probe_.go(middle + side * half * abscissa[i])) return false;
        probe_.powers(powers_);
        const std::size_t m = powers_.size() - 1;
        fine.resize(2 * m + 1), coarse.resize(2 * m + 1);
        for (std::size_t k = 0; k < 2 * m + 1; ++k) {
          const double f = half * (k < m ? powers_[k] : k < 2 * m ? std::min(powers_[k - m], 0.0) : powers_[m]);
          fine[k] += kronrod[i] * f;
          if (i % 2 == 1) coarse[k] += gauss[i / 2] * f;
        }
      }
    if (halvings < most_halvings && intervals_ < most_intervals && !good(fine, coarse)) {
      intervals_ += 2;
      return add(from, middle, sums, halvings + 1) && add(middle, to, sums, halvings + 1);
    }
    sums.resize(fine.size());
    for (std::size_t k = 0; k < fine.size(); ++k) sums[k] += fine[k];
    return true;
  }

 private:
  bool good(const std::vector<double>& fine, const std::vector<double>& coarse) const {
    const std::size_t m = fine.size() / 2;
    double total = 0, part = 0;
    for (std::size_t k = 0; k < fine.size(); ++k) {
      const double error = fine[k] - coarse[k];
      if (k < m || k == 2 * m) total += error;
      part = std::max(part, std::abs(error));
    }
    return std::abs(total) <= smooth_tolerance * flow_ && part <= part_tolerance * flow_;
  }

  MotionProbe& probe_;
  double flow_;
  int intervals_ = 1;
  std::vector<double> powers_;
};

// All that flows, through actuators and load, and in and out of what is stored: where the platform falls freely only the last is more than
// rounding. By samples: a scale needs no more.
double flow_of(const Analysis& a) {
  std::vector<ColumnId> columns{column_of(OfMachine::load_power)};
  for (const Actuator& x : a.machine().topology().actuators) columns.push_back(column_of(x, OfActuator::power));
  double flow = 0;
  const auto add = [&](double piece) {
    if (std::isfinite(piece)) flow += piece;
  };
  for (std::size_t k = 0; k + 1 < a.time().size(); ++k) {
    for (const ColumnId& column : columns) {
      const std::vector<double>& p = a.column(column);
      add((std::abs(p[k]) + std::abs(p[k + 1])) / 2 * (a.time()[k + 1] - a.time()[k]));
    }
    for (const OfMachine what : {OfMachine::kinetic_energy, OfMachine::potential_energy}) {
      const std::vector<double>& energy = a.column(column_of(what));
      add(std::abs(energy[k + 1] - energy[k]));
    }
  }
  return flow;
}

double energy_at(const Analysis& a, std::size_t k) {
  return a.column(column_of(OfMachine::kinetic_energy))[k] + a.column(column_of(OfMachine::potential_energy))[k];
}

// Same pose and same rates, to what the rounding of a motion's expressions leaves of them.
bool returns(const Analysis& a) {
  constexpr double tolerance = 1e-9;
  const mechanics::Trajectory& m = a.trajectory();
  const auto same = [&](const Eigen::MatrixXd& x) {
    for (Eigen::Index i = 0; i < x.cols(); ++i) {
      const double scale = x.col(i).cwiseAbs().maxCoeff();
      if (std::abs(x(x.rows() - 1, i) - x(0, i)) > tolerance * scale) return false;
    }
    return true;
  };
  return same(m.value) && same(m.rate);
}

// The samples with forces, in runs.
std::vector<SampleRun> runs_with_forces(const Analysis& a) {
  const std::vector<double>& p = a.column(column_of(OfMachine::total_power));
  std::vector<SampleRun> out = runs(a.samples(), [&](int k) { return std::isfinite(p[static_cast<std::size_t>(k)]); });
  std::erase_if(out, [](const SampleRun& i) { return i.first == i.last; });
  return out;
}

}  // namespace

double MotionWork::work() const { return std::accumulate(actuators.begin(), actuators.end(), 0.0); }

std::optional<MotionWork> motion_work(const Analysis& a) {
  const std::vector<SampleRun> found = runs_with_forces(a);
  if (found.empty() || !a.crossings().empty()) return std::nullopt;
  const std::size_t m = a.machine().topology().actuators.size();
  MotionWork out;
  out.whole = found.size() == 1 && found.front().first == 0 && found.front().last == a.samples() - 1;
  out.closed = out.whole && returns(a);
  out.flow = flow_of(a);
  std::vector<double> sums(2 * m + 1, 0.0);
  tbb::enumerable_thread_specific<MotionProbe> probes([&] { return MotionProbe(a.trajectory(), a.scenario().load, a.machine()); });
  for (const SampleRun& run : found) {
    const auto first = static_cast<std::size_t>(run.first), last = static_cast<std::size_t>(run.last);
    out.stored += energy_at(a, last) - energy_at(a, first);
    const double from = a.time()[first], to = a.time()[last];
    std::vector<std::vector<double>> parts(base_panels);
    std::atomic<bool> reached = true;
    tbb::parallel_for(0, base_panels, [&](int i) {
      const auto end = [&](int n) { return n == base_panels ? to : from + (to - from) * n / base_panels; };
      if (!Quadrature(probes.local(), out.flow).add(end(i), end(i + 1), parts[static_cast<std::size_t>(i)])) reached = false;
    });
    if (!reached) return std::nullopt;
    for (const std::vector<double>& part : parts)
      for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += part[k];
  }
  out.actuators.assign(sums.begin(), sums.begin() + static_cast<std::ptrdiff_t>(m));
  for (std::size_t i = 0; i < m; ++i) out.regenerated.push_back(-sums[m + i] + 0.0);
  out.load = sums.back();
  return out;
}

}  // namespace pmreport::analysis
