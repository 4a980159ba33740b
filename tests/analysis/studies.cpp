// Studies of a run: limits, given forces, prescribed actuators, work. The stage's carriage and table have 5 kg along the slide.
#include <catch2/catch.hpp>
#include <reports/section/kinds.hpp>

#include <core/analysis/study/given_forces.hpp>
#include <core/analysis/study/limits.hpp>
#include <core/analysis/study/motion_work.hpp>
#include <core/analysis/study/prescribed.hpp>
#include <core/analysis/study/speed_study.hpp>
#include <tests/analysis/run.hpp>
#include <tests/scenario/trial.hpp>

#include <cmath>

using namespace pmreport;
using trial::Run;

namespace {

// x goes 10 mm/s for 2 s, 21 samples.
std::string steady(const std::string& more) { return trial::with("20 mm * sin(2*pi*t/10 s)", "10 mm * t / 1 s") + more; }

std::string moving(const std::string& motion, const std::string& kind) {
  return "title = \"Stage\"\n[mechanism]\nuse = \"stage\"\n[[section]]\nkind = \"" + kind +
         "\"\n[motion]\nduration = \"2 s\"\nsamples = 21\n" + motion;
}

}  // namespace

TEST_CASE("a speed that is met exactly keeps its limit, and one below breaks it at every sample") {
  const Run kept(steady("[limits]\nactuator_speed = { q = \"10 mm/s\" }\n"));
  CHECK(analysis::limit_breaches(kept.analysis).empty());
  CHECK(analysis::count_limits(kept.analysis).judged == 21);
  const Run broken(steady("[limits]\nactuator_speed = { q = \"8 mm/s\" }\n"));
  const auto breaches = analysis::limit_breaches(broken.analysis);
  REQUIRE(breaches.size() == 1);
  CHECK(breaches[0].subject == "speed of q (slide)");
  CHECK(breaches[0].samples.size() == 21);
  CHECK(breaches[0].value == Approx(0.01));
  CHECK(analysis::count_limits(broken.analysis).broken == 21);
}

TEST_CASE("a run without forces in motion has no limits to hold them against") {
  const Run r{std::string(trial::sound)};
  CHECK(analysis::limit_breaches(r.analysis).empty());
  CHECK(analysis::count_limits(r.analysis).judged == 0);
}

TEST_CASE("at s times the speed a rate grows with s, and its limit admits their ratio") {
  const Run r(steady("[limits]\nactuator_speed = { q = \"25 mm/s\" }\n[[section]]\nkind = \"speed\"\n"));
  const analysis::SpeedStudy study(r.analysis);
  CHECK(study.scale() == Approx(2.5));
  CHECK(study.duration(study.scale()) == Approx(0.8));
  REQUIRE(study.own().size() == 1);
  CHECK(study.bound(study.feasible().limits[0]) == 0.025);
  CHECK(study.demand(study.feasible().limits[0], 2)[7] == Approx(0.02));
  REQUIRE(study.proof());
  CHECK(study.proof()->binding < 1e-12);
}

TEST_CASE("inverse dynamics finds the forces again from which a motion follows, and tells when they are others") {
  Run r(moving("from = \"forces\"\n[motion.forces]\nq = \"-500 N/m * (q - 10 mm)\"\n", "dynamics"));
  CHECK(analysis::given_against_found(r.analysis) < 1e-8);
  const auto forces = r.loaded.scenario.motion->forces;
  r.loaded.scenario.motion->forces = [forces](double t, const std::vector<mechanics::Scalar>& actuators, double* out) {
    forces(t, actuators, out);
    out[0] *= 1.01;
  };
  // One hundredth of the largest force, which is the largest share of inertia.
  CHECK(analysis::given_against_found(r.analysis) == Approx(0.01).epsilon(1e-3));
}

TEST_CASE("actuators that were followed have their prescribed values, rates and accelerations") {
  const Run r(moving("q = \"20 mm * sin(t/1 s)\"\n", "displacement"));
  const analysis::PrescribedDeviation d = analysis::prescribed_deviation(r.analysis);
  CHECK(d.value < 1e-11);
  CHECK(d.rate < 1e-9);
  CHECK(d.acceleration < 1e-9);
}

TEST_CASE("the work of the slide becomes the energy of what it moves") {
  // From rest to 40 mm/s: 5 kg v^2 / 2.
  const Run r(moving("x = \"10 mm/s^2 * t^2\"\n", "dynamics"));
  const auto work = analysis::motion_work(r.analysis);
  REQUIRE(work);
  CHECK(work->work() == Approx(0.5 * 5 * 0.04 * 0.04));
  CHECK(work->stored == Approx(work->work()));
  CHECK(work->whole);
  CHECK_FALSE(work->closed);
}
