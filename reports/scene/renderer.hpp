// Draws meshes into pictures, tile by tile: the supersampled and multisampled frame of a whole picture would take hundreds of MiB.
#pragma once

#include <reports/scene/gl_objects.hpp>
#include <reports/scene/mesh/mesh.hpp>
#include <reports/scene/offscreen.hpp>

namespace pmreport::scene {

class Renderer {
 public:
  explicit Renderer(int tile = 400);  // [px] of a tile's side, supersampled
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;
  ~Renderer() { context_.make_current(); }  // its objects are deleted there
  Image draw(const Scene& scene, const Camera& camera, const Quality& quality);

 private:
  struct Frame;  // what is fixed for one picture
  void upload(const Mesh& mesh);
  void cast_shadow(const Frame& frame);
  void blur(const Texture& from, const Texture& to, int scale, const Eigen::Vector2i& stride, double above);
  void set_view(const Program& program, const Frame& frame);
  bool draw_tile(const Frame& frame, int x, int y, int width, int height);
  void develop(bool any, int x, int y, int width, int height, Image& image);

  int tile_;
  OffscreenContext context_;  // first of all that needs it, so that it goes last
  Program solid_, surface_, plain_, cast_, blur_, develop_;
  VertexArray vertices_, nothing_;
  Buffer vertex_data_, index_data_;
  Texture samples_, heights_, shade_a_, shade_b_, developed_;
  Renderbuffer depth_, heights_depth_;
  Framebuffer sampled_, casting_, blurring_, developing_;
};

}  // namespace pmreport::scene
