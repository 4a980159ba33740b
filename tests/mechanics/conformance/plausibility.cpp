// Mistakes in data alone, each planted in a table on six legs that is sound without it: what is remarked, and that nothing else is.
#include <core/mechanics/conformance/plausibility.hpp>
#include <core/numbers.hpp>
#include <pmreport/free_platform.hpp>
#include <pmreport/leg.hpp>
#include <pmreport/mechanism.hpp>

#include <catch2/catch.hpp>

#include <functional>

using namespace pmreport;
using namespace pmreport::mechanics;
using Catch::Contains;
using Eigen::Vector3d;

namespace {

constexpr double base_radius = 0.5, platform_radius = 0.2, home_height = 0.6;
using Six = std::array<Vector3d, 6>;

// Pairs, half an angle to either side of vertices that are a step apart.
Six pairs(double radius, double first, double step, double half) {
  Six out;
  for (std::size_t i = 0; i < 6; ++i) {
    const double azimuth = (first + step * double(i / 2) + (i % 2 == 0 ? -half : half)) * deg;
    out[i] = radius * Vector3d(cos(azimuth), sin(azimuth), 0);
  }
  return out;
}
Six around(double radius, double step) {
  Six out;
  for (std::size_t i = 0; i < 6; ++i) out[i] = radius * Vector3d(cos(step * double(i) * deg), sin(step * double(i) * deg), 0);
  return out;
}

// What a test plants its mistake in.
struct Given {
  Six a = pairs(base_radius, 0, 120, 20), b = pairs(platform_radius, 0, 120, 40);
  Vector3d home{0, 0, home_height};
  std::function<void(Topology&)> change = [](Topology&) {};
};
Given given;

class OddTable : public Mechanism<6> {
 public:
  static constexpr const char *name = "table", *title = "a table on six legs", *source = "a test";
  static constexpr std::array<Parameter, 0> parameters{};
  explicit OddTable(const Parameters&) : given_(given) {}

  Topology topology() const {
    Topology t;
    t.coordinates = free_pose({given_.home.x(), given_.home.y(), given_.home.z(), 0, 0, 0}, 0.1, 0.2);
    t.platform = t.add(Body{"table", 0, false, Inertia::solid_cylinder(5, 0.02, platform_radius, 0)});
    const Telescope made{"cylinder ",
                         "piston ",
                         "l",
                         "length of leg ",
                         Inertia::solid_cylinder(1, 0.4, 0.02, 0.2),
                         Inertia::solid_cylinder(0.5, 0.4, 0.01, -0.2),
                         {0.4, 1.1}};
    for (const Leg& leg : legs_) {
      const std::string n = std::to_string(leg.limb);
      add_leg(t, leg, n, made, {"A" + n, JointKind::universal, 0, leg.cylinder, {{-1, 1}, {-1, 1}}},
              {"B" + n, JointKind::spherical, leg.piston, 1, {{0, 1}}});
      draw_leg(t, leg, 0.4, 0.02, 0.01);
    }
    given_.change(t);
    return t;
  }
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> p(q[0], q[1], q[2]);
    const Matrix3<T> r = place_free(at, 1, q);
    for (std::size_t i = 0; i < 6; ++i) {
      // Across the leg as it stands at home, wherever that is.
      const Vector3d along = (given_.home + given_.b[i] - given_.a[i]).normalized();
      place_ups<T>(at, legs_[i], {given_.a[i].cast<T>(), p + r * given_.b[i]}, along.unitOrthogonal().cast<T>());
    }
  }
  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    Matrix6<T> g;
    for (const Leg& leg : legs_) force_row<T>(g, leg.drive, at.axis(leg.slide), at.centre(leg.high) - at.origin(1));
    return g;
  }

 private:
  static constexpr auto legs_ = legs<6>(2);
  Given given_;
};

std::vector<Remark> remarks_on(const Given& with) {
  given = with;
  const pm_mechanism& table = contract::mechanism<OddTable>;
  return plausibility(Machine(table, default_values(describe(table))));
}

// The only remark on a table with such a mistake in its topology.
Remark only(const Given& with) {
  const std::vector<Remark> all = remarks_on(with);
  std::string text;
  for (const Remark& r : all) text += sentence(r) + "\n";
  INFO(text);
  REQUIRE(all.size() == 1);
  CHECK_FALSE(all[0].usual.empty());
  CHECK_FALSE(all[0].reason.empty());
  return all[0];
}
Remark only(const std::function<void(Topology&)>& change) {
  Given g;
  g.change = change;
  return only(g);
}

Body& body(Topology& t, const std::string& name) {
  for (Body& b : t.bodies)
    if (b.name == name) return b;
  throw std::out_of_range(name);
}
void of_all(Topology& t, const std::string& stem, const std::function<void(Body&)>& change) {
  for (Body& b : t.bodies)
    if (b.name.starts_with(stem)) change(b);
}
using Names = std::vector<std::string>;
const Names cylinders{"cylinder 1", "cylinder 2", "cylinder 3", "cylinder 4", "cylinder 5", "cylinder 6"};

}  // namespace

TEST_CASE("nothing looks odd in a sound table, nor in one without any mass") {
  CHECK(remarks_on({}).empty());
  Given weightless;
  weightless.change = [](Topology& t) {
    for (Body& b : t.bodies) b.inertia = {};
  };
  CHECK(remarks_on(weightless).empty());
}

TEST_CASE("a platform without mass on limbs that have one is remarked") {
  const Remark r = only([](Topology& t) { body(t, "table").inertia = {}; });
  CHECK(r.of == Names{"table"});
  CHECK_THAT(r.seen, Contains("no mass") && Contains("9 kg"));  // six times 1 kg and 0.5 kg
}

TEST_CASE("a mass in g is remarked against the others") {
  const Remark r = only([](Topology& t) { body(t, "table").inertia = Inertia::solid_cylinder(0.005, 0.02, platform_radius, 0); });
  CHECK(r.of == Names{"table"});
  CHECK_THAT(r.seen, Contains("0.005 kg") && Contains("1.5 kg"));
}

TEST_CASE("a centre of mass on the wrong side is remarked with the way it lies") {
  const Remark r = only([](Topology& t) { of_all(t, "cylinder", [](Body& b) { b.inertia.centre *= -1; }); });
  CHECK(r.of == cylinders);
  CHECK_THAT(r.seen, Contains("200 mm outside") && Contains("along -z"));
  CHECK_THAT(r.reason, Contains("sign"));
}

TEST_CASE("a tool that hangs below its plate is nothing odd") {
  Given g;
  g.change = [](Topology& t) { body(t, "table").inertia.centre.z() = -0.15; };
  CHECK(remarks_on(g).empty());
}

TEST_CASE("a rod that is drawn shorter than it is, to be hidden in its cylinder, is nothing odd") {
  Given g;
  g.change = [](Topology& t) {
    for (Shape& s : t.shapes)
      if (s.radius == 0.01) s.a.z() = -0.05;  // its mass reaches back for 0.4 m
  };
  CHECK(remarks_on(g).empty());
  const auto hidden = g.change;
  CHECK(only([hidden](Topology& t) {
          hidden(t);
          of_all(t, "piston", [](Body& b) { b.inertia.centre *= -1; });
        }).of.size() == 6);
}

TEST_CASE("exchanged inertias of a disc are remarked") {
  // A disc has half about a diameter of what it has about its axis.
  const Remark r = only([](Topology& t) {
    Eigen::Matrix3d& i = body(t, "table").inertia.about_centre;
    i = Vector3d(i(2, 2), i(2, 2), i(0, 0)).asDiagonal();
  });
  CHECK(r.of == Names{"table"});
  CHECK_THAT(r.reason, Contains("exchanged"));
}

TEST_CASE("an inertia in another unit is remarked, too large or too small") {
  const Remark large = only([](Topology& t) { of_all(t, "piston", [](Body& b) { b.inertia.about_centre *= 1e3; }); });
  CHECK(large.of.size() == 6);
  CHECK_THAT(large.seen, Contains("12.6 m long along z"));  // 0.4 m times the square root of 1000
  const Remark small = only([](Topology& t) { of_all(t, "piston", [](Body& b) { b.inertia.about_centre *= 1e-4; }); });
  CHECK_THAT(small.seen, Contains("within 4 mm") && Contains("400 mm long"));
}

TEST_CASE("cylinders of 760 mm on legs of 30 mm are remarked") {
  Given g;
  for (Vector3d& p : g.a) p *= 0.02 / base_radius;
  for (Vector3d& p : g.b) p *= 0.015 / platform_radius;
  g.home = {0, 0, 0.025};
  g.change = [](Topology& t) {
    t.shapes.clear();
    for (Actuator& a : t.actuators) a.stroke = {0.015, 0.045};
    body(t, "table").inertia = Inertia::solid_cylinder(0.1, 0.003, 0.015, 0);
    of_all(t, "cylinder", [](Body& b) { b.inertia = Inertia::solid_cylinder(1, 0.76, 0.03, 0.38); });
    of_all(t, "piston", [](Body& b) { b.inertia = Inertia::solid_cylinder(0.1, 0.02, 0.002, -0.01); });
  };
  const Remark r = only(g);
  CHECK(r.of == cylinders);
  // A_i to B_i: 20 degrees apart in azimuth, radii 20 and 15 mm, 25 mm up.
  const double leg = std::sqrt(0.02 * 0.02 + 0.015 * 0.015 - 2 * 0.02 * 0.015 * cos(20 * deg) + 0.025 * 0.025);
  CHECK(leg == Approx(0.0262).epsilon(1e-3));
  CHECK_THAT(r.seen, Contains("760 mm long along z") && Contains("26.2 mm apart") && Contains("45 mm"));
}

TEST_CASE("solids drawn in mm for m are remarked") {
  const Remark longer = only([](Topology& t) {
    for (Shape& s : t.shapes)
      if (s.radius == 0.01) s.a.z() = -4;  // ten times its length
  });
  CHECK(longer.of.size() == 6);
  CHECK_THAT(longer.seen, Contains("4000 mm in size is drawn"));
  const Remark thin = only([](Topology& t) {
    for (Shape& s : t.shapes)
      if (s.radius == 0.02) s.radius = 2e-5;
  });
  CHECK(thin.of == cylinders);
  CHECK_THAT(thin.seen, Contains("kg/m^3"));
}

TEST_CASE("a radius in mm for m is remarked as one length against the rest") {
  Given g;
  for (Vector3d& p : g.a) p *= 1000;
  const std::vector<Remark> all = remarks_on(g);
  const auto found =
      std::find_if(all.begin(), all.end(), [](const Remark& r) { return r.of == Names{"table"} && r.seen.starts_with("its joints are"); });
  REQUIRE(found != all.end());
  // 40 degrees to either side of 0 and 120: the farthest two are 160 degrees apart.
  CHECK(2 * platform_radius * sin(80 * deg) == Approx(0.394).epsilon(1e-3));
  CHECK_THAT(found->seen, Contains("394 mm apart") && Contains("500 m"));
  CHECK_THAT(found->reason, Contains("mm where m were meant"));
}

TEST_CASE("a stroke in which home does not lie is remarked") {
  const Remark r = only([](Topology& t) {
    for (Actuator& a : t.actuators) a.stroke = {0.04, 0.11};
  });
  CHECK(r.of.size() == 6);
  CHECK_THAT(r.seen, Contains("40 mm to 110 mm"));
}

TEST_CASE("limits in degrees, and a direction that points the wrong way, are remarked") {
  const Remark degrees = only([](Topology& t) {
    for (Joint& j : t.joints)
      if (j.kind == JointKind::spherical) j.limits = {{0, 60}};
  });
  CHECK(degrees.of == Names{"B1", "B2", "B3", "B4", "B5", "B6"});
  CHECK_THAT(degrees.seen, Contains("60 rad") && Contains("3438 deg"));
  const auto from = [](double z) {
    Given g;
    g.change = [z](Topology& t) {
      for (Joint& j : t.joints)
        if (j.kind == JointKind::spherical) j.from = {0, 0, z};
    };
    return g;
  };
  CHECK(remarks_on(from(1)).empty());  // the legs lean by half a radian
  CHECK_THAT(only(from(-1)).seen, Contains("at home already"));
}

TEST_CASE("steps of 100 degrees for 120 are remarked, whatever axis they go about") {
  Given g;
  g.a = pairs(base_radius, 0, 100, 20);
  const Remark flat = only(g);
  CHECK(flat.of == Names{"A1", "A2", "A3", "A4", "A5", "A6"});
  CHECK_THAT(flat.seen, Contains("every 100 deg about Z") && Contains("gap of 120 deg"));  // 160 less half an angle at either end
  CHECK_THAT(flat.usual, Contains("every 120 deg"));

  for (Six* six : {&g.a, &g.b})
    for (Vector3d& p : *six) p = Vector3d(p.y(), 0, p.x());
  g.home = {0, home_height, 0};
  CHECK_THAT(only(g).seen, Contains("every 100 deg about Y"));

  Given single;
  single.a = around(base_radius, 55);
  single.b = around(platform_radius, 60);
  CHECK_THAT(only(single).seen, Contains("every 55 deg") && Contains("gap of 85 deg"));
}

TEST_CASE("three limbs every 100 degrees are remarked, and every 90 degrees, as in a T, are not") {
  // Of six limbs the last three are made one, so that three are alike.
  const auto of_step = [](double step) {
    Given g;
    g.change = [](Topology& t) {
      for (Body& b : t.bodies) b.limb = std::min(b.limb, 4);
    };
    for (std::size_t i = 0; i < 3; ++i) g.a[i] = base_radius * Vector3d(cos(step * double(i) * deg), sin(step * double(i) * deg), 0);
    return g;
  };
  CHECK(only(of_step(100)).of == Names{"A1", "A2", "A3"});
  CHECK(remarks_on(of_step(90)).empty());
  CHECK(remarks_on(of_step(120)).empty());
}

TEST_CASE("one joint that breaks the pattern of all others is remarked with its place") {
  Given g;
  g.a[3] *= 1.1;
  const Remark out = only(g);
  CHECK(out.of == Names{"A4"});
  CHECK_THAT(out.seen, Contains("stands 50 mm away") && Contains("radius 550 mm") && Contains("500 mm"));
  Given raised;
  raised.b[0].z() = 0.03;
  CHECK(only(raised).of == Names{"B1"});
  CHECK_THAT(only(raised).seen, Contains("30 mm away"));
  Given turned;
  turned.a[4] = base_radius * Vector3d(cos(230 * deg), sin(230 * deg), 0);  // for 220
  CHECK(only(turned).of == Names{"A5"});
  CHECK_THAT(only(turned).seen, Contains("azimuth 230 deg") && Contains("220 deg"));
}

TEST_CASE("patterns that are meant, rounded or not there at all are nothing odd") {
  Given rounded;
  for (Vector3d& p : rounded.a) p = (p * 1e3).array().round() * 1e-3;
  CHECK(remarks_on(rounded).empty());
  Given mirrored;  // about XZ alone
  const double azimuths[] = {10, 80, 140, 220, 280, 350};
  for (std::size_t i = 0; i < 6; ++i) mirrored.a[i] = base_radius * Vector3d(cos(azimuths[i] * deg), sin(azimuths[i] * deg), 0);
  CHECK(remarks_on(mirrored).empty());
  Given ellipse;
  for (Vector3d& p : ellipse.a) p.x() *= 1.3;
  CHECK(remarks_on(ellipse).empty());
}

TEST_CASE("one limb with another mass, inertia, limit or stroke than all others of its make is remarked") {
  const Remark mass = only([](Topology& t) { body(t, "piston 3").inertia.mass = 0.05; });
  CHECK(mass.of == Names{"piston 3"});
  CHECK_THAT(mass.seen, Contains("0.05 kg") && Contains("5 others") && Contains("0.5 kg"));
  CHECK(only([](Topology& t) { body(t, "cylinder 5").inertia.centre.z() = 0.02; }).of == Names{"cylinder 5"});
  CHECK(only([](Topology& t) { body(t, "cylinder 5").inertia.about_centre *= 2; }).of == Names{"cylinder 5"});
  const Remark stroke = only([](Topology& t) { t.actuators[1].stroke.max = 11; });
  CHECK(stroke.of == Names{"l2"});
  CHECK_THAT(stroke.seen, Contains("11 m") && Contains("1100 mm"));
  CHECK(only([](Topology& t) { t.joints[0].limits[1].min = -0.1; }).of == Names{"A1"});
}

TEST_CASE("joints almost in one place are remarked, joints in one place are not") {
  Given g;
  g.a[1] = g.a[0];
  g.a[3] = g.a[2];
  g.a[5] = g.a[4];
  CHECK(remarks_on(g).empty());
  for (const std::size_t i : {1u, 3u, 5u}) g.a[i] += Vector3d(0, 0, 1e-4);
  const Remark r = only(g);
  CHECK(r.of == Names{"base"});
  CHECK_THAT(r.seen, Contains("0.1 mm apart"));
}

TEST_CASE("a sentence names a few of many, and how many more there are") {
  const Remark r{{"a", "b", "c", "d", "e", "f", "g", "h", "i"}, "seen", "usual", "reason"};
  CHECK(sentence(r) == "a, b, c, d, e, f and 3 more: seen. Usually usual: reason.");
}
