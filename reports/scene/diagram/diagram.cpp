#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <reports/scene/diagram/diagram.hpp>
#include <reports/scene/look.hpp>
#include <reports/scene/view.hpp>

namespace pmreport::scene {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using mechanics::Machine;
using mechanics::Pose;

constexpr Color ink = rgb(0x16191d), paper = rgb(0xffffff), driven = rgb(0xb4bac1), base_tint = rgb(0xeceef0),
                platform_tint = rgb(0xdde4ec);
constexpr double link_line = 1.1, frame_line = 0.7, axis_line = 0.35, hatch_line = 0.4;  // [pt]
constexpr float dashed = 0.5f;                                                           // hidden parts are drawn dashed
constexpr std::size_t few_axes = 8;

struct Flat {
  std::vector<Vector3d> corners;
};

class Sketch {
 public:
  Sketch(const Machine& m, const std::vector<std::string>& drives, double azimuth, double elevation, const Quality& q)
      : m_(m), t_(m.topology()), pose_(m.home_pose()), drives_(drives), overall_(measure(m).overall), r_(0.021 * overall_) {
    Camera looking;
    looking.azimuth = azimuth, looking.elevation = elevation;
    const View view(looking, q.width, q.height);
    right_ = view.right(), up_ = view.up();
    per_point_ = q.width / (q.printed * 72 / 25.4);
    driven_.assign(t_.joints.size(), false);
    for (const Actuator& a : t_.actuators) driven_[static_cast<std::size_t>(a.joint)] = true;
  }

  Diagram draw(double azimuth, double elevation, const Quality& q) {
    for (int body = 0; body < static_cast<int>(t_.bodies.size()); ++body) link(body);
    for (int j = 0; j < static_cast<int>(t_.joints.size()); ++j) symbol(j);
    name_axes();
    for (std::size_t k = 0; k < t_.actuators.size(); ++k)
      scene_.labels.push_back({place_of(t_.actuators[k].joint), drives_[k], ink, 1.3 * r_});
    frame(0, {"O", "X", "Y", "Z"}, 0.20 * overall_);
    frame(t_.platform, {"o", "x", "y", "z"}, 0.16 * overall_);
    Bounds bounds;
    for (const Solid& s : scene_.solids) {
      for (const Vector3d& p : s.outline) bounds.include(p, r_);
      if (s.outline.empty()) bounds.include(s.a, 2 * r_);
    }
    for (const Polyline& l : scene_.lines)
      for (const Vector3d& p : l.points) bounds.include(p, r_);
    return {std::move(scene_), scene::frame(bounds, azimuth, elevation, static_cast<double>(q.width) / q.height)};
  }

 private:
  const Joint& joint(int j) const { return t_.joints[static_cast<std::size_t>(j)]; }
  Vector3d centre(int j) const { return m_.centre(pose_, j); }
  bool is_driven(int j) const { return driven_[static_cast<std::size_t>(j)]; }
  bool on_base(int j) const { return joint(j).a == 0 || joint(j).b == 0; }
  std::vector<int> joints_of(int body) const {
    std::vector<int> all;
    for (int j = 0; j < static_cast<int>(t_.joints.size()); ++j)
      if (joint(j).a == body || joint(j).b == body) all.push_back(j);
    return all;
  }

  void line(std::vector<Vector3d> points, double width, float through = dashed) {
    scene_.lines.push_back({std::move(points), ink, width * per_point_, through});
  }
  // A link ends where the symbols of its joints begin.
  void bar(const Vector3d& p, const Vector3d& q, double from, double to) {
    const double length = (q - p).norm();
    if (length <= from + to) return;
    const Vector3d d = (q - p) / length;
    line({p + from * d, q - to * d}, link_line);
  }
  // From the middle of a joint's symbol to where a link in this direction comes out of it.
  double reach(int j, const Vector3d& towards) const {
    switch (joint(j).kind) {
      case JointKind::spherical:
        return 0.98 * r_;
      case JointKind::prismatic:
      case JointKind::cylindrical:
        return (std::abs(towards.normalized().dot(m_.axis(pose_, j))) > 0.7 ? 2.2 : 0.8) * r_;
      case JointKind::revolute:
      case JointKind::universal:
        break;
    }
    return 0.6 * r_;
  }

  // Of a slide between two bodies that have other joints, where it is drawn: between those, along the line of the limb.
  std::optional<Vector3d> between(int j) const {
    const auto far = [&](int body) -> std::optional<Vector3d> {
      std::optional<Vector3d> best;
      double most = 2 * r_;
      for (const int k : joints_of(body))
        if (const double d = (centre(k) - centre(j)).cross(m_.axis(pose_, j)).norm(), e = (centre(k) - centre(j)).norm();
            k != j && d < 0.05 * overall_ && e > most)
          most = e, best = centre(k);
      return best;
    };
    if (on_base(j)) return std::nullopt;
    std::optional<Vector3d> a = far(joint(j).a), b = far(joint(j).b);
    for (const int body : {joint(j).a, joint(j).b})
      for (const int k : joints_of(body))
        if (k != j && (centre(k) - centre(j)).norm() <= 2 * r_) (body == joint(j).a ? a : b) = centre(k);
    if (!a || !b || (*a - *b).norm() < 6 * r_) return std::nullopt;
    return (*a + *b) / 2;
  }
  Vector3d place_of(int j) const {
    if (joint(j).kind == JointKind::prismatic || joint(j).kind == JointKind::cylindrical)
      if (const auto middle = between(j)) return *middle;
    return centre(j);
  }

  std::pair<Vector3d, Vector3d> rail(int j) const {
    Range travel{-0.35 * overall_, 0.35 * overall_};
    if (const Joint& k = joint(j); !k.limits.empty() && k.limits[0].max - k.limits[0].min < 4 * overall_) travel = k.limits[0];
    const Vector3d axis = m_.axis(pose_, j);
    return {centre(j) + (travel.min - 3 * r_) * axis, centre(j) + (travel.max + 3 * r_) * axis};
  }

  // The convex polygon of points that lie in a plane and not in a row.
  std::optional<Flat> polygon(const std::vector<Vector3d>& points) const {
    if (points.size() < 3) return std::nullopt;
    Vector3d mean = Vector3d::Zero();
    for (const Vector3d& p : points) mean += p / static_cast<double>(points.size());
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Vector3d& p : points) spread += (p - mean) * (p - mean).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
    const Vector3d extent = solver.eigenvalues().cwiseMax(0).cwiseSqrt();
    if (!(extent(1) > 0.05 * extent(2)) || extent(0) > 0.03 * extent(2)) return std::nullopt;
    // Axes in the plane: of a regular polygon no direction is its own, and rounding would choose one.
    Vector3d n = solver.eigenvectors().col(0);
    if (n.sum() < 0) n = -n;
    const Vector3d out = points.front() - mean, u = (out - out.dot(n) * n).normalized(), v = n.cross(u);
    Flat flat;
    // From the lowest point round about, each time to the one that leaves all others to its left.
    std::vector<Vector2d> p;
    for (const Vector3d& q : points) p.emplace_back((q - mean).dot(u), (q - mean).dot(v));
    std::size_t at = 0;
    for (std::size_t k = 1; k < p.size(); ++k)
      if (p[k].y() < p[at].y() || (p[k].y() == p[at].y() && p[k].x() < p[at].x())) at = k;
    const std::size_t first = at;
    do {
      flat.corners.push_back(mean + p[at].x() * u + p[at].y() * v);
      std::size_t next = at == 0 ? 1 : 0;
      for (std::size_t k = 0; k < p.size(); ++k) {
        const Vector2d a = p[next] - p[at], b = p[k] - p[at];
        const double side = a.x() * b.y() - a.y() * b.x();
        const double tiny = 1e-9 * (a.squaredNorm() + b.squaredNorm());
        if (b.squaredNorm() > 0 && (a.squaredNorm() == 0 || side < -tiny || (std::abs(side) <= tiny && b.norm() > a.norm()))) next = k;
      }
      at = next;
    } while (at != first && flat.corners.size() <= p.size());
    return flat.corners.size() < 3 ? std::nullopt : std::optional(flat);
  }

  void plate(const Flat& flat, int body, const Color& color) {
    Solid s{Solid::Kind::plate, {0, 0, 0}, {0, 0, 0}, 0.008 * r_, Eigen::Matrix3d::Identity(), flat.corners, color, 0};
    s.body = body;
    scene_.solids.push_back(std::move(s));
  }

  // Short strokes below the lower sides of the base: it stands still.
  void hatch(const Vector3d& p, const Vector3d& q) {
    const double length = (q - p).norm(), spacing = 1.3 * r_;
    const int n = std::max(2, static_cast<int>(length / spacing));
    const Vector3d stroke = 1.1 * r_ * (-0.75 * right_ - up_);
    for (int k = 1; k <= n; ++k) {
      const Vector3d at = p + (k - 0.4) / n * (q - p);
      line({at, at + stroke}, hatch_line, 0);
    }
  }
  void ground(const Vector3d& p) {
    const Vector3d left = p - 1.2 * r_ * up_ - 1.9 * r_ * right_, to = left + 3.8 * r_ * right_;
    line({left, to}, frame_line);
    hatch(left, to);
  }

  void base() {
    std::vector<Vector3d> points, ends;
    for (const int j : joints_of(0)) {
      if (joint(j).kind != JointKind::prismatic) {
        points.push_back(centre(j));
        continue;
      }
      const auto [a, b] = rail(j);
      line({a, b}, link_line);
      ends.push_back(a), ends.push_back(b);
    }
    for (const Vector3d& p : ends) ground(p);
    if (const auto flat = polygon(points)) {
      plate(*flat, 0, base_tint);
      const std::size_t n = flat->corners.size();
      Vector3d middle = Vector3d::Zero();
      for (const Vector3d& c : flat->corners) middle += c / static_cast<double>(n);
      for (std::size_t k = 0; k < n; ++k) {
        const Vector3d &p = flat->corners[k], &q = flat->corners[(k + 1) % n];
        const Vector2d along(right_.dot(q - p), up_.dot(q - p)), out(right_.dot((p + q) / 2 - middle), up_.dot((p + q) / 2 - middle));
        Vector2d normal(-along.y(), along.x());
        if (normal.dot(out) < 0) normal = -normal;
        if (normal.y() < -0.25 * normal.norm()) hatch(p, q);
      }
      return;
    }
    for (const Vector3d& p : points) ground(p);
  }

  void link(int body) {
    if (body == 0) return base();
    std::vector<int> joints = joints_of(body);
    std::vector<Vector3d> points;
    std::vector<int> at;
    for (const int j : joints) {
      const Vector3d p = place_of(j);
      if (std::any_of(points.begin(), points.end(), [&](const Vector3d& q) { return (p - q).norm() < 0.2 * r_; })) continue;
      points.push_back(p);
      at.push_back(j);
    }
    const bool platform = body == t_.platform;
    if (platform || points.size() > 3)
      if (const auto flat = polygon(points)) return plate(*flat, body, platform ? platform_tint : paper);
    const auto out = [&](std::size_t k, const Vector3d& to) { return reach(at[k], to - points[k]); };
    if (points.size() == 2) return bar(points[0], points[1], out(0, points[1]), out(1, points[0]));
    if (points.size() == 3) {  // the two that are nearest to each other as a bar across, the third to its middle
      std::size_t lone = 0;
      for (std::size_t k = 1; k < 3; ++k)
        if ((points[(k + 1) % 3] - points[(k + 2) % 3]).norm() < (points[(lone + 1) % 3] - points[(lone + 2) % 3]).norm()) lone = k;
      const std::size_t a = (lone + 1) % 3, b = (lone + 2) % 3;
      bar(points[a], points[b], out(a, points[b]), out(b, points[a]));
      const Vector3d middle = (points[a] + points[b]) / 2;
      return bar(points[lone], middle, out(lone, middle), 0);
    }
    Vector3d middle = Vector3d::Zero();
    for (const Vector3d& p : points) middle += p / static_cast<double>(points.size());
    for (std::size_t k = 0; k < points.size() && points.size() > 3; ++k) bar(points[k], middle, out(k, middle), 0);
  }

  void add(int j, Solid s) {
    s.body = static_cast<int>(t_.bodies.size()) + j;  // each symbol has its own outline
    s.color = is_driven(j) ? driven : paper;
    scene_.solids.push_back(std::move(s));
  }

  // Long dash, dot, long dash.
  void axis(const Vector3d& c, const Vector3d& d, double half) {
    const double dash = 1.7 * r_, gap = 0.45 * r_, dot = 0.25 * r_;
    for (double s = -half; s < half; s += dash + 2 * gap + dot) {
      line({c + s * d, c + std::min(s + dash, half) * d}, axis_line, 0.1f);
      if (const double at = s + dash + gap; at + dot < half) line({c + at * d, c + (at + dot) * d}, axis_line, 0.1f);
    }
  }

  void symbol(int j) {
    const Vector3d c = place_of(j);
    switch (joint(j).kind) {
      case JointKind::spherical:
        add(j, ball(c, r_, paper));
        break;
      case JointKind::revolute: {
        const Vector3d d = m_.axis(pose_, j);
        add(j, cylinder(c - 1.5 * r_ * d, c + 1.5 * r_ * d, 0.72 * r_, paper));
        axis(c, d, 4.2 * r_);
        axes_.push_back({j, c + 4.2 * r_ * d});
        break;
      }
      case JointKind::universal:
        for (int k = 0; k < 2; ++k) {
          const Vector3d d = m_.axis(pose_, j, k);
          add(j, cylinder(c - 1.45 * r_ * d, c + 1.45 * r_ * d, 0.30 * r_, paper));
          axis(c, d, 3.0 * r_);
          axes_.push_back({j, c + 3.0 * r_ * d});
        }
        break;
      case JointKind::cylindrical: {
        const Vector3d d = m_.axis(pose_, j);
        add(j, cylinder(c - 2.2 * r_ * d, c + 2.2 * r_ * d, 0.8 * r_, paper));
        axis(c, d, 4.5 * r_);
        break;
      }
      case JointKind::prismatic: {
        const Vector3d z = m_.axis(pose_, j), x = z.unitOrthogonal();
        Eigen::Matrix3d axes;
        axes << x, z.cross(x), z;
        add(j, {Solid::Kind::box, c, {0.85 * r_, 0.85 * r_, 2.2 * r_}, 0, axes, {}, paper, 0});
        return;  // named by its drive
      }
    }
    scene_.labels.push_back({c, joint(j).name, ink, 1.0 * r_});
  }

  void name_axes() {
    for (std::size_t k = 0; k < axes_.size(); ++k) {
      const Joint& of = joint(axes_[k].joint);
      const auto limb = [&](int body) { return t_.bodies[static_cast<std::size_t>(body)].limb; };
      if (axes_.size() <= few_axes || limb(of.a) == 1 || limb(of.b) == 1)
        scene_.labels.push_back({axes_[k].end, fmt::format("s{}", k + 1), ink});
    }
  }

  void frame(int body, const std::array<const char*, 4>& names, double length) {
    const Vector3d o = m_.origin(pose_, body);
    const Eigen::Matrix3d axes = m_.rotation(pose_, body);
    for (int k = 0; k < 3; ++k) {
      const Vector3d d = axes.col(k), tip = o + length * d;
      line({o, tip - 0.8 * r_ * d}, frame_line);
      Solid head = cone(tip - 1.5 * r_ * d, tip, 0.36 * r_, ink, dashed);
      head.body = -1 - body;
      scene_.solids.push_back(std::move(head));
      scene_.labels.push_back({tip + 0.4 * r_ * d, names[static_cast<std::size_t>(k) + 1], ink});
    }
    scene_.labels.push_back({o, names[0], ink});
  }

  struct Axis {
    int joint;
    Vector3d end;
  };

  const Machine& m_;
  const Topology& t_;
  const Pose& pose_;
  const std::vector<std::string>& drives_;
  double overall_, r_;  // [m] of the machine; radius of a symbol
  double per_point_ = 1;
  Vector3d right_, up_;
  std::vector<bool> driven_;
  std::vector<Axis> axes_;
  Scene scene_;
};

}  // namespace

Diagram diagram(const Machine& machine, const std::vector<std::string>& drives, double azimuth, double elevation, const Quality& quality) {
  return Sketch(machine, drives, azimuth, elevation, quality).draw(azimuth, elevation, quality);
}

std::string legend(const Machine& machine) {
  const auto& joints = machine.topology().joints;
  std::vector<std::string> symbols;
  bool axes = false;
  const auto add = [&](JointKind kind, const char* symbol, const char* name) {
    if (std::none_of(joints.begin(), joints.end(), [&](const Joint& j) { return j.kind == kind; })) return;
    symbols.push_back(fmt::format("{} {}{}", symbol, symbols.empty() ? "are " : "", name) + (symbols.empty() ? " joints" : " ones"));
    axes = axes || (kind != JointKind::spherical && kind != JointKind::prismatic);
  };
  add(JointKind::spherical, "balls", "spherical");
  add(JointKind::revolute, "cylinders", "revolute");
  add(JointKind::cylindrical, "long cylinders", "cylindrical");
  add(JointKind::universal, "crosses", "universal");
  add(JointKind::prismatic, "boxes", "prismatic");
  return fmt::format("{}{}grey joints are driven, {}dashed lines are hidden", fmt::join(symbols, ", "), symbols.empty() ? "" : "; ",
                     axes ? "dash-dot lines are axes, " : "");
}

}  // namespace pmreport::scene
