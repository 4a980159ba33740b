#include <reports/section/singularity/singularity.hpp>

#include <cmath>

namespace pmreport::section {

SingularityMap singularity_map(const Analysis& a, const MapRequest& request, double length) {
  MapRequest r = request;
  if (r.at.size() == 0) r.at = a.machine().home();
  const analysis::SingularityGrid grid = analysis::singularity_grid(a.machine(), r, length);
  constexpr auto diverging = figure::ColourMap::Scale::diverging;
  const MapIndex::Contour surface{0, "det Ĝ = 0"};
  DrawnMap drawn =
      draw_map(a, r, "singularity-map",
               "(a) the determinant of Ĝ; (b) its smallest singular value with the sign of the determinant, the distance from "
               "the singular surface. The strong line is that surface.",
               {{"determinant", "", "determinant", "det Ĝ", grid.determinant, diverging, surface},
                {"smallest_singular_value", "", "smallest singular value, signed", "± σ₆", grid.smallest, diverging, surface}});
  for (double& v : drawn.data.columns.back()) v = std::abs(v);

  SingularityMap out{std::move(drawn.figure), std::move(drawn.data)};
  out.all = r.points * r.points;
  out.reachable = grid.reachable, out.negative = grid.negative, out.singular = grid.singular;
  return out;
}

}  // namespace pmreport::section
