#include <reports/scene/labels.hpp>
#include <reports/scene/renderer.hpp>

namespace pmreport::scene {

// A context takes longer to make than a picture to draw, and belongs to one thread: each thread keeps its own.
Image render(const Scene& scene, const Camera& camera, const Quality& quality) {
  thread_local Renderer renderer;
  Image image = renderer.draw(scene, camera, quality);
  draw_labels(image, scene, camera, quality);
  return image;
}

}  // namespace pmreport::scene
