// The phase plane of a motion, and what it asks for at its largest speed.
#include <core/numbers.hpp>
#include <reports/section/speed/speed.hpp>

#include <reports/figure/palette.hpp>
#include <reports/section/common/force_plots.hpp>
#include <reports/section/common/words/words.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace pmreport::section {

using Kind = mechanics::SpeedLimit::Kind;

namespace {

constexpr double shown = 3;  // times the largest feasible speed: what lies higher in the phase plane binds nobody

const char* word_of(Kind kind, bool rotary) {
  switch (kind) {
    case Kind::actuator_force:
      return rotary ? "actuator torque" : "actuator force";
    case Kind::actuator_speed:
      return "actuator speed";
    case Kind::actuator_power:
      return "actuator power";
    case Kind::joint_force:
      return "joint force";
    case Kind::joint_moment:
      break;
  }
  return "joint moment";
}

}  // namespace

// The envelope in pieces, each in the colour of the kind of limit that binds there. Where the kind changes, the two pieces share a sample.
figure::Figure phase_plane(const Analysis& a, const SpeedStudy& study) {
  const mechanics::FeasibleSpeed& feasible = study.feasible();
  figure::Figure f{
      "phase-plane",
      "Phase plane: how many times as fast the motion may run at each of its poses before a limit binds, and which kind of limit "
      "it is. Run at one speed throughout, the motion must stay "
      "below the lowest point. Thin line: the motion as written, s = 1.",
      "data/speed.csv",
      figure::Width::full,
      1,
      {}};
  const auto n = static_cast<std::size_t>(a.samples());
  const double top = shown * std::max(study.scale(), 1.0);
  const auto binding = [&](std::size_t k) {
    const mechanics::SpeedLimit* least = nullptr;
    for (const mechanics::SpeedLimit& l : feasible.limits)
      if (least == nullptr || l.largest[k] < least->largest[k]) least = &l;
    return least->kind;
  };
  // A curve that leaves the figure goes to its edge.
  const auto low = [&](std::size_t k) { return k < n && feasible.largest[k] <= top; };
  const auto seen = [&](std::size_t k) { return !std::isnan(feasible.largest[k]) && (low(k) || low(k + 1) || (k > 0 && low(k - 1))); };
  figure::Panel p;
  p.x = {"time of the motion as written", "s"};
  p.y = {"path speed s", ""};
  for (const Kind kind : {Kind::actuator_force, Kind::actuator_speed, Kind::actuator_power, Kind::joint_force, Kind::joint_moment}) {
    figure::Series s{word_of(kind, a.machine().topology().actuators.front().sense() == Sense::rotary), a.time(),
                     std::vector<double>(n, nan), figure::style_of(static_cast<int>(kind) + (kind >= Kind::joint_force ? 1 : 0), 0)};
    bool any = false;
    for (std::size_t k = 0; k < n; ++k) {
      if (!seen(k) || (binding(k) != kind && (k == 0 || binding(k - 1) != kind))) continue;
      s.y[k] = std::min(feasible.largest[k], top);
      any |= binding(k) == kind;
    }
    if (any) p.series.push_back(std::move(s));
  }
  constexpr int black = 3, dotted = 3;
  const std::string value = speed_words(study.scale());
  p.series.push_back({"largest constant s = " + value, a.time(), std::vector<double>(n, study.scale()), figure::style_of(black, 1)});
  double highest = study.scale();
  for (const figure::Series& s : p.series)
    for (const double y : s.y)
      if (y > highest) highest = y;
  const double at = a.time()[static_cast<std::size_t>(feasible.sample)];
  p.series.push_back(
      {"binds at t = " + show_time(a, feasible.sample), {at, at}, {study.scale(), highest}, figure::style_of(black, dotted)});
  p.lines.push_back({1, ""});
  f.panels.push_back(std::move(p));
  for (const double y : feasible.largest)
    if (y > top) {
      f.caption += fmt::format(" The envelope is cut at s = {}.", format_number(top, 3));
      break;
    }
  return f;
}

figure::Figure at_scale(const Analysis& a, const SpeedStudy& study) {
  const mechanics::FeasibleSpeed& feasible = study.feasible();
  figure::Figure f{"at-largest-speed",
                   fmt::format("What the motion asks for when it runs {} times as fast, against the limits.", speed_words(study.scale())),
                   "data/speed.csv",
                   figure::Width::full,
                   2,
                   {}};
  constexpr std::size_t most_curves = 6;
  const mechanics::MotionLimits& limits = a.scenario().limits;
  const Topology& t = a.machine().topology();
  std::vector<double> time = a.time();
  for (double& x : time) x = time.front() + (x - a.time().front()) / study.scale();
  const auto add = [&](Kind kind, const std::string& si) {
    std::vector<const mechanics::SpeedLimit*> chosen;
    for (const SpeedStudy::Own& o : study.own())
      if (const auto& l = feasible.limits[o.limit]; l.kind == kind && unit_of(a, l) == si && chosen.size() < most_curves)
        chosen.push_back(&l);
    std::sort(chosen.begin(), chosen.end(), [](const auto* x, const auto* y) { return x->index < y->index; });
    if (chosen.empty()) return;
    figure::Panel p;
    const bool joint = kind >= Kind::joint_force;
    p.title = word_of(kind, si == "N*m");
    p.x = {"time", "s"};
    double largest = 0;
    for (const auto* l : chosen) {
      p.series.push_back(
          {joint ? t.joints[static_cast<std::size_t>(l->index)].name : symbol(t.actuators[static_cast<std::size_t>(l->index)].name), time,
           study.demand(*l, study.scale()), -1});
      for (const double y : p.series.back().y)
        if (std::isfinite(y)) largest = std::max(largest, std::abs(y));
    }
    const DisplayUnit d = display_unit(si, largest);
    p.y = {kind == Kind::actuator_force ? effort(si == "N" ? "m" : "rad") : p.title.substr(p.title.find(' ') + 1), d.label};
    for (figure::Series& s : p.series)
      for (double& y : s.y) y *= d.per_si;
    if (joint) {
      std::vector<double> values;
      for (const auto* l : chosen) values.push_back(study.bound(*l));
      std::sort(values.begin(), values.end());
      values.erase(std::unique(values.begin(), values.end()), values.end());
      for (const double v : values) p.lines.push_back({v * d.per_si, "limit"});
    } else {
      const std::vector<double>& list = kind == Kind::actuator_force   ? limits.force
                                        : kind == Kind::actuator_speed ? limits.speed
                                                                       : limits.power;
      add_limit_lines(p, a, list, si == "N" || si == "m/s" ? "m" : si == "W" ? "" : "rad", d.per_si);
    }
    f.panels.push_back(std::move(p));
  };
  for (const char* si : {"N", "N*m"}) add(Kind::actuator_force, si);
  for (const char* si : {"m/s", "rad/s"}) add(Kind::actuator_speed, si);
  add(Kind::actuator_power, "W");
  add(Kind::joint_force, "N");
  add(Kind::joint_moment, "N*m");
  return f;
}

}  // namespace pmreport::section
