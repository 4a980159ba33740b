// Indices of transmission of mechanisms whose answers are known by hand.
#include <core/mechanics/model/random_poses.hpp>
#include <core/mechanics/transmission/transmission.hpp>
#include <pmreport/mechanism.hpp>
#include <tests/given/two_legs.hpp>
#include <tests/mechanics/mechanisms.hpp>

#include <catch2/catch.hpp>

#include <cmath>

using namespace pmreport;
using namespace pmreport::mechanics;
using Catch::Matchers::Contains;
using Eigen::Vector3d;

namespace {

constexpr double rounding = 1e-13;

// Planar four-bar A (0, 0), D (d, 0), crank a, coupler b, rocker c in the plane z = 0, of which the crank drives and the rocker carries the
// load: its angle from the x axis is the coordinate.
class FourBar : public Mechanism<1> {
 public:
  static constexpr const char *name = "four-bar", *title = "four-bar with a rocker", *source = "a test";
  static constexpr Parameter parameters[] = {Parameter::length("crank", 0.2, "a"), Parameter::length("coupler", 0.45, "b"),
                                             Parameter::length("rocker", 0.35, "c"), Parameter::length("ground", 0.5, "d")};
  explicit FourBar(const Parameters& p) : a_(p["crank"]), b_(p["coupler"]), c_(p["rocker"]), d_(p["ground"]) {}

  Topology topology() const {
    Topology t;
    t.coordinates = {{"psi", "angle of the rocker", "rad", 1.7, {1.5, 1.9}}};
    t.platform = t.add(Body{"rocker", 0, false, {}});
    t.add(Body{"crank", 1, false, {}});
    t.add(Body{"coupler", 1, false, {}});
    t.add(Joint{"A", JointKind::revolute, 0, 2, {}});
    t.add(Joint{"B", JointKind::revolute, 2, 3, {}});
    t.add(Joint{"C", JointKind::revolute, 3, 1, {}});
    t.add(Joint{"D", JointKind::revolute, 0, 1, {}});
    t.add(Actuator{"theta", "angle of the crank", "rad", 0, {-7, 7}});
    for (const char* n : {"force_x", "force_y", "force_z"}) t.constraints.push_back({n, "", "N"});
    for (const char* n : {"couple_x", "couple_y"}) t.constraints.push_back({n, "", "N*m"});
    return t;
  }
  // B is where the circle a about A meets the circle b about C, above AC.
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> z = Vector3d::UnitZ().cast<T>(), a = Vector3d::Zero().cast<T>(), d = Vector3d(d_, 0, 0).cast<T>();
    const Vector3<T> arm(cos(q[0]), sin(q[0]), T(0.0)), c = d + arm * T(c_);
    const T s2 = c.dot(c), s = sqrt(s2), along = (s2 + a_ * a_ - b_ * b_) / (2.0 * s), radicand = a_ * a_ - square(along);
    at.require(radicand, "crank and coupler are too short, or too long");
    const Vector3<T> u = c * (1.0 / s), across(-u(1), u(0), T(0.0)), b = u * along + across * sqrt(radicand);
    const Vector3<T> crank = unit(b), coupler = unit(Vector3<T>(c - b));
    at.body(1, d, frame_xz(arm, z));
    at.body(2, a, frame_xz(crank, z));
    at.body(3, b, frame_xz(coupler, z));
    at.joint(0, a, z);
    at.joint(1, b, z);
    at.joint(2, c, z);
    at.joint(3, d, z);
    at.actuator(0, atan2(b(1), b(0)));
  }
  // Along the coupler n B and C have one speed: n . v_C = n . (z x B) theta'.
  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    const Vector3<T> b = at.centre(1), n = unit(Vector3<T>(at.centre(2) - b)), z = at.axis(0), arm = at.centre(2) - at.origin(1);
    Matrix6<T> g = Matrix6<T>::Zero();
    force_row<T>(g, 0, n * (1.0 / n.dot(z.cross(b))), arm);
    for (int k = 0; k < 5; ++k) g(1 + k, k) = T(1.0);
    return g;
  }

 private:
  double a_, b_, c_, d_;
};

const pm_mechanism& four_bar() { return contract::mechanism<FourBar>; }

TransmissionIndices indices(const Transmission& t, const Eigen::VectorXd& q) {
  const auto out = t.at({q.data(), static_cast<std::size_t>(q.size())});
  REQUIRE(out);
  return *out;
}

}  // namespace

TEST_CASE("the output transmission of a four-bar is the sine of its transmission angle, the input that of crank and coupler") {
  const Machine m(four_bar(), default_values(describe(four_bar())));
  const Transmission t(m);
  CHECK(t.has_local());
  const double a = 0.2, b = 0.45, c = 0.35, d = 0.5;
  for (const double psi : {1.5, 1.6, 1.7, 1.85}) {
    const TransmissionIndices at = indices(t, Eigen::VectorXd::Constant(1, psi));
    // By the law of cosines: C from A, then the angle between coupler and rocker by the diagonal from the crank's pin to D.
    const double s = std::sqrt(d * d + c * c + 2 * d * c * std::cos(psi));
    const double at_a = std::atan2(c * std::sin(psi), d + c * std::cos(psi)) + std::acos((s * s + a * a - b * b) / (2 * s * a));
    const double diagonal2 = a * a + d * d - 2 * a * d * std::cos(at_a);
    const double mu = std::acos((b * b + c * c - diagonal2) / (2 * b * c));
    const double of_crank = std::acos((a * a + b * b - s * s) / (2 * a * b));
    CHECK(at.actuators[0].output == Approx(std::abs(std::sin(mu))).epsilon(rounding));
    CHECK(at.actuators[0].cosine == Approx(std::abs(std::sin(mu))).epsilon(rounding));
    CHECK(at.actuators[0].input == Approx(std::abs(std::sin(of_crank))).epsilon(rounding));
    CHECK(at.local == Approx(std::min(std::abs(std::sin(mu)), std::abs(std::sin(of_crank)))).epsilon(rounding));
  }
}

TEST_CASE("with its legs in one line a table in two legs cannot be moved across them, and says so by zeros") {
  const Machine m(test::two_legs(), {{0.3}});
  const Transmission t(m);
  // On the line through both feet, beyond them: l1 and l2 push one way.
  const TransmissionIndices singular = indices(t, Eigen::Vector2d(0.12, 0));
  CHECK(singular.actuators[0].output < 1e-15);
  CHECK(singular.actuators[1].output < 1e-15);
  CHECK(singular.actuators[0].cosine < 1e-15);
  CHECK(singular.local < 1e-15);
  CHECK(singular.conditioning < 1e-15);
  // Elsewhere leg 1, the other held, pushes along itself and the table goes across leg 2: the sine of the angle between the legs.
  for (const Eigen::Vector2d& p : {Eigen::Vector2d(0.1, 0.2), Eigen::Vector2d(0.25, 0.1), Eigen::Vector2d(0.15, 1e-7)}) {
    const Eigen::Vector2d to_a(0.3 - p.x(), -p.y());
    const double sine = std::abs(p.x() * to_a.y() - p.y() * to_a.x()) / (p.norm() * to_a.norm());
    const TransmissionIndices at = indices(t, p);
    for (int i = 0; i < 2; ++i) {
      CHECK(at.actuators[static_cast<std::size_t>(i)].output == Approx(sine).epsilon(1e-9));
      CHECK(at.actuators[static_cast<std::size_t>(i)].cosine == Approx(sine).epsilon(1e-9));
      CHECK(at.actuators[static_cast<std::size_t>(i)].input == Approx(1).epsilon(rounding));
    }
  }
}

TEST_CASE("a hexapod's legs push along themselves at the platform's joints, whatever their joints at the base") {
  for (const test::BaseJoint base : {test::BaseJoint::ball, test::BaseJoint::universal}) {
    const Machine m = test::make_hexapod(base);
    const Transmission t(m);
    REQUIRE(t.has_local());
    for (const Eigen::VectorXd& q : random_poses(m, 10, 3)) {
      const TransmissionIndices at = indices(t, q);
      for (int i = 0; i < 6; ++i) {
        const auto& leg = at.actuators[static_cast<std::size_t>(i)];
        CHECK(words_of(m.topology(), t.paths().drives[static_cast<std::size_t>(i)].output) == "B" + std::to_string(i + 1));
        CHECK(leg.output == Approx(leg.cosine).epsilon(1e-11));
        CHECK(leg.input == Approx(1).epsilon(rounding));
        CHECK(leg.force.dot(leg.velocity) == Approx(1).epsilon(1e-10));  // unit rate along the leg
      }
    }
  }
}

TEST_CASE("the singular values of G and of its inverse make the conditioning") {
  const Machine m = test::make_hexapod(test::BaseJoint::ball);
  for (const double length : {0.1, 0.25, 2.0}) {
    const Transmission t(m, length);
    for (const Eigen::VectorXd& q : random_poses(m, 5, 4)) {
      const Pose pose = m.pose({q.data(), 6});
      Matrix6d g = m.jacobian(pose).matrix;
      g.rightCols<3>() /= length;
      const Eigen::JacobiSVD<Eigen::MatrixXd> svd{Eigen::MatrixXd(g)};
      const TransmissionIndices at = indices(t, q);
      CHECK(at.condition == Approx(svd.singularValues()(0) / svd.singularValues()(5)).epsilon(1e-11));
      CHECK(at.conditioning * at.condition == Approx(1).epsilon(rounding));
      CHECK(at.manipulability == Approx(1 / std::abs(g.determinant())).epsilon(1e-11));
    }
  }
}

TEST_CASE("a pose out of reach has no indices") {
  const Machine m(four_bar(), default_values(describe(four_bar())));
  const double out_of_reach = 0;
  CHECK_FALSE(Transmission(m).at({&out_of_reach, 1}));
}

TEST_CASE("an actuator that turns the platform by a couple has no pressure angle, and is told so") {
  const Machine m = test::make(test::arm());
  const Transmission t(m);
  CHECK_FALSE(t.has_local());
  bool couple = false;
  for (const DrivePath& d : t.paths().drives) couple = couple || d.no_output.find("by a couple") != std::string::npos;
  CHECK(couple);
}
