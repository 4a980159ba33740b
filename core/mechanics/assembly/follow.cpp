#include <core/mechanics/assembly/follow.hpp>

#include <core/mechanics/displacement/displacement.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ranges>

namespace pmreport::mechanics {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double shortest = 1.0 / 1024;  // of the time between two samples: how exactly the time of a mode's end is known
constexpr double near = 0.15;            // of the characteristic length: the farthest that a mode goes in one step
constexpr double same = 1e-5;            // likewise: two modes that are one

struct Place {
  std::size_t word = 0;
  SmallVector q;
  Pose pose;
};

class Follower {
 public:
  Follower(const std::vector<WorkingMode>& words, const std::vector<double>& times, const PoseAt& motion, double length)
      : words_(words), times_(times), motion_(motion), length_(length) {
    for (const WorkingMode& w : words) solvers_.push_back(std::make_unique<ForwardSolver>(*w.machine));
    for (const double t : times) poses_.push_back(motion(t));
  }

  const Pose& pose(int sample) const { return poses_[static_cast<std::size_t>(sample)]; }
  int samples() const { return static_cast<int>(times_.size()); }
  SmallVector actuators(const Pose& pose) const {
    const Machine& own = *words_.front().machine;
    return Eigen::Map<const Eigen::VectorXd>(pose.numbers.data() + own.layout().actuator(0), own.dof());
  }
  double apart(const Pose& a, const Pose& b) const { return distance(*words_.front().machine, a, b, length_); }

  // Where a mode is at each sample.
  using Places = std::vector<std::optional<Place>>;

  // Fills the distances of a track, and where its mode is, from a sample on, forwards or backwards. Ends where it comes upon a mode of
  // `others`: then they have met on a singular surface, and cannot be told apart from there on.
  void run(ModeTrack& track, Place place, int sample, int direction, Places& places, const std::vector<Places>& others);

 private:
  bool met(const Place& place, std::size_t sample, const std::vector<Places>& others) const;
  bool step(Place& place, double& t, double to);
  bool neighbours(std::size_t a, std::size_t b) const;
  std::optional<Place> solve(const Place& from, const SmallVector& actuators, std::size_t word);

  const std::vector<WorkingMode>& words_;
  const std::vector<double>& times_;
  const PoseAt& motion_;
  double length_;
  std::vector<std::unique_ptr<ForwardSolver>> solvers_;
  std::vector<Pose> poses_;
};

std::optional<Place> Follower::solve(const Place& from, const SmallVector& actuators, std::size_t word) {
  const ForwardSolution s = solvers_[word]->solve(actuators, from.q);
  if (s.outcome != Outcome::good) return {};
  Place to{word, s.coordinates, words_[word].machine->pose({s.coordinates.data(), static_cast<std::size_t>(s.coordinates.size())})};
  if (to.pose.status != PM_OK || apart(from.pose, to.pose) > near * length_) return {};
  return to;
}

// A limb that comes to the edge of its reach goes on in its other solution: words that differ in one choice.
bool Follower::neighbours(std::size_t a, std::size_t b) const {
  const ParameterValues &x = words_[a].machine->values(), &y = words_[b].machine->values();
  int different = 0;
  for (std::size_t i = 0; i < x.size(); ++i) different += x[i] != y[i];
  return different == 1;
}

// From the mode at time t to that at time `to`. False where it ends before; t is then when.
bool Follower::step(Place& place, double& t, double to) {
  const double least = std::abs(to - t) * shortest;
  double h = to - t;
  while (t != to) {
    const double next = std::abs(to - t) <= std::abs(h) ? to : t + h;
    const Pose there = motion_(next);
    std::optional<Place> found;
    if (there.status == PM_OK) {
      const SmallVector l = actuators(there);
      found = solve(place, l, place.word);
      if (!found && std::abs(h) <= 4 * least)
        for (std::size_t w = 0; w < words_.size() && !found; ++w)
          if (neighbours(place.word, w)) found = solve(place, l, w);
    }
    if (found) {
      place = std::move(*found);
      t = next;
      h *= 2;
    } else if (std::abs(h) <= least) {
      return false;
    } else {
      h = (next - t) / 2;
    }
  }
  return true;
}

bool Follower::met(const Place& place, std::size_t sample, const std::vector<Places>& others) const {
  return apart(place.pose, poses_[sample]) < same * length_ || std::ranges::any_of(others, [&](const Places& other) {
           return other[sample] && apart(place.pose, other[sample]->pose) < same * length_;
         });
}

void Follower::run(ModeTrack& track, Place place, int sample, int direction, Places& places, const std::vector<Places>& others) {
  double t = times_[static_cast<std::size_t>(sample)];
  bool& ends = direction > 0 ? track.vanishes : track.born;
  for (int k = sample; k >= 0 && k < samples() && !ends; k += direction) {
    const auto at = static_cast<std::size_t>(k);
    const double before = t;
    ends = k != sample && (pose(k).status != PM_OK || !step(place, t, times_[at]));
    if (!ends && k != sample && met(place, at, others)) {
      ends = true;
      t = before;
    }
    if (ends) break;
    track.distance[at] = apart(place.pose, pose(k));
    places[at] = place;
  }
  (direction > 0 ? track.ends : track.begins) = t;
}

}  // namespace

ModeTracks follow_assembly_modes(const AssemblyModes& found, const std::vector<double>& times, const PoseAt& motion, int start,
                                 const std::vector<int>& later, double length, const AssemblyOptions& options) {
  ModeTracks out;
  Follower follower(found.words, times, motion, length);
  std::vector<Follower::Places> places;
  const auto add = [&](const AssemblyMode& m, int sample) {
    ModeTrack track{m.word, std::vector<double>(times.size(), nan), times.front(), times.back(), false, false};
    Follower::Places own(times.size());
    for (const int direction : {1, -1}) follower.run(track, {m.word, m.coordinates, m.pose}, sample, direction, own, places);
    places.push_back(std::move(own));
    out.tracks.push_back(std::move(track));
  };
  const auto is_own = [&](const AssemblyMode& m, int sample) {
    return follower.apart(m.pose, follower.pose(sample)) < same * length && m.word == 0;
  };
  for (const AssemblyMode& m : found.modes)
    if (!is_own(m, start)) add(m, start);
  const Machine& own = *found.words.front().machine;
  for (const int sample : later) {
    if (follower.pose(sample).status != PM_OK) continue;
    const Eigen::VectorXd actuators = follower.actuators(follower.pose(sample));
    const AssemblyModes anew = find_assembly_modes(own, actuators, own.home(), options);
    for (const AssemblyMode& m : anew.modes) {
      const auto at = static_cast<std::size_t>(sample);
      const bool known =
          std::ranges::any_of(places, [&](const auto& p) { return p[at] && follower.apart(p[at]->pose, m.pose) < same * length; });
      if (!known && !is_own(m, sample)) add(m, sample);
    }
  }
  out.nearest.assign(times.size(), nan);
  out.least = nan;
  for (std::size_t i = 0; i < out.tracks.size(); ++i)
    for (std::size_t k = 0; k < times.size(); ++k) {
      const double d = out.tracks[i].distance[k];
      if (d < out.nearest[k] || (std::isnan(out.nearest[k]) && std::isfinite(d))) out.nearest[k] = d;
      if (d < out.least || (std::isnan(out.least) && std::isfinite(d))) {
        out.least = d;
        out.least_sample = static_cast<int>(k);
        out.least_track = i;
      }
    }
  return out;
}

}  // namespace pmreport::mechanics
