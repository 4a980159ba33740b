#include <core/mechanics/transmission/pressure.hpp>

#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/transmission/transmission_paths.hpp>
#include <core/program/derivative.hpp>
#include <core/program/recorder.hpp>
#include <pmreport/scalar.hpp>

#include <fmt/format.h>

#include <limits>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace pmreport::mechanics {

namespace {

// Outputs: the actuators; of each drive the point whose velocity counts, of a telescopic one its far end from its near one; of each drive
// its force; then the partials of all of these.
program::Program motions_of_drives(const Machine& machine, const std::vector<DrivePath>& drives) {
  const Topology& t = machine.topology();
  const Layout& layout = machine.layout();
  program::Recorder recorder(*machine.program());
  const auto at = [&](std::size_t first) { return recorder.output(static_cast<int>(first)); };
  const auto centres = [&](const BodyPoint& point, std::size_t x) {
    if (point.joints.empty()) return at(layout.body(point.body) + x);
    Recorded sum(0.0);
    for (const int j : point.joints) sum += at(layout.joint(j) + x);
    return sum;  // as many times the mean, which no angle tells apart
  };
  const auto point = [&](const DrivePath& d, std::size_t x) {
    return d.telescope ? at(layout.joint(d.telescope->far) + x) - at(layout.joint(d.telescope->near) + x) : centres(d.entry, x);
  };
  std::vector<Recorded> outputs;
  for (std::size_t i = 0; i < drives.size(); ++i) outputs.push_back(at(layout.actuator(static_cast<int>(i))));
  for (const DrivePath& d : drives)
    for (std::size_t x = 0; x < 3; ++x) outputs.push_back(point(d, x));
  for (std::size_t i = 0; i < drives.size(); ++i)
    for (std::size_t x = 0; x < 3; ++x) outputs.push_back(drives[i].telescope ? point(drives[i], x) : at(layout.size() + 6 * i + x));
  std::vector<int> by(t.coordinates.size());
  std::iota(by.begin(), by.end(), 0);
  return program::partials(recorder.finish(outputs), by);
}

// Minors of a square matrix, by its first row and the minors that are left (Laplace), each once.
class Minors {
 public:
  explicit Minors(std::vector<std::vector<Recorded>> matrix) : matrix_(std::move(matrix)) {}

  // Of all rows but `row` and all columns but `column`, with its sign.
  Recorded cofactor(std::size_t row, std::size_t column) {
    const unsigned all = (1u << matrix_.size()) - 1;
    const Recorded minor = of(all & ~(1u << row), all & ~(1u << column));
    return (row + column) % 2 == 0 ? minor : -minor;
  }

 private:
  Recorded of(unsigned rows, unsigned columns) {
    if (rows == 0) return Recorded(1.0);
    const auto known = known_.find({rows, columns});
    if (known != known_.end()) return known->second;
    std::size_t row = 0;
    while ((rows >> row & 1) == 0) ++row;
    Recorded sum(0.0);
    bool odd = false;
    for (std::size_t c = 0; c < matrix_.size(); ++c) {
      if ((columns >> c & 1) == 0) continue;
      const Recorded term = matrix_[row][c] * of(rows & ~(1u << row), columns & ~(1u << c));
      odd ? sum -= term : sum += term;
      odd = !odd;
    }
    return known_.emplace(std::pair(rows, columns), sum).first->second;
  }

  std::vector<std::vector<Recorded>> matrix_;
  std::map<std::pair<unsigned, unsigned>, Recorded> known_;
};

}  // namespace

bool pressure_known(const Machine& machine, std::string* why) {
  const TransmissionPaths paths = transmission_paths(machine, characteristic_length(machine));
  for (std::size_t i = 0; i < paths.drives.size(); ++i)
    if (!paths.drives[i].no_pressure.empty()) {
      if (why != nullptr)
        *why = fmt::format("the pressure angle of {} is not known: {}", machine.topology().actuators[i].name, paths.drives[i].no_pressure);
      return false;
    }
  return true;
}

program::Program squared_pressure_cosines(const Machine& machine) {
  const std::vector<DrivePath> drives = transmission_paths(machine, characteristic_length(machine)).drives;
  const program::Program motions = motions_of_drives(machine, drives);
  program::Recorder recorder(motions);
  const std::size_t n = drives.size(), values = 7 * n;
  const auto partial = [&](std::size_t o, std::size_t by) { return recorder.output(static_cast<int>(values + o * n + by)); };
  std::vector<std::vector<Recorded>> rates(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t c = 0; c < n; ++c) rates[i].push_back(partial(i, c));
  Minors minors(std::move(rates));
  std::vector<Recorded> outputs;
  for (std::size_t i = 0; i < n; ++i) {
    Vector3<Recorded> force, v;
    for (std::size_t x = 0; x < 3; ++x) {
      const std::size_t o = n + 3 * i + x;
      Recorded sum(0.0);
      for (std::size_t c = 0; c < n; ++c) sum += partial(o, c) * minors.cofactor(i, c);
      force(static_cast<Eigen::Index>(x)) = recorder.output(static_cast<int>(o + 3 * n));
      v(static_cast<Eigen::Index>(x)) = sum;
    }
    // Where v is zero, so is the numerator.
    const Recorded along = force.dot(v), lengths = force.dot(force) * v.dot(v);
    outputs.push_back(along * along / larger(lengths, Recorded(std::numeric_limits<double>::min())));
  }
  return recorder.finish(outputs);
}

}  // namespace pmreport::mechanics
