// Limits of a workspace on indices of transmission: pressure angles of any drive, and the local transmission index.
#include <core/mechanics/model/random_poses.hpp>
#include <core/mechanics/transmission/pressure.hpp>
#include <core/mechanics/transmission/transmission.hpp>
#include <core/mechanics/workspace/pose_limits.hpp>
#include <core/program/batch.hpp>
#include <core/scan/proved_volume.hpp>
#include <tests/plugins/every_mechanism.hpp>
#include <tests/plugins/workspace.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;
using Catch::Matchers::Contains;

TEST_CASE("the program of pressure angles gives of every drive of every mechanism what its output twist gives") {
  int known = 0;
  for (const auto& [name, machine] : test::every_mechanism()) {
    CAPTURE(name);
    const Transmission t(*machine);
    CHECK(pressure_known(*machine) == t.has_pressure());
    if (!t.has_pressure() || machine->program() == nullptr) continue;
    ++known;
    const program::Program squares = squared_pressure_cosines(*machine);
    program::Batch batch(squares);
    std::vector<double> out(static_cast<std::size_t>(machine->dof()));
    for (const Eigen::VectorXd& q : random_poses(*machine, 20, 23)) {
      const auto at = t.at({q.data(), static_cast<std::size_t>(q.size())});
      if (!at || !(at->condition < 1e3)) continue;
      batch.run(1, q.data(), out.data());
      for (std::size_t i = 0; i < out.size(); ++i)
        CHECK(std::sqrt(out[i]) == Approx(at->actuators[i].cosine).margin(1e-9));  // a root doubles what rounding leaves of a small square
    }
  }
  CHECK(known >= 9);
}

TEST_CASE("margins that boxes can bound refuse the poses that are refused pose by pose, of every mechanism and with any guides") {
  int examined = 0, refused = 0;
  for (const auto& [name, machine] : test::every_mechanism()) {
    CAPTURE(name);
    std::string why;
    if (machine->program() == nullptr) continue;
    LimitChoice choice{false, false, {}};
    AskedLimit pressure{"", AskedPressure{}, 0.3, 1.1}, transmission{"", AskedTransmission{}, 0.35, 0.8};
    if (!refusal(*machine, pressure)) choice.asked.push_back(pressure);
    if (!refusal(*machine, transmission)) choice.asked.push_back(transmission);
    if (choice.asked.empty()) continue;
    const auto margins = pose_margins(*machine, choice, &why);
    REQUIRE(margins);
    REQUIRE(margins->late_over_boxes);
    const program::Guided& boxed = *margins->late_over_boxes;
    REQUIRE(boxed.program.outputs().size() == margins->late);
    const auto n = static_cast<std::size_t>(machine->dof());
    program::Batch batch(boxed.program);
    std::vector<double> late(margins->late), out(margins->late), in(n + boxed.guides);
    const std::vector<Eigen::VectorXd> poses = random_poses(*machine, 30, 31);
    for (std::size_t k = 0; k < poses.size(); ++k) {
      margins->judge_late(1, poses[k].data(), late.data());
      std::copy_n(poses[k].data(), n, in.begin());
      for (const std::size_t guide : {k, (k + 1) % poses.size()}) {  // of the pose, and of another
        boxed.choose(1, poses[guide].data(), in.data() + n);
        batch.run(1, in.data(), out.data());
        for (std::size_t m = 0; m < out.size(); ++m) {
          if (std::abs(late[m]) < 1e-9) continue;
          CHECK((out[m] >= 0) == (late[m] >= 0));
          ++examined, refused += late[m] < 0 ? 1 : 0;
        }
      }
    }
  }
  CHECK(examined > 3000);
  CHECK(refused > 500);
  CHECK(examined - refused > 500);
}

TEST_CASE("a condition number has no margins over boxes, and takes them from the limits beside it") {
  const Machine machine(test::plugin("gough"), test::values_with(test::plugin("gough"), {}));
  const AskedLimit pressure{"", AskedPressure{}, -open_end, 1.3}, condition{"", AskedCondition{}, -open_end, 20};
  CHECK(pose_margins(machine, {true, true, {pressure}})->late_over_boxes);
  CHECK_FALSE(pose_margins(machine, {true, true, {pressure, condition}})->late_over_boxes);
  CHECK_FALSE(pose_margins(machine, {true, true, {}})->late_over_boxes);
}

// At level pose the pressure angle of limb i is that between it and the vertical (Ren and Zhang 2025, eq. of section 2.2): limb 1 stands
// over y and a carriage at x = 0, limbs 2 and 3 over x and y = +-L/2, and they hold points at h behind and e / 2 beside the reference
// point. So at height z all are within acos(k) where, with t = z sqrt(1 / k^2 - 1), |x - h| <= t and |y| <= t - (L - e) / 2.
TEST_CASE("the volume where all pressure angles are good is proved, and is what geometry says") {
  const Machine machine(test::plugin("p2prpu-prps"), test::values_with(test::plugin("p2prpu-prps"), {}));
  constexpr double k = 0.9, h = 0.24, beside = 0.4, least_x = 0.3, low = 1.0, high = 1.2;
  const AskedLimit asked{"", AskedPressure{}, -open_end, std::acos(k)};
  const auto margins = pose_margins(machine, {false, false, {asked}});
  REQUIRE(margins);
  scan::PoseSet set = test::pose_set(*margins);
  set.late.over_boxes = margins->late_over_boxes;
  scan::Scan over;
  over.at = {0, 0, 0, 0, 0};
  over.points = {{0, least_x, 1.3}, {1, -0.3, 0.35}, {2, low, high}};
  const scan::ProvedVolume v = scan::prove_volume(set, over, {});
  const double slope = std::sqrt(1 / (k * k) - 1);
  const auto integral = [&](double z) {  // of (slope z + h - least_x) 2 (slope z - beside)
    const double a = h - least_x, b = -beside;
    return 2 * (slope * slope * z * z * z / 3 + slope * (a + b) * z * z / 2 + a * b * z);
  };
  const double exact = integral(high) - integral(low);
  CHECK(v.enough);
  CHECK(v.volume.low <= exact);
  CHECK(exact <= v.volume.high);
  CHECK(v.volume.high - v.volume.low < 1.1e-3 * exact);
}

TEST_CASE("a limit on the local transmission index refuses the poses whose index is less, and no others") {
  for (const char* name : {"delta", "5pus-upu", "p2prpu-prps", "stewart"}) {
    CAPTURE(name);
    const Machine machine(test::plugin(name), test::values_with(test::plugin(name), {}));
    const Transmission t(machine);
    const std::vector<Eigen::VectorXd> poses = random_poses(machine, 40, 29);
    std::vector<double> indices;
    for (const Eigen::VectorXd& q : poses) indices.push_back(t.at({q.data(), static_cast<std::size_t>(q.size())})->local);
    std::vector<double> sorted = indices;
    std::sort(sorted.begin(), sorted.end());
    AskedLimit asked;
    asked.what = AskedTransmission{};
    asked.min = 0.5 * (sorted[19] + sorted[20]);
    CHECK_FALSE(refusal(machine, asked));
    const auto margins = pose_margins(machine, {false, false, {asked}});
    REQUIRE(margins);
    REQUIRE(margins->late == 1);
    for (std::size_t k = 0; k < poses.size(); ++k) {
      double margin = 0;
      margins->judge_late(1, poses[k].data(), &margin);
      CHECK((margin >= 0) == (indices[k] >= asked.min));
    }
  }
}

TEST_CASE("a limit on an index that the mechanism has not is refused with the reason") {
  const auto why = [](const char* name) {
    const Machine machine(test::plugin(name), test::values_with(test::plugin(name), {}));
    AskedLimit asked;
    asked.what = AskedTransmission{};
    asked.min = 0.5;
    return refusal(machine, asked).value_or("");
  };
  CHECK_THAT(why("parallel-cross"), Contains("rho4 has none: it acts on the platform by a force and a couple"));
  CHECK_THAT(why("par4"), Contains("one of several bodies of the platform"));
}
