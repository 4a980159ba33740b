#include <reports/scene/gltf/machine_model.hpp>

#include <reports/scene/look.hpp>
#include <reports/scene/mesh/mesh.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace pmreport::scene {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using mechanics::Machine;
using mechanics::Pose;

// Facets are as fine as in a picture in which the machine is this large: a joint's ball gets twenty round its equator.
constexpr int picture_height = 200;  // [px]

// Bodies that are built alike must come out equal to the last bit, although rounding put them at other places. So lengths are whole
// multiples of about a millionth of the machine's size, and components of unit vectors of 2^-16.
double step_of(double overall) { return std::exp2(std::round(std::log2(overall)) - 20); }
double snapped(double x, double step) { return std::round(x / step) * step + 0.0; }  // + 0: no -0
Vector3d snapped(const Vector3d& v, double step) { return {snapped(v.x(), step), snapped(v.y(), step), snapped(v.z(), step)}; }
constexpr double direction_step = 0x1p-16;

// The frame of one body, pose after pose.
class Frame {
 public:
  Frame(const Machine& machine, int body) : machine_(machine), body_(body) {
    if (!machine.topology().bodies[static_cast<std::size_t>(body)].slender) return;
    slender_ = true;
    guide_ = guide_of(machine, body);
    before_ = machine.rotation(machine.home_pose(), body);
  }

  Matrix3d rotation(const Pose& pose) {
    const Matrix3d r = machine_.rotation(pose, body_);
    if (!slender_) return r;
    double turn = 0;  // about z
    if (guide_) {
      const Vector3d x = r.transpose() * machine_.axis(pose, guide_->joint, guide_->k);
      turn = std::atan2(x.y(), x.x());
    } else {
      // R Rz(turn) is nearest to the frame before where the trace of before^T R Rz(turn) is largest.
      const Matrix3d m = before_.transpose() * r;
      turn = std::atan2(m(0, 1) - m(1, 0), m(0, 0) + m(1, 1));
    }
    return before_ = r * Eigen::AngleAxisd(turn, Vector3d::UnitZ());
  }

 private:
  const Machine& machine_;
  int body_;
  bool slender_ = false;
  std::optional<Guide> guide_;
  Matrix3d before_ = Matrix3d::Identity();
};

Solid in_frame(Solid s, const Vector3d& origin, const Matrix3d& rotation, double step) {
  const auto local = [&](const Vector3d& p) { return snapped(rotation.transpose() * (p - origin), step); };
  s.a = local(s.a);
  if (s.kind == Solid::Kind::box) {
    const Matrix3d axes = rotation.transpose() * s.axes;
    for (int k = 0; k < 3; ++k) s.axes.col(k) = snapped(axes.col(k), direction_step).normalized();
  } else {
    s.b = local(s.b);
  }
  for (Vector3d& p : s.outline) p = local(p);
  return s;
}

// The solids of one body, in its frame, as one primitive a colour. Vertices that coincide are one: solids of revolution come with whole
// rings at their poles.
std::vector<Primitive> mesh_of(const std::vector<Solid>& solids, double overall, double step) {
  std::vector<Primitive> out;
  Camera camera;
  camera.height = overall;
  const View view(camera, picture_height, picture_height);
  const auto same = [](const Color& x, const Color& y) { return x.r == y.r && x.g == y.g && x.b == y.b && x.a == y.a; };
  std::vector<Color> colors;
  for (const Solid& s : solids)
    if (std::ranges::none_of(colors, [&](const Color& c) { return same(c, s.color); })) colors.push_back(s.color);
  for (const Color& color : colors) {
    Scene scene;
    std::ranges::copy_if(solids, std::back_inserter(scene.solids), [&](const Solid& s) { return same(s.color, color); });
    const Mesh mesh = tessellate(scene, view);
    Primitive p{color, {}, {}, {}};
    std::map<std::array<float, 6>, std::uint32_t> known;
    std::vector<std::uint32_t> index_of;
    for (const Vertex& v : mesh.vertices) {
      const auto vector = [](const std::array<float, 3>& x) { return Vector3d(x[0], x[1], x[2]); };
      const Vector3d n = vector(v.normal);
      const Vector3d at = snapped(view.world(vector(v.position)), step),
                     normal = snapped((n.x() * view.right() + n.y() * view.up() + n.z() * view.towards()).normalized(), direction_step);
      std::array<float, 6> key;
      for (int k = 0; k < 3; ++k)
        key[static_cast<std::size_t>(k)] = static_cast<float>(at(k)), key[static_cast<std::size_t>(k + 3)] = static_cast<float>(normal(k));
      const auto [found, is_new] = known.try_emplace(key, static_cast<std::uint32_t>(p.positions.size()));
      if (is_new) p.positions.push_back({key[0], key[1], key[2]}), p.normals.push_back({key[3], key[4], key[5]});
      index_of.push_back(found->second);
    }
    for (std::size_t k = 0; k + 2 < mesh.indices.size(); k += 3) {
      const std::uint32_t a = index_of[mesh.indices[k]], b = index_of[mesh.indices[k + 1]], c = index_of[mesh.indices[k + 2]];
      if (a != b && b != c && c != a) p.indices.insert(p.indices.end(), {a, b, c});
    }
    if (!p.indices.empty()) out.push_back(std::move(p));
  }
  return out;
}

bool moves(const ModelTrack& track) {
  for (std::size_t k = 1; k < track.rotation.size(); ++k)
    if (track.translation[k] != track.translation[0] || track.rotation[k].coeffs() != track.rotation[0].coeffs()) return true;
  return false;
}

}  // namespace

std::optional<Guide> guide_of(const Machine& m, int body) {
  const Topology& t = m.topology();
  const Vector3d z = m.rotation(m.home_pose(), body).col(2);
  for (int j = 0; j < static_cast<int>(t.joints.size()); ++j) {
    const Joint& joint = t.joints[static_cast<std::size_t>(j)];
    if ((joint.a != body && joint.b != body) || (joint.kind != JointKind::universal && joint.kind != JointKind::revolute)) continue;
    const int k = joint.kind == JointKind::universal && joint.b == body ? 1 : 0;
    constexpr double well_off = 0.5;
    if (m.axis(m.home_pose(), j, k).cross(z).norm() > well_off) return Guide{j, k};
  }
  return {};
}

Model model_of(const Machine& machine, const std::vector<Moment>& moments) {
  Model model;
  model.name = machine.info().title;
  model.platform = machine.topology().platform;
  const Sizes sizes = measure(machine);
  const double step = step_of(sizes.overall);
  Scene home;
  add_bodies(home, machine, machine.home_pose(), sizes);
  add_joints(home, machine, machine.home_pose(), sizes);

  for (const Moment& moment : moments) model.times.push_back(static_cast<float>(moment.time));
  const std::vector<Body>& bodies = machine.topology().bodies;
  for (int body = 0; body < static_cast<int>(bodies.size()); ++body) {
    Frame frame(machine, body);
    const Vector3d origin = machine.origin(machine.home_pose(), body);
    const Matrix3d rotation = frame.rotation(machine.home_pose());
    std::vector<Solid> solids;
    for (const Solid& s : home.solids)
      if (s.body == body) solids.push_back(in_frame(s, origin, rotation, step));

    ModelNode node{bodies[static_cast<std::size_t>(body)].name, -1, origin, Eigen::Quaterniond(rotation).normalized()};
    if (std::vector<Primitive> mesh = mesh_of(solids, sizes.overall, step); !mesh.empty()) {
      const auto known = std::ranges::find(model.meshes, mesh);
      node.mesh = static_cast<int>(known - model.meshes.begin());
      if (known == model.meshes.end()) model.meshes.push_back(std::move(mesh));
    }
    ModelTrack track{body, {}, {}};
    Eigen::Quaterniond before = node.rotation;
    for (const Moment& moment : moments) {
      Eigen::Quaterniond q = Eigen::Quaterniond(frame.rotation(moment.pose)).normalized();
      if (q.dot(before) < 0) q.coeffs() *= -1;  // the same rotation, and the short way to it
      track.translation.push_back(machine.origin(moment.pose, body));
      track.rotation.push_back(before = q);
    }
    if (!moments.empty()) node.translation = track.translation.front(), node.rotation = track.rotation.front();
    model.nodes.push_back(std::move(node));
    if (moves(track)) model.tracks.push_back(std::move(track));
  }
  if (model.tracks.empty()) model.times.clear();
  return model;
}

}  // namespace pmreport::scene
