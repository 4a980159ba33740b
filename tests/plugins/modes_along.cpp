// Assembly modes that come into being and vanish along a motion, against searches of their own at times before and after.
#include <core/mechanics/assembly/follow.hpp>
#include <core/mechanics/model/generic_model.hpp>

#include <core/numbers.hpp>
#include <tests/plugins/hexapods.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;

namespace {

Pose pose_of(const Machine& machine, const Eigen::VectorXd& q) { return machine.pose({q.data(), static_cast<std::size_t>(q.size())}); }

AssemblyOptions shortly() {  // tests are not compiled for speed
  AssemblyOptions options;
  options.joint_starts = 0;
  return options;
}

struct Motion {
  const Machine& machine;
  std::function<Eigen::VectorXd(double)> q;
  std::vector<double> times;

  AssemblyModes modes(double t) const {
    const Pose pose = pose_of(machine, q(t));
    REQUIRE(pose.status == PM_OK);
    return find_assembly_modes(
        machine, Eigen::Map<const Eigen::VectorXd>(pose.numbers.data() + machine.layout().actuator(0), machine.dof()), q(t), shortly());
  }
  ModeTracks follow(const std::vector<LookedAt>& looked) const {
    return follow_assembly_modes(
        modes(times.front()), times, [&](double t) { return pose_of(machine, q(t)); }, 0, looked, characteristic_length(machine));
  }
};

std::vector<double> times(double end, int samples) {
  std::vector<double> out;
  for (int k = 0; k < samples; ++k) out.push_back(end * k / (samples - 1));
  return out;
}

int events_between(const ModeTracks& tracks, double from, double to) {  // modes that come into being, less those that vanish
  int n = 0;
  for (const ModeEvent& e : tracks.events) {
    if (!(e.time > from && e.time < to)) continue;
    const bool both = e.how == ModeEnd::How::meets && e.with < tracks.tracks.size() &&
                      (e.birth ? tracks.tracks[e.with].begins : tracks.tracks[e.with].ends).with == e.track;
    n += (e.birth ? 1 : -1) * (both ? 2 : 1);
  }
  return n;
}

}  // namespace

TEST_CASE("a hexapod's closed motion has as many modes at both ends, and each birth and death where searches before and after say") {
  const auto machine = test::hexapod("gough");
  const Motion motion{*machine,
                      [&](double t) {
                        Eigen::VectorXd q = machine->home();
                        const double once = std::sin(pi * t), twice = std::sin(2 * pi * t);
                        q(0) += 0.15 * once, q(1) += 0.1 * twice;
                        q(3) += 0.4 * once, q(4) += 0.25 * once, q(5) += 0.2 * twice;
                        return q;
                      },
                      times(2, 41)};
  const ModeTracks tracks = motion.follow({{40, shortly()}, {20, shortly()}});
  CHECK(tracks.count.front() == static_cast<int>(motion.modes(0).modes.size()));
  CHECK(tracks.count.back() == tracks.count.front());
  CHECK_FALSE(tracks.events.empty());
  for (const ModeEvent& e : tracks.events) {
    CAPTURE(e.time, e.track, e.with);
    CHECK(e.how == ModeEnd::How::meets);
    CHECK(e.with < tracks.tracks.size());
  }
  // The counts are what the events make of them.
  for (std::size_t k = 1; k < motion.times.size(); ++k)
    CHECK(tracks.count[k] - tracks.count[k - 1] == events_between(tracks, motion.times[k - 1], motion.times[k]));
  // At two of the times, all modes are searched anew closely before and after.
  for (const std::size_t at : {std::size_t{0}, tracks.events.size() / 2}) {
    const double t = tracks.events[at].time, close = 1e-4;
    CAPTURE(t);
    const int before = static_cast<int>(motion.modes(t - close).modes.size()),
              after = static_cast<int>(motion.modes(t + close).modes.size());
    CHECK(after - before == events_between(tracks, t - close, t + close));
    CHECK(after != before);
  }
}

TEST_CASE("where three modes of the 5PUS-UPU meet at once, one of them goes on") {
  const pm_mechanism& table = test::plugin("5pus-upu");
  const Machine machine(table, default_values(describe(table)));
  const Motion motion{machine,
                      [&](double t) {  // the arc of the source's example
                        Eigen::VectorXd q = machine.home();
                        q(1) = 0.05 * std::cos((60 + 6 * t) * deg), q(2) = -0.05 * std::sin((60 + 6 * t) * deg);
                        return q;
                      },
                      times(10, 41)};
  const ModeTracks tracks = motion.follow({{40, shortly()}, {24, shortly()}});
  for (const std::size_t k : {std::size_t{0}, std::size_t{12}, std::size_t{24}, std::size_t{40}}) {
    CAPTURE(motion.times[k]);
    CHECK(tracks.count[k] == static_cast<int>(motion.modes(motion.times[k]).modes.size()));
  }
  CHECK(*std::ranges::min_element(tracks.count) < tracks.count.front());
  for (const ModeEvent& e : tracks.events) CHECK(e.how == ModeEnd::How::meets);
  for (std::size_t k = 1; k < motion.times.size(); ++k)
    CHECK(tracks.count[k] - tracks.count[k - 1] == events_between(tracks, motion.times[k - 1], motion.times[k]));
}

TEST_CASE("modes that a search misses at one time of a motion are known from another") {
  const auto machine = test::hexapod("gough");
  const Motion motion{*machine,
                      [&](double t) {
                        Eigen::VectorXd q = machine->home();
                        q(0) += 0.02 + 0.01 * std::sin(pi * t), q(1) -= 0.03, q(3) += 0.04, q(4) -= 0.05, q(5) += 0.03;
                        return q;
                      },
                      times(2, 11)};
  AssemblyModes found = motion.modes(0);
  const auto all = static_cast<int>(found.modes.size());
  REQUIRE(all > 2);
  found.modes.resize(1);  // as if the first search had found the motion's own alone
  const ModeTracks tracks = follow_assembly_modes(
      found, motion.times, [&](double t) { return pose_of(*machine, motion.q(t)); }, 0, {{3, shortly()}}, characteristic_length(*machine));
  CHECK(tracks.count.front() == all);
  CHECK(tracks.count.back() == all);
}
