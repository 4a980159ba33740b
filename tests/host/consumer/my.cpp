// A table on a vertical slide: the smallest mechanism there is.
#include <pmreport/mechanism.hpp>

using namespace pmreport;

class Lift : public Mechanism<1> {
 public:
  static constexpr const char *name = "lift", *title = "Lift: one vertical slide", *source = "an example";
  static constexpr Parameter parameters[] = {Parameter::number("mass", 5, {0, 1000}, "kg", "kg", "mass of the table")};

  explicit Lift(const Parameters& p) : mass_(p["mass"]) {}

  Topology topology() const {
    Topology t;
    t.coordinates.push_back({"z", "height", "m", 0.5, {0.4, 0.6}});
    t.platform = t.add(Body{"table", 0, false, Inertia::axisymmetric(mass_, 0, 0.1, 0.2)});
    t.add(Joint{"P", JointKind::prismatic, 0, t.platform, {{-0.2, 0.2}}});
    t.add(Actuator{"q", "height", "m", 0, {0.3, 0.7}});
    t.constraints = {
        {"fx", "force X", "N"}, {"fy", "force Y", "N"}, {"mx", "moment X", "N*m"}, {"my", "moment Y", "N*m"}, {"mz", "moment Z", "N*m"}};
    return t;
  }

  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> p(T(0.0), T(0.0), q[0]);
    at.body(1, p, Matrix3<T>::Identity());
    at.joint(0, p, Eigen::Vector3d::UnitZ().cast<T>());
    at.actuator(0, q[0]);
  }

  // Rows: the slide's force along Z, then what its guide holds back.
  template <class T>
  Matrix6<T> jacobian(const Placement<T>&) const {
    Matrix6<T> g = Matrix6<T>::Zero();
    constexpr int direction[] = {2, 0, 1, 3, 4, 5};
    for (int i = 0; i < 6; ++i) g(i, direction[i]) = T(1.0);
    return g;
  }

 private:
  double mass_;
};

PMREPORT_PLUGIN(Lift)
