#include <tests/proof/at_an_instant.hpp>
#include <tests/proof/attack.hpp>
#include <tests/proof/oracle.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace pmreport::test {

namespace {

using namespace analysis;

constexpr Number infinite = std::numeric_limits<Number>::infinity();

template <class... X>
std::string sentence(fmt::format_string<X...> words, X&&... x) {
  return fmt::format(words, std::forward<X>(x)...);
}

// Of the quantity that has a column, or is claimed: its place in what an Oracle gives, and which derivative of it.
struct Watched {
  ColumnId column;
  std::size_t place;  // outputs of the program; after them the coordinates
  OfMotion order;
};

Number part(const Moved& x, OfMotion order) {
  return order == OfMotion::value ? x.value : order == OfMotion::rate ? x.rate : x.acceleration;
}

std::vector<Watched> all_watched(const mechanics::Machine& machine, const mechanics::MotionProgram& program, const Oracle& oracle) {
  const Topology& t = machine.topology();
  std::vector<Watched> out;
  for (const OfMotion order : {OfMotion::value, OfMotion::rate, OfMotion::acceleration}) {
    for (std::size_t i = 0; i < t.coordinates.size(); ++i) out.push_back({column_of(t.coordinates[i], order), oracle.coordinate(i), order});
    for (std::size_t i = 0; i < t.actuators.size(); ++i)
      out.push_back({column_of(t.actuators[i], order), machine.layout().actuator(static_cast<int>(i)), order});
    if (order == OfMotion::acceleration) continue;
    for (std::size_t i = 0; i < t.derived.size(); ++i)
      out.push_back({column_of(t.derived[i], order), machine.layout().derived(static_cast<int>(i)), order});
  }
  for (const auto& j : program.joints)
    out.push_back(
        {joint_column(t.joints[static_cast<std::size_t>(j.joint)], static_cast<std::size_t>(j.limit)), j.output, OfMotion::value});
  return out;
}

// What must be claimed, and of which output.
struct Expected {
  Claim::About about;
  int index, limit;
  Range range;
  std::size_t output;
};
std::vector<Expected> expected_claims(const mechanics::Machine& machine, const mechanics::MotionProgram& program) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Topology& t = machine.topology();
  std::vector<Expected> out{{Claim::About::assembled, 0, 0, {0, infinity}, 0}};
  for (std::size_t i = 0; i < t.actuators.size(); ++i)
    out.push_back({Claim::About::stroke, static_cast<int>(i), 0, t.actuators[i].stroke, machine.layout().actuator(static_cast<int>(i))});
  for (std::size_t j = 0; j < t.joints.size(); ++j)
    for (std::size_t k = 0; k < t.joints[j].limits.size(); ++k) {
      const Joint& joint = t.joints[j];
      Range range = joint.limits[k];
      if (joint.kind == JointKind::prismatic || range.max - range.min > 6.2831) continue;
      if (joint.kind == JointKind::spherical && range.min <= 0) range.min = -infinity;  // no deflection is less than none
      std::size_t output = std::numeric_limits<std::size_t>::max();                     // its motion is not known
      for (const auto& moving : program.joints)
        if (moving.joint == static_cast<int>(j) && moving.limit == static_cast<int>(k)) output = moving.output;
      out.push_back({Claim::About::joint_limit, static_cast<int>(j), static_cast<int>(k), range, output});
    }
  return out;
}

std::string name_of(const mechanics::Machine& machine, const Expected& e) {
  const Topology& t = machine.topology();
  if (e.about == Claim::About::stroke) return "the stroke of " + t.actuators[static_cast<std::size_t>(e.index)].name;
  if (e.about == Claim::About::joint_limit)
    return fmt::format("limit {} of {}", e.limit + 1, t.joints[static_cast<std::size_t>(e.index)].name);
  return "assembly";
}

const Claim* claim_of(const MotionProof& proof, const Expected& e) {
  for (const Claim& c : proof.claims)
    if (c.about == e.about && c.index == e.index && c.limit == e.limit) return &c;
  return nullptr;
}

std::string about_states(const Claim& c, const std::vector<Meeting>& meetings) {
  const bool crossed = std::ranges::count(meetings, Meeting::What::crossing, &Meeting::what) > 0;
  const bool regular = c.about == Claim::About::regular;
  const Claim::State is = (regular ? crossed : !c.broken.empty())                ? Claim::State::broken
                          : (regular ? !meetings.empty() : !c.undecided.empty()) ? Claim::State::undecided
                                                                                 : Claim::State::holds;
  return is == c.state ? "" : "its state is not what its stretches say";
}

// Instants: ends and random ones, and about every time that the proof names, from a millionth of the motion away to none.
std::vector<Number> instants_of(const MotionProof& proof, const Attack& attack) {
  std::mt19937_64 random(attack.seed);
  std::uniform_real_distribution<double> share(0, 1), power(-16, -1);
  std::vector<double> named;
  const auto name = [&](const Bounds& b) { named.insert(named.end(), {b.low, b.high, b.middle()}); };
  for (const Claim& c : proof.claims) {
    for (const Bounds& u : c.undecided) name(u);
    for (const Claim::Broken& b : c.broken) name(b.begin), name(b.end), named.push_back(b.at);
  }
  for (const Meeting& m : proof.meetings) name(m.time);
  for (const Extreme& e : proof.extremes) named.insert(named.end(), {e.at_least, e.at_largest});
  const double width = proof.end - proof.begin;
  std::vector<Number> out{proof.begin, proof.end};
  for (int k = 0; k < attack.random; ++k) out.push_back(proof.begin + static_cast<Number>(width) * share(random));
  const int each = std::max(1, attack.random / std::max(1, static_cast<int>(named.size())));
  for (const double t : named)
    for (int k = 0; k < each; ++k) {
      const double away = width * std::pow(10, power(random)) * (share(random) < 0.5 ? -1 : 1);
      out.push_back(
          std::clamp(static_cast<Number>(t) + (k == 0 ? 0 : away), static_cast<Number>(proof.begin), static_cast<Number>(proof.end)));
    }
  std::ranges::sort(out);
  return out;
}

class Attacker {
 public:
  Attacker(const mechanics::Machine& machine, const mechanics::MotionProgram& program, const MotionProof& proof, const Law& law,
           const Attack& attack)
      : machine_(machine),
        proof_(proof),
        attack_(attack),
        oracle_(machine, program, law),
        watched_(all_watched(machine, program, oracle_)),
        expected_(expected_claims(machine, program)) {}

  std::vector<std::string> run() {
    if (!proof_.unexamined.empty()) return {};
    times_ = instants_of(proof_, attack_);
    scale();
    claims();
    brackets();
    sides();
    return std::move(told_);
  }

 private:
  void tell(std::string s) {
    if (!s.empty() && told_.size() < most_told_of_attacks) told_.push_back(std::move(s));
  }
  Number tolerance(OfMotion order) const {
    return order == OfMotion::value ? attack_.tolerance : order == OfMotion::rate ? attack_.of_rates : attack_.of_accelerations;
  }

  // The size of everything, and where each watched quantity is greatest and least among the instants.
  void scale() {
    size_.assign(watched_.size(), 0), least_.assign(watched_.size(), infinite), largest_.assign(watched_.size(), -infinite);
    at_least_.assign(watched_.size(), 0), at_largest_ = at_least_;
    for (const Number t : times_) {
      const std::vector<Moved>& now = oracle_.at(t);
      values_.emplace_back();
      for (const Moved& x : now) values_.back().push_back(x.value);
      if (output_size_.empty()) output_size_.assign(now.size(), 0);
      if (!(now[0].value >= 0)) continue;
      for (std::size_t o = 0; o < now.size(); ++o) output_size_[o] = std::max(output_size_[o], std::abs(now[o].value));
      for (std::size_t w = 0; w < watched_.size(); ++w) {
        const Number x = part(now[watched_[w].place], watched_[w].order);
        size_[w] = std::max(size_[w], std::abs(x));
        if (x < least_[w]) least_[w] = x, at_least_[w] = t;
        if (x > largest_[w]) largest_[w] = x, at_largest_[w] = t;
      }
    }
  }

  void claims() {
    for (const Claim& c : proof_.claims) tell(about_states(c, proof_.meetings));
    for (const Expected& e : expected_) {
      const Claim* claim = claim_of(proof_, e);
      if (claim == nullptr) {
        tell("nothing is claimed of " + name_of(machine_, e));
        continue;
      }
      if (claim->state == Claim::State::unexamined) {
        if (claim->reason.empty() || e.output < output_size_.size()) tell(name_of(machine_, e) + " is not examined, without need");
        continue;
      }
      if (claim->range.min != e.range.min || claim->range.max != e.range.max) tell(name_of(machine_, e) + " is another range");
      const Number tolerance = attack_.tolerance * std::max(output_size_[e.output], e.about == Claim::About::assembled ? 1.0L : 0.0L);
      for (std::size_t k = 0; k < times_.size(); ++k) {
        const Number t = times_[k];
        if (e.about != Claim::About::assembled && (!(values_[k][0] >= 0) || doubtful(*claim_of(proof_, expected_[0]), t))) continue;
        if (const std::string s = against(*claim, t, values_[k][e.output], tolerance); !s.empty()) {
          tell(name_of(machine_, e) + " is " + s);
          break;
        }
      }
      for (const Claim::Broken& b : claim->broken) {
        const Number value = oracle_.at(b.at)[e.output].value;
        if (b.worst.bounded() && (value > b.worst.high + tolerance || value < b.worst.low - tolerance))
          tell(name_of(machine_, e) + " is not at its worst where it is said to be");
      }
    }
  }

  // The turning point of a quantity near a time, by Newton's method on its rate.
  Number refined(const Watched& w, Number t) {
    for (int k = 0; k < 4 && w.order == OfMotion::value; ++k) {
      const Moved x = oracle_.at(t)[w.place];
      const Number step = x.rate / x.acceleration;
      if (!std::isfinite(step) || std::abs(step) > 0.01L * (proof_.end - proof_.begin)) break;
      t = std::clamp(t - step, static_cast<Number>(proof_.begin), static_cast<Number>(proof_.end));
    }
    return t;
  }

  void brackets() {
    for (std::size_t w = 0; w < watched_.size(); ++w) {
      const Watched& q = watched_[w];
      const Extreme* e = proof_.extreme(q.column);
      if (e == nullptr) {
        tell("there is no bracket of " + q.column.name());
        continue;
      }
      const Number tolerance = this->tolerance(q.order) * size_[w];
      for (const Number t : {at_least_[w], at_largest_[w], refined(q, at_least_[w]), refined(q, at_largest_[w])}) {
        const std::vector<Moved>& now = oracle_.at(t);
        if (!(now[0].value >= 0)) continue;
        const Number x = part(now[q.place], q.order);
        if (x < e->least.low - tolerance || x > e->largest.high + tolerance)
          tell(sentence("{} is {} at {} s, and said to stay between {} and {}", q.column.name(), x, t, e->least.low, e->largest.high));
      }
      if (e->least.bounded() && part(oracle_.at(e->at_least)[q.place], q.order) > e->least.high + tolerance)
        tell(sentence("{} is not as little as {} at {} s", q.column.name(), e->least.high, e->at_least));
      if (e->largest.bounded() && part(oracle_.at(e->at_largest)[q.place], q.order) < e->largest.low - tolerance)
        tell(sentence("{} is not as much as {} at {} s", q.column.name(), e->largest.low, e->at_largest));
    }
  }

  // det G has one sign from meeting to meeting, another beyond a crossing, the same beyond a touch; and every change lies in a meeting.
  void sides() {
    const Claim* assembly = claim_of(proof_, expected_[0]);
    const auto unassembled = [&](Number t) { return assembly != nullptr && (doubtful(*assembly, t) || certainly_broken(*assembly, t)); };
    std::size_t next = 0;  // meeting
    int side = 0;
    Number before = proof_.begin;
    const Meeting* between = nullptr;
    for (int k = 0; k <= attack_.dense; ++k) {
      const Number t = proof_.begin + static_cast<Number>(proof_.end - proof_.begin) * k / attack_.dense;
      if (unassembled(t)) {
        side = 0, between = nullptr;
        continue;
      }
      bool several = false;
      while (next < proof_.meetings.size() && proof_.meetings[next].time.high < t) {
        several = several || between != nullptr;
        between = &proof_.meetings[next++];
      }
      if (next < proof_.meetings.size() && within(proof_.meetings[next].time, t)) continue;
      const int now = oracle_.side(t);
      if (now == 0) continue;
      if (side != 0 && between == nullptr && now != side) {
        Number low = before, high = t;
        for (int h = 0; h < 60; ++h) (oracle_.side(0.5L * (low + high)) == side ? low : high) = 0.5L * (low + high);
        tell(sentence("det G changes its sign at {} s, and no meeting is told there", low));
      }
      if (side != 0 && between != nullptr && !several) {
        if (between->what == Meeting::What::crossing && now == side)
          tell(sentence("a crossing is told at {} s, and det G has one sign", between->time.low));
        if (between->what == Meeting::What::touch && now != side)
          tell(sentence("a touch is told at {} s, and det G changes its sign", between->time.low));
      }
      side = now, before = t, between = nullptr;
    }
    for (const Meeting& m : proof_.meetings) {  // close by: what is dense may be coarse beside it
      const Number width = proof_.end - proof_.begin;
      for (const Number away : {1e-9L, 1e-7L, 1e-6L}) {
        const Number low = m.time.low - away * width, high = m.time.high + away * width;
        const auto apart = [&](const Meeting& o) { return &o == &m || o.time.high < low || o.time.low > high; };
        if (m.what != Meeting::What::crossing || low < proof_.begin || high > proof_.end || !std::ranges::all_of(proof_.meetings, apart) ||
            unassembled(low) || unassembled(high))
          continue;
        if (const int product = oracle_.side(low) * oracle_.side(high); product > 0)
          tell(sentence("a crossing is told from {} s to {} s, and det G has one sign about it", m.time.low, m.time.high));
      }
    }
  }

  const mechanics::Machine& machine_;
  const MotionProof& proof_;
  const Attack& attack_;
  Oracle oracle_;
  std::vector<Watched> watched_;
  std::vector<Expected> expected_;
  std::vector<std::vector<Number>> values_;  // of each time, of each output and then the coordinates
  std::vector<Number> times_, size_, least_, largest_, at_least_, at_largest_, output_size_;
  std::vector<std::string> told_;
};

}  // namespace

std::vector<std::string> contradictions(const mechanics::Machine& machine, const mechanics::MotionProgram& program,
                                        const MotionProof& proof, const Law& law, const Attack& attack) {
  return Attacker(machine, program, proof, law, attack).run();
}

std::vector<std::string> contradictions(const mechanics::Machine& machine, const MotionProof& proof, const Law& law, const Attack& attack) {
  return contradictions(machine, mechanics::motion_program(machine).value(), proof, law, attack);
}

std::string joined(const std::vector<std::string>& sentences) {
  std::string out;
  for (const std::string& s : sentences) out += "\n  " + s;
  return out;
}

}  // namespace pmreport::test
