// What indices of transmission are made of, recorded: of every drive its rates, and the forces, points and directions of its paths.
//
// Bodies move with the coordinates: where these change at rates u, a point x of a body has the velocity (dx/dq) u, and the platform of
// place p and rotation R turns at (dR/dq u) R^T. Of a row of G the direction alone counts, so it stands without common divisors
// (common_divisors.hpp): times a number of its own, of either sign.
#pragma once

#include <core/mechanics/machine/machine.hpp>
#include <core/mechanics/transmission/transmission_paths.hpp>
#include <core/program/recorder.hpp>

#include <vector>

namespace pmreport::mechanics {

class RecordedDrives {
 public:
  // With `guides` further inputs behind the coordinates. The machine must record its geometry.
  explicit RecordedDrives(const Machine& machine, int guides = 0);

  std::size_t size() const { return drives_.size(); }
  program::Recorder& recorder() { return recorder_; }

  // A = dr/dq: of actuator i by coordinate c.
  Recorded rate(std::size_t i, std::size_t c) const { return partial(i, c); }
  // The same times a number of row i: the power of its wrench on the platform, of a single force at the point that it acts at. Where dr/dq
  // is a derivative of roots and arcs, this is no more than the wrench.
  Recorded power(std::size_t i, std::size_t c) const;
  // f of the pressure angle: the line of a telescopic drive, not of unit length, or the force of its row of G.
  Vector3<Recorded> pressure_force(std::size_t i) const { return drives_[i].telescope ? vector(Of::line, i) : force(i); }
  // v of the pressure angle, with coordinates that change at `rates`; of a point that is the mean of several, as many times it.
  Vector3<Recorded> pressure_velocity(std::size_t i, const std::vector<Recorded>& rates) const {
    return velocity(Of::pressure_point, i, rates);
  }
  // The force of row i of G.
  Vector3<Recorded> force(std::size_t i) const { return wrench(i, 0); }
  // Of the point of the platform where that force acts; likewise.
  Vector3<Recorded> output_velocity(std::size_t i, const std::vector<Recorded>& rates) const {
    return velocity(Of::output_point, i, rates);
  }
  // The way the drive moves what it moves: of a slide its axis; of a motor across its axis and the arm to the next joint; of any length.
  Vector3<Recorded> input_way(std::size_t i) const { return vector(Of::input_way, i); }

 private:
  enum class Of : std::size_t { pressure_point, line, output_point, input_way, count };
  static program::Program numbers_of(const Machine& machine, const std::vector<DrivePath>& drives);

  Vector3<Recorded> wrench(std::size_t i, std::size_t first) const;  // 0: its force; 3: its moment
  std::size_t platform() const { return at(Of::count, 0); }          // its place, then its rotation by rows
  std::size_t partials() const { return platform() + 12; }
  std::size_t at(Of what, std::size_t i) const { return size() + 3 * (static_cast<std::size_t>(what) * size() + i); }
  Recorded partial(std::size_t output, std::size_t coordinate) const;
  Vector3<Recorded> vector(Of what, std::size_t i) const;
  Vector3<Recorded> velocity(Of what, std::size_t i, const std::vector<Recorded>& rates) const;

  std::vector<DrivePath> drives_;
  program::Recorder recorder_;
};

}  // namespace pmreport::mechanics
