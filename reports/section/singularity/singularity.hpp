// Section `singularity`, and its parts.
#pragma once

#include <core/analysis/study/singular_margins.hpp>
#include <core/mechanics/singularity/singularity.hpp>
#include <reports/section/common/pose_map.hpp>
#include <reports/section/common/stage.hpp>
#include <reports/section/common/words/screw_words.hpp>
#include <reports/section/kind.hpp>

#include <optional>
#include <vector>

namespace pmreport::section {

using analysis::along_motion;
using analysis::AlongMotion;

struct SingularityOptions : scenario::Options {
  std::optional<double> length;        // [m] makes moments comparable with forces; default: the characteristic length
  std::vector<Eigen::VectorXd> poses;  // coordinates, besides those of the motion
  std::optional<MapRequest> map;
};

Result singularity_section(const Analysis& a, const SingularityOptions& r, const Stage& stage, const Progress& progress);

// A pose that the section looks at closely.
struct ExaminedPose {
  std::string name;   // "t = 3.314 s, crossing", "pose 1"
  std::string where;  // coordinates that differ from home: "alpha = −62.688°"
  mechanics::Singularity at;
  std::optional<mechanics::OnSurface> snapped;          // ranks and type are those of the singular pose that rounded numbers mean
  double determinant = 0, smallest = 0, condition = 0;  // at the numbers given
  bool beyond_g = false;                                // a loss that the constraints of the bodies tell, and G does not
  std::optional<program::Bounds> proved = {};           // of a crossing that was proved: the times between which it happens [s]
  bool singular() const { return at.type != mechanics::SingularityType::regular; }
};

std::string type_name(mechanics::SingularityType t);   // "type 2, direct", "regular"
std::string type_words(mechanics::SingularityType t);  // with what it means
// What the platform can do there although its actuators are locked; of a regular pose, what they hold least.
std::string escape_words(const Analysis& a, const ExaminedPose& p, double length);
// The screw to draw of it.
mechanics::Screw escape_screw(const Topology& t, const ExaminedPose& p, double length);

// det G^ and the signed smallest singular value over two coordinates, as a figure and as data.
struct SingularityMap {
  figure::Figure figure;
  document::Data data;
  int reachable = 0, all = 0, negative = 0, singular = 0;
};
SingularityMap singularity_map(const Analysis& a, const MapRequest& request, double length);

}  // namespace pmreport::section
