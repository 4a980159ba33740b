#include <reports/section/common/words/singular_words.hpp>

#include <core/text/text.hpp>
#include <reports/section/common/words/words.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace pmreport::section {

using What = analysis::Crossing::What;

namespace {

// From this condition number of the unit wrenches on the platform on, a load asks for forces out of all proportion, and a report says so.
constexpr double poor_hold = 1000;
// Of home's hold of all bodies: from here on the same.
constexpr double loose = 0.05;

const char* meaning(What what) {
  switch (what) {
    case What::surface:
      return "There the actuators do not hold the platform.";
    case What::pole:
      return "There a limb holds the platform whatever its actuator does.";
    case What::bodies:
      return "There bodies move although all actuators are locked, and forces inside the mechanism grow without bound.";
    case What::freedoms:
      return "There bodies have a freedom that no actuator has a say in (a constraint singularity): they move although all actuators are "
             "locked, and forces inside the mechanism grow without bound.";
    case What::limb:
      return "There the platform has lost a freedom: with the platform locked an actuator moves (type 1).";
    case What::limb_locked:
      return "There bodies of a limb move by themselves, platform and actuators locked.";
  }
  return "";
}

const char* does(const Crossing& c) {
  if (c.lasts()) return "stays on";
  if (c.what != What::surface && c.what != What::pole) return "meets";
  return c.touches ? "touches" : "crosses";
}
const char* place(const Crossing& c) { return c.what == What::surface || c.what == What::pole ? "a singular surface" : "a singularity"; }

// One sentence for all that are alike.
std::string many(const std::vector<Crossing>& all) {
  return fmt::format("The motion {} {} {} times: {}, first at t = {} s and last at t = {} s. {}", does(all.front()), place(all.front()),
                     all.size(), signs_of(all.front()), format_number(all.front().time, 7), format_number(all.back().time, 7),
                     meaning(all.front().what));
}

// Samples that are singular and belong to no crossing.
std::vector<SampleRun> singular_runs(const Analysis& a) {
  return analysis::runs(a.samples(), [&](int k) {
    const double t = a.time()[static_cast<std::size_t>(k)];
    return a.outcome(k) == Outcome::singular &&
           std::ranges::none_of(a.crossings(), [&](const Crossing& c) { return t >= c.time && t <= c.until; });
  });
}

// The sample at which the constraints of all bodies, actuators locked, hold them least, and how much of home's hold is left.
struct Loosest {
  double share = 0;
  int sample = 0;
};
std::optional<Loosest> loosest(const Analysis& a) {
  constexpr auto locked = mechanics::BodyFreedoms::locked;
  std::optional<Loosest> out;
  for (std::size_t k = 0; k < a.margins().at_sample.size(); ++k) {
    const double share = a.margins().at_sample[k][locked] / a.margins().sound[locked];
    if (std::isfinite(share) && (!out || share < out->share)) out = {share, static_cast<int>(k)};
  }
  return out;
}

// Sample of the poorest hold among those that hold at all; -1: none.
int poorest(const Analysis& a) {
  int out = -1;
  for (int k = 0; k < a.samples(); ++k)
    if (a.outcome(k) == Outcome::good && (out < 0 || a.wrenches(k).condition > a.wrenches(out).condition)) out = k;
  return out;
}

}  // namespace

std::string signs_of(const Crossing& c) {
  switch (c.what) {
    case What::surface:
      return c.touches ? "det G is zero and keeps its sign" : "det G changes its sign";
    case What::pole:
      return "det G changes its sign through infinity";
    case What::limb:
      return "the constraints of a limb lose rank";
    default:
      return "the constraints of the bodies lose rank though det G is regular";
  }
}

std::string sentence(const Analysis& a, const Crossing& c) {
  const auto time = [](double t) { return format_number(t, 7) + " s"; };
  const bool at_sample = a.time()[static_cast<std::size_t>(c.before)] == c.time;
  const std::string when =
      c.lasts()   ? fmt::format("From t = {} to t = {}", time(c.time), time(c.until))
      : at_sample ? fmt::format("At the sample t = {}", time(c.time))
                  : fmt::format("Between t = {} and t = {}", show_time(a, c.before), show_time(a, std::min(c.before + 1, a.samples() - 1)));
  return fmt::format("{} the motion {} {}: {}{}. {}{}", when, does(c), place(c), signs_of(c),
                     at_sample || c.lasts() ? "" : " at t = " + time(c.time),
                     c.unseen ? "The samples do not show it, the proof does. " : "", meaning(c.what));
}

std::vector<std::string> singularity_sentences(const Analysis& a) {
  if (a.singular_everywhere())
    return {
        "The architecture is singular at every pose: the wrenches of the limbs on the platform depend on one another at home and wherever "
        "else it was looked at, so that the actuators hold the platform nowhere, and forces and assembly modes have no meaning."};
  std::vector<std::vector<Crossing>> alike;
  for (const Crossing& c : a.crossings()) {
    const auto same = [&](const std::vector<Crossing>& all) { return all.front().what == c.what && all.front().touches == c.touches; };
    const auto found = std::ranges::find_if(alike, same);
    (found != alike.end() ? *found : alike.emplace_back()).push_back(c);
  }
  std::vector<std::string> out;
  for (const std::vector<Crossing>& all : alike)
    if (all.size() > told_one_by_one)
      out.push_back(many(all));
    else
      for (const Crossing& c : all) out.push_back(sentence(a, c));
  const std::vector<SampleRun> runs = singular_runs(a);
  if (runs.size() > told_one_by_one) {
    int samples = 0;
    for (const SampleRun& run : runs) samples += run.last - run.first + 1;
    out.push_back(
        fmt::format("The pose is singular at {} of {} samples, in {} intervals between {}; forces have no value there; at the first: {}.",
                    samples, a.samples(), runs.size(), span_of(a, runs.front().first, runs.back().last), a.why(runs.front().first)));
    return out;
  }
  for (const SampleRun& run : runs)
    out.push_back(
        fmt::format("{}: the pose is singular: {}; forces have no value there.", span_of(a, run.first, run.last), a.why(run.first)));
  return out;
}

int singularities_met(const Analysis& a) {
  if (a.singular_everywhere()) return std::max(1, a.samples());
  return static_cast<int>(a.crossings().size() + singular_runs(a).size());
}

std::vector<std::string> nearness_sentences(const Analysis& a) {
  std::vector<std::string> out;
  if (a.singular_everywhere()) return out;
  const Topology& t = a.machine().topology();
  if (a.margins().home_is_singular)
    out.push_back(
        "Home itself stands on a singular surface: what counts from home, sides and assembly modes among it, has no sound beginning. Give "
        "a "
        "home that is regular.");
  if (const auto& near = a.margins().end_of_reach) {
    std::vector<std::string> names;
    for (const int i : near->end.actuators) names.push_back(symbol(t.actuators[static_cast<std::size_t>(i)].name));
    out.push_back(fmt::format(
        "At t = {} the end of the reach (a singularity of type 1) is {} away: the {} of {} {} nearly stretched or folded, and the rates of "
        "{} grow without bound towards it.",
        show_time(a, near->sample), show(near->end.distance, "m", 3), names.size() == 1 ? "limb" : "limbs", listed(names),
        names.size() == 1 ? "is" : "are", names.size() == 1 ? "that actuator" : "those actuators"));
  }
  if (const int k = poorest(a); k >= 0 && a.wrenches(k).condition > poor_hold)
    out.push_back(fmt::format(
        "At t = {} the motion is nearly singular: the wrenches of the limbs on the platform have the condition number {}, and a load there "
        "may ask for forces {} times its size.",
        show_time(a, k), format_number(a.wrenches(k).condition, 3), format_number(a.wrenches(k).amplification, 3)));
  if (const auto l = loosest(a); l && l->share < loose && a.crossings().empty())
    out.push_back(
        fmt::format("At t = {} the bodies are nearly loose with all actuators locked: the constraints of all bodies hold them {} times "
                    "less than at home, "
                    "and forces inside the mechanism may be that many times larger, whatever G says of the platform.",
                    show_time(a, l->sample), format_number(1 / l->share, 3)));
  if (const auto& chart = a.margins().chart)
    out.push_back(
        fmt::format("At t = {}{}: {}. Forces and motions of the bodies come from the platform's twist and are right; the rates of these "
                    "coordinates, and "
                    "what is told in them, are not to be relied on. Turn the platform's own axes, so that it moves at other angles.",
                    show_time(a, chart->sample), chart->samples > 1 ? fmt::format(" (worst of {} samples)", chart->samples) : "",
                    in_words(a.machine(), chart->fault)));
  return out;
}

}  // namespace pmreport::section
