// An OpenGL 3.3 core context without a screen. All that is Mesa's own is in offscreen.cpp: another way to a context (EGL without a surface)
// would change that file alone.
#pragma once

#include <memory>

namespace pmreport::scene {

// Belongs to the thread that made it, and is current there until another one is. Throws std::runtime_error where there is no such context.
class OffscreenContext {
 public:
  OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;
  ~OffscreenContext();
  void make_current() const;

 private:
  struct Handle;
  std::unique_ptr<Handle> handle_;
};

}  // namespace pmreport::scene
