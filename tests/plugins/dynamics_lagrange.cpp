// Equations of motion of every mechanism by Lagrange's way, from its placement alone: no twist, no jet, no partial, no inertia tensor.
//
// With c the centre of mass of a body, R its rotation and S = (tr I / 2) E - I the second moments of its mass about c,
//     2 T = sum m |c'|^2 + tr(R' S R'^T),   hence   M_ij = sum m c_,i . c_,j + tr(R_,i S R_,j^T),
// and of a slender body with axis n, transverse inertia I_t and no spin: m |c'|^2 + I_t |n'|^2. A comma is a partial derivative. Lagrange:
//     sum_j M_kj q_j'' + (sum_j M_kj,t q_j' - T_,k) + V_,k = l_,k . tau + (platform)_,k . load
// All derivatives are central differences of eighth order in extended precision.
#include <core/mechanics/dynamics/virtual_work.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <tests/plugins/every_mechanism.hpp>

#include <Eigen/Geometry>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

using Long = long double;
using Vector = Eigen::Matrix<Long, Eigen::Dynamic, 1>;
using Matrix = Eigen::Matrix<Long, Eigen::Dynamic, Eigen::Dynamic>;
using LongMatrix3 = Eigen::Matrix<Long, 3, 3>;
using LongVector3 = Eigen::Matrix<Long, 3, 1>;

// A step of 2^-10 of a size, where differences of eighth order err by some (step / distance of the next singularity)^8 < 1e-16, and
// roundings of 5e-20 are divided by it once for M and twice for its derivatives: 1e-13. Further digits go to poses near singular ones.
constexpr Long step = 0x1p-10L;
constexpr double lagrange_tolerance = 1e-9;

template <class F>
auto difference(F&& f, Long h) {
  const auto pair = [&](int k) { return (f(k * h) - f(-k * h)).eval(); };
  return ((pair(1) * (4.0L / 5) - pair(2) * (1.0L / 5) + pair(3) * (4.0L / 105) - pair(4) * (1.0L / 280)) / h).eval();
}

class Lagrange {
 public:
  explicit Lagrange(const Machine& machine) : machine_(machine), size_(test::sizes(machine).cast<Long>()) {}

  // All numbers of the placement by each coordinate.
  Matrix placement_by_coordinates(const Vector& q) const {
    Matrix out(static_cast<Eigen::Index>(machine_.layout().size()), q.size());
    for (Eigen::Index k = 0; k < q.size(); ++k) out.col(k) = difference([&](Long t) { return placement(moved(q, k, t)); }, step * size_(k));
    return out;
  }
  Matrix mass(const Vector& q) const { return mass_of(placement_by_coordinates(q)); }
  // d/dt (dT/dq') - dT/dq at constant rates.
  Vector coriolis(const Vector& q, const Vector& rate) const {
    const auto along = [&](Long t) { return Vector(q + t * rate); };  // rates are about a size a second
    Vector out = difference([&](Long t) { return Vector(mass(along(t)) * rate); }, step);
    for (Eigen::Index k = 0; k < q.size(); ++k)
      out(k) -= difference([&](Long t) { return energy(moved(q, k, t), rate); }, step * size_(k))(0);
    return out;
  }
  Vector gravity(const Matrix& by, const Vector3d& field) const {
    Vector out = Vector::Zero(by.cols());
    for (std::size_t b = 1; b < machine_.topology().bodies.size(); ++b)
      out -= static_cast<Long>(machine_.topology().bodies[b].inertia.mass) * centre(by, b).transpose() * field.cast<Long>();
    return out;
  }
  Matrix actuators(const Matrix& by) const { return by.middleRows(static_cast<Eigen::Index>(machine_.layout().actuator(0)), by.cols()); }
  // Work of a load on the platform by each coordinate. dR R^T is skew, its axial vector the turn.
  Vector work(const Matrix& by, const Vector& q, const Vector6d& load) const {
    const auto platform = static_cast<std::size_t>(machine_.topology().platform);
    const LongMatrix3 r = rows(placement(q), platform);
    Vector out = by.middleRows<3>(at(platform)).transpose() * load.head<3>().cast<Long>();
    for (Eigen::Index k = 0; k < by.cols(); ++k) {
      const LongMatrix3 turn = rows(by.col(k), platform) * r.transpose();
      out(k) += LongVector3(turn(2, 1), turn(0, 2), turn(1, 0)).dot(load.tail<3>().cast<Long>());
    }
    return out;
  }
  Matrix mass_of(const Matrix& by) const {
    Matrix m = Matrix::Zero(by.cols(), by.cols());
    for (std::size_t b = 1; b < machine_.topology().bodies.size(); ++b) {
      const Body& body = machine_.topology().bodies[b];
      const Matrix c = centre(by, b);
      m += static_cast<Long>(body.inertia.mass) * c.transpose() * c;
      if (body.slender) {
        const Matrix axis = by.middleRows<3>(at(b) + 3);
        m += static_cast<Long>(body.inertia.about_centre(0, 0)) * axis.transpose() * axis;
        continue;
      }
      const LongMatrix3 i = body.inertia.about_centre.cast<Long>();
      const LongMatrix3 second = LongMatrix3::Identity() * (i.trace() / 2) - i;
      for (Eigen::Index j = 0; j < by.cols(); ++j)
        for (Eigen::Index k = 0; k < by.cols(); ++k) m(j, k) += (rows(by.col(j), b) * second * rows(by.col(k), b).transpose()).trace();
    }
    return m;
  }

 private:
  // Kinetic energy, from the placement's change along the motion.
  Vector energy(const Vector& q, const Vector& rate) const {
    const Matrix change = difference([&](Long t) { return placement(q + t * rate); }, step);
    return mass_of(change).reshaped() / 2;
  }
  static Vector moved(const Vector& q, Eigen::Index k, Long by) {
    Vector out = q;
    out(k) += by;
    return out;
  }
  Vector placement(const Vector& q) const {
    const auto n = machine_.layout().size();
    std::vector<double> in, out(2 * n);
    for (const Long x : q) {
      in.push_back(static_cast<double>(x));
      in.push_back(static_cast<double>(x - static_cast<Long>(in.back())));
    }
    REQUIRE(machine_.place(PM_EXTENDED, 1, in.data(), out.data()) == PM_OK);
    Vector numbers(static_cast<Eigen::Index>(n));
    for (std::size_t s = 0; s < n; ++s)
      numbers(static_cast<Eigen::Index>(s)) = static_cast<Long>(out[2 * s]) + static_cast<Long>(out[2 * s + 1]);
    return numbers;
  }
  Eigen::Index at(std::size_t body) const { return static_cast<Eigen::Index>(machine_.layout().body(static_cast<int>(body))); }
  LongMatrix3 rows(const Vector& numbers, std::size_t body) const {
    LongMatrix3 r;
    for (int i = 0; i < 9; ++i) r(i / 3, i % 3) = numbers(at(body) + 3 + i);
    return r;
  }
  // Centre of mass by each coordinate: linear in origin and rotation, so derivatives of these give derivatives of it.
  Matrix centre(const Matrix& by, std::size_t b) const {
    const Body& body = machine_.topology().bodies[b];
    const LongVector3 c = body.inertia.centre.cast<Long>();
    Matrix out = by.middleRows<3>(at(b));
    for (Eigen::Index k = 0; k < by.cols(); ++k)
      out.col(k) += body.slender ? LongVector3(by.col(k).segment<3>(at(b) + 3) * c.z()) : LongVector3(rows(by.col(k), b) * c);
    return out;
  }

  const Machine& machine_;
  Vector size_;
};

}  // namespace

TEST_CASE("mass matrix, Coriolis terms and weights of every mechanism are those of Lagrange's equations") {
  for (const test::Named& named : test::every_mechanism()) {
    const Machine& machine = *named.machine;
    const Lagrange lagrange(machine);
    const VectorXd size = test::sizes(machine);
    std::mt19937_64 random(41);
    for (int pose = 0; pose < 2; ++pose) {
      const test::RandomMotion motion = test::random_motion(machine, random);
      INFO(named.name << ", pose " << pose << ", q = " << motion.q.transpose());
      const Vector3d field = test::random_gravity(random);
      const Vector6d load = test::random_load(characteristic_length(machine), random);
      const State s = motion.state(machine);
      const Tangent t = tangent(machine, s);
      const EquationsOfMotion e = equations_of_motion(machine, s, t, field);

      const Vector q = motion.q.cast<Long>(), rate = motion.rate.cast<Long>(), acceleration = motion.acceleration.cast<Long>();
      const Matrix by = lagrange.placement_by_coordinates(q), mass = lagrange.mass_of(by), to_actuators = lagrange.actuators(by);
      const Vector coriolis = lagrange.coriolis(q, rate), weight = lagrange.gravity(by, field), work = lagrange.work(by, q, load);

      // Generalised forces count by their work over a size of the coordinate.
      const auto largest = [&](const Vector& forces) {
        return static_cast<double>(forces.cwiseProduct(size.cast<Long>()).lpNorm<Eigen::Infinity>());
      };
      const auto close = [&](const char* what, const VectorXd& seen, const Vector& expected, double scale) {
        INFO(what << ": " << seen.transpose() << " and " << expected.transpose());
        REQUIRE(scale > 0);
        CHECK(largest(seen.cast<Long>() - expected) < lagrange_tolerance * scale);
      };
      const Matrix scaled = size.cast<Long>().asDiagonal() * mass * size.cast<Long>().asDiagonal();
      CHECK((size.cast<Long>().asDiagonal() * (e.mass.cast<Long>() - mass) * size.cast<Long>().asDiagonal()).cwiseAbs().maxCoeff() <
            lagrange_tolerance * scaled.cwiseAbs().maxCoeff());
      close("Coriolis terms", e.coriolis, coriolis, largest(coriolis));
      close("weights", e.gravity, weight, largest(weight));
      const double energy = static_cast<double>(rate.dot(mass * rate)) / 2;
      CHECK(std::abs(kinetic_energy(machine, s) - energy) < lagrange_tolerance * energy);

      const ForceShares shares = virtual_work(machine, s, t, {load, field});
      const Vector inertia = mass * acceleration + coriolis;
      const auto generalised = [&](const SmallVector& forces) -> VectorXd {
        return (to_actuators.transpose() * forces.cast<Long>()).eval().cast<double>();
      };
      close("share of inertia", generalised(shares.inertia), inertia, largest(inertia));
      close("share of the weights", generalised(shares.gravity), weight, largest(weight));
      close("share of the load", generalised(shares.load), -work, largest(work));
    }
  }
}
