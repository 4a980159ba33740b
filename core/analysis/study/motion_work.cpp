// Power has no closed integral, so it is added up by a pair of Gauss and Kronrod rules: seven points give exact integrals of polynomials to
// degree 13, eight more to degree 22, and the difference tells how far the interval must be halved, and what is left open at last. No
// interval straddles a knot of the motion or of its load. Kinks elsewhere (of the power that turns its sign, where only the negative part
// counts) cost a few halvings where they stand.
#include <core/analysis/samples/motion_probe.hpp>
#include <core/analysis/samples/stretch.hpp>
#include <core/analysis/study/motion_work.hpp>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
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

constexpr int fewest_panels = 32, most_halvings = 20;
constexpr std::size_t most_panels = 50'000;  // of a motion with that many knots; with more they are not minded, and the error tells
constexpr int most_intervals = 512;          // of a panel: a kink takes some forty; where all is rounding, halving has no end
constexpr double smooth_tolerance = 1e-12;   // error of an interval's total work, of all that flows: far below what anyone asks
constexpr double part_tolerance = 1e-7;      // of negative power alone: finer than anyone reads it

// Over an interval: the integrals of each actuator's power, of its negative part, and of the load's power.
struct Integrals {
  std::vector<double> sums;
  double gross = 0;                // of the magnitudes of all powers
  double open = 0, part_open = 0;  // by how much two rules differ, in total work, and in the worst of the parts
  void add(const Integrals& more) {
    sums.resize(more.sums.size());
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += more.sums[k];
    gross += more.gross, open += more.open, part_open += more.part_open;
  }
};

// Nothing where the motion has no pose.
std::optional<Integrals> over(MotionProbe& probe, double from, double to) {
  const double middle = (from + to) / 2, half = (to - from) / 2;
  Integrals out;
  std::vector<double> coarse, powers;
  for (std::size_t i = 0; i < abscissa.size(); ++i)
    for (const double side : {-1.0, 1.0}) {
      if (abscissa[i] == 0 && side > 0) continue;
      if (!probe.go(middle + side * half * abscissa[i])) return std::nullopt;
      probe.powers(powers);
      const std::size_t m = powers.size() - 1;
      out.sums.resize(2 * m + 1), coarse.resize(2 * m + 1);
      for (std::size_t k = 0; k < 2 * m + 1; ++k) {
        const double f = half * (k < m ? powers[k] : k < 2 * m ? std::min(powers[k - m], 0.0) : powers[m]);
        out.sums[k] += kronrod[i] * f;
        if (i % 2 == 1) coarse[k] += gauss[i / 2] * f;
        if (k < m || k == 2 * m) out.gross += kronrod[i] * std::abs(f);
      }
    }
  const std::size_t m = coarse.size() / 2;
  double total = 0;
  for (std::size_t k = 0; k < coarse.size(); ++k) {
    const double error = out.sums[k] - coarse[k];
    if (k < m || k == 2 * m) total += error;
    out.part_open = std::max(out.part_open, std::abs(error));
  }
  out.open = std::abs(total);
  return out;
}

// The same, halved until two rules agree or the budget is spent; what they leave open is in the result.
std::optional<Integrals> refined(MotionProbe& probe, const Integrals& whole, double from, double to, double flow, int halvings,
                                 int& intervals) {
  const bool good = whole.open <= smooth_tolerance * flow && whole.part_open <= part_tolerance * flow;
  if (good || halvings == most_halvings || intervals >= most_intervals) return whole;
  intervals += 2;
  const double middle = (from + to) / 2;
  Integrals out;
  for (const auto& [a, b] : {std::pair{from, middle}, {middle, to}}) {
    const auto first = over(probe, a, b);
    const auto half = first ? refined(probe, *first, a, b, flow, halvings + 1, intervals) : std::nullopt;
    if (!half) return std::nullopt;
    out.add(*half);
  }
  return out;
}

// From `from` to `to`, rising: a panel is never longer than a share of the whole, and no knot lies inside one.
std::vector<double> panels(double from, double to, const std::vector<double>& knots) {
  std::vector<double> corners{from};
  if (knots.size() <= most_panels)
    std::copy_if(knots.begin(), knots.end(), std::back_inserter(corners), [&](double t) { return t > from && t < to; });
  corners.push_back(to);
  std::vector<double> out{from};
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const double length = corners[i] - corners[i - 1];
    const int parts = std::max(1, static_cast<int>(std::ceil(length / (to - from) * fewest_panels)));
    for (int n = 1; n < parts; ++n) out.push_back(corners[i - 1] + length * n / parts);
    out.push_back(corners[i]);
  }
  return out;
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

namespace {

// In and out of what is stored, by samples: a scale needs no more. Where the platform falls freely nothing else flows.
double stored_and_back(const Analysis& a, const SampleRun& run) {
  double out = 0;
  for (int k = run.first; k < run.last; ++k)
    for (const OfMachine what : {OfMachine::kinetic_energy, OfMachine::potential_energy}) {
      const std::vector<double>& energy = a.column(column_of(what));
      const double change = energy[static_cast<std::size_t>(k) + 1] - energy[static_cast<std::size_t>(k)];
      if (std::isfinite(change)) out += std::abs(change);
    }
  return out;
}

// What rounding may make of the balance over a run: of the forces, which lose the digits of the condition number; of the energies at both
// ends; and of the times there, at which the rates are taken.
double rounding_of(const Analysis& a, const SampleRun& run, double gross) {
  constexpr double roundings = 64 * std::numeric_limits<double>::epsilon();  // in a row, of what is computed from a pose
  double condition = 1, mass = 0;
  for (int k = run.first; k <= run.last; ++k) condition = std::fmax(condition, a.wrenches(k).condition);
  for (const Body& b : a.machine().topology().bodies) mass += b.inertia.mass;
  double ends = 2 * mass * a.scenario().load.gravity.norm() * a.length();
  for (const int k : {run.first, run.last}) {
    const auto sample = static_cast<std::size_t>(k);
    for (const OfMachine what : {OfMachine::kinetic_energy, OfMachine::potential_energy})
      ends += std::abs(a.column(column_of(what))[sample]);
    double power = std::abs(a.column(column_of(OfMachine::load_power))[sample]);
    for (const Actuator& x : a.machine().topology().actuators) power += std::abs(a.column(column_of(x, OfActuator::power))[sample]);
    ends += power * std::abs(a.time()[sample]);
  }
  return roundings * (condition * gross + ends);
}

}  // namespace

std::optional<MotionWork> motion_work(const Analysis& a) {
  const std::vector<SampleRun> found = runs_with_forces(a);
  if (found.empty() || !a.crossings().empty()) return std::nullopt;
  const std::size_t m = a.machine().topology().actuators.size();
  MotionWork out;
  out.whole = found.size() == 1 && found.front().first == 0 && found.front().last == a.samples() - 1;
  out.closed = out.whole && returns(a);
  const std::vector<double> knots = knots_along(a.trajectory(), a.scenario().load);
  Integrals all;
  all.sums.assign(2 * m + 1, 0.0);
  tbb::enumerable_thread_specific<MotionProbe> probes([&] { return MotionProbe(a.trajectory(), a.scenario().load, a.machine()); });
  for (const SampleRun& run : found) {
    const auto first = static_cast<std::size_t>(run.first), last = static_cast<std::size_t>(run.last);
    out.stored += energy_at(a, last) - energy_at(a, first);
    const std::vector<double> corners = panels(a.time()[first], a.time()[last], knots);
    std::vector<std::optional<Integrals>> parts(corners.size() - 1);
    tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t i) { parts[i] = over(probes.local(), corners[i], corners[i + 1]); });
    if (!std::all_of(parts.begin(), parts.end(), [](const auto& p) { return p.has_value(); })) return std::nullopt;
    double flow = stored_and_back(a, run);
    for (const auto& part : parts) flow += part->gross;
    tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t i) {
      int intervals = 1;
      parts[i] = refined(probes.local(), *parts[i], corners[i], corners[i + 1], flow, 0, intervals);
    });
    Integrals sum;
    for (const auto& part : parts) {
      if (!part) return std::nullopt;
      sum.add(*part);
    }
    all.add(sum);
    out.flow += flow;
    out.uncertainty += sum.open + rounding_of(a, run, sum.gross);
  }
  out.regenerated_uncertainty = all.part_open;
  out.actuators.assign(all.sums.begin(), all.sums.begin() + static_cast<std::ptrdiff_t>(m));
  for (std::size_t i = 0; i < m; ++i) out.regenerated.push_back(-all.sums[m + i] + 0.0);
  out.load = all.sums.back();
  return out;
}

}  // namespace pmreport::analysis
