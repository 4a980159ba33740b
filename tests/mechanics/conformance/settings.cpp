// Mistakes that show with another choice or size alone are found there, and other settings are those that were meant.
#include <core/mechanics/conformance/settings.hpp>
#include <tests/mechanics/conformance/tilt_table.hpp>

#include <set>

using namespace pmreport;
using namespace pmreport::test;

namespace {

std::set<std::string> failing(const Settings& settings) {
  std::set<std::string> out;
  for (const Setting& s : settings.taken)
    for (const Property& p : check_properties(*s.machine, {.poses = 20, .out_of_reach = 1}))
      if (p.verdict() == Verdict::failed && p.claim == "joints close") out.insert(s.words);
  return out;
}

// Two choices, three words and two; numbers of every kind. It refuses "x" with "low".
class Box : public Mechanism<1> {
 public:
  static constexpr const char *name = "box", *title = "a box on a rail", *source = "a test";
  static constexpr const char *axes[] = {"x", "y", "z"}, *places[] = {"high", "low"};
  static constexpr double inertia[] = {0.1, 0.1, 0.15, 0, 0, 0};
  static constexpr Parameter parameters[] = {Parameter::choice("axis", axes, 1, "of the rail"),
                                             Parameter::choice("place", places, 0, "of the rail"),
                                             Parameter::length("travel", 0.4, "of the box", {0.1, 100}),
                                             Parameter::angle("slope", 0, "of the floor", {-1, 1}),
                                             Parameter::numbers("inertia", inertia, {-10, 10}, 6, 6, "kg*m^2", "kg*m^2", "of the box"),
                                             Parameter::numbers("points", {}, {-1, 1}, 0, 9, "m", "mm", "of no use")};
  explicit Box(const Parameters& p) : travel_(p["travel"]) {
    for (std::size_t i = 0; i < 6; ++i) inertia_[i] = p.numbers("inertia")[i];
    if (p.choice("axis") == "x" && p.choice("place") == "low") refuse("place: a rail along x must lie high");
    if (travel_ > 2.5) refuse("travel leaves the hall");
  }
  Topology topology() const {
    Topology t;
    t.coordinates = {{"s", "position", "m", 0, {-0.1, 0.1}}};
    t.platform = t.add(Body{"box", 0, false, Inertia::central(2, inertia_)});
    t.add(Joint{"P", JointKind::prismatic, 0, 1, {}});
    t.add(Actuator{"q", "position", "m", 0, {-travel_, travel_}});
    for (const char* n : {"fy", "fz"}) t.constraints.push_back({n, "", "N"});
    for (const char* n : {"mx", "my", "mz"}) t.constraints.push_back({n, "", "N*m"});
    return t;
  }
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> p(q[0], T(0.0), T(0.0));
    at.body(1, p, Eigen::Matrix3d::Identity().cast<T>());
    at.joint(0, p, Eigen::Vector3d::UnitX().cast<T>());
    at.actuator(0, q[0]);
  }
  template <class T>
  Matrix6<T> jacobian(const Placement<T>&) const {
    return Eigen::Matrix<double, 6, 6>::Identity().cast<T>();
  }

 private:
  double travel_;
  std::array<double, 6> inertia_;
};
Machine box() { return Machine(contract::mechanism<Box>, default_values(describe(contract::mechanism<Box>))); }

}  // namespace

TEST_CASE("a mistake that shows with another choice alone is found there") {
  CHECK(failures(Mistake::only_behind).empty());
  CHECK(failing(other_choices(machine_of(Mistake::none))).empty());
  const With mistake(Mistake::only_behind);
  CHECK(failing(other_choices(machine_of(Mistake::only_behind))) == std::set<std::string>{"side = back"});
}

TEST_CASE("a mistake that shows at another size alone is found there") {
  CHECK(failures(Mistake::only_when_wide).empty());
  CHECK(failing(other_numbers(machine_of(Mistake::none), 10, 1)).empty());
  const With mistake(Mistake::only_when_wide);
  CHECK(failing(other_numbers(machine_of(Mistake::only_when_wide), 0, 1)) == std::set<std::string>{"edge = 250 mm"});
}

TEST_CASE("all combinations of words are tried when they are few, else each word alone") {
  const Machine machine = box();
  const auto words = [](const Settings& s) {
    std::set<std::string> out;
    for (const Setting& one : s.taken) out.insert(one.words);
    return out;
  };
  const Settings all = other_choices(machine, 6), each = other_choices(machine, 5);
  CHECK(words(all) == std::set<std::string>{"axis = x", "axis = z", "place = low", "axis = z, place = low"});
  CHECK(all.refused == 1);
  CHECK(all.example == "place: a rail along x must lie high");
  CHECK(words(each) == std::set<std::string>{"axis = x", "axis = z", "place = low"});
  CHECK(each.refused == 0);
}

TEST_CASE("numbers are drawn near their own size, and alone towards the ends of their ranges") {
  const Machine machine = box();
  const Settings alone = other_numbers(machine, 0, 1);
  std::set<double> travels, slopes;
  for (const Setting& s : alone.taken) {
    const ParameterValues& v = s.machine->values();
    int changed = 0;
    for (std::size_t i = 0; i < v.size(); ++i) changed += v[i] != machine.values()[i];
    CHECK(changed == 1);
    CHECK(v[5].empty());
    if (v[2] != machine.values()[2]) travels.insert(v[2][0]);
    if (v[3] != machine.values()[3]) slopes.insert(v[3][0]);
  }
  // Down to the least, 0.1 m. Ten times 0.4 m and half the way there, 2.2 m: the latter is taken.
  REQUIRE(travels.size() == 2);
  CHECK(*travels.begin() == Approx(0.1));
  CHECK(*travels.rbegin() == Approx(2.2));
  CHECK(alone.refused == 1);
  CHECK(slopes == std::set<double>{-1, 1});

  for (const Setting& s : other_numbers(machine, 20, 7).taken) {
    const double travel = s.machine->values()[2][0];
    if (travels.contains(travel)) continue;
    CHECK(travel >= 0.4 * 2 / 3 - 1e-12);
    CHECK(travel <= 0.4 * 4 / 3 + 1e-12);
    const auto& inertia = s.machine->values()[4];
    CHECK(inertia[2] / inertia[0] == Approx(1.5));
  }
}

TEST_CASE("the same seed draws the same numbers, another seed others") {
  const Machine machine = box();
  const auto drawn = [&](std::uint64_t seed) {
    std::vector<ParameterValues> out;
    for (const Setting& s : other_numbers(machine, 5, seed).taken) out.push_back(s.machine->values());
    return out;
  };
  CHECK(drawn(3) == drawn(3));
  CHECK(drawn(3) != drawn(4));
}
