#include <reports/section/common/words/motion_words.hpp>

#include <core/scenario/loaded.hpp>
#include <core/text/text.hpp>
#include <reports/section/common/words/demands.hpp>
#include <reports/section/common/words/words.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace pmreport::section {

namespace {

// "x", "the rate of x", "the acceleration of x"; `first` of a sentence.
std::string subject(const std::string& what, OfMotion of, bool first) {
  const char* words = of == OfMotion::rate ? "he rate of " : of == OfMotion::acceleration ? "he acceleration of " : nullptr;
  return words == nullptr ? what : fmt::format("{}{}{}", first ? "T" : "t", words, what);
}

std::string unit_of(const Break& b) {
  const char* per[] = {"", "/s", "/s^2"};
  return b.unit + per[static_cast<int>(b.of)];
}

// "by 100 mm/s at t = 1 s and 3 s", "7 times, by up to 100 mm/s, at t = 1 s, 2 s, 3 s and later".
std::string jumps(const std::vector<const Break*>& all) {
  constexpr std::size_t named = 4;
  double largest = 0;
  std::vector<std::string> times;
  for (const Break* b : all) {
    largest = std::max(largest, b->jump);
    if (times.size() < named) times.push_back(format_number(b->time, 6) + " s");
  }
  const std::string size = show(largest, unit_of(*all.front()));
  if (all.size() == 1) return fmt::format("by {} at t = {}", size, times.front());
  if (all.size() > named) times.back() = "later";
  return fmt::format("{} times, by up to {}, at t = {}", all.size(), size, listed(times, "and"));
}

// One for each quantity that jumps in one of these orders.
std::vector<std::string> sentences(const Analysis& a, std::initializer_list<Break::Of> orders, const char* consequence) {
  std::vector<std::string> out;
  const std::vector<Break>& breaks = a.trajectory().breaks;
  for (const Break::Of of : orders) {
    std::vector<std::string> told;
    for (const Break& b : breaks) {
      if (b.of != of || std::find(told.begin(), told.end(), b.what) != told.end()) continue;
      told.push_back(b.what);
      std::vector<const Break*> same;
      for (const Break& other : breaks)
        if (other.of == of && other.what == b.what) same.push_back(&other);
      out.push_back(fmt::format("{} jumps {}: {}.", subject(b.what, static_cast<OfMotion>(of), true), jumps(same), consequence));
    }
  }
  return out;
}

}  // namespace

int count_jumps(const Analysis& a) {
  const std::vector<Break>& breaks = a.trajectory().breaks;
  return static_cast<int>(std::count_if(breaks.begin(), breaks.end(), [](const Break& b) { return b.of != Break::Of::acceleration; }));
}

bool must_be_smooth(const Analysis& a) {
  const analysis::Asked asked = analysis::asked_by(a.scenario());
  const bool rates_count = asked.velocity_evidence || asked.acceleration_evidence || asked.forces;
  return rates_count && a.scenario().motion && !a.scenario().motion->by_forces();
}

std::vector<std::string> jump_sentences(const Analysis& a) {
  return sentences(a, {Break::Of::value, Break::Of::rate}, "no finite force follows it");
}

std::vector<std::string> acceleration_sentences(const Analysis& a) {
  return sentences(a, {Break::Of::acceleration}, "the forces jump with it");
}

std::vector<std::string> unseen_sentences(const Analysis& a, const std::vector<analysis::Unseen>& unseen) {
  std::vector<std::string> out;
  for (const analysis::Unseen& u : unseen) {
    const DisplayUnit unit = display_unit(u.unit, u.moves);
    const auto amount = [&](double si) {
      return typeset(format_number(si * unit.per_si, 3)) + (unit.label == "°" ? "" : " ") + unit.label;
    };
    const std::string enough = u.enough > static_cast<double>(scenario::max_samples) ? "and no number that a scenario may have does"
                                                                                     : format_number(u.enough, 7) + " do";
    out.push_back(
        fmt::format("Between samples {} goes up to {} beyond them (at t = {} s); it moves by {} in all, its samples by {}: {} "
                    "cannot show it, {}.",
                    subject(u.what, u.of, false), amount(u.beyond), format_number(u.time, 6), amount(u.moves), amount(u.samples_move),
                    plural(a.samples(), "sample"), enough));
  }
  return out;
}

std::vector<document::Check> motion_demands(const Analysis& a, const std::vector<analysis::Unseen>& unseen) {
  std::vector<document::Check> out;
  if (!a.scenario().motion) return out;
  const auto demand = [&](const std::string& name, int broken, const std::string& measured, const std::vector<std::string>& sentences) {
    document::Check c;
    c.name = name, c.measured = measured, c.limit = "none", c.value = broken, c.passed = broken == 0;
    if (!c.passed) c.message = first_and_number(sentences);
    out.push_back(c);
  };
  const int hidden = static_cast<int>(unseen.size()), jumping = count_jumps(a);
  demand(demands::visibility, hidden, hidden == 0 ? "nothing hidden" : fmt::format("{} hidden", hidden), unseen_sentences(a, unseen));
  if (must_be_smooth(a)) demand(demands::smoothness, jumping, jumping == 0 ? "no jump" : plural(jumping, "jump"), jump_sentences(a));
  return out;
}

}  // namespace pmreport::section
