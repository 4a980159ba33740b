// Crossings that the samples found and meetings that the proof did, told once.
#include <catch2/catch.hpp>

#include <core/analysis/proved_crossings.hpp>

#include <vector>

using namespace pmreport;
using analysis::Crossing;
using analysis::Meeting;

namespace {

// One coordinate, equal to the time, from 0 s to 10 s, a sample a second.
mechanics::Trajectory ramp() {
  std::vector<double> times;
  for (int k = 0; k <= 10; ++k) times.push_back(k);
  const auto path = [](double t, double* value, double* rate, double* acceleration) {
    *value = t, *rate = 1, *acceleration = 0;
    return true;
  };
  return mechanics::sampled(path, times, 1);
}

analysis::MotionProof proof(std::vector<Meeting> meetings) {
  analysis::MotionProof p;
  p.end = 10, p.resolution = 1e-7, p.meetings = std::move(meetings);
  return p;
}

Crossing found(double time, bool touches = false, Crossing::What what = Crossing::What::surface) {
  return {static_cast<int>(time), time, time, Eigen::VectorXd::Constant(1, time), what, touches};
}

std::vector<Crossing> matched(std::vector<Crossing> crossings, std::vector<Meeting> meetings) {
  match_with_proof(crossings, proof(std::move(meetings)), ramp());
  return crossings;
}

constexpr auto crossing = Meeting::What::crossing, touch = Meeting::What::touch;

}  // namespace

TEST_CASE("a crossing that both found is one, and has the interval in which it is proved to happen") {
  const auto all = matched({found(3.25)}, {{crossing, {3.2499999, 3.2500001}}});
  REQUIRE(all.size() == 1);
  REQUIRE(all[0].proved);
  CHECK(*all[0].proved == program::Bounds{3.2499999, 3.2500001});
  CHECK_FALSE(all[0].unseen);
}

TEST_CASE("bisection may miss the proved interval by rounding, not by more") {
  CHECK(matched({found(3.25)}, {{crossing, {3.25000005, 3.2500001}}}).size() == 1);
  CHECK(matched({found(3.25)}, {{crossing, {3.251, 3.252}}}).size() == 2);
}

TEST_CASE("two crossings within one step that no sample shows are added, with pose and sample before") {
  const auto all =
      matched({found(1.5), found(8.5)},
              {{crossing, {1.49, 1.51}}, {crossing, {3.25, 3.2500001}}, {crossing, {3.75, 3.7500001}}, {crossing, {8.49, 8.51}}});
  REQUIRE(all.size() == 4);
  for (const std::size_t k : {1u, 2u}) {
    CHECK(all[k].unseen);
    CHECK(all[k].proved);
    CHECK(all[k].before == 3);
    CHECK(all[k].what == Crossing::What::surface);
    CHECK_FALSE(all[k].touches);
    CHECK(all[k].coordinates(0) == all[k].time);
  }
  CHECK(all[1].time == Approx(3.25));
  CHECK(all[2].time == Approx(3.75));
  CHECK(all[0].proved);
  CHECK(all[3].proved);
}

TEST_CASE("each crossing answers to one meeting: a second one beside it is a crossing of its own") {
  const auto all = matched({found(3.25)}, {{crossing, {3.24, 3.26}}, {crossing, {3.245, 3.265}}});
  REQUIRE(all.size() == 2);
  CHECK((all[0].unseen != all[1].unseen));
}

TEST_CASE("a touch that was two crossings is replaced by them") {
  const auto all = matched({found(3.5, true)}, {{crossing, {3.49, 3.491}}, {crossing, {3.509, 3.51}}});
  REQUIRE(all.size() == 2);
  CHECK(all[0].unseen);
  CHECK(all[1].unseen);
  // One crossing beside it does not explain it away.
  CHECK(matched({found(3.5, true)}, {{crossing, {3.7, 3.701}}}).size() == 2);
}

TEST_CASE("what the proof leaves open confirms a crossing, and adds none") {
  CHECK(matched({}, {{touch, {3, 4}}, {Meeting::What::unbounded, {5, 6}}}).empty());
  const auto all = matched({found(3.5, true)}, {{touch, {3.4, 3.6}}});
  REQUIRE(all.size() == 1);
  CHECK(all[0].proved);
}

TEST_CASE("a loss that det G does not tell is no crossing of the proof") {
  const auto all = matched({found(3.25, true, Crossing::What::bodies)}, {{crossing, {3.2499, 3.2501}}});
  REQUIRE(all.size() == 2);
  for (const Crossing& c : all) CHECK(c.proved.has_value() == (c.what == Crossing::What::surface));
}

TEST_CASE("a proof that did not look changes nothing") {
  std::vector<Crossing> crossings{found(3.25)};
  analysis::MotionProof p = proof({{crossing, {7, 7.1}}});
  p.unexamined = "the motion follows from forces";
  match_with_proof(crossings, p, ramp());
  REQUIRE(crossings.size() == 1);
  CHECK_FALSE(crossings[0].proved);
}
