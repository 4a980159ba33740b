#include <array>
#include <catch2/catch.hpp>
#include <pmreport/placement.hpp>
#include <tests/pmreport/functions.hpp>

using namespace pmreport;
using functions::Random;

namespace {

// Every kind of body and joint.
Topology mixed_topology() {
  Topology t;
  t.platform = t.add(Body{"platform", 0, false, {}});
  t.add(Body{"leg", 1, true, {}});
  t.add(Body{"slide", 2, false, {}});
  for (const JointKind kind :
       {JointKind::revolute, JointKind::prismatic, JointKind::universal, JointKind::spherical, JointKind::cylindrical})
    t.add(Joint{"J", kind, 0, 1, {}});
  t.add(Actuator{"q1", "", "m", 1, {}});
  t.add(Actuator{"q2", "", "m", 1, {}});
  t.derived.push_back({"y", "", "m", true});
  return t;
}

// Writes a scalar between sentinels and reads it back.
template <class T>
void check_round_trip(const T& x, std::size_t stride, std::size_t width) {
  constexpr double sentinel = -12345;
  constexpr std::size_t components = Codec<T>::components;
  std::vector<double> array(components * stride, sentinel), again = array;
  Codec<T>::store(array.data(), stride, x);
  for (std::size_t i = 0; i < array.size(); ++i) CHECK((array[i] == sentinel) == (i % stride >= width));
  Codec<T>::store(again.data(), stride, Codec<T>::load(array.data(), stride));
  CHECK(again == array);
}

}  // namespace

// reach 0; platform 1 (12), leg 13 (6), slide 19 (12); revolute 31 (6), prismatic 37 (6), universal 43 (9), spherical 52 (3),
// cylindrical 55 (6); actuators 61, 62; derived 63.
TEST_CASE("scalars of a placement stand where the contract says") {
  const Layout layout(mixed_topology());
  CHECK(layout.body(1) == 1);
  CHECK(layout.body(2) == 13);
  CHECK(layout.body(3) == 19);
  CHECK(layout.joint(0) == 31);
  CHECK(layout.joint(1) == 37);
  CHECK(layout.joint(2) == 43);
  CHECK(layout.joint(3) == 52);
  CHECK(layout.joint(4) == 55);
  CHECK(layout.actuator(0) == 61);
  CHECK(layout.actuator(1) == 62);
  CHECK(layout.derived(0) == 63);
  CHECK(layout.size() == 64);
}

TEST_CASE("components of a scalar stand a pose apart, scalars their components apart") {
  const Topology topology = mixed_topology();
  const Layout layout(topology);
  constexpr std::size_t count = 3, pose = 2;
  std::vector<double> row(64 * 3 * count, 0.0);
  Placement<Jet<double>> at(row.data() + pose, count, layout);
  const auto number = [&](std::size_t scalar, std::size_t component) { return row[(scalar * 3 + component) * count + pose]; };
  CHECK(number(0, 0) == 1.0);

  const auto jet = [](double x) { return Jet<double>(x, x + 0.25, x + 0.5); };
  Matrix3<Jet<double>> r;
  for (int i = 0; i < 9; ++i) r(i / 3, i % 3) = jet(10 + i);
  const auto vector = [&](double x) { return Vector3<Jet<double>>(jet(x), jet(x + 1), jet(x + 2)); };
  at.body(3, vector(1), r);
  at.slender(2, vector(20), vector(30));
  at.joint(2, vector(40), vector(50), vector(60));
  at.joint(3, vector(70));
  at.actuator(1, jet(80));
  at.derived(0, jet(90));

  for (const auto& [scalar, value] : std::vector<std::pair<std::size_t, double>>{{19, 1},
                                                                                 {21, 3},
                                                                                 {22, 10},
                                                                                 {23, 11},
                                                                                 {25, 13},
                                                                                 {30, 18},
                                                                                 {13, 20},
                                                                                 {16, 30},
                                                                                 {43, 40},
                                                                                 {46, 50},
                                                                                 {49, 60},
                                                                                 {51, 62},
                                                                                 {52, 70},
                                                                                 {54, 72},
                                                                                 {62, 80},
                                                                                 {63, 90}}) {
    CAPTURE(scalar);
    CHECK(number(scalar, 0) == value);
    CHECK(number(scalar, 1) == value + 0.25);
    CHECK(number(scalar, 2) == value + 0.5);
  }
  for (std::size_t i = 0; i < row.size(); ++i)
    if (i % count != pose) CHECK(row[i] == 0.0);

  CHECK(at.origin(3).x().value == 1);
  CHECK(at.rotation(3)(1, 0).value == 13);
  CHECK(at.spine(2).z().rate == 32.25);
  CHECK(at.centre(3).y().value == 71);
  CHECK(at.axis(2, 1).x().acceleration == 60.5);
  CHECK(at.actuator(1).value == 80);
  CHECK(at.derived(0).value == 90);
}

TEST_CASE("a placement reaches as far as the least of its margins, and tells the first that fails") {
  const Topology topology = mixed_topology();
  const Layout layout(topology);
  std::vector<double> row(layout.size());
  Placement<double> at(row.data(), 1, layout);
  CHECK(at.reach() == 1.0);
  at.require(0.25, "wide enough");
  CHECK(at.reach() == 0.25);
  CHECK(at.why() == nullptr);
  at.require(-0.5, "too far");
  at.require(-0.25, "too high");
  at.require(3.0, "wide again");
  CHECK(at.reach() == -0.5);
  CHECK(at.why() == std::string("too far"));
}

TEST_CASE("each lane has its own reach") {
  const Topology topology = mixed_topology();
  const Layout layout(topology);
  std::vector<double> row(layout.size() * Lanes::width), margins(Lanes::width);
  for (std::size_t i = 0; i < margins.size(); ++i) margins[i] = 0.5 - double(i);
  Placement<Lanes> at(row.data(), Lanes::width, layout);
  at.require(Lanes::load(margins.data()), "");
  for (std::size_t i = 0; i < margins.size(); ++i) CHECK(row[i] == margins[i]);
}

TEST_CASE("every scalar survives the way through the contract's array, and touches no other pose") {
  Random random(11);
  const auto r = [&] { return random.within(-3, 3); };
  constexpr std::size_t w = Lanes::width;
  const auto lanes = [&] {
    std::array<double, w> x;
    for (double& e : x) e = r();
    return Lanes::load(x.data());
  };
  for (const std::size_t stride : {1u, 2u, 7u}) {
    CAPTURE(stride);
    check_round_trip(r(), stride, 1);
    check_round_trip(static_cast<long double>(r()) + 0x1p-60L * static_cast<long double>(r()), stride, 1);
    check_round_trip(Jet<double>(r(), r(), r()), stride, 1);
    check_round_trip(Partials<double, 5>(r(), {r(), r(), r(), r(), r()}), stride, 1);
  }
  for (const std::size_t stride : {w, w + 3}) {
    CAPTURE(stride);
    check_round_trip(lanes(), stride, w);
    check_round_trip(Jet<Lanes>(lanes(), lanes(), lanes()), stride, w);
    check_round_trip(Partials<Lanes, 2>(lanes(), {lanes(), lanes()}), stride, w);
  }
}

TEST_CASE("extended precision loses no bit on the way") {
  const long double pi = 3.14159265358979323846264338327950288L;
  for (const long double x : {pi, -pi * 1e-9L, 1.0L + 0x1p-63L, 1e200L * pi}) {
    std::array<double, 2> parts;
    Codec<long double>::store(parts.data(), 1, x);
    CHECK(parts[0] == static_cast<double>(x));
    CHECK(Codec<long double>::load(parts.data(), 1) == x);
  }
}
