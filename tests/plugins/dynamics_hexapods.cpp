// Inverse dynamics and every joint reaction of Gough's, Stewart's and the parallel-cross mechanisms against a separately derived model
// (tests/data/parallel-cross.json), whose 78 equations of Newton and Euler for the 13 bodies hold to 1e-13.
#include <tests/plugins/dynamics.hpp>
#include <tests/plugins/hexapods.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using nlohmann::json;
using test::check_equal, test::number, test::vector;

namespace {

// Compares the joints of one mechanism with the reactions of a case. In the reference A and C show what base or leg exert on the chain
// above, B and D what the chain exerts on platform or leg, and P what the cylinder exerts on the rod, about the rod's head.
class Reactions {
 public:
  Reactions(const json& c, const Machine& machine, const State& state, const test::Dynamics& dynamics)
      : expected_(c["dynamics"]["reactions"]), machine_(machine), state_(state), dynamics_(dynamics) {
    for (const auto& [name, wrench] : expected_.items())
      for (const char* component : {"fx", "fy", "fz", "f1", "f2"})
        if (wrench.contains(component)) largest_ = std::max(largest_, std::abs(number(wrench[component])));
  }
  void on_body(const char* prefix, std::size_t chain, const std::string& joint, const std::string& body) {
    const json& e = take(prefix + std::to_string(chain));
    const Vector6d seen = dynamics_.on(body, joint);
    check_equal("force", seen.head<3>(), Vector3d(number(e["fx"]), number(e["fy"]), number(e["fz"])));
    // A Cardan joint transmits a couple about the line across both of its axes; a ball none.
    const Vector3d across = dynamics_.joint(joint).axis[0].cross(dynamics_.joint(joint).axis[1]);
    const Vector3d couple = e.contains("m") ? Vector3d(number(e["m"]) * across) : Vector3d::Zero();
    check_equal("couple", seen.tail<3>(), couple, dynamics_.length() * largest_);
    if (e.contains("m")) check_equal("couple of a Cardan joint", seen.tail<3>().dot(across), number(e["m"]), least_couple);
  }
  // In the axes u, e2, u x e2 of the reference: ours are x = e2, z = u.
  void prismatic(const std::string& name, const std::string& joint, const std::string& rod) {
    const json& e = take(name);
    const Matrix3d& r = test::body_state(machine_, state_, rod).rotation;
    Matrix3d axes;
    axes << r.col(2), r.col(0), r.col(2).cross(r.col(0));
    const Vector6d seen = in_axes(axes, dynamics_.on(rod, joint));
    check_equal("force across", seen.head<3>(), Vector3d(0, number(e["f1"]), number(e["f2"])));
    check_equal("moment", seen.tail<3>(), Vector3d(number(e["m0"]), number(e["m1"]), number(e["m2"])));
    check_equal("moment along the chain", seen(3), number(e["m0"]), least_couple);
  }
  std::size_t compared() const { return compared_; }
  std::size_t listed() const { return expected_.size(); }

 private:
  const json& take(const std::string& name) {
    REQUIRE(expected_.contains(name));
    ++compared_;
    return expected_[name];
  }
  // Couples about a chain's own axis come from its axial inertia alone and are a thousandth of the others: the reference has them to some
  // 1e-13 N m, rounding of its forces.
  static constexpr double least_couple = 1e-3;  // [N m]

  const json& expected_;
  const Machine& machine_;
  const State& state_;
  const test::Dynamics& dynamics_;
  double largest_ = 0;
  std::size_t compared_ = 0;
};

}  // namespace

TEST_CASE("forces and reactions of every hexapod's reference cases come out to nine digits") {
  const json& file = test::reference("parallel-cross.json");
  REQUIRE(file["cases"].size() == 8);
  for (const json& c : file["cases"]) DYNAMIC_SECTION(c["id"].get<std::string>()) {
      const auto machine = test::hexapod(c["mechanism"]);
      const State s = test::state_of(*machine, c);
      const test::Dynamics d(*machine, s, {vector(c["dynamics"]["load_on_platform"]), {0, 0, -9.81}});
      d.check_actuators(vector(c["dynamics"]["actuator_forces"]));
      CHECK(d.reactions.stresses.empty());
      for (const Joint& joint : machine->topology().joints) CHECK(d.unique(joint.name));

      Reactions reactions(c, *machine, s, d);
      const bool gough = c["mechanism"] == "gough", stewart = c["mechanism"] == "stewart";
      const std::string leg = gough ? "" : "leg ";
      for (std::size_t i = 1; i <= (gough ? 6 : 3); ++i) {
        const std::string n = std::to_string(i);
        CAPTURE(n);
        reactions.on_body("A", i, "A" + n, leg + "cylinder " + n);
        reactions.prismatic("leg" + n + "P", "P" + n, leg + "rod " + n);
        reactions.on_body("B", i, "B" + n, "platform");
      }
      for (std::size_t i = 1; !gough && i <= 3; ++i) {
        const std::string n = std::to_string(i), head = std::to_string((i - 1 + test::first_head(c)) % 3 + 1),
                          chain = std::to_string(3 + i);
        CAPTURE(n, stewart);
        reactions.on_body("C", i, "C" + n, "cross cylinder " + chain);
        reactions.prismatic("cross" + n + "P", "P" + chain, "cross rod " + chain);
        reactions.on_body("D", i, "D" + head, "leg cylinder " + head);
      }
      CHECK(reactions.compared() == reactions.listed());
    }
}
