// How well an actuator's motion and force pass on to the platform: the published indices, at a pose.
//
// Output twist i is the platform's twist where actuator i moves with unit rate and all others are held: column i of G^-1. All indices are
// cosines between a force and a velocity, 1 at best and 0 where the actuator cannot move the platform any more. With a force of direction f
// and the velocity v of the point that it acts at, under output twist i,
//     cos of the pressure angle    |f . v| / |v|,   0 where v = 0                                     (1)
//     output transmission          |g . v| / (|g| |v|)    of row i of G, a single force g at that point   (2)
//     input transmission           |g . s| / |g|          s the way the drive moves its next joint        (3)
//     constraint transmission      |c . w| / (|c| |w|)    of a couple c and column i of G^-1; of a single force as (2)   (4)
// (1) takes f along the slide of a telescopic drive and v as the velocity of its far end from its near end (Glazunov et al. 2008); of any
// other drive f = g / |g|, and v is that of the point where its limb holds the platform. (2) and (3) are the power coefficients of a
// transmission wrench with the output and the input twist: their power over the largest that force and velocity of these sizes could have
// (Takeda and Funabashi 1995; Wang, Wu, Liu 2010); for a force through the point of the pressure angle (2) is (1), the virtual coefficient
// of Chen and Angeles (2007). (4): Liu, Chen, Xie (2014). The local transmission index is the least of all (2) and (3).
//
// Where G is singular a column of its inverse has no length, yet a direction (scaled_inverse.hpp), which is all that counts here: the
// indices are zero there.
//
// Conditioning is that of G^ (overall_jacobian.hpp); of a platform that only translates, that of the three rows and columns of its motion.
#pragma once

#include <core/linear/types.hpp>
#include <core/mechanics/model/tangent.hpp>
#include <core/mechanics/transmission/transmission_paths.hpp>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace pmreport::mechanics {

struct TransmissionIndices {
  struct OfActuator {
    Vector6d twist;            // output twist (v; w) about the reference point, by unit rate; infinite where G is singular
    Eigen::Vector3d force;     // f of (1), unit
    Eigen::Vector3d velocity;  // v of (1), by unit rate
    double cosine, output, input;
  };
  // NaN where one is not known, as Transmission tells.
  std::array<OfActuator, 6> actuators;
  std::array<double, 6> constraints;
  double local;           // least of all output and input transmissions; NaN where one of them is not known
  double condition;       // largest over least singular value of G^; infinite where it is singular
  double conditioning;    // local conditioning index, 1 / condition
  double manipulability;  // 1 / |det G^|; infinite where it is singular
};

class Transmission {
 public:
  // `length`: that makes moments comparable with forces [m]; 0: the characteristic length. The machine must outlive it.
  explicit Transmission(const Machine& machine, double length = 0);

  const Machine& machine() const { return machine_; }
  double length() const { return length_; }  // [m]
  const TransmissionPaths& paths() const { return paths_; }
  bool has_pressure(int actuator) const { return drive(actuator).no_pressure.empty(); }
  bool has_output(int actuator) const { return drive(actuator).no_output.empty(); }  // and the input transmission with it
  bool has_constraint(int constraint) const { return paths_.constraints[static_cast<std::size_t>(constraint)].none.empty(); }
  bool has_local() const;
  bool has_pressure() const;  // of every actuator

  // Numbers that one thread works with.
  struct Work {
    std::vector<double> partials, placement;
    State state;
    Tangent tangent;
  };
  // At dof coordinates [m], [rad]. False, and no number to be read, where the pose cannot be assembled or has no G.
  bool at(std::span<const double> coordinates, Work& work, TransmissionIndices& out) const;
  // The same with memory of its own.
  std::optional<TransmissionIndices> at(std::span<const double> coordinates) const;

 private:
  struct Ends {  // bodies that hold the joints of a telescopic drive, from outside
    int near = 0, far = 0;
  };
  const DrivePath& drive(int i) const { return paths_.drives[static_cast<std::size_t>(i)]; }
  void of_rows(const Matrix6d& g, const Matrix6d& twists, const Vector6d& factors, const Work& work, TransmissionIndices& out) const;
  Eigen::Vector3d input_direction(int actuator, const Work& work) const;
  void by_motions(std::span<const double> coordinates, Work& work, TransmissionIndices& out) const;

  const Machine& machine_;
  double length_;
  TransmissionPaths paths_;
  std::vector<Ends> ends_;   // one an actuator
  bool by_motions_ = false;  // some point moves with the coordinates, and not with the platform
};

}  // namespace pmreport::mechanics
