// Indices over a map of two coordinates: how it is asked for, drawn, and written as data. The key reads
//     map = { x = ["-100 mm", "100 mm"], y = ["-110 mm", "110 mm"], at = { alpha = "5 deg" }, points = 61, show = ["condition"] }
#pragma once

#include <core/analysis/study/pose_map.hpp>
#include <core/scenario/section/key.hpp>
#include <core/scenario/section/reading.hpp>
#include <reports/document/report.hpp>
#include <reports/section/common/analysis.hpp>

#include <optional>
#include <string>
#include <vector>

namespace pmreport::section {

struct MapRequest : analysis::PoseMap {
  std::vector<std::string> show;  // names of indices; empty: the kind's own choice
};

// What may stand as the key `map`. `show`: what each item of its list `show` may be, with the meaning of that list and what counts without
// it; nothing: a kind that has no choice.
struct ShownKey {
  scenario::Shape item;
  std::string meaning, unset;
};
scenario::Shape map_shape(const std::optional<ShownKey>& show = std::nullopt);

// `shown`: the words that may stand in `show`, none of a kind without that key. Nothing, told, where something is wrong. The mechanism's
// topology must be known.
std::optional<MapRequest> read_map(const scenario::Entry& entry, const scenario::MechanismPart& mechanism, const scenario::Reader& reader,
                                   const std::vector<std::string>& shown = {});

// An index over the map.
struct MapIndex {
  std::string name;            // heading of its column: "smallest_singular_value"
  std::string unit;            // SI
  std::string title;           // of its panel
  std::string symbol;          // at its colour bar: "σ₆"
  std::vector<double> values;  // SI, row by row as of over_map(); NaN: out of reach
  figure::ColourMap::Scale scale = figure::ColourMap::Scale::sequential;
  struct Contour {
    double level = 0;  // SI
    std::string label;
  };
  std::optional<Contour> contour = {};
  std::string missing = "out of reach";  // what NaN means
};

// A figure with a panel for each index, over which the motion goes, and the numbers: the two coordinates, then a column an index. `id`: of
// the figure and of the data, "singularity-map". `what`: completes the caption "Over x and y at z = 900 mm: ...".
struct DrawnMap {
  figure::Figure figure;
  document::Data data;
};
DrawnMap draw_map(const Analysis& a, const analysis::PoseMap& map, const std::string& id, const std::string& what,
                  const std::vector<MapIndex>& indices);

}  // namespace pmreport::section
