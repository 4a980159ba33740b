// The map of det G on a mechanism whose determinant is known: a table on crossed slides, X driven at its slide, Y by a leg that stands on
// the carriage h above it, l^2 = y^2 + h^2, so that l' = (y / l) y' and det G = y / l: singular on the line y = 0.
#include <catch2/catch.hpp>

#include <pmreport/leg.hpp>
#include <tests/given/only.hpp>
#include <tests/section/report_words.hpp>
#include <tests/section/whole_report.hpp>

#include <cmath>

using namespace pmreport;
using namespace whole_report;
using Catch::Contains;

namespace {

constexpr double above = 0.3;  // h [m]

class CrossTable : public Mechanism<2> {
 public:
  static constexpr const char *name = "cross-table", *title = "cross table", *source = "this test";
  static constexpr std::array<Parameter, 0> parameters{};
  explicit CrossTable(const Parameters&) {}
  Topology topology() const {
    Topology t;
    t.coordinates = {{"x", "place of the carriage", "m", 0, {-0.2, 0.2}}, {"y", "place of the table", "m", 0.1, {-0.2, 0.2}}};
    t.platform = t.add(Body{"table", 0, false, {}});
    t.add(Body{"carriage", 0, false, {}});
    t.add(Joint{"X", JointKind::prismatic, 0, 2, {}});
    t.add(Joint{"Y", JointKind::prismatic, 2, 1, {}});
    t.add(Actuator{"q", "drive of the carriage", "m", 0, {-1, 1}});
    add_leg(t, leg, "1", {"cylinder ", "piston ", "l", "length of leg ", {}, {}, {0, 1}}, {"A", JointKind::revolute, 2, leg.cylinder, {}},
            {"B", JointKind::revolute, leg.piston, 1, {}});
    t.constraints = {{"force_z", "", "N"}};
    for (const char* n : {"couple_x", "couple_y", "couple_z"}) t.constraints.push_back({n, "", "N*m"});
    return t;
  }
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> carriage(q[0], T(0.0), T(0.0)), table(q[0], q[1], T(0.0)), foot(q[0], T(0.0), T(above));
    const Vector3<T> x = Eigen::Vector3d::UnitX().cast<T>();
    at.body(1, table, Matrix3<T>(Matrix3<T>::Identity()));
    at.body(2, carriage, Matrix3<T>(Matrix3<T>::Identity()));
    at.joint(0, carriage, x);
    at.joint(1, table, Eigen::Vector3d::UnitY().cast<T>());
    at.actuator(0, q[0]);
    place_leg<T>(at, leg, Line<T>(foot, table), x);
    at.joint(leg.low, foot, x);
    at.joint(leg.high, table, x);
  }
  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    Matrix6<T> g = Matrix6<T>::Constant(T(0.0));
    g(0, 0) = T(1.0);
    g(1, 1) = at.axis(leg.slide)(1);
    for (int k = 2; k < 6; ++k) g(k, k) = T(1.0);
    return g;
  }

 private:
  static constexpr Leg leg{1, 1, 3, 4, 2, 3, 4};
};

document::Report mapped(const std::string& motion) {
  return report_of(
      "title = \"Cross table\"\n[mechanism]\nuse = \"cross-table\"\n[motion]\nduration = \"1 s\"\nsamples = 11\n" + motion +
          "[[section]]\nkind = \"singularity\"\nmap = { x = [\"-200 mm\", \"200 mm\"], y = [\"-100 mm\", \"300 mm\"], points = 21 }\n",
      test::only<CrossTable>());
}

const figure::Figure& map_of(const document::Report& r) {
  for (const auto* f : report_words::pointers<figure::Figure>(section_of(r, "singularity")))
    if (f->id == "singularity-map") return *f;
  throw std::out_of_range("no map");
}

}  // namespace

TEST_CASE("a map shows the determinant of G over two coordinates, and its zero line where the mechanism is singular") {
  const auto r = mapped("x = \"0 mm\"\ny = \"100 mm\"\n");
  const figure::Figure& f = map_of(r);
  REQUIRE(f.panels.size() == 2);
  const figure::Panel &determinant = f.panels[0], &smallest = f.panels[1];
  CHECK(determinant.x.unit == "mm");
  REQUIRE(determinant.map);
  REQUIRE(smallest.map);
  REQUIRE(determinant.map->values.size() == 21 * 21);
  CHECK(determinant.map->contour == "det Ĝ = 0");
  for (std::size_t row = 0; row < 21; ++row)
    for (std::size_t k = 0; k < 21; ++k) {
      const double y = -0.1 + 0.02 * double(row), expected = y / std::hypot(y, above);
      CHECK(determinant.map->x[k] == Approx(-200 + 20 * double(k)).margin(1e-9));
      CHECK(determinant.map->y[row] == Approx(1e3 * y).margin(1e-9));
      CHECK(determinant.map->values[row * 21 + k] == Approx(expected).margin(1e-14));
      // G is diagonal, all its other entries one: its smallest singular value is that of the leg, with the determinant's sign.
      CHECK(smallest.map->values[row * 21 + k] == Approx(expected).margin(1e-14));
    }
}

TEST_CASE("the numbers behind a map are those that it shows, in SI, a row a point") {
  const auto r = mapped("x = \"0 mm\"\ny = \"100 mm\"\n");
  const auto &x = column_of(r, "singularity-map", "x [m]"), &y = column_of(r, "singularity-map", "y [m]"),
             &d = column_of(r, "singularity-map", "determinant"), &sigma = column_of(r, "singularity-map", "smallest_singular_value");
  REQUIRE(d.size() == 21 * 21);
  for (std::size_t k = 0; k < d.size(); ++k) {
    CHECK(x[k] == Approx(-0.2 + 0.02 * double(k % 21)).margin(1e-12));
    CHECK(d[k] == Approx(y[k] / std::hypot(y[k], above)).margin(1e-14));
    CHECK(sigma[k] == Approx(std::abs(d[k])).margin(1e-14));
  }
}

TEST_CASE("the motion is drawn over the map, and a motion that stands still is not") {
  const auto still = mapped("x = \"0 mm\"\ny = \"100 mm\"\n");
  CHECK(map_of(still).panels[0].series.empty());
  const auto moving = mapped("x = \"100 mm * t / 1 s\"\ny = \"100 mm\"\n");
  REQUIRE(map_of(moving).panels[0].series.size() == 1);
  const figure::Series& path = map_of(moving).panels[0].series[0];
  CHECK(path.label == "motion");
  for (std::size_t k = 0; k < 11; ++k) {
    CHECK(path.x[k] == Approx(10 * double(k)).margin(1e-9));
    CHECK(path.y[k] == Approx(100));
  }
}
