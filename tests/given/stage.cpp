#include <pmreport/mechanism.hpp>
#include <tests/given/stage.hpp>

namespace stage {

using namespace pmreport;

namespace {

constexpr const char* followers[] = {"y", "phi"};
constexpr double grid[] = {0, 0.1, 0.2};

class Stage : public Mechanism<2> {
 public:
  static constexpr const char *name = "stage", *title = "Stage: slide and turntable", *source = "made for the tests";
  static constexpr Parameter parameters[] = {
      Parameter::number("arm", 0.2, {0.01, 1}, "m", "mm", "length r of the feeler"),
      Parameter::number("stroke_min", -0.5, {-10, 10}, "m", "mm", "lower end of the slide"),
      Parameter::number("stroke_max", 0.5, {-10, 10}, "m", "mm", "upper end of the slide"),
      Parameter::number("cone", 1, {0, std::numbers::pi}, "rad", "deg", "largest turn"),
      Parameter::number("ratio", 2, {1, 3}, "", "", "a plain number"),
      Parameter::numbers("grid", grid, {-1, 1}, 2, 4, "m", "mm", "marks"),
      Parameter::choice("dependent", followers, 0, "which coordinate follows"),
  };

  explicit Stage(const Parameters& p) : arm_(p["arm"]), turning_(p.choice("dependent") == "y") {
    if (p["stroke_min"] >= p["stroke_max"]) throw std::invalid_argument("stroke_min must be less than stroke_max");
    t_.coordinates = {{"x", "slide", "m", 0, {-0.1, 0.1}},
                      turning_ ? Coordinate{"phi", "turn", "rad", 0, {-1, 1}} : Coordinate{"y", "feeler", "m", 0, {-0.1, 0.1}}};
    t_.derived = {{turning_ ? "y" : "phi", turning_ ? "feeler" : "turn", turning_ ? "m" : "rad", true}};
    const int carriage = t_.add(Body{"carriage", 1, false, Inertia::axisymmetric(3, 0, 0.05, 0.05)});
    t_.platform = t_.add(Body{"table", 0, false, Inertia::axisymmetric(2, 0, 0.01, 0.02)});
    const int slide = t_.add(Joint{"P", JointKind::prismatic, 0, carriage, {}});
    const int turn = t_.add(Joint{"R", JointKind::revolute, carriage, t_.platform, {}});
    t_.add(Actuator{"q", "slide", "m", slide, {p["stroke_min"], p["stroke_max"]}});
    t_.add(Actuator{"psi", "turn", "rad", turn, {-p["cone"] - 0.1, p["cone"] + 0.1}});
    for (const char* n : {"c1", "c2", "c3", "c4"}) t_.constraints.push_back({n, n, "N"});
  }
  Topology topology() const { return t_; }

  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    if (!turning_) at.require(arm_ - abs(q[1]), "the feeler is too short");
    const T phi = turning_ ? q[1] : asin(q[1] / arm_);
    const Vector3<T> origin(q[0], T(0.0), T(0.0));
    at.body(1, origin, Matrix3<T>::Identity());
    at.body(2, origin, rotation_z(phi));
    at.joint(0, origin, Vector3<T>(T(1.0), T(0.0), T(0.0)));
    at.joint(1, origin, Vector3<T>(T(0.0), T(0.0), T(1.0)));
    at.actuator(0, q[0]);
    at.actuator(1, phi);
    at.derived(0, turning_ ? arm_ * sin(phi) : phi);
  }
  template <class T>
  Matrix6<T> jacobian(const Placement<T>&) const {
    Matrix6<T> g = Matrix6<T>::Zero();
    for (const auto& [row, column] : {std::pair{0, 0}, {1, 5}, {2, 1}, {3, 2}, {4, 3}, {5, 4}}) g(row, column) = T(1.0);
    return g;
  }

 private:
  double arm_;
  bool turning_;
  Topology t_;
};

}  // namespace

scenario::MechanismSource source() {
  return {[](const std::string& name) { return name == "stage" ? &contract::mechanism<Stage> : nullptr; }, {"stage", "stewart"}};
}

}  // namespace stage
