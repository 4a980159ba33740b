// The mechanism in the author's guide at the top of mechanism.hpp is this one, and it is sound.
#include <core/mechanics/conformance/properties.hpp>
#include <pmreport/free_platform.hpp>
#include <pmreport/leg.hpp>
#include <pmreport/mechanism.hpp>

#include <catch2/catch.hpp>

#include <fstream>
#include <regex>

using namespace pmreport;
using Eigen::Vector3d;

namespace {

class Table : public Mechanism<6> {  // degrees of freedom
 public:
  static constexpr const char* name = "table";                    // what a scenario calls it
  static constexpr const char* title = "A table on six legs";     // a line for people
  static constexpr const char* source = "the guide for authors";  // the paper
  static constexpr Parameter parameters[] = {
      // what a scenario may set
      Parameter::length("base_radius", 0.5, "distance of A1 to A6 from O", {0.1, 10}),
      Parameter::mass("platform_mass", 5, "mass of the table"),
  };

  explicit Table(const Parameters& p) : mass_(p["platform_mass"]) {
    if (p["base_radius"] < 2 * radius) refuse("base_radius must be at least ", 2 * radius, " m");
    for (std::size_t i = 0; i < 6; ++i) {  // joints in pairs, 20 degrees to either side
      const double vertex = double(i / 2) * 2 * std::numbers::pi / 3, side = i % 2 == 0 ? -0.35 : 0.35;
      const double at_base = vertex + side, at_table = vertex + side * 2;
      a_[i] = p["base_radius"] * Vector3d(cos(at_base), sin(at_base), 0);
      b_[i] = radius * Vector3d(cos(at_table), sin(at_table), 0);
      e_[i] = {-sin(at_base), cos(at_base), 0};
    }
  }

  Topology topology() const {  // what is connected to what
    Topology t;
    t.coordinates = free_pose({0, 0, 0.6, 0, 0, 0}, 0.1, 0.2);
    t.platform = t.add(Body{"table", 0, false, Inertia::solid_cylinder(mass_, 0.02, radius, 0)});
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
              {"B" + n, JointKind::spherical, leg.piston, platform, {{0, 1}}});
    }
    return t;
  }

  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {  // where everything is
    const Vector3<T> p(q[0], q[1], q[2]);
    const Matrix3<T> r = place_free(at, platform, q);
    for (std::size_t i = 0; i < 6; ++i) place_ups<T>(at, legs_[i], {a_[i].cast<T>(), p + r * b_[i]}, e_[i].cast<T>());
  }

  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {  // what carries the load
    Matrix6<T> g;
    for (const Leg& leg : legs_) force_row<T>(g, leg.drive, at.axis(leg.slide), at.centre(leg.high) - at.origin(platform));
    return g;
  }

 private:
  static constexpr int platform = 1;
  static constexpr double radius = 0.2;
  static constexpr auto legs_ = legs<6>(platform + 1);
  double mass_;
  Vector3d a_[6], b_[6], e_[6];  // A_i, first axes: base axes; B_i: the table's
};

// The class as it stands in a text, every run of white space and comment signs as one blank.
std::string class_in(const char* file) {
  std::ifstream in(file, std::ios::binary);
  REQUIRE(in);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  const auto begin = text.find("class Table : "), end = text.find("A_i, first axes", begin);
  REQUIRE(end != std::string::npos);
  return std::regex_replace(text.substr(begin, end - begin), std::regex("[\\s/]+"), " ");
}

}  // namespace

TEST_CASE("the mechanism of the author's guide stands there as it is tested here") {
  CHECK(class_in(SOURCE "/core/pmreport/mechanism.hpp") == class_in(__FILE__));
}

TEST_CASE("the mechanism of the author's guide has every property") {
  const pm_mechanism& table = contract::mechanism<Table>;
  const mechanics::Machine machine(table, mechanics::default_values(mechanics::describe(table)));
  const auto properties = mechanics::check_properties(machine, {50, 1});
  REQUIRE(properties.size() > 10);
  for (const mechanics::Property& p : properties) {
    INFO(p.claim << ": " << p.worst << " of " << p.tolerance << "; " << p.where);
    CHECK(p.holds());
  }
}
