// Takes pictures one after the other on a thread of its own. An OpenGL context belongs to one thread; shaders compile there while the
// caller still computes, and a picture is compressed while the next one is drawn.
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

class Studio {
 public:
  Studio();
  ~Studio();  // drops what is still queued

  // Sets the renderer up, if pictures are to come: context and shaders take as long as a picture.
  void prepare();

  // The PNG of a picture. The future throws what render() throws.
  std::future<std::string> take(Scene scene, const Camera& camera, const Quality& quality);

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
