#include <core/mechanics/transmission/pressure.hpp>

#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/transmission/recorded_drives.hpp>
#include <core/mechanics/transmission/transmission_paths.hpp>
#include <pmreport/scalar.hpp>

#include <fmt/format.h>

#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace pmreport::mechanics {

namespace {

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
  RecordedDrives drives(machine);
  const std::size_t n = drives.size();
  std::vector<std::vector<Recorded>> rates(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t c = 0; c < n; ++c) rates[i].push_back(drives.rate(i, c));
  Minors minors(std::move(rates));
  std::vector<Recorded> outputs;
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<Recorded> column;
    for (std::size_t c = 0; c < n; ++c) column.push_back(minors.cofactor(i, c));
    const Vector3<Recorded> force = drives.pressure_force(i), v = drives.pressure_velocity(i, column);
    // Where v is zero, so is the numerator.
    const Recorded along = force.dot(v), lengths = force.dot(force) * v.dot(v);
    outputs.push_back(along * along / larger(lengths, Recorded(std::numeric_limits<double>::min())));
  }
  return drives.recorder().finish(outputs);
}

}  // namespace pmreport::mechanics
