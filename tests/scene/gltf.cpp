#include <reports/scene/gltf/machine_model.hpp>
#include <reports/scene/look.hpp>
#include <tests/scene/glb.hpp>

#include <pmreport/mechanism.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

using namespace pmreport;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using scene::Solid;

namespace {

// A table that climbs a screw, held by two telescopic legs of one make: cross, slide, ball; and a slide on the base with a link to the
// table. Only where it all is matters here.
class Climber : public Mechanism<1> {
 public:
  static constexpr const char *name = "climber", *title = "climber: \"made\" of bits", *source = "this test";
  static constexpr std::array<Parameter, 0> parameters{};
  explicit Climber(const Parameters&) {}

  Topology topology() const {
    Topology t;
    t.coordinates.push_back({"phi", "turn", "rad", 0, {-20, 20}});
    t.platform = t.add(Body{"table", 0, false, {}});
    for (const int leg : {1, 2}) {
      const std::string number = std::to_string(leg);
      const int tube = t.add(Body{"tube " + number, leg, true, {}}), rod = t.add(Body{"rod " + number, leg, true, {}});
      t.add(Joint{"A" + number, JointKind::universal, 0, tube, {}});
      const int slide = t.add(Joint{"P" + number, JointKind::prismatic, tube, rod, {}});
      t.add(Joint{"B" + number, JointKind::spherical, rod, t.platform, {}});
      if (leg == 1) t.add(Actuator{"l", "length", "m", slide, {0, 2}});
    }
    const int slider = t.add(Body{"slider", 3, false, {}}), link = t.add(Body{"link", 3, false, {}});
    t.add(Joint{"P3", JointKind::prismatic, 0, slider, {{-1, 1}}});
    t.add(Joint{"A3", JointKind::revolute, slider, link, {}});
    t.add(Joint{"B3", JointKind::spherical, link, t.platform, {}});
    t.shapes.push_back({1, ShapeKind::box, {0, 0, 0.02}, {0.15, 0.1, 0.02}, 0});
    t.shapes.push_back({7, ShapeKind::box, {0, 0, 0.1}, {0.004, 0.005, 0.1}, 0});  // slim: its bevels must not meet
    for (int k = 0; k < 5; ++k) t.constraints.push_back({"c" + std::to_string(k), "", "N"});
    return t;
  }

  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const T phi = q[0];
    const Vector3<T> x = Vector3d(1, 0, 0).cast<T>(), y = Vector3d(0, 1, 0).cast<T>();
    const Vector3<T> p(T(0.0), T(0.0), 0.6 + 0.01 * phi);
    const Matrix3<T> turned = rotation_z(phi);
    at.body(1, p, turned);
    for (const int leg : {0, 1}) {
      const double side = leg == 0 ? 1 : -1;
      const Vector3<T> foot = Vector3d(0.3 * side, 0, 0).cast<T>(), top = p + turned * Vector3d(0.1 * side, 0, 0).cast<T>();
      const Vector3<T> along = unit(Vector3<T>(top - foot)), first = side * x;
      at.slender(2 + 2 * leg, foot, along), at.slender(3 + 2 * leg, top, along);
      at.joint(3 * leg, foot, first, unit(Vector3<T>(along.cross(first))));
      at.joint(3 * leg + 1, top, along), at.joint(3 * leg + 2, top);
      if (leg == 0) at.actuator(0, length(Vector3<T>(top - foot)));
    }
    const Vector3<T> carriage(0.05 * phi, T(0.4), T(0.0));
    at.body(6, carriage, Matrix3<T>::Identity());
    const Matrix3<T> tilted = rotation_y(phi);
    at.body(7, carriage, tilted);
    at.joint(6, carriage, x), at.joint(7, carriage, y), at.joint(8, Vector3<T>(carriage + tilted * Vector3d(0, 0, 0.2).cast<T>()));
  }
  template <class T>
  Matrix6<T> jacobian(const Placement<T>&) const {
    return Eigen::Matrix<double, 6, 6>::Identity().template cast<T>();
  }
};

const mechanics::Machine& climber() {
  static const mechanics::Machine one(contract::mechanism<Climber>, {});
  return one;
}

// Two turns of the table and back, begun off home.
std::vector<scene::Moment> moments() {
  std::vector<scene::Moment> out;
  for (int k = 0; k <= 60; ++k) {
    const double t = 0.05 * k, phi = 0.3 + 4 * 3.14159 * std::sin(t);
    out.push_back({t, climber().pose({&phi, 1})});
  }
  return out;
}

glb::File file_of(const std::vector<scene::Moment>& at) { return glb::File(scene::to_glb(scene::model_of(climber(), at))); }

constexpr double single = 1e-6;  // of numbers about 1 in single precision

}  // namespace

TEST_CASE("a model is the same to the byte every time") {
  CHECK(scene::to_glb(scene::model_of(climber(), moments())) == scene::to_glb(scene::model_of(climber(), moments())));
}

TEST_CASE("one root turns up into up, and carries one node a body") {
  const glb::File file = file_of({});
  CHECK(file.json["asset"]["version"] == "2.0");
  CHECK_FALSE(file.json.contains("animations"));
  const auto& nodes = file.json["nodes"];
  const std::vector<Body>& bodies = climber().topology().bodies;
  REQUIRE(nodes.size() == bodies.size() + 1);
  CHECK(file.json["scenes"][0]["nodes"] == nlohmann::json{0});
  CHECK(nodes[0]["name"] == climber().info().title);
  CHECK(nodes[0]["children"].size() == bodies.size());
  const Quaterniond root = glb::quaternion(nodes[0]["rotation"]);
  CHECK((root * Vector3d::UnitZ() - Vector3d::UnitY()).norm() < single);
  CHECK((root * Vector3d::UnitX() - Vector3d::UnitX()).norm() < single);
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    CHECK(nodes[k + 1]["name"] == bodies[k].name);
    CHECK(nodes[k + 1].contains("mesh"));
    const int body = static_cast<int>(k);
    CHECK((glb::vector(nodes[k + 1]["translation"]) - climber().origin(climber().home_pose(), body)).norm() < single);
  }
}

TEST_CASE("the first key is the pose of the body at the first sample, and its node rests there") {
  const std::vector<scene::Moment> at = moments();
  const glb::File file = file_of(at);
  for (int body = 1; body < static_cast<int>(climber().topology().bodies.size()); ++body) {
    const Body& b = climber().topology().bodies[static_cast<std::size_t>(body)];
    INFO(b.name);
    std::vector<double> times;
    const std::vector<double> translation = file.keys(b.name, "translation"), rotation = file.keys(b.name, "rotation", &times);
    REQUIRE(times.size() == at.size());
    REQUIRE(translation.size() == 3 * at.size());
    REQUIRE(rotation.size() == 4 * at.size());
    CHECK(file.node(b.name)["translation"].get<std::vector<double>>() == std::vector(translation.begin(), translation.begin() + 3));
    CHECK(file.node(b.name)["rotation"].get<std::vector<double>>() == std::vector(rotation.begin(), rotation.begin() + 4));
    for (std::size_t k = 0; k < at.size(); ++k) {
      CHECK(times[k] == Approx(at[k].time).margin(single));
      CHECK((glb::vector(translation, k) - climber().origin(at[k].pose, body)).norm() < single);
      const Quaterniond q = glb::quaternion(rotation, k);
      CHECK(q.norm() == Approx(1).margin(single));
      if (k > 0) CHECK(q.dot(glb::quaternion(rotation, k - 1)) > 0);
      // Of a slender body the machine tells the z axis alone.
      const Matrix3d is = q.toRotationMatrix(), expected = climber().rotation(at[k].pose, body);
      const int from = b.slender ? 2 : 0;
      CHECK((is.rightCols(3 - from) - expected.rightCols(3 - from)).norm() < 3 * single);
    }
  }
}

TEST_CASE("carried by its body, every solid of a picture at home is where the picture at another pose has it") {
  const auto& m = climber();
  const scene::Sizes sizes = scene::measure(m);
  const auto solids_at = [&](const mechanics::Pose& pose) {
    scene::Scene s;
    scene::add_bodies(s, m, pose, sizes), scene::add_joints(s, m, pose, sizes);
    return s.solids;
  };
  std::vector<scene::Moment> at = moments();
  at.insert(at.begin(), scene::Moment{-1, m.home_pose()});
  const scene::Model model = scene::model_of(m, at);
  const std::vector<Solid> home = solids_at(m.home_pose());
  std::set<int> bodies;
  for (const std::size_t k : {1u, 20u, 45u}) {
    const std::vector<Solid> now = solids_at(at[k].pose);
    REQUIRE(now.size() == home.size());
    for (std::size_t i = 0; i < now.size(); ++i) {
      const Solid &s = now[i], &h = home[i];
      INFO("solid " << i << " of " << m.topology().bodies[static_cast<std::size_t>(s.body)].name);
      REQUIRE(s.body == h.body);
      bodies.insert(s.body);
      const auto track = std::find_if(model.tracks.begin(), model.tracks.end(), [&](const auto& x) { return x.node == s.body; });
      const auto moved = [&](const Vector3d& p) {
        if (track == model.tracks.end()) return p;
        return Vector3d(track->translation[k] + track->rotation[k] * (track->rotation[0].inverse() * (p - track->translation[0])));
      };
      CHECK((moved(h.a) - s.a).norm() < 1e-12);
      if (s.kind == Solid::Kind::cylinder) CHECK((moved(h.b) - s.b).norm() < 1e-12);
      if (s.kind == Solid::Kind::box)
        for (int axis = 0; axis < 3; ++axis) CHECK((moved(h.a + h.axes.col(axis)) - s.a - s.axes.col(axis)).norm() < 1e-12);
    }
  }
  CHECK(bodies.size() == m.topology().bodies.size());
}

TEST_CASE("meshes are closed against light: outward, of unit normals, within their bounds, and in the colours of the pictures") {
  const glb::File file = file_of({});
  std::set<std::vector<double>> colours;
  for (const auto& mesh : file.json["meshes"])
    for (const auto& p : mesh["primitives"]) {
      const std::size_t position = p["attributes"]["POSITION"];
      const std::vector<double> points = file.numbers(position), normals = file.numbers(p["attributes"]["NORMAL"]),
                                indices = file.numbers(p["indices"]);
      REQUIRE(points.size() == normals.size());
      REQUIRE(indices.size() % 3 == 0);
      Vector3d low = glb::vector(points), high = low;
      for (std::size_t k = 0; k < points.size() / 3; ++k) {
        low = low.cwiseMin(glb::vector(points, k)), high = high.cwiseMax(glb::vector(points, k));
        CHECK(glb::vector(normals, k).norm() == Approx(1).margin(1e-4));
      }
      CHECK(glb::vector(file.json["accessors"][position]["min"]) == low);
      CHECK(glb::vector(file.json["accessors"][position]["max"]) == high);
      int inward = 0;
      for (std::size_t k = 0; k < indices.size(); k += 3) {
        std::size_t i[3];
        for (std::size_t c = 0; c < 3; ++c) {
          i[c] = static_cast<std::size_t>(indices[k + c]);
          REQUIRE(i[c] < points.size() / 3);
        }
        const Vector3d a = glb::vector(points, i[0]), b = glb::vector(points, i[1]), c = glb::vector(points, i[2]);
        const Vector3d n = glb::vector(normals, i[0]) + glb::vector(normals, i[1]) + glb::vector(normals, i[2]);
        if ((b - a).cross(c - a).dot(n) <= 0) ++inward;
      }
      CHECK(inward == 0);
      colours.insert(file.json["materials"].at(p["material"].get<std::size_t>())["pbrMetallicRoughness"]["baseColorFactor"]);
    }
  CHECK(colours.size() == file.json["materials"].size());
  // The orange of balls, #ec9a2c, in linear light: sRGB's own table.
  CHECK(colours.contains({0.8388, 0.3231, 0.0252, 1}));
}

TEST_CASE("legs of one make share their shape, each in the colour of its actuator") {
  const glb::File file = file_of(moments());
  const auto primitive = [&](const char* node) {
    return file.json["meshes"].at(file.node(node)["mesh"].get<std::size_t>())["primitives"].at(0);
  };
  for (const auto& [one, other] : {std::pair{"tube 1", "tube 2"}, {"rod 1", "rod 2"}}) {
    CHECK(primitive(one)["attributes"] == primitive(other)["attributes"]);
    CHECK(primitive(one)["indices"] == primitive(other)["indices"]);
    CHECK(primitive(one)["material"] != primitive(other)["material"]);
  }
  CHECK(primitive("tube 1")["attributes"] != primitive("rod 1")["attributes"]);
}

TEST_CASE("what stands still is not animated") {
  const mechanics::Pose& home = climber().home_pose();
  CHECK_FALSE(file_of({{0, home}, {1, home}}).json.contains("animations"));
  CHECK(file_of(moments()).keys("base", "translation").empty());
}

TEST_CASE("a mesh of more vertices than sixteen bits count has wider indices") {
  for (const std::uint32_t vertices : {65535u, 65536u}) {
    scene::Primitive p{{1, 0, 0, 1}, {}, {}, {0, 1, vertices - 1}};
    p.positions.assign(vertices, {0, 0, 0}), p.normals.assign(vertices, {0, 0, 1});
    scene::Model model;
    model.meshes = {{p}};
    model.nodes = {{"no UTF-8: \xff", 0}};
    const glb::File file(scene::to_glb(model));
    const std::size_t indices = file.json["meshes"][0]["primitives"][0]["indices"];
    CHECK(file.json["accessors"][indices]["componentType"] == (vertices > 65535 ? 5125 : 5123));
    CHECK(file.numbers(indices) == std::vector<double>{0, 1, static_cast<double>(vertices - 1)});
  }
}

TEST_CASE("the platform is marked, and so is where a motion begins whose times were moved") {
  scene::Model model = scene::model_of(climber(), moments());
  const glb::File file(scene::to_glb(model));
  for (std::size_t k = 0; k < file.json["nodes"].size(); ++k) CHECK(file.json["nodes"][k].contains("extras") == (k == 2));
  CHECK(file.json["nodes"][2]["extras"]["platform"] == true);
  CHECK_FALSE(file.json["animations"][0].contains("extras"));
  model.begin = -1.5;
  CHECK(glb::File(scene::to_glb(model)).json["animations"][0]["extras"]["begin"] == -1.5);
}

// The reader of report.html is another one than that of these tests, in another language.
TEST_CASE("the script of the page reads a model as it was written, and moves its bodies as the machine moves") {
  if (std::system("command -v node >/dev/null") != 0) {
    WARN("node is not here: the script's reader of models was not tested");
    return;
  }
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "pmreport-model-read";
  std::filesystem::create_directories(folder);
  const std::vector<scene::Moment> at = moments();
  std::ofstream(folder / "model.glb", std::ios::binary) << scene::to_glb(scene::model_of(climber(), at));
  std::ofstream(folder / "read.js") << R"js(
const fs = require("node:fs"), vm = require("node:vm"), [file, view] = process.argv.slice(2);
vm.runInThisContext(fs.readFileSync(view, "utf8"));
const bytes = fs.readFileSync(file), model = vm.runInThisContext("readModel")(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
const poses = vm.runInThisContext("posesAt");
console.log(JSON.stringify({ names: model.bodies.map((b) => b.name), platform: model.platform, at: Array.from({ length: 121 }, (_, k) => poses(model, 0.025 * k)) }));
)js";
  const std::string command = "node " + (folder / "read.js").string() + " " + (folder / "model.glb").string() +
                              " " SOURCE "/reports/document/html/view.js > " + (folder / "out.json").string();
  REQUIRE(std::system(command.c_str()) == 0);
  const auto read = nlohmann::json::parse(std::ifstream(folder / "out.json"));
  std::filesystem::remove_all(folder);
  const std::vector<Body>& bodies = climber().topology().bodies;
  REQUIRE(read["names"].size() == bodies.size());
  CHECK(read["platform"] == climber().topology().platform);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    CHECK(read["names"][b] == bodies[b].name);
    for (std::size_t k = 0; k < at.size(); ++k) {
      const auto& pose = read["at"][2 * k][b];
      const int body = static_cast<int>(b);
      CHECK((glb::vector(pose["origin"]) - climber().origin(at[k].pose, body)).norm() < 2 * single);
      const Matrix3d expected = climber().rotation(at[k].pose, body);
      for (int row = 0; row < 3; ++row)
        for (int column = bodies[b].slender ? 2 : 0; column < 3; ++column)
          CHECK(pose["rotation"][static_cast<std::size_t>(3 * row + column)].get<double>() ==
                Approx(expected(row, column)).margin(5 * single));
    }
  }
  // Half-way between two keys a body has gone half its way, and has turned evenly: the table rises with its turn.
  for (std::size_t k = 0; k + 1 < at.size(); ++k) {
    const Vector3d middle = glb::vector(read["at"][2 * k + 1][1]["origin"]);
    CHECK((middle - (climber().origin(at[k].pose, 1) + climber().origin(at[k + 1].pose, 1)) / 2).norm() < 2 * single);
    Matrix3d r;
    for (int e = 0; e < 9; ++e) r(e / 3, e % 3) = read["at"][2 * k + 1][1]["rotation"][static_cast<std::size_t>(e)].get<double>();
    const Quaterniond q(climber().rotation(at[k].pose, 1)), next(climber().rotation(at[k + 1].pose, 1));
    CHECK((q.slerp(0.5, next).toRotationMatrix() - r).norm() < 1e-5);
  }
}
