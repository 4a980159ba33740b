#include <reports/section/common/pose_map.hpp>
#include <reports/section/singularity/singularity.hpp>

#include <core/scenario/section/keys.hpp>

#include <algorithm>

namespace pmreport::section {

using scenario::Shape;
namespace keys = scenario::keys;

namespace {

constexpr std::size_t most_poses = 100;

void read_length(const scenario::Entry& e, const scenario::Reading& r, SingularityOptions& options) {
  options.length = r.reader.quantity(e.value, {1, 0, 0, 0});
  if (options.length && !(*options.length > 0))
    r.reader.diagnostics().add(e.value.place,
                               fmt::format("expected a length above 0 mm, seen {} mm", format_number(*options.length * 1e3, 6)));
}

void read_poses(const scenario::Entry& e, const scenario::Reading& r, SingularityOptions& options) {
  options.poses = scenario::read_poses(e, most_poses, r);
}

void complete(scenario::TableReader& table, const scenario::Reading& r, scenario::Options& options) {
  const auto& own = static_cast<const SingularityOptions&>(options);
  if (r.span && r.span->empty() && own.poses.empty() && !own.map)
    r.reader.diagnostics().add(table.place(), "a section \"singularity\" has nothing to look at: there is no motion, no pose and no map",
                               "add poses or map to it, or [motion], duration = \"10 s\" and samples = 501");
}

std::vector<scenario::Quantity> quantities(const scenario::Options* options) {
  std::vector<scenario::Quantity> out{
      {"singularity.crossings", "", "singular surfaces crossed by the motion", true, true},
      {"singularity.smallest_singular_value", "", "smallest singular value of G along the motion", false, true},
      {"singularity.largest_condition", "", "largest condition number along the motion", false, true},
      {"singularity.line_rank", "", "rank of the actuation lines at the worst pose of the motion", true, true},
      {"singularity.wrench_rank", "", "rank of the whole wrench system at the worst pose of the motion", true, true}};
  const std::size_t poses = options != nullptr ? static_cast<const SingularityOptions*>(options)->poses.size() : most_poses;
  for (std::size_t i = 1; i <= poses; ++i) {
    const std::string n = std::to_string(i);
    out.push_back({"singularity.line_rank_" + n, "", "rank of the actuation lines at pose " + n});
    out.push_back({"singularity.wrench_rank_" + n, "", "rank of the whole wrench system at pose " + n});
  }
  return out;
}

std::vector<scenario::Key> all_keys() {
  using O = SingularityOptions;
  const Shape pose = Shape::values_of("coordinates");
  return {keys::of<O>("length", Shape::quantity(Dimension{1, 0, 0, 0}), "which makes moments comparable with forces",
                      "the characteristic length", read_length),
          keys::of<O>("poses", Shape::list(1, most_poses, pose),
                      "looked at beside those of the motion, `[{x = \"10 mm\"}]`, coordinates left out at home", "none", read_poses),
          keys::of<O>("map", map_shape(),
                      "of det G over two coordinates, `{x = [\"-100 mm\", \"100 mm\"], y = [\"-110 mm\", \"110 mm\"], at = {alpha = \"5 "
                      "deg\"}, points = 61}`",
                      "none", [](const scenario::Entry& e, const scenario::Reading& r, O& options) {
                        if (r.mechanism.topology) options.map = read_map(e, r.mechanism, r.reader);
                      })};
}

}  // namespace

const SectionKind& singularity_kind() {
  static const SectionKind kind{
      {.name = "singularity",
       .purpose = "how far the motion stays from a loss of control, where control is lost, and how the platform escapes",
       .keys = all_keys(),
       .needs = {.motion = false, .pictures = true},
       .quantities = quantities,
       .make_options = scenario::plain_options<SingularityOptions>,
       .complete = complete},
      [](const Context& c, const scenario::Section& s) {
        return singularity_section(c.analysis, options_of<SingularityOptions>(s), c.stage, c.progress);
      }};
  return kind;
}

}  // namespace pmreport::section
