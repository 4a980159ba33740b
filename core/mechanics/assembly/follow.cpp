#include <core/mechanics/assembly/follow.hpp>

#include <core/mechanics/assembly/follower.hpp>
#include <core/numbers.hpp>

#include <algorithm>
#include <cmath>
#include <ranges>

namespace pmreport::mechanics {

namespace {

constexpr double same_actuators = 1e-9;  // of the characteristic length, or rad: values of one pose

class Tracks {
 public:
  Tracks(const AssemblyModes& found, const std::vector<double>& times, const PoseAt& motion, double length, ModeTracks& out)
      : words_(found.words), length_(length), follower_(found.words, times, motion, length), times_(times), out_(out) {}

  void enter(const AssemblyModes& modes, int sample);
  void name(const AssemblyModes& found, int start);
  void search(const LookedAt& looked);
  void exchange();
  void resolve();
  void explain_the_lost();
  void count();

 private:
  bool enter(const ModePlace& place, int sample);
  bool known(const Pose& pose, int sample) const;
  std::size_t track_at(const Pose& pose, int sample, std::size_t but) const;
  void go_on(ModeTrack& track, bool birth);
  ModeEnd& end_of(std::size_t track, bool birth) { return birth ? out_.tracks[track].begins : out_.tracks[track].ends; }
  bool same_values(int a, int b) const;
  std::size_t at(int k) const { return static_cast<std::size_t>(k); }

  const std::vector<WorkingMode>& words_;
  double length_;
  ModeFollower follower_;
  const std::vector<double>& times_;
  ModeTracks& out_;
  std::vector<ModeFollower::Places> places_;
  struct End {
    std::size_t track;
    bool birth;
    ModeFollower::Stop stop;
  };
  std::vector<End> folds_, lost_;  // whose partners are not known yet, and that have no partner beyond a fold
};

bool Tracks::known(const Pose& pose, int sample) const {
  return follower_.is_own(pose, sample) || track_at(pose, sample, no_track) != no_track;
}

// The track, other than one, that is at a pose; no_track: none.
std::size_t Tracks::track_at(const Pose& pose, int sample, std::size_t but) const {
  for (std::size_t j = 0; j < places_.size(); ++j)
    if (j != but && places_[j][at(sample)] && follower_.one(places_[j][at(sample)]->pose, pose)) return j;
  return no_track;
}

// A track came upon an older one that could not be followed to here: the two are one mode. Where several come upon it, as after a fork,
// one of them goes on with it, and the others meet it there.
void Tracks::go_on(ModeTrack& track, bool birth) {
  ModeEnd& end = birth ? track.begins : track.ends;
  ModeEnd& older = end_of(end.with, !birth);
  if (older.how == ModeEnd::How::beyond)
    end = {ModeEnd::How::meets, older.time, end.with};
  else
    older.how = ModeEnd::How::beyond;
}

bool Tracks::enter(const ModePlace& place, int sample) {
  if (known(place.pose, sample)) return false;
  ModeTrack track{place.word, std::vector<double>(times_.size(), nan), {}, {}};
  ModeFollower::Places own(times_.size());
  const std::size_t number = out_.tracks.size();
  for (const bool birth : {false, true}) {
    ModeFollower::Stop stop = follower_.run(place, sample, birth ? -1 : 1, own, places_);
    (birth ? track.begins : track.ends) = stop.end;
    if (stop.end.how == ModeEnd::How::beyond && stop.end.with < number) go_on(track, birth);
    if (stop.partner)
      folds_.push_back({number, birth, std::move(stop)});
    else if (stop.end.how == ModeEnd::How::lost)
      lost_.push_back({number, birth, std::move(stop)});
  }
  for (std::size_t k = 0; k < own.size(); ++k)
    if (own[k]) track.distance[k] = follower_.apart(own[k]->pose, follower_.pose(static_cast<int>(k)));
  out_.tracks.push_back(std::move(track));
  places_.push_back(std::move(own));
  return true;
}

void Tracks::enter(const AssemblyModes& modes, int sample) {
  for (const AssemblyMode& m : modes.modes) enter(ModePlace{m.word, m.coordinates, m.pose}, sample);
}

void Tracks::name(const AssemblyModes& found, int start) {
  for (const AssemblyMode& m : found.modes)
    out_.of_found.push_back(follower_.is_own(m.pose, start) ? own_mode : track_at(m.pose, start, no_track));
}

// Whom the tracks met where they ended: the mechanism's own mode, a track, or a mode that nobody has seen yet.
void Tracks::resolve() {
  for (std::size_t i = 0; i < folds_.size(); ++i) {
    const End fold = folds_[i];
    ModeEnd& end = end_of(fold.track, fold.birth);
    const ModePlace& partner = *fold.stop.partner;
    const int sample = fold.stop.sample;
    if (follower_.is_own(partner.pose, sample)) {
      end.with = own_mode;
      continue;
    }
    end.with = track_at(partner.pose, sample, fold.track);
    if (end.with != no_track) continue;
    const std::size_t next = out_.tracks.size();
    if (!enter(partner, sample)) continue;
    ++out_.further;
    end_of(fold.track, fold.birth).with = next;
  }
  folds_.clear();
}

// Where three modes or more meet at once, as symmetry makes them do, there is none beyond a fold: they are told by being in one place.
void Tracks::explain_the_lost() {
  for (const End& e : lost_) {
    ModeEnd& end = end_of(e.track, e.birth);
    if (end.how != ModeEnd::How::lost) continue;
    std::size_t with = no_track;
    for (std::size_t j = 0; j < places_.size() && with == no_track; ++j)
      if (j != e.track && places_[j][at(e.stop.sample)] && follower_.near_at(e.stop, places_[j][at(e.stop.sample)])) with = j;
    if (with == no_track && follower_.near_at(e.stop, {})) with = own_mode;
    if (with != no_track) end = {ModeEnd::How::meets, end.time, with};
  }
}

bool Tracks::same_values(int a, int b) const {
  const Machine& own = *words_.front().machine;
  SmallVector change = follower_.actuators(follower_.pose(a)) - follower_.actuators(follower_.pose(b));
  for (Eigen::Index i = 0; i < change.size(); ++i)
    if (own.topology().actuators[static_cast<std::size_t>(i)].sense() == Sense::linear) change(i) /= length_;
  return change.lpNorm<Eigen::Infinity>() < same_actuators;
}

void Tracks::search(const LookedAt& looked) {
  const Pose& pose = follower_.pose(looked.sample);
  if (pose.status != PM_OK) return;
  const bool done = std::ranges::any_of(out_.searched, [&](int k) { return same_values(k, looked.sample); });
  out_.searched.push_back(looked.sample);
  if (done) return;
  const Machine& own = *words_.front().machine;
  const AssemblyModes found = find_assembly_modes(own, follower_.actuators(pose), own.home(), looked.options);
  if (!found.continua.empty()) out_.continua.push_back(looked.sample);
  enter(found, looked.sample);
  resolve();
}

// What is known where one search looked is a start for Newton's method where the others did, until that brings nothing new.
void Tracks::exchange() {
  for (bool fresh = true; fresh;) {
    fresh = false;
    for (const int from : out_.searched)
      for (const int to : out_.searched) {
        if (from == to) continue;
        for (std::size_t j = 0; j < places_.size(); ++j) {
          if (!places_[j][at(from)]) continue;
          const std::optional<ModePlace> found = follower_.from_afar(*places_[j][at(from)], to);
          if (!found || !enter(*found, to)) continue;
          ++out_.further;
          fresh = true;
          resolve();
        }
      }
  }
}

void Tracks::count() {
  out_.nearest.assign(times_.size(), nan);
  out_.count.assign(times_.size(), 0);
  out_.least = nan;
  for (std::size_t k = 0; k < times_.size(); ++k) out_.count[k] = follower_.pose(static_cast<int>(k)).status == PM_OK;
  for (std::size_t i = 0; i < out_.tracks.size(); ++i)
    for (std::size_t k = 0; k < times_.size(); ++k) {
      const double d = out_.tracks[i].distance[k];
      if (std::isnan(d)) continue;
      ++out_.count[k];
      if (!(d >= out_.nearest[k])) out_.nearest[k] = d;
      if (d >= out_.least) continue;
      out_.least = d;
      out_.least_sample = static_cast<int>(k);
      out_.least_track = i;
    }
  // A meeting of two tracks is one event.
  for (std::size_t i = 0; i < out_.tracks.size(); ++i)
    for (const bool birth : {false, true}) {
      const ModeEnd& e = birth ? out_.tracks[i].begins : out_.tracks[i].ends;
      if (e.how == ModeEnd::How::beyond) continue;
      const bool told = std::ranges::any_of(out_.events, [&](const ModeEvent& o) {
        return o.how == ModeEnd::How::meets && o.birth == birth && o.with == i && o.track == e.with;
      });
      if (!told) out_.events.push_back({e.time, birth, e.how, i, e.with});
    }
  std::ranges::stable_sort(out_.events, {}, &ModeEvent::time);
}

}  // namespace

ModeTracks follow_assembly_modes(const AssemblyModes& found, const std::vector<double>& times, const PoseAt& motion, int start,
                                 const std::vector<LookedAt>& looked, double length) {
  ModeTracks out;
  Tracks tracks(found, times, motion, length, out);
  tracks.enter(found, start);
  tracks.name(found, start);
  tracks.resolve();
  out.searched.push_back(start);
  if (!found.continua.empty()) out.continua.push_back(start);
  for (const LookedAt& l : looked) tracks.search(l);
  tracks.exchange();
  tracks.explain_the_lost();
  tracks.count();
  return out;
}

}  // namespace pmreport::mechanics
