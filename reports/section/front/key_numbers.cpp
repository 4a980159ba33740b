#include <core/numbers.hpp>
#include <reports/section/front/key_numbers.hpp>

#include <core/analysis/study/reduce.hpp>
#include <core/analysis/transmission/transmission_numbers.hpp>
#include <core/mechanics/machine/joint_words.hpp>
#include <core/mechanics/model/effort.hpp>
#include <core/mechanics/model/joint_motion.hpp>
#include <reports/section/common/words/brackets.hpp>
#include <reports/section/common/words/words.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

namespace pmreport::section {

using document::KeyNumber;

namespace {

constexpr std::size_t most = 6;
constexpr double nearly_used = 0.8;

std::string upper_first(std::string s) {
  if (!s.empty()) s[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(s[0])));
  return s;
}

// Gathers candidates, what matters most first.
class Candidates {
 public:
  Candidates(const Analysis& a, const document::Report& r) : a_(a), r_(r) {}

  std::vector<KeyNumber> take() && { return std::move(out_); }

  void add_ranges() {
    if (a_.samples() == 0 || !has("displacement")) return;
    const Topology& t = a_.machine().topology();
    std::optional<Used> stroke, joint;
    for (const Actuator& x : t.actuators) look(stroke, column_of(x), x.stroke, {}, symbol(x.name), x.unit);
    for (const Joint& j : t.joints)
      for (std::size_t k = 0; k < j.limits.size(); ++k)
        if (mechanics::is_told(j, k))
          look(joint, analysis::joint_column(j, k), j.limits[k], &j, "joint " + j.name, mechanics::motion_unit(j));
    put(stroke, "Stroke used most", "stroke");
    put(joint, "Joint motion used most", "limits");
  }

  // Of [limits] the one that is used most; else the largest force and torque.
  void add_forces() {
    if (a_.samples() == 0) return;
    const Topology& t = a_.machine().topology();
    const bool moving = a_.has_dynamics() && has("dynamics");
    if (!moving && !has("statics")) return;
    for (const Sense sense : {Sense::linear, Sense::rotary}) {
      KeyNumber best;
      for (std::size_t i = 0; i < t.actuators.size(); ++i) {
        const Actuator& x = t.actuators[i];
        const ColumnId column = column_of(x, moving ? OfActuator::dynamic_force : OfActuator::static_force);
        if (x.sense() != sense || !a_.has(column)) continue;
        const analysis::Peak peak = analysis::peak(a_, column);
        if (peak.sample < 0) continue;
        const std::vector<double>& limits = a_.scenario().limits.force;
        const double limit = moving && i < limits.size() && std::isfinite(limits[i]) ? limits[i] : nan, size = std::abs(peak.value);
        const double used = size / limit;
        if (!best.what.empty() && !(std::isfinite(used) ? used > best.used || !best.limited() : !best.limited() && size > best.number))
          continue;
        const std::string word = mechanics::word_of_effort(sense), unit = mechanics::unit_of_effort(sense);
        best = {std::isfinite(used) ? upper_first(word) + " of an actuator nearest to its limit"
                                    : "Largest " + word + " of an actuator" + (moving ? "" : ", at rest"),
                show(size, unit),
                std::isfinite(limit) ? "limit " + show(limit, unit) : "",
                symbol(x.name) + ", t = " + show_time(a_, peak.sample),
                moving ? "dynamics" : "statics",
                used,
                size,
                limit,
                unit};
      }
      if (best.number > 0) out_.push_back(best);  // else nothing loads the machine
    }
  }

  void add_speeds() {
    if (a_.samples() == 0) return;
    KeyNumber best;
    const Topology& t = a_.machine().topology();
    const std::vector<double>& limits = a_.scenario().limits.speed;
    for (std::size_t i = 0; i < t.actuators.size() && i < limits.size(); ++i) {
      const ColumnId column = column_of(t.actuators[i], OfMotion::rate);
      if (!std::isfinite(limits[i]) || !a_.has(column)) continue;
      const analysis::Peak peak = analysis::peak(a_, column);
      const double size = std::abs(peak.value), used = size / limits[i];
      if (peak.sample < 0 || (!best.what.empty() && !(used > best.used))) continue;
      const std::string unit = t.actuators[i].unit + "/s";
      best = {"Speed of an actuator nearest to its limit",
              show(size, unit),
              "limit " + show(limits[i], unit),
              symbol(t.actuators[i].name) + ", t = " + show_time(a_, peak.sample),
              has("velocity") ? "velocity" : "dynamics",
              used,
              size,
              limits[i],
              unit};
    }
    if (!best.what.empty()) out_.push_back(best);
  }

  void add_power() {
    if (a_.samples() == 0 || !a_.has_dynamics()) return;
    const Topology& t = a_.machine().topology();
    KeyNumber best;
    for (std::size_t i = 0; i < t.actuators.size(); ++i) {
      const std::vector<double>& limits = a_.scenario().limits.power;
      if (i >= limits.size() || !std::isfinite(limits[i])) continue;
      const analysis::Peak peak = analysis::peak(a_, column_of(t.actuators[i], OfActuator::power));
      const double size = std::abs(peak.value), used = size / limits[i];
      if (peak.sample < 0 || (!best.what.empty() && !(used > best.used))) continue;
      best = {"Power of an actuator nearest to its limit",
              show(size, "W"),
              "limit " + show(limits[i], "W"),
              symbol(t.actuators[i].name) + ", t = " + show_time(a_, peak.sample),
              "dynamics",
              used,
              size,
              limits[i],
              "W"};
    }
    if (!best.what.empty()) out_.push_back(best);
  }

  // Of [limits] the one that is used most; else the largest.
  void add_joint_forces() {
    if (a_.samples() == 0 || !has("reactions")) return;
    KeyNumber best;
    const std::vector<Joint>& joints = a_.machine().topology().joints;
    const std::vector<double>& limits = a_.scenario().limits.joint_force;
    for (std::size_t j = 0; j < joints.size(); ++j) {
      const ColumnId column = column_of(joints[j], OfJoint::force);
      if (!a_.has(column)) continue;
      const analysis::Peak peak = analysis::peak(a_, column);
      if (peak.sample < 0) continue;
      const double size = std::abs(peak.value), limit = j < limits.size() && std::isfinite(limits[j]) ? limits[j] : nan,
                   used = size / limit;
      if (!best.what.empty() && !(std::isfinite(used) ? used > best.used || !best.limited() : !best.limited() && size > best.number))
        continue;
      best = {std::isfinite(used) ? "Force in a joint nearest to its limit" : "Largest force in a joint",
              show(size, "N"),
              std::isfinite(limit) ? "limit " + show(limit, "N") : "",
              "joint " + joints[j].name + ", t = " + show_time(a_, peak.sample),
              "reactions",
              used,
              size,
              limit,
              "N"};
    }
    if (!best.what.empty()) out_.push_back(best);
  }

  void add_transmission() {
    const double least = value("transmission", "least_local");
    if (!std::isfinite(least)) return;
    const ColumnId column = column_of(OfMachine::local_transmission);
    // What is called good is no limit.
    KeyNumber k{"Least local transmission index",
                number(least, 3),
                number(analysis::good_transmission, 2) + " is called good",
                "",
                "transmission",
                nan,
                least,
                nan,
                ""};
    if (a_.has(column)) k.where = where_least(column);
    out_.push_back(k);
  }

  void add_singularity() {
    const double condition = value("singularity", "largest_condition");
    if (std::isnan(condition)) return;
    constexpr double of_rounding = 1e12;  // beyond it nothing but rounding tells the matrix from a singular one
    const ColumnId column = column_of(OfMachine::condition);
    KeyNumber k{
        "Largest condition number", condition < of_rounding ? number(condition, 3) : "∞", "", "", "singularity", nan, condition, nan, ""};
    if (a_.samples() > 0 && a_.has(column)) {
      const analysis::Peak peak = analysis::peak(a_, column);
      if (peak.sample >= 0 && std::abs(peak.value) == condition) k.where = "t = " + show_time(a_, peak.sample);
    }
    out_.push_back(k);
  }

  void add_speed() {
    const double scale = value("speed", "scale");
    if (!std::isfinite(scale) || !(scale > 0)) return;
    out_.push_back({"Feasible speed, of that written", number(scale, 3) + " times", "1 at least", "", "speed",
                    scale > 1 - 1e-9 ? std::min(1.0, 1 / scale) : 1 / scale, scale, 1, ""});
  }

  void add_stiffness() {
    if (const double d = value("stiffness", "largest_deflection"); std::isfinite(d)) {
      KeyNumber k{"Largest deflection", show(d, "m"), "", "", "stiffness", nan, d, nan, "m"};
      if (const ColumnId column = column_of(analysis::OfStiffness::deflection_size); a_.has(column))
        k.where = "t = " + show_time(a_, analysis::peak(a_, column).sample);
      out_.push_back(k);
    }
    double f = value("stiffness", "lowest_frequency");
    const bool at_home = std::isnan(f);
    if (at_home) f = value("stiffness", "home_frequency");
    if (std::isfinite(f))
      out_.push_back({"Lowest natural frequency", show(f, "Hz"), "", at_home ? "at home" : "", "stiffness", nan, f, nan, "Hz"});
    if (const double b = value("stiffness", "least_buckling"); std::isfinite(b))
      out_.push_back({"Least buckling load factor", number(b, 3), "1 at least", "", "stiffness", 1 / b, b, 1, ""});
  }

  void add_volumes() {
    for (const document::Section& s : r_.sections) {
      if (s.kind != "workspace") continue;
      const std::string point = s.id.starts_with("workspace-") ? s.id.substr(10) + "." : "";
      const document::Value* volume = found("workspace", point + "volume");
      if (volume == nullptr) continue;
      const double low = value("workspace", point + "volume_low"), high = value("workspace", point + "volume_high");
      KeyNumber k{point.empty() ? "Volume of the workspace" : "Volume of workspace " + point.substr(0, point.size() - 1),
                  std::isfinite(low) && std::isfinite(high) && high > low ? show_bracket({low, high}, volume->unit)
                                                                          : show_volume(volume->value, volume->unit),
                  "",
                  "",
                  s.id,
                  nan,
                  volume->value,
                  nan,
                  volume->unit};
      out_.push_back(k);
    }
  }

  void add_freedoms() {
    if (const double n = value("mobility", "freedoms"); std::isfinite(n))
      out_.push_back({"Degrees of freedom", fmt::format("{:.0f}", n), "", "by rank, at home", "mobility", nan, n, nan, ""});
  }

  void add_comparison() {
    const double published = value("comparison", "published"), good_ones = value("comparison", "reproduced");
    if (!(published > 0)) return;
    out_.push_back({"Published values that reproduce", fmt::format("{:.0f} of {:.0f}", good_ones, published), "", "", "comparison", nan,
                    good_ones, nan, ""});
  }

 private:
  struct Used {
    double share, value, end, time;
    std::string whose, unit;
    Range range;
    bool one_end;
  };

  static std::string number(double x, int digits) { return typeset(format_number(x, digits)); }
  bool has(std::string_view kind) const {
    return std::ranges::any_of(r_.sections, [&](const document::Section& s) { return s.kind == kind; });
  }
  const document::Value* found(std::string_view section, std::string_view name) const {
    for (const document::Value& v : r_.values)
      if (v.section == section && v.name == name) return &v;
    return nullptr;
  }
  double value(std::string_view section, std::string_view name) const {
    const document::Value* v = found(section, name);
    return v != nullptr ? v->value : nan;
  }
  std::string where_least(const ColumnId& column) const {
    const std::vector<double>& x = a_.column(column);
    int best = -1;
    for (int k = 0; k < static_cast<int>(x.size()); ++k)
      if (const double v = x[static_cast<std::size_t>(k)]; std::isfinite(v) && (best < 0 || v < x[static_cast<std::size_t>(best)]))
        best = k;
    return best < 0 ? "" : "t = " + show_time(a_, best);
  }

  // How much of the way to an end is used: a stroke from its middle, a joint from where its motion counts from. A deflection has no lower
  // end.
  void look(std::optional<Used>& best, const ColumnId& column, const Range& range, const Joint* joint, const std::string& whose,
            const std::string& unit) const {
    const bool from_zero = joint != nullptr && joint->kind == JointKind::spherical;
    if (!a_.has(column)) return;
    if (!from_zero && std::isfinite(range.min) != std::isfinite(range.max)) return look_beyond(best, column, range, whose, unit);
    if (!std::isfinite(range.max) || !(range.max > range.min)) return;
    const bool from_home = joint != nullptr && range.min < 0 && 0 < range.max;
    const double origin = from_zero || from_home ? 0 : 0.5 * (range.min + range.max);
    const auto see = [&](double v, double t) {
      const double end = v < origin && !from_zero ? range.min : range.max, share = std::abs((v - origin) / (end - origin));
      if (share > (best ? best->share : -1)) best = Used{share, share < 1e-9 ? origin : v, end, t, whose, unit, range, from_zero};
    };
    // Over all instants where that is proved, what is certain at one; else at the samples.
    if (const analysis::Extreme* e = a_.proof().extreme(column);
        e != nullptr && a_.proof().unexamined.empty() && e->least.bounded() && e->largest.bounded()) {
      see(e->least.high, e->at_least);
      see(e->largest.low, e->at_largest);
      return;
    }
    const std::vector<double>& x = a_.column(column);
    for (std::size_t k = 0; k < x.size(); ++k)
      if (std::isfinite(x[k])) see(x[k], a_.time()[k]);
  }
  // With one end alone nothing tells how near to it is near, but beyond it is beyond.
  void look_beyond(std::optional<Used>& best, const ColumnId& column, const Range& range, const std::string& whose,
                   const std::string& unit) const {
    const bool upper = std::isfinite(range.max);
    const double end = upper ? range.max : range.min;
    const std::vector<double>& x = a_.column(column);
    for (int k = 0; k < static_cast<int>(x.size()); ++k) {
      const double v = x[static_cast<std::size_t>(k)], excess = upper ? v - end : end - v;
      const double share = 1 + excess / std::max(std::abs(end), std::abs(v));
      if (excess > 1e-12 * std::max(1.0, std::abs(end)) && share > (best ? best->share : -1))
        best = Used{share, v, end, a_.time()[static_cast<std::size_t>(k)], whose, unit, range, true};
    }
  }
  void put(const std::optional<Used>& u, const char* what, const char* range) {
    if (!u) return;
    const Apart apart = show_apart(u->value, u->end, u->unit);
    // A limit that is met exactly is kept.
    const double share = u->share > 1 && u->share < 1 + 1e-12 ? 1 : u->share;
    const std::string limit =
        u->one_end ? "limit " + apart.beside : fmt::format("{} {} to {}", range, show(u->range.min, u->unit), show(u->range.max, u->unit));
    out_.push_back(
        {what, apart.value, limit, fmt::format("{}, t = {}", u->whose, when(u->time)), "displacement", share, u->value, u->end, u->unit});
  }
  // A sample's time as samples are told, any other with the digits that place it between them.
  std::string when(double time) const {
    const int k = a_.sample_at(time);
    return a_.time()[static_cast<std::size_t>(k)] == time ? show_time(a_, k) : show(time, "s", 5);
  }

  const Analysis& a_;
  const document::Report& r_;
  std::vector<KeyNumber> out_;
};

// A check of the scenario that bounds the same number from one side. Only where number and bound are positive is their ratio the share of a
// limit; and it never says what the check does not.
void take_limit_of_a_check(KeyNumber& k, const document::Report& r) {
  for (const document::Check& c : r.checks) {
    if (k.limited() || c.line <= 0 || c.unit != k.unit || !(c.value > 0) || !(c.bound > 0)) continue;
    if (!(std::abs(c.value - k.number) <= 1e-12 * c.value) || c.limit.find(',') != std::string::npos) continue;
    const bool below = c.limit.starts_with("< "), above = c.limit.starts_with("> ");
    const double used = below ? c.value / c.bound : c.bound / c.value;
    if (!(below || above) || (used > 1) == c.passed) continue;
    k.used = used, k.bound = c.bound, k.limit = "checked: " + c.limit;
    // Beside its limit in the same unit.
    if (const auto unit = parse_unit(c.told_in); unit && !c.told_in.empty())
      k.value = show(k.number, DisplayUnit{typographic(c.told_in), 1 / unit->factor});
  }
}

}  // namespace

std::vector<KeyNumber> key_numbers(const Analysis& a, const document::Report& r) {
  Candidates candidates(a, r);
  candidates.add_ranges();
  candidates.add_forces();
  candidates.add_power();
  candidates.add_speeds();
  candidates.add_transmission();
  candidates.add_singularity();
  candidates.add_stiffness();
  candidates.add_speed();
  candidates.add_comparison();
  candidates.add_volumes();
  candidates.add_freedoms();
  candidates.add_joint_forces();
  std::vector<KeyNumber> out = std::move(candidates).take();
  for (KeyNumber& k : out) take_limit_of_a_check(k, r);
  const auto class_of = [](const KeyNumber& k) { return k.broken() ? 0 : k.limited() && k.used >= nearly_used ? 1 : k.limited() ? 2 : 3; };
  std::ranges::stable_sort(out, [&](const KeyNumber& x, const KeyNumber& y) {
    const int of_x = class_of(x), of_y = class_of(y);
    if (of_x != of_y) return of_x < of_y;
    return of_x < 2 && x.used > y.used;
  });
  if (out.size() > most) out.resize(most);
  return out;
}

}  // namespace pmreport::section
