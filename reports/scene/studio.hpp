// Takes pictures one after the other on a thread of its own. An OpenGL context belongs to one thread; shaders compile there while the
// caller still computes, and a picture is compressed, and drawn as vectors, while the next one is rendered.
#pragma once

#include <reports/scene/scene.hpp>

#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <mutex>
#include <thread>
#include <vector>

namespace pmreport::scene {

struct Prints {  // of one picture
  std::string png;
  std::string pdf, svg;  // vectors, as wide as it is printed
};

class Studio {
 public:
  Studio();
  ~Studio();  // drops what is still queued

  // Sets the renderer up, if pictures are to come: context and shaders take as long as a picture.
  void prepare();

  // The picture; `id` and `title` are those of the SVG. The future throws what render() throws.
  std::future<Prints> take(Scene scene, const Camera& camera, const Quality& quality, const std::string& id, const std::string& title);

 private:
  void work();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> queue_;
  bool closing_ = false;
  std::vector<std::future<void>> encoders_;  // of the working thread
  std::thread thread_;                       // last: it uses all of the above
};

}  // namespace pmreport::scene
