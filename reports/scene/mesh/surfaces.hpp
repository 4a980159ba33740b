// Surfaces as triangles of a view.
#pragma once

#include <reports/scene/mesh/mesh.hpp>

namespace pmreport::scene {

// Opaque surfaces become a part each. All translucent triangles become one part, the farthest first, so that each is laid over those behind
// it; where triangles cut one another the order of their middles decides. Triangles with a corner that is not finite, or not one of the
// points, are left out.
void add_surfaces(const Scene& scene, const View& view, Mesh& mesh);

}  // namespace pmreport::scene
