#include <reports/scene/studio.hpp>

#include <reports/scene/vector/drawing.hpp>

#include <memory>
#include <utility>

namespace pmreport::scene {

Studio::Studio() : thread_([this] { work(); }) {}

void Studio::prepare() {
  // Drawn once, small, for the sake of the shaders: each kind of surface that pictures have. A failure shows again with the first picture.
  Scene scene;
  Solid solid{};
  solid.kind = Solid::Kind::cylinder;
  solid.b = {0, 0, 1};
  solid.radius = 0.1;
  solid.color = {0.5F, 0.5F, 0.5F};
  scene.solids.push_back(solid);
  solid.through = 0.5F;
  scene.solids.push_back(solid);
  Polyline line{};
  line.points = {{0, 0, 0}, {1, 0, 0}};
  line.color = {0, 0, 0};
  line.width = 2;
  scene.lines.push_back(line);
  line.through = 0.5F;
  scene.lines.push_back(line);
  Camera camera;
  camera.elevation = 0.5;
  (void)take(std::move(scene), camera, {64, 48, false, 2}, "", "");
}

Studio::~Studio() {
  {
    const std::scoped_lock lock(mutex_);
    closing_ = true;
    queue_.clear();
  }
  changed_.notify_one();
  thread_.join();
}

std::future<Prints> Studio::take(Scene scene, const Camera& camera, const Quality& quality, const std::string& id,
                                 const std::string& title) {
  const auto promise = std::make_shared<std::promise<Prints>>();
  std::future<Prints> prints = promise->get_future();
  auto job = [this, promise, scene = std::move(scene), camera, quality, id, title]() mutable {
    try {
      Image image = render(scene, camera, quality);
      encoders_.push_back(
          std::async(std::launch::async, [promise, image = std::move(image), scene = std::move(scene), camera, quality, id, title] {
            try {
              const Drawing drawing = draw(scene, camera, quality);
              promise->set_value({to_png(image), to_pdf(drawing), to_svg(drawing, id, title)});
            } catch (...) {
              promise->set_exception(std::current_exception());
            }
          }));
    } catch (...) {
      promise->set_exception(std::current_exception());
    }
  };
  {
    const std::scoped_lock lock(mutex_);
    queue_.emplace_back(std::move(job));
  }
  changed_.notify_one();
  return prints;
}

void Studio::work() {
  while (true) {
    std::function<void()> job;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [this] { return closing_ || !queue_.empty(); });
      if (closing_) break;
      job = std::move(queue_.front());
      queue_.pop_front();
    }
    job();
  }
  for (const std::future<void>& encoder : encoders_) encoder.wait();
}

}  // namespace pmreport::scene
