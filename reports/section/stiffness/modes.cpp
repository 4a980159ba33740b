// A natural vibration, drawn: every body at the end of its swing.
#include <reports/section/common/words/words.hpp>
#include <reports/section/stiffness/stiffness.hpp>

#include <core/mechanics/stiffness/whole_system.hpp>

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace pmreport::section {

namespace {

// Of the machine's size: how far the drawn body that moves most is from where it rests.
constexpr double swing = 0.06;

// The pose with its bodies displaced: each turned about its origin, which moves; joints go with body a, or with b where a is the base.
mechanics::Pose displaced(const mechanics::Machine& m, const mechanics::Pose& pose, const Eigen::VectorXd& u) {
  const Topology& t = m.topology();
  mechanics::Pose out = pose;
  const auto body_motion = [&](int body) { return Eigen::Matrix<double, 6, 1>(u.segment<6>(6 * body - 6)); };
  const auto turned = [](const Eigen::Vector3d& w) {
    const double angle = w.norm();
    return angle > 0 ? Eigen::AngleAxisd(angle, w / angle).toRotationMatrix() : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
  };
  for (int b = 1; b < static_cast<int>(t.bodies.size()); ++b) {
    double* at = out.numbers.data() + m.layout().body(b);
    const auto d = body_motion(b);
    const Eigen::Matrix3d r = turned(d.tail<3>());
    Eigen::Map<Eigen::Vector3d> origin(at);
    origin += d.head<3>();
    if (t.bodies[static_cast<std::size_t>(b)].slender) {
      Eigen::Map<Eigen::Vector3d> axis(at + 3);
      axis = (r * axis).eval();
    } else {
      Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> rotation(at + 3);
      rotation = (r * rotation).eval();
    }
  }
  for (int j = 0; j < static_cast<int>(t.joints.size()); ++j) {
    const Joint& joint = t.joints[static_cast<std::size_t>(j)];
    const int body = joint.a > 0 ? joint.a : joint.b;
    double* at = out.numbers.data() + m.layout().joint(j);
    const auto d = body_motion(body);
    const Eigen::Vector3d before = m.centre(pose, j), arm = before - m.origin(pose, body);
    const Eigen::Matrix3d r = turned(d.tail<3>());
    Eigen::Map<Eigen::Vector3d> centre(at);
    centre = m.origin(pose, body) + d.head<3>() + r * arm;
    for (int k = 0; k < axes_of(joint.kind); ++k) {
      Eigen::Map<Eigen::Vector3d> axis(at + 3 + 3 * k);
      axis = r * m.axis(pose, j, k);
    }
  }
  return out;
}

// The machine at rest as thin lines: from joint to joint of every body.
std::vector<scene::Polyline> at_rest(const mechanics::Machine& m, const mechanics::Pose& pose) {
  constexpr scene::Color grey{0.35F, 0.35F, 0.38F, 1.0F};
  const Topology& t = m.topology();
  std::vector<scene::Polyline> out;
  for (int b = 1; b < static_cast<int>(t.bodies.size()); ++b) {
    std::vector<Eigen::Vector3d> at;
    for (int j = 0; j < static_cast<int>(t.joints.size()); ++j)
      if (t.joints[static_cast<std::size_t>(j)].a == b || t.joints[static_cast<std::size_t>(j)].b == b) at.push_back(m.centre(pose, j));
    for (std::size_t i = 1; i < at.size(); ++i) out.push_back({{at[i - 1], at[i]}, grey, 2.0, 1.0F});
    if (b == t.platform && at.size() > 2) out.push_back({{at.back(), at.front()}, grey, 2.0, 1.0F});
  }
  return out;
}

}  // namespace

Stage::Ordered mode_picture(const Analysis& a, const StiffnessRequest& request, const ElasticView& view, const Stage& stage,
                            std::size_t number) {
  const mechanics::Machine& m = a.machine();
  const mechanics::Pose pose = m.pose({view.q.data(), static_cast<std::size_t>(view.q.size())});
  const mechanics::WholeSystem system(mechanics::SpringPlan(m), state_at_rest(m, view.q));
  const Eigen::Vector3d reference = m.origin(pose, m.topology().platform);
  // What bends the machine into the shape: the inertia of every mass; of a platform on massless limbs the wrench that does.
  Eigen::VectorXd loads = Eigen::VectorXd::Zero(6 * (static_cast<Eigen::Index>(m.topology().bodies.size()) - 1));
  const auto add = [&](int body, const mechanics::Vector6d& wrench) {
    auto at = loads.segment<6>(6 * body - 6);
    at += wrench;
    at.tail<3>() += (reference - m.origin(pose, body)).cross(Eigen::Vector3d(wrench.head<3>()));
  };
  double frequency = 0;
  if (request.limb_inertia) {
    const mechanics::WholeMode mode = mechanics::whole_modes(view.pose, 1).front();
    frequency = mode.frequency;
    for (std::size_t i = 0; i < view.pose.masses.size(); ++i)
      add(view.pose.masses[i].body, view.pose.masses[i].wrench * mode.masses(static_cast<Eigen::Index>(i)));
  } else {
    const mechanics::Mode mode = mechanics::modes(view.pose.compliance, view.pose.platform_inertia, a.length()).front();
    frequency = mode.frequency;
    add(m.topology().platform, view.pose.compliance.completeOrthogonalDecomposition().solve(mode.shape));
  }
  Eigen::VectorXd u = system.displacements(loads);
  scene::Bounds bounds;
  scene::include(bounds, m, m.home_pose());
  scene::include(bounds, m, pose);
  double most = 0;
  for (Eigen::Index b = 0; b < u.size(); b += 6) most = std::max({most, u.segment<3>(b).norm(), a.length() * u.segment<3>(b + 3).norm()});
  const double size = (bounds.high - bounds.low).norm();
  if (most > 0) u *= swing * size / most;
  const mechanics::Pose swung = displaced(m, pose, u);
  scene::include(bounds, m, swung);
  scene::Extras extras;
  extras.frames = false;
  extras.labels = false;
  extras.lines = at_rest(m, pose);
  return stage.picture(m, swung, extras, bounds, {"auto", 0, 0}, fmt::format("mode-{}", number),
                       fmt::format("{}: lowest natural vibration, {} Hz, at the end of its swing, much enlarged.", view.name,
                                   typeset(format_number(frequency, 4))),
                       {800, 600, false, 2});
}

}  // namespace pmreport::section
