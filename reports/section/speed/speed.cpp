// Section `speed`: how much faster the motion could run, and what stops it.
#include <reports/section/common/words/limits.hpp>
#include <reports/section/common/words/words.hpp>
#include <reports/section/speed/speed.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace pmreport::section {

using document::Paragraph;

namespace {

constexpr std::size_t most_rows = 20;

std::string definition() {
  return "Run s times as fast, the motion passes the same poses under the same loads with s times the rates and s² times the "
         "accelerations. A force is then what it is at rest plus s² times its inertial share, a power s times the rate times that force, "
         "and "
         "so for each limit and each sample the largest s is the root of a polynomial, found exactly.";
}

// What binds, where, and how the next one stands.
void add_verdict(Result& out, const Analysis& a, const SpeedStudy& study) {
  const auto tell = [&](const std::string& text, Paragraph::Tone tone = Paragraph::Tone::plain) {
    out.section.blocks.push_back(Paragraph{tone, text});
    using Kind = document::Finding::Kind;
    if (out.findings.empty()) out.findings.push_back({tone == Paragraph::Tone::warning ? Kind::fault : Kind::result, text});
  };
  const double scale = study.scale();
  if (std::isnan(scale)) return tell("No sample of the motion has forces to hold against the limits.", Paragraph::Tone::warning);
  if (study.feasible().limit < 0) return tell("No limit binds at any speed.");
  const mechanics::SpeedLimit& l = study.feasible().limits[static_cast<std::size_t>(study.feasible().limit)];
  const std::string where = fmt::format("the {} at t = {} of the motion as written, limit {}", subject(a, l),
                                        show_time(a, study.feasible().sample), show(study.bound(l), unit_of(a, l)));
  if (scale == 0)
    return tell(fmt::format("The motion breaks a limit at any speed, even at rest in the pose: {}.", where), Paragraph::Tone::warning);
  const std::string duration = show(study.duration(1), "s"), then = duration_words(study.duration(scale));
  if (scale < 1 - met_exactly)
    tell(fmt::format(
             "The motion as written breaks a limit. It may run at no more than {} of its speed, in {} instead of {}; what binds is {}.",
             speed_words(scale), then, duration, where),
         Paragraph::Tone::warning);
  else
    tell(fmt::format("The motion can run {} times as fast, in {} instead of {}. Then a limit binds: {}.", speed_words(scale), then,
                     duration, where));
  const std::vector<SpeedStudy::Own> own = study.own();
  if (own.size() > 1 && std::isfinite(own[1].scale)) {
    const mechanics::SpeedLimit& next = study.feasible().limits[own[1].limit];
    tell(fmt::format("Without this limit it would be {}, bound by the {} at t = {}.", speed_words(own[1].scale), subject(a, next),
                     show_time(a, own[1].sample)));
  }
}

document::Table table_of(const Analysis& a, const SpeedStudy& study) {
  const std::vector<SpeedStudy::Own> own = study.own();
  document::Table table{
      "Each limit by itself, the tightest first: how much of it the motion as written uses at most, the largest s that it "
      "admits, and where it binds then (time of the motion as written).",
      {"limited", "limit", "used", "largest s", "duration", "binds at"},
      {false, true, true, true, true, true},
      {}};
  table.ranked = true;
  if (own.size() > most_rows) table.caption += fmt::format(" The {} tightest of {}.", most_rows, own.size());
  for (const SpeedStudy::Own& o : own) {
    if (table.rows.size() == most_rows) break;
    const mechanics::SpeedLimit& l = study.feasible().limits[o.limit];
    double used = 0;
    for (const double x : study.demand(l, 1))
      if (std::isfinite(x)) used = std::max(used, std::abs(x) / study.bound(l));
    const bool binds = o.sample >= 0, moves = binds && o.scale > 0;
    table.rows.push_back({brief_subject(a, l), show(study.bound(l), unit_of(a, l)), format_number(100 * used, 3) + " %",
                          !binds  ? "never binds"
                          : moves ? speed_words(o.scale)
                                  : "0",
                          moves ? duration_words(study.duration(o.scale)) : "–", binds ? show_time(a, o.sample) : "–"});
  }
  return table;
}

document::Data data_of(const Analysis& a, const SpeedStudy& study) {
  document::Data d{"speed", {"t [s]", "largest_s"}, {a.time(), study.feasible().largest}};
  using Kind = mechanics::SpeedLimit::Kind;
  const Topology& t = a.machine().topology();
  for (const mechanics::SpeedLimit& l : study.feasible().limits) {
    const auto i = static_cast<std::size_t>(l.index);
    const bool joint = l.kind == Kind::joint_force || l.kind == Kind::joint_moment;
    const char* of = l.kind == Kind::actuator_speed                     ? "rate"
                     : l.kind == Kind::actuator_power                   ? "power"
                     : l.kind == Kind::joint_moment                     ? "moment"
                     : joint || t.actuators[i].sense() == Sense::linear ? "force"
                                                                        : "torque";
    d.headings.push_back(fmt::format("{}_{}_largest_s", joint ? t.joints[i].name : t.actuators[i].name, of));
    d.columns.push_back(l.largest);
  }
  return d;
}

}  // namespace

Result speed_section(const Analysis& a) {
  Result out{{"speed", "speed", "Feasible speed", {}}, {}, {}, {}};
  document::Section& s = out.section;
  const SpeedStudy study(a);
  add_verdict(out, a, study);
  s.blocks.push_back(Paragraph{Paragraph::Tone::plain, definition()});
  const auto missing =
      std::count_if(study.feasible().largest.begin(), study.feasible().largest.end(), [](double x) { return std::isnan(x); });
  if (missing > 0)
    s.blocks.push_back(Paragraph{Paragraph::Tone::warning,
                                 fmt::format("{} of {} have no forces and are left out.", missing, plural(a.samples(), "sample"))});
  const bool moves = study.feasible().limit >= 0 && study.scale() > 0;
  if (moves) s.blocks.push_back(phase_plane(a, study));
  if (!study.feasible().limits.empty()) s.blocks.push_back(table_of(a, study));
  if (moves) {
    s.blocks.push_back(at_scale(a, study));
    s.blocks.push_back(document::Proof{evidence(study)});
    out.values.push_back({"speed", "duration", "s", study.duration(study.scale())});
  }
  if (std::isfinite(study.scale())) out.values.push_back({"speed", "scale", "", study.scale()});
  out.data.push_back(data_of(a, study));
  return out;
}

}  // namespace pmreport::section
