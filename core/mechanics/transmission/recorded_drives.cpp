#include <core/mechanics/transmission/recorded_drives.hpp>

#include <core/mechanics/model/generic_model.hpp>
#include <core/program/common_divisors.hpp>
#include <core/program/derivative.hpp>
#include <pmreport/scalar.hpp>

#include <numeric>

namespace pmreport::mechanics {

namespace {

program::Program with_guides(const program::Program& p, int guides) { return {p.steps(), p.inputs() + guides, p.outputs()}; }

// Vectors of a placement, as it is recorded.
class Placed {
 public:
  Placed(const Machine& machine, program::Recorder& recorder) : m_(machine), recorder_(recorder) {}

  Vector3<Recorded> vector(std::size_t first) const {
    const auto at = [&](std::size_t k) { return recorder_.output(static_cast<int>(first + k)); };
    return {at(0), at(1), at(2)};
  }
  Vector3<Recorded> centre(int joint) const { return vector(m_.layout().joint(joint)); }
  Vector3<Recorded> axis(int joint) const { return vector(m_.layout().joint(joint) + 3); }
  // As many times the point as there are joints whose mean it is: no angle tells them apart.
  Vector3<Recorded> point(const BodyPoint& p) const {
    if (!p.exists()) return {0.0, 0.0, 0.0};
    if (p.joints.empty()) return vector(m_.layout().body(p.body));
    Vector3<Recorded> sum(0.0, 0.0, 0.0);
    for (const int j : p.joints) sum += centre(j);
    return sum;
  }
  Vector3<Recorded> input_way(int actuator, const DrivePath& d) const {
    const Topology& t = m_.topology();
    const int joint = t.actuators[static_cast<std::size_t>(actuator)].joint;
    if (t.joints[static_cast<std::size_t>(joint)].kind == JointKind::prismatic) return axis(joint);
    Vector3<Recorded> arm(0.0, 0.0, 0.0);
    for (const int j : d.next) arm += centre(j) - centre(joint);
    return axis(joint).cross(arm);
  }

 private:
  const Machine& m_;
  program::Recorder& recorder_;
};

}  // namespace

// Outputs: the actuators; then each kind of vector, of one drive after the other; the platform; then the partials of all of these; then the
// rows of G.
program::Program RecordedDrives::numbers_of(const Machine& machine, const std::vector<DrivePath>& drives) {
  const Layout& layout = machine.layout();
  program::Recorder recorder(*machine.program());
  const Placed placed(machine, recorder);
  std::vector<Recorded> outputs;
  for (std::size_t i = 0; i < drives.size(); ++i)
    outputs.push_back(recorder.output(static_cast<int>(layout.actuator(static_cast<int>(i)))));
  const auto number = [&](Of what, std::size_t i) -> Vector3<Recorded> {
    const DrivePath& d = drives[i];
    const auto along = [&] { return Vector3<Recorded>(placed.centre(d.telescope->far) - placed.centre(d.telescope->near)); };
    switch (what) {
      case Of::pressure_point:
        return d.telescope ? along() : placed.point(d.entry);
      case Of::line:
        return d.telescope ? along() : Vector3<Recorded>(0.0, 0.0, 0.0);
      case Of::output_point:
        return placed.point(d.output);
      case Of::input_way:
      case Of::count:
        break;
    }
    return placed.input_way(static_cast<int>(i), d);
  };
  for (std::size_t what = 0; what < static_cast<std::size_t>(Of::count); ++what)
    for (std::size_t i = 0; i < drives.size(); ++i) {
      const Vector3<Recorded> v = number(static_cast<Of>(what), i);
      for (Eigen::Index x = 0; x < 3; ++x) outputs.push_back(v(x));
    }
  for (std::size_t k = 0; k < 12; ++k) outputs.push_back(recorder.output(static_cast<int>(layout.body(machine.topology().platform) + k)));
  std::vector<int> by(machine.topology().coordinates.size()), rows(6 * drives.size());
  std::iota(by.begin(), by.end(), 0);
  std::iota(rows.begin(), rows.end(), static_cast<int>(layout.size()));
  return program::joined(program::partials(recorder.finish(outputs), by),
                         program::without_common_divisors(machine.program()->slice(rows), 6));
}

RecordedDrives::RecordedDrives(const Machine& machine, int guides)
    : drives_(transmission_paths(machine, characteristic_length(machine)).drives),
      recorder_(with_guides(numbers_of(machine, drives_), guides)) {}

Recorded RecordedDrives::partial(std::size_t output, std::size_t coordinate) const {
  return recorder_.output(static_cast<int>(partials() + output * size() + coordinate));
}

Vector3<Recorded> RecordedDrives::wrench(std::size_t i, std::size_t first) const {
  const std::size_t rows = partials() + partials() * size() + 6 * i + first;
  const auto x = [&](std::size_t k) { return recorder_.output(static_cast<int>(rows + k)); };
  return {x(0), x(1), x(2)};
}

Recorded RecordedDrives::power(std::size_t i, std::size_t c) const {
  const Vector3<Recorded> f = wrench(i, 0), m = wrench(i, 3);
  Recorded sum(0.0);
  const bool at_a_point = drives_[i].output.exists();
  for (std::size_t x = 0; x < 3; ++x) {
    sum += f(static_cast<Eigen::Index>(x)) * partial((at_a_point ? at(Of::output_point, i) : platform()) + x, c);
    if (at_a_point) continue;
    // The angular velocity about axis x: row z of dR/dq times row y of R, and so on in a ring.
    const std::size_t y = platform() + 3 + 3 * ((x + 1) % 3), z = platform() + 3 + 3 * ((x + 2) % 3);
    Recorded turn(0.0);
    for (std::size_t k = 0; k < 3; ++k) turn += partial(z + k, c) * recorder_.output(static_cast<int>(y + k));
    sum += m(static_cast<Eigen::Index>(x)) * turn;
  }
  return sum;
}

Vector3<Recorded> RecordedDrives::vector(Of what, std::size_t i) const {
  const auto x = [&](std::size_t k) { return recorder_.output(static_cast<int>(at(what, i) + k)); };
  return {x(0), x(1), x(2)};
}

Vector3<Recorded> RecordedDrives::velocity(Of what, std::size_t i, const std::vector<Recorded>& rates) const {
  Vector3<Recorded> v(0.0, 0.0, 0.0);
  for (std::size_t x = 0; x < 3; ++x)
    for (std::size_t c = 0; c < rates.size(); ++c) v(static_cast<Eigen::Index>(x)) += partial(at(what, i) + x, c) * rates[c];
  return v;
}

}  // namespace pmreport::mechanics
