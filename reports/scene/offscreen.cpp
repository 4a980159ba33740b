#include <reports/scene/gl.hpp>
#include <reports/scene/offscreen.hpp>

#define __gl_h_  // osmesa.h would pull in the old gl.h
#define GLAPIENTRY APIENTRY
#include <GL/osmesa.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <mutex>
#include <stdexcept>
#include <string>

namespace pmreport::scene {

struct OffscreenContext::Handle {
  OSMesaContext context = nullptr;
  std::array<std::uint32_t, 16> pixels{};  // Mesa wants a buffer of its own; pictures are drawn elsewhere
  ~Handle() {
    if (context != nullptr) OSMesaDestroyContext(context);
  }
};

OffscreenContext::OffscreenContext() : handle_(std::make_unique<Handle>()) {
  // Mesa would write its shader cache into the user's home; and it crashes at vector widths that a user may have asked for.
  static std::once_flag environment;
  std::call_once(environment, [] {
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
    unsetenv("LP_NATIVE_VECTOR_WIDTH");
  });
  constexpr int attributes[] = {
      OSMESA_FORMAT, OSMESA_RGBA, OSMESA_PROFILE, OSMESA_CORE_PROFILE, OSMESA_CONTEXT_MAJOR_VERSION, 3, OSMESA_CONTEXT_MINOR_VERSION, 3, 0};
  handle_->context = OSMesaCreateContextAttribs(attributes, nullptr);
  if (handle_->context == nullptr) throw std::runtime_error("no picture can be drawn: OSMesa gives no OpenGL 3.3 core context");
  make_current();
}

OffscreenContext::~OffscreenContext() = default;

void OffscreenContext::make_current() const {
  if (OSMesaMakeCurrent(handle_->context, handle_->pixels.data(), GL_UNSIGNED_BYTE, 4, 4) != GL_TRUE)
    throw std::runtime_error("no picture can be drawn: OSMesa cannot make its OpenGL context current");
}

}  // namespace pmreport::scene
