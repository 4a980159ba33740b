// Assembly modes along a motion, on mechanisms whose modes are known by hand.
#include <core/mechanics/assembly/follow.hpp>

#include <core/mechanics/model/generic_model.hpp>
#include <core/numbers.hpp>
#include <tests/mechanics/assembly/actuators_at.hpp>
#include <tests/mechanics/assembly/crank_angles.hpp>
#include <tests/mechanics/mechanisms.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;
using test::actuators_at, test::crank_angles, test::modes_at, test::shortly;

TEST_CASE("the other mode of a slider-crank is followed along a motion and comes nearest where the crank is nearest to its dead centre") {
  const Machine machine = test::make(test::slider_crank());
  const auto theta = [](double t) { return 1.0 - 0.4 * std::sin(pi * t); };
  const PoseAt motion = [&](double t) {
    const double q = theta(t);
    return machine.pose({&q, 1});
  };
  std::vector<double> times;
  for (int k = 0; k <= 40; ++k) times.push_back(k / 40.0);
  const double length = characteristic_length(machine);
  for (const int start : {0, 13, 40}) {
    const AssemblyModes found = modes_at(machine, Eigen::VectorXd::Constant(1, theta(times[static_cast<std::size_t>(start)])));
    const ModeTracks tracks = follow_assembly_modes(found, times, motion, start, {}, length);
    REQUIRE(tracks.tracks.size() == 1);
    CHECK(tracks.tracks[0].begins.how == ModeEnd::How::beyond);
    CHECK(tracks.tracks[0].ends.how == ModeEnd::How::beyond);
    CHECK(tracks.events.empty());
    for (const int n : tracks.count) CHECK(n == 2);
    double least = 10;
    for (std::size_t k = 0; k < times.size(); ++k) {
      const std::vector<double> both = crank_angles(actuators_at(machine, Eigen::VectorXd::Constant(1, theta(times[k])))(0));
      const double apart = length * std::abs(std::remainder(both[1] - both[0], 2 * pi));  // the reference point O stands still
      CHECK(tracks.tracks[0].distance[k] == Approx(apart).epsilon(1e-9));
      least = std::min(least, apart);
    }
    CHECK(tracks.least == Approx(least).epsilon(1e-9));
  }
}

TEST_CASE("two modes that meet on a singular surface vanish at that time") {
  // The slider goes out to where the circle of the pin and the sphere of the rod only touch; beyond there is no pose, and no motion either.
  const Machine machine = test::make(test::slider_crank());
  const double dead = [&] {  // crank angle at which d s / d theta = 0, by the middle of the two modes
    double q = 0.8;
    for (int k = 0; k < 200; ++k) {
      const std::vector<double> both = crank_angles(actuators_at(machine, Eigen::VectorXd::Constant(1, q))(0));
      q = 0.5 * (both[0] + both[1]);
    }
    return q;
  }();
  const PoseAt motion = [&](double t) {  // at t = 1 through the dead centre
    const double q = dead + 0.5 * (1 - t);
    return machine.pose({&q, 1});
  };
  std::vector<double> times;
  for (int k = 0; k <= 20; ++k) times.push_back(0.1 * k + 0.05);
  const AssemblyModes found = modes_at(machine, Eigen::VectorXd::Constant(1, dead + 0.5 * (1 - times[0])));
  const ModeTracks tracks = follow_assembly_modes(found, times, motion, 0, {}, characteristic_length(machine));
  REQUIRE(tracks.tracks.size() == 1);
  CHECK(tracks.tracks[0].ends.how == ModeEnd::How::meets);
  CHECK(tracks.tracks[0].ends.with == own_mode);
  // Both are 0.5 (1 - t) rad from the dead centre; they count as one from 1e-5 of the length on.
  CHECK(tracks.tracks[0].ends.time == Approx(1).margin(1e-4));
}
