#include <core/mechanics/machine/joint_words.hpp>
#include <core/mechanics/mobility/mobility.hpp>
#include <reports/section/common/words/words.hpp>
#include <reports/section/mobility/mobility.hpp>

#include <fmt/core.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <set>

namespace pmreport::section {

using document::Table;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using mechanics::LimbSystem;
using mechanics::SelfStress;

namespace {

// "in every direction", "in every direction perpendicular to Y", "along X".
std::string span_words(const Surroundings& s, const MatrixXd& directions, const char* all, const char* across, const char* one) {
  if (directions.cols() == 3) return all;
  if (directions.cols() == 1) return fmt::format("{} {}", one, direction_words(s, directions.col(0)));
  const MatrixXd normal = mechanics::aligned(Vector3d(directions.col(0)).cross(Vector3d(directions.col(1))));
  return fmt::format("{} {}", across, direction_words(s, normal.col(0)));
}

// "SPS" for a chain of few joints, "14 R and 4 P" for more.
std::string chain_words(const Topology& t, const LimbSystem& l) {
  constexpr std::size_t few = 7;
  std::string chain;
  std::map<char, int> counts;
  for (const int j : l.joints) {
    const Joint& joint = t.joints[static_cast<std::size_t>(j)];
    // Where another limb is hinged to this one is no part of its own chain.
    const auto of_another = [&](int body) {
      const int limb = t.bodies[static_cast<std::size_t>(body)].limb;
      return l.alone && limb > 0 && limb != l.limb;
    };
    if (of_another(joint.a) || of_another(joint.b)) continue;
    const char letter = mechanics::letter_of(joint.kind);
    chain += letter, ++counts[letter];
  }
  if (chain.size() <= few) return chain;
  std::vector<std::string> parts;
  for (const auto& [kind, n] : counts) parts.push_back(fmt::format("{} {}", n, kind));
  return listed(parts);
}

std::string limbs_listed(const std::vector<int>& limbs) {
  std::vector<std::string> names;
  for (const int n : limbs) names.push_back(std::to_string(n));
  return (limbs.size() == 1 ? "limb " : "limbs ") + listed(names);
}

// How often the kinds of wrenches differ from those at home: "the same at 100 of 100 poses", "1 force at 100 of 100 poses".
std::string elsewhere_words(const std::string& home, const std::vector<std::string>& kinds) {
  if (kinds.empty()) return "–";
  std::map<std::string, int> counts;
  for (const std::string& k : kinds) ++counts[k];
  std::vector<std::string> parts;
  for (const auto& [kind, n] : counts) parts.push_back(fmt::format("{} at {} of {}", kind == home ? "the same" : kind, n, kinds.size()));
  return listed(parts);
}

// "base – A1 – cylinder 1 – ... – base", or of several loops the limbs, with the joints where they are few.
std::string loop_words(const Topology& t, const SelfStress& s) {
  if (!s.loop.joints.empty()) return in_words(t, s.loop);
  std::set<int> limbs;
  std::vector<std::string> joints;
  for (const auto& share : s.shares) {
    const Joint& j = t.joints[static_cast<std::size_t>(share.joint)];
    joints.push_back(j.name);
    for (const int body : {j.a, j.b})
      if (const int limb = t.bodies[static_cast<std::size_t>(body)].limb; limb > 0) limbs.insert(limb);
  }
  constexpr std::size_t few = 6;
  std::sort(joints.begin(), joints.end());
  std::string out = "several loops together";
  if (!limbs.empty()) out += ", of " + limbs_listed({limbs.begin(), limbs.end()});
  return joints.size() <= few ? out + ": " + listed(joints) : fmt::format("{}: {} joints", out, joints.size());
}

std::string symbol_of(const MobilityAt& m) { return fmt::format("{}T{}R", m.platform.translations.cols(), m.platform.rotations.cols()); }

}  // namespace

std::vector<std::string> freedom_sentences(const Surroundings& home, const MobilityAt& at_home, const std::vector<MobilityAt>& elsewhere) {
  const mechanics::PlatformFreedoms& f = at_home.platform;
  std::vector<std::string> out;
  std::string s = "At home the platform ";
  if (f.translations.cols() == 0)
    s += "has no translation without a rotation";
  else
    s += "translates, without turning, " +
         span_words(home, f.translations, "in every direction", "in every direction perpendicular to", "along");
  s += "; it ";
  if (f.rotations.cols() == 0)
    s += "does not turn.";
  else
    s += "turns " + span_words(home, f.rotations, "about every direction", "about every direction perpendicular to", "about") + ".";
  out.push_back(s);

  std::vector<int> all;
  for (int j = 0; j < static_cast<int>(home.state.joints.size()); ++j) all.push_back(j);
  std::vector<std::string> axes;  // of couples
  for (const auto& w : readable_basis(f.constraints, landmarks_of(home.machine.topology(), home.state, all), home.length)) {
    if (w.screw.is_free()) {
      axes.push_back(direction_words(home, w.screw.direction));
      continue;
    }
    out.push_back("The limbs hold it against " + wrench_words(home, w.screw) +
                  (w.screw.is_line()
                       ? ": those of its points that are on this line cannot move along it, and a motion in that direction comes "
                         "only with a rotation."
                       : ": a turn about this axis comes with a translation along it."));
  }
  if (!axes.empty())
    out.push_back(fmt::format("The limbs hold it against {} about {}: it cannot turn about {}.", axes.size() == 1 ? "a couple" : "couples",
                              listed(axes), axes.size() == 1 ? "this direction" : "these directions"));

  std::vector<std::string> kinds;
  for (const MobilityAt& m : elsewhere) kinds.push_back(symbol_of(m));
  if (std::any_of(kinds.begin(), kinds.end(), [&](const std::string& k) { return k != symbol_of(at_home); }))
    out.push_back(
        fmt::format("The kind of motion depends on the pose: {} at home, {} random poses. A translation and a rotation are coupled "
                    "there, a parasitic motion that home does not show.",
                    symbol_of(at_home), elsewhere_words(symbol_of(at_home), kinds)));
  return out;
}

Table limb_table(const Surroundings& home, const MobilityAt& at_home, const std::vector<MobilityAt>& elsewhere) {
  const Topology& t = home.machine.topology();
  Table table{
      "What each limb by itself allows the platform, and holds it against, at home; the kinds of its constraint wrenches at the random "
      "poses.",
      {"limb", "joints", "freedoms", "constraint wrenches at home", "at random poses"},
      {true, false, true, false, false},
      {}};
  for (std::size_t i = 0; i < at_home.limb_systems.size(); ++i) {
    const LimbSystem& l = at_home.limb_systems[i];
    if (!l.alone) {
      table.rows.push_back({std::to_string(l.limb), chain_words(t, l), "–", fmt::format("joins {}", limbs_listed(l.partners)), "–"});
      continue;
    }
    Surroundings own = home;
    own.joints = l.joints;
    std::vector<std::string> wrenches, kinds;
    for (const auto& w : at_home.wrenches[i]) wrenches.push_back(wrench_words(own, w.screw));
    for (const MobilityAt& m : elsewhere) kinds.push_back(kinds_of(m.wrenches[i]));
    table.rows.push_back({std::to_string(l.limb), chain_words(t, l), std::to_string(l.twists.dimension()),
                          wrenches.empty() ? "none" : listed(wrenches), elsewhere_words(kinds_of(at_home.wrenches[i]), kinds)});
  }
  return table;
}

std::vector<std::string> limb_sentences(const mechanics::Machine& machine, const MobilityAt& at_home) {
  std::vector<std::string> out;
  for (const LimbSystem& l : at_home.limb_systems) {
    if (l.alone) continue;
    std::vector<std::string> joints;
    for (const int j : l.joints) {
      const Joint& joint = machine.topology().joints[static_cast<std::size_t>(j)];
      const auto limb_of = [&](int body) { return machine.topology().bodies[static_cast<std::size_t>(body)].limb; };
      if (limb_of(joint.a) != limb_of(joint.b)) joints.push_back(joint.name);
    }
    out.push_back(
        fmt::format("Limb {} joins {} at {}. It reaches the platform only through other limbs, so it has no constraint wrench of its own.",
                    l.limb, limbs_listed(l.partners), listed(joints)));
  }
  return out;
}

Table stress_table(const Surroundings& home, const std::vector<SelfStress>& stresses) {
  Table table{"Redundant constraints at home, each as the self-stress that it allows: reactions that balance one another without a load.",
              {"", "self-stress", "in the loop"},
              {true, false, false},
              {}};
  const Topology& t = home.machine.topology();
  for (std::size_t i = 0; i < stresses.size(); ++i) {
    const SelfStress& s = stresses[i];
    const auto in_it = [&](const SelfStress& other) { return other.loop.joints == s.loop.joints; };
    const bool first = i == 0 || !in_it(stresses[i - 1]);
    std::string loop = first ? loop_words(t, s) : "the same";
    if (first && !s.loop.joints.empty()) loop += fmt::format(": {} redundant", std::count_if(stresses.begin(), stresses.end(), in_it));
    // Named by the joints that carry it: lines through joints far away would mean nothing there.
    Surroundings own = home;
    own.joints.clear();
    for (const auto& share : s.shares) own.joints.push_back(share.joint);
    std::string words = wrench_words(own, s.at_first.screw);
    words += s.same ? ", the same at every joint of the loop"
                    : fmt::format(" at {}, which the others balance", t.joints[static_cast<std::size_t>(s.shares.front().joint)].name);
    table.rows.push_back({std::to_string(i + 1), words, loop});
  }
  return table;
}

}  // namespace pmreport::section
