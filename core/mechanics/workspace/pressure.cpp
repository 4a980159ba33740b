#include <core/mechanics/workspace/pressure.hpp>

#include <core/mechanics/workspace/limb_line.hpp>
#include <core/program/derivative.hpp>
#include <core/program/recorder.hpp>
#include <pmreport/scalar.hpp>

#include <fmt/format.h>

#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace pmreport::mechanics {

namespace {

// The drives of all actuators; nothing where one is no telescopic drive.
std::optional<std::vector<TelescopicDrive>> drives_of(const Machine& machine, std::string* why) {
  std::vector<TelescopicDrive> out;
  for (int i = 0; i < machine.dof(); ++i) {
    const std::optional<TelescopicDrive> drive = telescopic_drive(machine, i);
    if (!drive) {
      if (why != nullptr)
        *why = fmt::format("the pressure angle of {} is not known: it is no drive along a limb that is a line",
                           machine.topology().actuators[static_cast<std::size_t>(i)].name);
      return std::nullopt;
    }
    out.push_back(*drive);
  }
  return out;
}

// Outputs: the actuators, then the line of each drive, from its near end to its far one, then the partials of all of these.
program::Program motions_of_drives(const Machine& machine, const std::vector<TelescopicDrive>& drives) {
  const Layout& layout = machine.layout();
  program::Recorder recorder(*machine.program());
  const auto at = [&](std::size_t first) { return recorder.output(static_cast<int>(first)); };
  std::vector<Recorded> outputs;
  for (std::size_t i = 0; i < drives.size(); ++i) outputs.push_back(at(layout.actuator(static_cast<int>(i))));
  for (const TelescopicDrive& d : drives)
    for (std::size_t x = 0; x < 3; ++x) outputs.push_back(at(layout.joint(d.far) + x) - at(layout.joint(d.near) + x));
  std::vector<int> by(static_cast<std::size_t>(machine.dof()));
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

bool pressure_known(const Machine& machine, std::string* why) { return drives_of(machine, why).has_value(); }

program::Program squared_pressure_cosines(const Machine& machine) {
  const std::vector<TelescopicDrive> drives = drives_of(machine, nullptr).value();
  const program::Program motions = motions_of_drives(machine, drives);
  program::Recorder recorder(motions);
  const std::size_t n = drives.size(), values = 4 * n;
  const auto partial = [&](std::size_t o, std::size_t by) { return recorder.output(static_cast<int>(values + o * n + by)); };
  std::vector<std::vector<Recorded>> rates(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t c = 0; c < n; ++c) rates[i].push_back(partial(i, c));
  Minors minors(std::move(rates));
  std::vector<Recorded> outputs;
  for (std::size_t i = 0; i < n; ++i) {
    Vector3<Recorded> line, v;
    for (std::size_t x = 0; x < 3; ++x) {
      const std::size_t o = n + 3 * i + x;
      Recorded sum(0.0);
      for (std::size_t c = 0; c < n; ++c) sum += partial(o, c) * minors.cofactor(i, c);
      line(static_cast<Eigen::Index>(x)) = recorder.output(static_cast<int>(o));
      v(static_cast<Eigen::Index>(x)) = sum;
    }
    // Where v is zero, so is the numerator.
    const Recorded along = line.dot(v), lengths = line.dot(line) * v.dot(v);
    outputs.push_back(along * along / larger(lengths, Recorded(std::numeric_limits<double>::min())));
  }
  return recorder.finish(outputs);
}

}  // namespace pmreport::mechanics
