// How a solid is filled in a vector drawing.
#pragma once

#include <reports/scene/vector/drawing.hpp>

namespace pmreport::scene {

Color lit(const Color& color, const Eigen::Vector3d& normal);  // normal: right, up, towards the viewer
inline Eigen::Vector2d on_page(const Eigen::Vector3d& p) { return {p.x(), -p.y()}; }
Paint flat(const Color& color);
// The visible region of a solid, side by side: the largest side under the others.
std::vector<Area> shaded(const Solid& solid, const Seen& seen, const View& view, Manner manner);
// A translucent surface without what solids hide of it: the layers turned away and towards the viewer, each in a few tones.
std::vector<Layer> shaded(const Surface& surface, const std::vector<Seen>& solids, const View& view, int width, int height);

}  // namespace pmreport::scene
