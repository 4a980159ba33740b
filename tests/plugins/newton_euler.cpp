// A third opinion on inverse dynamics: every body freed from its joints, six equations each, in extended precision, written from the
// textbook and from the numbers of `place` alone. Where there is neither self-stress nor idle freedom they are as many as the unknowns
// (78 of Gough's platform: 72 reactions, 6 actuator forces).
//
// Nobody is asked for an angular velocity. A body is the mass points that it is made of: one at X in body axes stands at p + R X and needs
// the force dm (p'' + R'' X). Summed, with m X_c = sum of dm X and E = sum of dm X X^T:
//     force   m (p'' + R'' X_c)
//     moment  sum of R X dm x (p'' + R'' X) = R m X_c x p'' + ax(R E R''^T),  ax(u v^T) = u x v,
// and of the inertia about the centre of mass follows E = (tr I / 2) 1 - I + m X_c X_c^T.
#include <core/mechanics/dynamics/virtual_work.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/reactions/inverse_dynamics.hpp>
#include <core/mechanics/reactions/reactions.hpp>
#include <tests/plugins/plugin.hpp>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <catch2/catch.hpp>
#include <random>

using namespace pmreport;
using namespace pmreport::mechanics;

namespace {

using Real = long double;
using Vector3 = Eigen::Matrix<Real, 3, 1>;
using Matrix3 = Eigen::Matrix<Real, 3, 3>;
using Vector6 = Eigen::Matrix<Real, 6, 1>;
using VectorX = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using MatrixX = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

constexpr double newton_euler_tolerance =
    1e-10;  // of the largest force: the dense system in double precision, at poses that magnify its roundings

struct Forces {
  Eigen::VectorXd actuators;
  std::vector<Vector6d> joints;  // on body b, about the joint's centre
};

// Numbers of a placement of order PM_JET: component 0 the value, 2 the acceleration.
class Jets {
 public:
  Jets(const Machine& machine, const std::vector<double>& coordinate_jets) : layout_(machine.layout()), x_(3 * layout_.size()) {
    REQUIRE(machine.place(PM_JET, 1, coordinate_jets.data(), x_.data()) == PM_OK);
  }
  Vector3 vector(std::size_t scalar, std::size_t component) const {
    return {x_[3 * scalar + component], x_[3 * scalar + 3 + component], x_[3 * scalar + 6 + component]};
  }
  Vector3 origin(int body, std::size_t component) const {
    return body == 0 ? Vector3(Vector3::Zero()) : vector(layout_.body(body), component);
  }
  Matrix3 rotation(int body, std::size_t component) const {
    Matrix3 r;
    for (std::size_t row = 0; row < 3; ++row)
      r.row(static_cast<Eigen::Index>(row)) = vector(layout_.body(body) + 3 + 3 * row, component).transpose();
    return r;
  }
  Vector3 centre(int joint) const { return vector(layout_.joint(joint), 0); }
  Vector3 axis(int joint, std::size_t k) const { return vector(layout_.joint(joint) + 3 + 3 * k, 0); }

 private:
  const Layout& layout_;
  std::vector<double> x_;
};

// (force; moment about the body's origin).
Vector6 needed_by(const Inertia& inertia, const Jets& jets, int body) {
  const Real mass = inertia.mass;
  const Vector3 centre = inertia.centre.cast<Real>(), acceleration = jets.origin(body, 2);
  const Matrix3 rotation = jets.rotation(body, 0), bent = jets.rotation(body, 2), i = inertia.about_centre.cast<Real>();
  const Matrix3 e = i.trace() / 2 * Matrix3::Identity() - i + mass * centre * centre.transpose();
  const Matrix3 m = rotation * e * bent.transpose();
  Vector6 out;
  out << mass * (acceleration + bent * centre),
      mass * (rotation * centre).cross(acceleration) + Vector3(m(1, 2) - m(2, 1), m(2, 0) - m(0, 2), m(0, 1) - m(1, 0));
  return out;
}

// The wrenches, as columns (force; moment about the centre), that a joint can pass on: those that do no work in its freedoms.
MatrixX passed_on(JointKind kind, const Vector3& first, const Vector3& second) {
  const Matrix3 all = Matrix3::Identity();
  const auto across = [&] {
    Eigen::Matrix<Real, 3, 2> e;
    e.col(0) = first.cross(Vector3::Unit(std::abs(first.x()) < 0.5L ? 0 : 1)).normalized();
    e.col(1) = first.cross(e.col(0));
    return e;
  };
  MatrixX out = MatrixX::Zero(6, 6 - freedoms_of(kind));
  switch (kind) {
    case JointKind::spherical:
      out.topRows<3>() = all;
      break;
    case JointKind::universal:
      out.topLeftCorner<3, 3>() = all;
      out.bottomRightCorner<3, 1>() = first.cross(second);
      break;
    case JointKind::revolute:
      out.topLeftCorner<3, 3>() = all;
      out.bottomRightCorner<3, 2>() = across();
      break;
    case JointKind::prismatic:
      out.topLeftCorner<3, 2>() = across();
      out.bottomRightCorner<3, 3>() = all;
      break;
    case JointKind::cylindrical:
      out.topLeftCorner<3, 2>() = across();
      out.bottomRightCorner<3, 2>() = across();
      break;
  }
  return out;
}

Forces newton_euler(const Machine& machine, const std::vector<double>& coordinate_jets, const Loading& loading) {
  const Topology& t = machine.topology();
  const Jets jets(machine, coordinate_jets);
  const Eigen::Index equations = 6 * (static_cast<Eigen::Index>(t.bodies.size()) - 1);
  MatrixX system = MatrixX::Zero(equations, equations);
  VectorX right(equations);
  for (int b = 1; b < static_cast<int>(t.bodies.size()); ++b) {
    const Body& body = t.bodies[static_cast<std::size_t>(b)];
    REQUIRE_FALSE(body.slender);  // whose rotation `place` does not tell
    const Vector3 weight = Real(body.inertia.mass) * loading.gravity.cast<Real>();
    const Vector3 arm = jets.rotation(b, 0) * body.inertia.centre.cast<Real>();
    right.segment<6>(6 * b - 6) = needed_by(body.inertia, jets, b);
    right.segment<3>(6 * b - 6) -= weight;
    right.segment<3>(6 * b - 3) -= arm.cross(weight);
    if (b == t.platform) right.segment<6>(6 * b - 6) -= loading.platform.cast<Real>();
  }

  // Unknown `column` is how much of `wrench` joint j passes on: to body b, and its opposite to body a.
  Eigen::Index column = 0;
  const auto add = [&](int j, const Vector6& wrench) {
    REQUIRE(column < equations);
    const Joint& joint = t.joints[static_cast<std::size_t>(j)];
    for (const auto& [body, sign] : {std::pair{joint.b, Real(1)}, std::pair{joint.a, Real(-1)}}) {
      if (body == 0) continue;
      const Vector3 force = wrench.head<3>(), arm = jets.centre(j) - jets.origin(body, 0);
      system.col(column).segment<3>(6 * body - 6) += sign * force;
      system.col(column).segment<3>(6 * body - 3) += sign * (wrench.tail<3>() + arm.cross(force));
    }
    ++column;
  };
  std::vector<MatrixX> wrenches;
  for (int j = 0; j < static_cast<int>(t.joints.size()); ++j) {
    const JointKind kind = t.joints[static_cast<std::size_t>(j)].kind;
    const Vector3 none = Vector3::Zero();
    wrenches.push_back(passed_on(kind, axes_of(kind) > 0 ? jets.axis(j, 0) : none, axes_of(kind) > 1 ? jets.axis(j, 1) : none));
    for (Eigen::Index c = 0; c < wrenches.back().cols(); ++c) add(j, wrenches.back().col(c));
  }
  for (const Actuator& a : t.actuators) {
    Vector6 wrench = Vector6::Zero();
    wrench.segment<3>(a.sense() == Sense::linear ? 0 : 3) = jets.axis(a.joint, 0);
    add(a.joint, wrench);
  }
  REQUIRE(column == equations);

  const VectorX x = system.partialPivLu().solve(right);
  Forces out{x.tail(machine.dof()).cast<double>(), {}};
  Eigen::Index next = 0;
  for (const MatrixX& w : wrenches) {
    out.joints.push_back((w * x.segment(next, w.cols())).cast<double>());
    next += w.cols();
  }
  return out;
}

// Within the box of the coordinates, which is crossed in about a second, under a load and a gravity that are not aligned with anything.
std::vector<double> random_jets(const Machine& machine, std::mt19937_64& random) {
  std::uniform_real_distribution<double> symmetric(-1, 1);
  std::vector<double> jets;
  do {
    jets.clear();
    for (const Coordinate& c : machine.topology().coordinates) {
      const double half = (c.box.max - c.box.min) / 2;
      for (const double x :
           {(c.box.max + c.box.min) / 2 + half * symmetric(random), 2 * half * symmetric(random), 20 * half * symmetric(random)})
        jets.push_back(x);
    }
    std::vector<double> placement(3 * machine.layout().size());
    if (machine.place(PM_JET, 1, jets.data(), placement.data()) == PM_OK) return jets;
  } while (true);
}

double largest(const Eigen::MatrixXd& m) { return m.lpNorm<Eigen::Infinity>(); }

}  // namespace

TEST_CASE("forces and reactions are those of free bodies made of mass points") {
  for (const auto& [name, equations] : {std::pair{"gough", 78}, {"5pus-upu", 78}, {"stewart", 78}, {"parallel-cross", 78}})
    DYNAMIC_SECTION(name) {
      const pm_mechanism& table = test::plugin(name);
      const Machine machine(table, default_values(describe(table)));
      REQUIRE(6 * (machine.topology().bodies.size() - 1) == static_cast<std::size_t>(equations));
      const double length = characteristic_length(machine);
      const JointFrames frames(machine);
      InverseDynamics limb_by_limb(machine);
      MotionReactions limbs;
      std::mt19937_64 random(7);
      std::uniform_real_distribution<double> symmetric(-1, 1);
      for (int k = 0; k < 32; ++k) {
        const std::vector<double> jets = random_jets(machine, random);
        Loading loading{Vector6d::Zero(), {1.3, -0.7, -9.6}};
        for (int i = 0; i < 6; ++i) loading.platform(i) = (i < 3 ? 100 : 10) * symmetric(random);
        const Forces free = newton_euler(machine, jets, loading);

        Eigen::VectorXd q(machine.dof()), rates(q.size()), accelerations(q.size());
        for (Eigen::Index i = 0; i < q.size(); ++i) {
          const auto at = 3 * static_cast<std::size_t>(i);
          q(i) = jets[at], rates(i) = jets[at + 1], accelerations(i) = jets[at + 2];
        }
        State state;
        evaluate(machine, q.data(), rates.data(), accelerations.data(), state);
        CAPTURE(k, q.transpose());
        const JointReactions dense = dense_reactions(machine, state, generic_model(machine, state), frames, loading, length);
        REQUIRE_FALSE(dense.singular);
        const double scale = std::max(largest(free.actuators), largest(dense.actuator_forces));
        CHECK(largest(dense.actuator_forces - free.actuators) <= newton_euler_tolerance * scale);
        CHECK(largest(virtual_work(machine, state, tangent(machine, state), loading).total() - free.actuators) <=
              newton_euler_tolerance * scale);
        limb_by_limb.solve(1, jets.data(), loading.platform.data(), loading.gravity, limbs);
        CHECK(largest(Eigen::Map<const Eigen::VectorXd>(limbs.actuator_forces.data(), machine.dof()) - free.actuators) <=
              newton_euler_tolerance * scale);
        REQUIRE(dense.joints.size() == free.joints.size());
        REQUIRE(limbs.joints.size() == 6 * free.joints.size());
        for (std::size_t j = 0; j < free.joints.size(); ++j) {
          CAPTURE(machine.topology().joints[j].name, free.joints[j].transpose());
          for (const Vector6d& seen : {dense.joints[j], Vector6d(&limbs.joints[6 * j])}) {
            CAPTURE(seen.transpose());
            CHECK(largest(seen.head<3>() - free.joints[j].head<3>()) <= newton_euler_tolerance * scale);
            CHECK(largest(seen.tail<3>() - free.joints[j].tail<3>()) <= newton_euler_tolerance * scale * length);
          }
        }
      }
    }
}
