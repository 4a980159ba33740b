#include <reports/section/common/words/limits.hpp>

#include <reports/section/common/words/words.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace pmreport::section {

namespace {

// What a breach is of: "l3 (length of limb 3)" and "joint B1" name their quantity alone, "force of l3 (...)" and "moment in joint B1" the
// effort too.
struct Subject {
  std::string effort, name;
  bool joint;
};

Subject subject_of(const LimitBreach& b) {
  Subject out{"", b.subject.substr(0, b.subject.find(" (")), false};
  for (const auto& [between, joint] : {std::pair<std::string, bool>{" of ", false}, {" in joint ", true}})
    if (const auto at = out.name.find(between); at != std::string::npos)
      return {out.name.substr(0, at), out.name.substr(at + between.size()), joint};
  if (out.name.starts_with("joint ")) return {"", out.name.substr(6), true};
  return out;
}

struct LimitGroup {  // of breaches that are told in one sentence, the worst first
  std::vector<LimitBreach> all;
  std::vector<std::string> names;  // each once
  std::set<int> samples;
};

// Breaches of one effort, of actuators or of joints of one letter, which are the same joint of all limbs.
bool alike(const LimitBreach& x, const LimitBreach& y) {
  const Subject s = subject_of(x), t = subject_of(y);
  const auto letters = [](const std::string& name) { return name.substr(0, name.find_first_of("0123456789")); };
  return s.effort == t.effort && s.joint == t.joint && x.unit == y.unit && (!s.joint || letters(s.name) == letters(t.name));
}

// `badness`: how far beyond its limit a breach goes, comparable among all. The worst group comes first.
template <class Badness>
std::vector<LimitGroup> grouped(const std::vector<LimitBreach>& breaches, Badness&& badness) {
  std::vector<LimitGroup> out;
  for (const LimitBreach& b : breaches) {
    auto group = std::find_if(out.begin(), out.end(), [&](const LimitGroup& g) { return alike(g.all.front(), b); });
    if (group == out.end()) group = out.insert(out.end(), LimitGroup{});
    group->all.push_back(b);
    if (const std::string name = subject_of(b).name; std::find(group->names.begin(), group->names.end(), name) == group->names.end())
      group->names.push_back(name);
    group->samples.insert(b.samples.begin(), b.samples.end());
  }
  const auto worse = [&](const LimitBreach& x, const LimitBreach& y) { return badness(x) > badness(y); };
  for (LimitGroup& g : out) std::stable_sort(g.all.begin(), g.all.end(), worse);
  std::stable_sort(out.begin(), out.end(), [&](const LimitGroup& x, const LimitGroup& y) { return worse(x.all.front(), y.all.front()); });
  return out;
}

std::string where(const Analysis& a, const LimitGroup& g) {
  return fmt::format("at {} of {} samples, {}; worst is {} at t = {}", g.samples.size(), a.samples(),
                     span_of(a, *g.samples.begin(), *g.samples.rbegin()), subject_of(g.all.front()).name,
                     show_time(a, g.all.front().worst));
}

std::string limit_words(const LimitBreach& b, const std::string& limit) {
  return b.stroke ? fmt::format("its stroke {} at {}", b.above ? "ends" : "begins", limit) : "its limit is " + limit;
}

std::string how_often(const Analysis& a, const LimitBreach& b) {
  if (b.samples.size() < 2) return ".";
  return fmt::format(" (worst at t = {}, {}).", show_time(a, b.worst), plural(static_cast<int>(b.samples.size()), "sample"));
}

// One sentence a group; where it is of one name alone, one a breach.
template <class Many, class One>
std::vector<std::string> sentences(const std::vector<LimitGroup>& groups, Many&& many, One&& one) {
  std::vector<std::string> out;
  for (const LimitGroup& g : groups)
    if (g.names.size() > 1)
      out.push_back(many(g));
    else
      for (const LimitBreach& b : g.all) out.push_back(one(b));
  return out;
}

std::vector<std::string> of_limits(const Analysis& a, const std::vector<LimitBreach>& breaches) {
  const auto many = [&](const LimitGroup& g) {
    const LimitBreach& worst = g.all.front();
    const Subject s = subject_of(worst);
    const Apart told = show_apart(worst.value, worst.limit, worst.unit);
    return fmt::format("The {}s {} {} exceed their limits {}: it is {}, the limit is {}.", s.effort, s.joint ? "in the joints" : "of",
                       names_of(g.names), where(a, g), told.value, told.beside);
  };
  return sentences(grouped(breaches, [](const LimitBreach& b) { return b.value / b.limit; }), many,
                   [&](const LimitBreach& b) { return limit_sentence(a, b); });
}

}  // namespace

std::string sentence(const Analysis& a, const LimitBreach& b) {
  const Apart told = show_apart(b.value, b.limit, b.unit);
  return fmt::format("{}: {} needs {}, {}{}", span_of(a, b.samples.front(), b.samples.back()), b.subject, told.value,
                     limit_words(b, told.beside), how_often(a, b));
}

// Lengths beyond a stroke are compared with the machine's length, angles as they are.
std::vector<std::string> breach_sentences(const Analysis& a) {
  const auto badness = [&](const LimitBreach& b) { return std::abs(b.value - b.limit) / (b.unit == "m" ? a.length() : 1); };
  const auto many = [&](const LimitGroup& g) {
    const LimitBreach& worst = g.all.front();
    const Apart told = show_apart(worst.value, worst.limit, worst.unit);
    return fmt::format("{}{} leave their {} {}: it needs {}, {}.", worst.stroke ? "" : "Joints ", names_of(g.names),
                       worst.stroke ? "strokes" : "limits", where(a, g), told.value, limit_words(worst, told.beside));
  };
  return sentences(grouped(a.breaches(), badness), many, [&](const LimitBreach& b) { return sentence(a, b); });
}

document::Table breach_table(const Analysis& a) {
  document::Table table{"Strokes and joint limits that the motion leaves.",
                        {"quantity", "needs", "limit", "at", "samples", "from", "to"},
                        {false, true, true, true, true, true, true},
                        {}};
  for (const LimitBreach& b : a.breaches()) {
    const Apart told = show_apart(b.value, b.limit, b.unit);
    table.rows.push_back({b.subject, told.value, told.beside, show_time(a, b.worst), std::to_string(b.samples.size()),
                          show_time(a, b.samples.front()), show_time(a, b.samples.back())});
  }
  return table;
}

std::string limit_sentence(const Analysis& a, const LimitBreach& b) {
  const Apart told = show_apart(b.value, b.limit, b.unit);
  return fmt::format("{}: {} is {}, the limit is {}{}", span_of(a, b.samples.front(), b.samples.back()), b.subject, told.value, told.beside,
                     how_often(a, b));
}

std::vector<std::string> limit_sentences(const Analysis& a) { return of_limits(a, limit_breaches(a)); }

std::vector<std::string> joint_limit_sentences(const Analysis& a) {
  std::vector<LimitBreach> of_joints = limit_breaches(a);
  std::erase_if(of_joints, [](const LimitBreach& b) { return !subject_of(b).joint; });
  return of_limits(a, of_joints);
}

}  // namespace pmreport::section
