#include <core/scan/proved_volume.hpp>

#include <core/scan/meaning.hpp>
#include <core/scan/proof/choice.hpp>
#include <core/scan/proof/refine.hpp>
#include <core/scan/proof/shared_waves.hpp>

#include <fmt/core.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <memory>

namespace pmreport::scan {

namespace {

using program::Bounds;

constexpr std::size_t questions_a_chunk = 1024, chunks_a_wave = 64;  // what a thread does at a stretch; between two looks at the clock
constexpr std::size_t chunks_a_shared_wave = 1024;                   // where a look at the clock is one of all who share it
constexpr std::size_t most_bytes = 128 << 20;                        // of boxes that are kept to be looked at again
constexpr std::size_t boxes_for_a_program = 256;                     // from so many on it pays to make one for them alone
constexpr double for_good = 0.25;                                    // of the gap that is allowed: of boxes put away for mattering little

// Breadth first. Known at any time are the volume of boxes that the set fills; of every box that is open and kept, how much of it belongs
// to the set; and the sum of that of boxes that are open and were put away, because they matter little, cannot be halved, or lack room. So
// it may end whenever it likes.
class Prover {
 public:
  Prover(const PoseSet& set, const Scan& scan, const VolumeOptions& options, const Watch& watch, const chunks::Work& work,
         const chunks::Sharing& sharing)
      : options_(options),
        watch_(watch),
        margins_(set, scan),
        axes_(margins_.axes().size()),
        waves_(work, sharing, margins_, watch),
        sets_(margins_.margins()),
        programs_(margins_, sets_),
        open_(axes_),
        ends_(axes_),
        examiners_([this] { return std::make_unique<Examiner>(margins_, sets_, programs_); }) {
    programs_.inherit(sets_.add_all(margins_.margins()), 0);
    std::vector<Bounds> sides;
    for (const FreeAxis& axis : margins_.axes()) sides.push_back(axis.range);
    std::vector<OpenOrientation> open;
    for (std::uint32_t o = 0; o < margins_.orientations(); ++o) open.push_back({o, 0});
    open_.add(sides, {0, 0}, {}, open);
    gone_.push_back(false);
  }

  ProvedVolume prove(const Scan& scan) {
    halve({0});  // along no axis yet: the whole range is examined
    while (go_on()) {
      halve(choose());
    }
    conclude(scan);
    return std::move(out_);
  }

 private:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }
  // The clocks of those who share the proof differ, and all must go the same way.
  bool out_of_time() {
    return timed() && waves_.agreed([this] { return seconds() > options_.seconds; });
  }
  bool timed() const { return options_.seconds < std::numeric_limits<double>::infinity(); }
  bool out_of_boxes() const { return out_.boxes >= options_.boxes; }
  static double width(Bounds volume) { return volume.high - volume.low; }

  bool go_on() {
    if (put_away([this](std::size_t k) { return open_.state(k).split == 0 || !(open_.gap(k) > 0); })) keep(OpenBoxes(axes_));
    out_.volume = sum(sum(filled_, put_away_), sum(open_.volumes()));
    const double middle = out_.volume.middle(), allowed = options_.gap * middle;
    out_.enough = width(out_.volume) <= allowed;
    if (out_.enough) return false;
    const std::string gap = middle > 0 ? fmt::format("the gap is {:.3g}", width(out_.volume) / middle) : "";
    if (open_.size() == 0)
      out_.why = fmt::format("{} boxes that are neither inside nor outside {}: {}", put_away_count_,
                             for_want_of_room_ ? "were not looked at again, for want of room" : "are as narrow as numbers are", gap);
    else if (out_of_time())
      out_.why = fmt::format("after {:g} s: {}", options_.seconds, gap);
    else if (out_of_boxes())
      out_.why = fmt::format("after {} boxes: {}", out_.boxes, gap);
    if (!out_.why.empty()) return false;

    // On smooth faces half the width leaves a quarter of the gap and 2^(d - 1) times the boxes.
    const double faces = 0.5 * static_cast<double>(std::max<std::size_t>(axes_, 2) - 1);
    told_ = std::max(told_, std::pow(allowed / width(out_.volume), faces));
    watch_.done(std::min(told_, 1.0));
    return true;
  }

  // The boxes to halve, those of one program together. The others are kept, or put away.
  std::vector<std::uint32_t> choose() {
    const Gaps gaps(open_, axes_);
    const std::size_t a_box = open_.bytes() / open_.size() + 1;
    const double allowed = options_.gap * out_.volume.middle();
    // What was put away for want of room may leave nothing of it: then the widest boxes are still worth some.
    const double threshold = gaps.threshold(std::max(allowed - width(put_away_), 0.1 * allowed), most_bytes / 4 / a_box);
    const bool full = open_.bytes() > most_bytes;
    const double least = full ? std::min(threshold, gaps.of_the_least(open_.size() / 2)) : threshold / 8;
    double may_go = full ? std::numeric_limits<double>::infinity() : for_good * options_.gap * out_.volume.low - width(put_away_);
    for_want_of_room_ = for_want_of_room_ || full;
    put_away([&](std::size_t k) {
      const double gap = open_.gap(k);
      if (gap > least || gap > may_go) return false;
      may_go -= gap;
      return true;
    });

    std::vector<std::uint32_t> which;
    for (std::uint32_t k = 0; k < open_.size(); ++k)
      if (open_.gap(k) > threshold) which.push_back(k);
    make_programs(which);
    std::ranges::stable_sort(which, {}, [this](std::uint32_t k) { return programs_.number(open_.open(k).front().set); });
    return which;
  }

  void make_programs(std::span<const std::uint32_t> which) {
    std::vector<std::size_t> boxes(sets_.size());
    for (const std::uint32_t k : which)
      for (const OpenOrientation& o : open_.open(k)) ++boxes[o.set];
    for (std::uint32_t set = 0; set < boxes.size(); ++set)
      if (boxes[set] >= boxes_for_a_program) programs_.give_own(set);
  }

  // Counts those for which `is_to_go` as done with; whether there are any. They stay in the list until `keep`.
  template <class F>
  bool put_away(F&& is_to_go) {
    std::vector<Bounds> going;
    for (std::size_t k = 0; k < open_.size(); ++k) {
      if (gone_[k] || !is_to_go(k)) continue;
      gone_[k] = true;
      going.push_back(open_.volume(k));
      note(k);
    }
    put_away_ = sum(put_away_, sum(going));
    put_away_count_ += going.size();
    return !going.empty();
  }
  // Those that are not done with, behind others.
  void keep(OpenBoxes first) {
    for (std::size_t k = 0; k < open_.size(); ++k)
      if (!gone_[k]) first.add(open_, k);
    open_ = std::move(first);
    gone_.assign(open_.size(), false);
  }
  // What an open box that is not looked at any more says of the ends.
  void note(std::size_t k) {
    for (std::size_t q = 0; q < axes_; ++q) {
      ends_[q].may_hold(open_.sides(k)[q]);
      if (open_.volume(k).low > 0) ends_[q].has_one_in(open_.sides(k)[q]);
    }
    if (open_.state(k).blind) out_.undecided += open_.volume(k).high;
  }

  // In chunks that depend neither on the number of threads nor on who shares them, whose answers are taken in their order.
  void halve(const std::vector<std::uint32_t>& which) {
    const std::vector<std::size_t> ends = cut(which);
    // Those who share a wave wait for each other in the end. So it is as long as it may be.
    const std::size_t most = !waves_.shared() ? chunks_a_wave : timed() ? chunks_a_shared_wave : ends.size();
    OpenBoxes parts(axes_);
    const auto take_it = [&](Refined& refined) { take(refined, parts); };
    std::size_t chunk = 0;
    while (chunk + 1 < ends.size() && (chunk == 0 || !out_of_time())) {
      watch_.stop_if_asked();
      const Wave wave{which, std::span(ends).subspan(chunk, std::min(most + 1, ends.size() - chunk))};
      if (waves_.shares(wave))
        waves_.run(
            wave, open_, sets_, [this](std::span<const std::uint32_t> boxes) { return refined(boxes); }, take_it);
      else
        run_here(wave, take_it);
      chunk += wave.chunks();
    }
    for (std::size_t i = 0; i < ends[chunk]; ++i) gone_[which[i]] = true;
    keep(std::move(parts));
  }
  // The ends of the chunks, behind a zero, down to the end of a wave with which there have been as many boxes as are allowed.
  std::vector<std::size_t> cut(const std::vector<std::uint32_t>& which) const {
    std::vector<std::size_t> ends{0};
    std::size_t questions = 0, boxes = out_.boxes;
    for (std::size_t i = 0; i < which.size(); ++i) {
      questions += open_.open(which[i]).size() << std::popcount(open_.state(which[i]).split);
      boxes += std::size_t{1} << std::popcount(open_.state(which[i]).split);
      if (questions < questions_a_chunk && i + 1 < which.size()) continue;
      ends.push_back(i + 1);
      questions = 0;
      if ((ends.size() - 1) % chunks_a_wave == 0 && boxes >= options_.boxes) break;
    }
    return ends;
  }
  template <class F>
  void run_here(const Wave& wave, F&& take_it) {
    std::vector<std::unique_ptr<Refined>> answers(wave.chunks());
    tbb::parallel_for(std::size_t{0}, answers.size(), [&](std::size_t i) { answers[i] = refined(wave.chunk(i)); });
    for (const auto& refined : answers) take_it(*refined);
  }
  std::unique_ptr<Refined> refined(std::span<const std::uint32_t> boxes) {
    auto out = std::make_unique<Refined>(axes_, margins_.margins());
    refine(open_, boxes, options_.need, margins_, *examiners_.local(), *out);
    return out;
  }

  void take(Refined& refined, OpenBoxes& parts) {
    std::vector<std::uint32_t> numbers(refined.came_from.size());
    for (std::uint32_t s = 0; s < numbers.size(); ++s) {
      if (refined.came_from[s] == Refined::nowhere) continue;
      const std::size_t known = sets_.size();
      numbers[s] = sets_.add(refined.examination.sets.bits(s));
      if (numbers[s] == known) programs_.inherit(numbers[s], refined.came_from[s]);
    }
    refined.open.renumber(numbers);
    parts.append(refined.open);
    filled_ = sum(filled_, refined.filled);
    for (std::size_t q = 0; q < axes_; ++q) ends_[q].add(refined.ends[q]);
    out_.boxes += refined.boxes;
    filled_count_ += refined.filled_count;
  }

  void conclude(const Scan& scan) {
    out_.empty = filled_count_ == 0 && put_away_count_ == 0 && open_.size() == 0;
    put_away([](std::size_t) { return true; });
    out_.low.resize(scan.points.size()), out_.high.resize(scan.points.size());
    if (!(out_.volume.low > 0)) return;  // it may be empty
    for (std::size_t a = 0; a < scan.points.size(); ++a) out_.low[a] = out_.high[a] = Bounds::exactly(scan.points[a].from);
    for (std::size_t q = 0; q < axes_; ++q) {
      const Ends& e = ends_[q];
      out_.low[margins_.axes()[q].point_axis] = {e.least, e.low_at_most};
      out_.high[margins_.axes()[q].point_axis] = {e.high_at_least, e.greatest};
    }
  }

  const VolumeOptions& options_;
  const Watch& watch_;
  BoxedMargins margins_;
  std::size_t axes_;
  SharedWaves waves_;
  MarginSets sets_;
  MarginPrograms programs_;
  OpenBoxes open_;
  std::vector<bool> gone_;  // of each of them: it is done with
  std::vector<Ends> ends_;  // of boxes that are filled or put away
  Bounds filled_{0, 0}, put_away_{0, 0};
  std::uint64_t filled_count_ = 0, put_away_count_ = 0;  // boxes
  bool for_want_of_room_ = false;
  double told_ = 0;
  ProvedVolume out_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  tbb::enumerable_thread_specific<std::unique_ptr<Examiner>> examiners_;
};

}  // namespace

ProvedVolume prove_volume(const PoseSet& set, const Scan& scan, const VolumeOptions& options, const Watch& watch, const chunks::Work& work,
                          const chunks::Sharing& sharing) {
  chunks::leave_unless_waiting(sharing);
  chunks::Meaning meaning;
  meaning << work.meaning << meaning_of(set, scan) << options.gap << options.seconds << options.boxes << options.need;
  if (set.late.over_boxes) meaning << meaning_of(set.late.over_boxes->program);
  return Prover(set, scan, options, watch, {work.name, meaning.value()}, sharing).prove(scan);
}

}  // namespace pmreport::scan
