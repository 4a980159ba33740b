// Labels written over a finished picture.
#pragma once

#include <reports/scene/scene.hpp>

namespace pmreport::scene {

void draw_labels(Image& image, const Scene& scene, const Camera& camera);

}  // namespace pmreport::scene
