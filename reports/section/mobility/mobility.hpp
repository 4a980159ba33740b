// Section `mobility`, and its parts.
#pragma once

#include <core/mechanics/mobility/mobility.hpp>
#include <reports/section/common/words/screw_words.hpp>
#include <reports/section/kind.hpp>

namespace pmreport::section {

struct MobilityOptions : scenario::Options {
  int random_poses = 100;
};

Result mobility_section(const Analysis& a, const MobilityOptions& r);

// Everything that the section compares from pose to pose.
struct MobilityAt {
  int rank = 0, freedoms = 0, idle = 0;
  mechanics::PlatformFreedoms platform;
  std::vector<mechanics::LimbSystem> limb_systems;
  std::vector<std::vector<mechanics::NamedWrench>> wrenches;  // of each limb, as they are told
  double closed_form = 0;                                     // constraint rows of G against those of the generic model, a sine
  double limbs = 0;                                           // constraint wrenches of the platform against those of the limbs, a sine
  bool limbs_compared = false;                                // every limb reaches the platform by itself and shares no body
};
MobilityAt mobility_at(const mechanics::Machine& machine, const mechanics::State& state, double length);

// Which translations, which rotations, what holds the platform against the others, and whether other poses agree.
std::vector<std::string> freedom_sentences(const Surroundings& home, const MobilityAt& at_home, const std::vector<MobilityAt>& elsewhere);
// Each limb with its chain, its freedoms, its constraint wrenches at home and their kinds elsewhere.
document::Table limb_table(const Surroundings& home, const MobilityAt& at_home, const std::vector<MobilityAt>& elsewhere);
// Of limbs that reach the platform only through others.
std::vector<std::string> limb_sentences(const mechanics::Machine& machine, const MobilityAt& at_home);
document::Table stress_table(const Surroundings& home, const std::vector<mechanics::SelfStress>& stresses);

}  // namespace pmreport::section
