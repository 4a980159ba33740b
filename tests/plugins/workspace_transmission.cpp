// Limits of a workspace on indices of transmission: pressure angles of any drive, and the local transmission index.
#include <core/mechanics/model/random_poses.hpp>
#include <core/mechanics/transmission/pressure.hpp>
#include <core/mechanics/transmission/transmission.hpp>
#include <core/mechanics/workspace/pose_limits.hpp>
#include <core/program/batch.hpp>
#include <tests/plugins/every_mechanism.hpp>

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
