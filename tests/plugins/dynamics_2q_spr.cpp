// Inverse dynamics and joint reactions of the 2Q-SPR against an independent model in 50-digit arithmetic (tests/data/2q-spr.json).
#include <core/mechanics/displacement/displacement.hpp>
#include <core/mechanics/dynamics/drive.hpp>
#include <core/mechanics/mobility/mobility.hpp>
#include <tests/plugins/dynamics.hpp>
#include <tests/plugins/two_q_spr_cases.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Vector3d;
using Eigen::VectorXd;
using nlohmann::json;
using test::check_equal, test::number, test::vector;

namespace {

// Direction of limb 3, from B3 to b3.
Vector3d delta3(const test::Dynamics& d) { return d.joint("R3").centre - d.joint("S3").centre; }

// With limb masses the sixth number of the paper's formula is the moment of R3 across its axis and the limb, by the limb's length.
double sixth(const test::Dynamics& d) {
  const Vector3d f3 = d.joint("R3").axis[0], along = delta3(d);
  return d.moment_on("platform", "R3").dot(f3.cross(along).normalized()) / along.norm();
}

}  // namespace

TEST_CASE("forces and reactions of the 2Q-SPR's reference cases come out to nine digits") {
  const json file = test::reference("2q-spr.json");
  for (const json& c : file["cases"]) DYNAMIC_SECTION(c["name"].get<std::string>()) {
      const json &in = c["input"], &out = c["output"];
      const Machine machine(test::two_q_spr(), test::two_q_spr_cases::parameters_of(c, file["meta"]));
      const State s = test::two_q_spr_cases::state_of(machine, in);
      const test::Dynamics d(machine, s, {test::two_q_spr_cases::load_of(in), test::two_q_spr_cases::gravity_of(file)});
      // One case asks for forces before an efficiency, in the convention of the paper.
      const double efficiency = c["name"] == "B10_eta" ? number(file["meta"]["B10_parameters"]["eta"]) : 1.0;
      const VectorXd expected = vector(out["inverse_dynamics"]), forces = efficiency * expected;
      d.check_actuators(forces.head(5));

      for (std::size_t i = 0; i < 2; ++i) {
        const std::string n = std::to_string(i + 1);
        check_equal("force of the base on a lower beam", d.force_on("lower beam G" + n, "R" + n + "1"), vector(out["base_force_on_G"][i]));
      }
      const Vector3d at_ball = d.force_on("cylinder 3", "S3"), f3 = vector(out["f3"]);
      const Vector3d moment = d.moment_on("platform", "R3");
      check_equal("force of the base on limb 3", at_ball, vector(out["S3_base_force_on_leg"]));
      check_equal("its share along f3", at_ball.dot(f3), number(out["S3_base_force_dot_f3"]), at_ball.norm());
      const double size = std::max(moment.norm(), d.length() * at_ball.norm());
      check_equal("moment along f3 x delta3", moment.dot(f3.cross(delta3(d)).normalized()),
                  number(out["R3_moment_on_platform_along_f3xd3"]), size);
      check_equal("sixth number of the formula", sixth(d), forces(5), at_ball.norm());
      if (c["name"] == "B05_full") CHECK(std::abs(sixth(d) - at_ball.dot(f3)) > 1);
    }
}

TEST_CASE("forces along the motion of the 2Q-SPR's Table 1 come out to nine digits") {
  const json file = test::reference("2q-spr.json");
  const Machine machine(test::two_q_spr(), test::values_with(test::two_q_spr(), {}));
  const Loading loading{(Vector6d() << 0, 0, 1000, 0, 0, 10).finished(), test::two_q_spr_cases::gravity_of(file)};
  ForwardSolver forward(machine);
  SmallVector guess = machine.home();
  REQUIRE(file["table1_trajectory"].size() == 5);
  for (const json& at : file["table1_trajectory"]) {
    CAPTURE(at["t"]);
    const VectorXd p = vector(at["p"]), v = vector(at["V"]), a = vector(at["A"]);
    const State s = test::state_at(machine, {p(0), p(2)}, test::matrix(at["R"]), {v(0), v(2)}, v.tail<3>(), {a(0), a(2)}, a.tail<3>());
    REQUIRE(s.status == PM_OK);
    // The motion is given by the rods: r_k = r_k(0) + c_k t^3 / 6.
    constexpr double c[] = {2.5e-3, 2.8e-3, 3.3e-3, 3.6e-3, 0.8e-3};
    const double t = number(at["t"]);
    const VectorXd start = vector(file["table1_trajectory"][0]["lengths"]);
    SmallVector rods(5);
    for (int k = 0; k < 5; ++k) rods(k) = start(k) + c[k] * t * t * t / 6;
    const ForwardSolution solution = forward.solve(rods, guess);
    REQUIRE(solution.outcome == Outcome::good);
    guess = solution.coordinates;
    for (int k = 0; k < 5; ++k) {
      const auto i = static_cast<std::size_t>(k);
      check_equal("coordinate", solution.coordinates(k), s.coordinates[i].value, 0.3);  // sizes of home
      check_equal("rate of a rod", s.actuators[i].rate, c[k] * t * t / 2);
      check_equal("acceleration of a rod", s.actuators[i].acceleration, c[k] * t);
    }
    const test::Dynamics d(machine, s, loading);
    const VectorXd expected = vector(at["dynamics"]);
    d.check_actuators(expected.head(5));
    check_equal("sixth number of the formula", sixth(d), expected(5), expected.lpNorm<Eigen::Infinity>());
  }
}

TEST_CASE("the paper's efficiency asks too little of a rod that its load drives back") {
  const json file = test::reference("2q-spr.json");
  const json& with = *std::find_if(file["cases"].begin(), file["cases"].end(), [](const json& c) { return c["name"] == "B10_eta"; });
  const Machine machine(test::two_q_spr(), test::two_q_spr_cases::parameters_of(with, file["meta"]));
  const State s = test::two_q_spr_cases::state_of(machine, with["input"]);
  const test::Dynamics d(machine, s, {test::two_q_spr_cases::load_of(with["input"]), test::two_q_spr_cases::gravity_of(file)});
  const double efficiency = number(file["meta"]["B10_parameters"]["eta"]);
  DriveTrain paper{efficiency, EfficiencyConvention::always_divides}, physical{efficiency, EfficiencyConvention::by_power};
  const VectorXd expected = vector(with["output"]["inverse_dynamics"]);
  int driving = 0, driven = 0;
  for (int k = 0; k < 5; ++k) {
    const double force = d.reactions.actuator_forces(k), rate = s.actuators[static_cast<std::size_t>(k)].rate;
    check_equal("as in the paper", drive_force(paper, force, rate), expected(k), expected.lpNorm<Eigen::Infinity>());
    // What the drive takes up can never be more than the rod gives, nor what the rod gives more than the drive's.
    const double at_rod = force * rate, at_drive = drive_force(physical, force, rate) * rate;
    CHECK(at_drive >= at_rod);
    check_equal("the loss", at_drive - at_rod, at_rod > 0 ? (1 / efficiency - 1) * at_rod : -(1 - efficiency) * at_rod);
    at_rod > 0 ? ++driving : ++driven;
    if (at_rod < 0) CHECK(drive_force(paper, force, rate) * rate < at_rod);  // a loss that gives power
  }
  CHECK(driving > 0);
  CHECK(driven > 0);
}

TEST_CASE("six self-stresses of the 2Q-SPR stay inside its planar loops") {
  const json file = test::reference("2q-spr.json");
  for (const json& c : file["cases"]) {
    CAPTURE(c["name"]);
    const Machine machine(test::two_q_spr(), test::two_q_spr_cases::parameters_of(c, file["meta"]));
    const State s = test::two_q_spr_cases::state_of(machine, c["input"]);
    const test::Dynamics d(machine, s, {test::two_q_spr_cases::load_of(c["input"]), test::two_q_spr_cases::gravity_of(file)});
    CHECK(d.reactions.stresses.size() == 6);
    d.check_least_norm();
    for (const char* joint : {"R11", "R14", "R15", "R21", "R24", "R25", "S3", "P3", "R3"}) {
      CAPTURE(joint);
      CHECK(d.unique(joint));
    }
    for (const std::string loop : {"1", "2"}) {
      const Vector3d normal = d.joint("RB" + loop + "1").axis[0];
      for (const std::string rod : {"1", "2"}) {
        // A plane linkage knows its forces in the plane; what stands across the plane, and what twists out of it, it shares as it likes.
        for (const std::string pin : {"RB", "Rb"}) {
          const std::string joint = pin + loop + rod;
          CAPTURE(joint);
          for (const int c6 : {1, 2, 3}) CHECK(d.unique(joint, c6));        // forces across the pin's axis, moment about it
          for (const int c6 : {0, 4, 5}) CHECK_FALSE(d.unique(joint, c6));  // force along the axis, moments across it
        }
        for (const auto& stress : d.reactions.stresses)
          for (const std::string& joint : {"RB" + loop + rod, "P" + loop + rod, "Rb" + loop + rod}) {
            const Vector6d& w = stress[static_cast<std::size_t>(test::joint_named(machine, joint))];
            double largest = 0;
            for (const Vector6d& x : stress) largest = std::max({largest, x.head<3>().norm(), x.tail<3>().norm() / d.length()});
            CHECK(w.head<3>().cross(normal).norm() < test::tolerance * largest);
            CHECK(std::abs(w.tail<3>().dot(normal)) < test::tolerance * largest * d.length());
          }
      }
    }
  }
}
