#include <reports/section/mobility/mobility.hpp>

#include <core/scenario/section/keys.hpp>

namespace pmreport::section {

namespace {

std::vector<scenario::Quantity> quantities(const scenario::Options*) {
  return {{"mobility.links", "", "links, base included"},
          {"mobility.joints", "", "joints"},
          {"mobility.freedoms_sum", "", "sum of the joints' freedoms"},
          {"mobility.gruebler", "", "degrees of freedom by Grübler-Kutzbach, without redundant constraints"},
          {"mobility.rows", "", "constraints of the generic model"},
          {"mobility.rank", "", "rank of the constraints"},
          {"mobility.idle", "", "idle freedoms"},
          {"mobility.redundant", "", "redundant constraints"},
          {"mobility.freedoms", "", "degrees of freedom"},
          {"mobility.translations", "", "independent translations of the platform"},
          {"mobility.rotations", "", "independent rotations of the platform"}};
}

}  // namespace

const SectionKind& mobility_kind() {
  static const SectionKind kind{
      {.name = "mobility",
       .purpose = "how many freedoms, which, why, and whether they last",
       .keys = {scenario::keys::whole<MobilityOptions>("poses", &MobilityOptions::random_poses, 1, 10000,
                                                       "how many random poses are looked at beside home")},
       .needs = {.motion = false},
       .quantities = quantities,
       .make_options = scenario::plain_options<MobilityOptions>},
      [](const Context& c, const scenario::Section& s) { return mobility_section(c.analysis, options_of<MobilityOptions>(s)); }};
  return kind;
}

}  // namespace pmreport::section
