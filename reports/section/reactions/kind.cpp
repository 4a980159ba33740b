#include <reports/section/reactions/reactions.hpp>

#include <core/scenario/section/keys.hpp>

#include <limits>

namespace pmreport::section {

using scenario::Shape;
namespace keys = scenario::keys;

namespace {

void read_joints(const scenario::Entry& e, const scenario::Reading& r, ReactionsOptions& options) {
  if (!r.mechanism.topology) return;
  std::vector<std::string> names;
  for (const Joint& j : r.mechanism.topology->joints) names.push_back(j.name);
  for (const scenario::Value& item : items_of(e, names.size(), r.reader))
    if (const auto index = r.reader.word(item, names, "the joints")) add_once(options.joints, static_cast<int>(*index), item, r.reader);
}

std::vector<scenario::Quantity> quantities(const scenario::Options*) {
  return {{"reactions.peak_force", "N", "largest force in any joint", false},
          {"reactions.peak_moment", "N*m", "largest moment in any joint", false},
          {"reactions.indeterminate", "", "components of joint reactions that rigid bodies do not determine"},
          {"reactions.by_elasticity", "", "components that rigid bodies leave open and elasticity determines"},
          {"reactions.self_stresses", "", "independent self-stresses"}};
}

}  // namespace

const SectionKind& reactions_kind() {
  static const SectionKind kind{
      {.name = "reactions",
       .purpose = "the wrench in every joint over the motion, and how far rigid bodies determine it",
       .keys = {keys::of<ReactionsOptions>("joints", Shape::list(1, std::numeric_limits<std::size_t>::max(), Shape::name_of("joints")),
                                           "those that are drawn, `[\"B1\", \"B2\"]`", "those with the largest reactions", read_joints)},
       .needs = {.dynamics = true, .reactions = true, .pictures = true, .force_evidence = true},
       .columns = analysis::reaction_columns,
       .quantities = quantities,
       .make_options = scenario::plain_options<ReactionsOptions>},
      [](const Context& c, const scenario::Section& s) { return reactions_section(c.analysis, options_of<ReactionsOptions>(s), c.stage); }};
  return kind;
}

}  // namespace pmreport::section
