#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <core/numbers.hpp>
#include <reports/scene/renderer.hpp>
#include <reports/scene/shaders.hpp>
#include <stdexcept>

namespace pmreport::scene {

namespace {

constexpr int samples_per_pixel = 4;
constexpr int heights_size = 1024, shade_size = 512;  // [px] of the shadow maps
constexpr double outline_width = 1.1;                 // [px]
constexpr double ghost_outline = 0.4;                 // opacity
const Eigen::Vector4f outline_ink(0.012f, 0.016f, 0.024f, 1), no_ink(0, 0, 0, 0);

void texture_2d(const Texture& texture, GLint format, int size, GLenum layout, GLenum type, GLint filter) {
  glBindTexture(GL_TEXTURE_2D, *texture);
  glTexImage2D(GL_TEXTURE_2D, 0, format, size, size, 0, layout, type, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

}  // namespace

// The shadow falls along one direction s, towards the light, down to the ground z = g: a point p falls on p - s (p_z - g) / s_z. Where it
// falls, scaled into the shadow map, and its height above ground are affine in p, and p is affine in what the view sees.
struct Renderer::Frame {
  const Scene& scene;
  const Quality& quality;
  View view;
  const Mesh& mesh;
  Eigen::Matrix4f to_light = Eigen::Matrix4f::Identity();  // view [px] -> shadow map [0, 1]^2, height above ground [m]
  Eigen::Vector4f to_shade = Eigen::Vector4f::Zero();      // ground [m] -> shadow map: factor, offset
  double top = 1;                                          // greatest height above ground [m]
  double half = 1;                                         // side of the shadow map / 2 [m]
  float near = 1, far = 0;
  Eigen::Vector2f middle{0, 0};
  double fade_radius = 1;

  Frame(const Scene& scene, const Camera& camera, const Quality& quality, const View& view, const Mesh& mesh);
};

Renderer::Frame::Frame(const Scene& s, const Camera& camera, const Quality& q, const View& v, const Mesh& m)
    : scene(s), quality(q), view(v), mesh(m) {
  for (const Part& p : mesh.parts) near = std::max(near, p.near + 4), far = std::min(far, p.far - 4);
  fade_radius = 0.60 * camera.height * std::max(1.0, double(quality.width) / quality.height);
  middle = camera.target.head<2>().cast<float>();

  // High, from the left of the viewer's shoulder.
  const Eigen::Vector3d aside(-view.right().y(), view.right().x(), 0);  // horizontal, away from the viewer
  const Eigen::Vector3d light = Eigen::Vector3d(Eigen::Vector3d::UnitZ() - 0.30 * view.right() - 0.16 * aside);
  Eigen::Matrix4d fall = Eigen::Matrix4d::Identity();
  fall.block<2, 1>(0, 2) = -light.head<2>();
  fall.block<2, 1>(0, 3) = scene.ground * light.head<2>();
  fall(2, 3) = -scene.ground;
  Eigen::Matrix4d seen_to_world = Eigen::Matrix4d::Identity();
  seen_to_world.block<3, 1>(0, 3) = view.world(Eigen::Vector3d::Zero());
  for (int k = 0; k < 3; ++k) seen_to_world.block<3, 1>(0, k) = view.world(Eigen::Vector3d::Unit(k)) - view.world(Eigen::Vector3d::Zero());
  const Eigen::Matrix4d to_ground = fall * seen_to_world;

  Eigen::Vector3d low = Eigen::Vector3d::Constant(infinity), high = -low;
  for (std::size_t k = 0; k < mesh.shadow_vertices; ++k) {
    const Vertex& x = mesh.vertices[k];
    const Eigen::Vector4d p(x.position[0], x.position[1], x.position[2], 1);
    const Eigen::Vector3d g = (to_ground * p).head<3>();
    low = low.cwiseMin(g), high = high.cwiseMax(g);
  }
  if (mesh.shadow_vertices == 0) low.setZero(), high.setOnes();
  top = std::max(high.z(), 1e-9) * 1.001;
  half = 0.56 * std::max({high.x() - low.x(), high.y() - low.y(), 1e-9});  // a rim for the blur
  const Eigen::Vector2d centre = (low + high).head<2>() / 2;
  Eigen::Matrix4d to_map = Eigen::Matrix4d::Identity();
  to_map(0, 0) = to_map(1, 1) = 0.5 / half;
  to_map(0, 3) = 0.5 - 0.5 * centre.x() / half;
  to_map(1, 3) = 0.5 - 0.5 * centre.y() / half;
  to_light = (to_map * to_ground).cast<float>();
  to_shade << float(to_map(0, 0)), float(to_map(1, 1)), float(to_map(0, 3)), float(to_map(1, 3));
}

Renderer::Renderer(int tile)
    : tile_(tile),
      solid_(shaders::solid_vertex, shaders::solid_fragment),
      surface_(shaders::solid_vertex, shaders::surface_fragment),
      plain_(shaders::solid_vertex, shaders::plain_fragment),
      cast_(shaders::cast_vertex, shaders::cast_fragment),
      blur_(shaders::whole_vertex, shaders::blur_fragment),
      develop_(shaders::whole_vertex, shaders::develop_fragment) {
  GLint most = 0;
  glGetIntegerv(GL_MAX_SAMPLES, &most);
  if (most < samples_per_pixel)
    throw std::runtime_error(
        fmt::format("no picture can be drawn: OpenGL offers {} samples a pixel, {} are needed", most, samples_per_pixel));

  glBindVertexArray(*vertices_);
  glBindBuffer(GL_ARRAY_BUFFER, *vertex_data_);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, *index_data_);
  const auto offset = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), offset(offsetof(Vertex, position)));
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), offset(offsetof(Vertex, normal)));
  glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(Vertex), offset(offsetof(Vertex, color)));
  for (GLuint k = 0; k < 3; ++k) glEnableVertexAttribArray(k);

  glBindFramebuffer(GL_FRAMEBUFFER, *sampled_);
  glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, *samples_);
  glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples_per_pixel, GL_RGBA8, tile_, tile_, GL_TRUE);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D_MULTISAMPLE, *samples_, 0);
  glBindRenderbuffer(GL_RENDERBUFFER, *depth_);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples_per_pixel, GL_DEPTH_COMPONENT24, tile_, tile_);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, *depth_);
  require_complete("a multisampled tile");

  texture_2d(heights_, GL_R32F, heights_size, GL_RED, GL_FLOAT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, *casting_);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, *heights_, 0);
  glBindRenderbuffer(GL_RENDERBUFFER, *heights_depth_);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, heights_size, heights_size);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, *heights_depth_);
  require_complete("a shadow map");

  for (const Texture* t : {&shade_a_, &shade_b_}) texture_2d(*t, GL_R8, shade_size, GL_RED, GL_UNSIGNED_BYTE, GL_LINEAR);
  texture_2d(developed_, GL_SRGB8_ALPHA8, tile_, GL_RGBA, GL_UNSIGNED_BYTE, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, *developing_);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, *developed_, 0);
  require_complete("a finished tile");
}

void Renderer::upload(const Mesh& mesh) {
  glBindVertexArray(*vertices_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(Vertex)), mesh.vertices.data(), GL_STREAM_DRAW);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(std::uint32_t)), mesh.indices.data(),
               GL_STREAM_DRAW);
}

void Renderer::blur(const Texture& from, const Texture& to, int scale, const Eigen::Vector2i& stride, double above) {
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, *to, 0);
  require_complete("a soft shadow");
  glBindTexture(GL_TEXTURE_2D, *from);
  blur_.set("scale", scale);
  blur_.set("stride", stride);
  blur_.set("above", above);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Renderer::cast_shadow(const Frame& frame) {
  glBindFramebuffer(GL_FRAMEBUFFER, *casting_);
  glViewport(0, 0, heights_size, heights_size);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  cast_.use();
  cast_.set("to_light", frame.to_light);
  cast_.set("top", frame.top);
  glBindVertexArray(*vertices_);
  for (const Part& p : frame.mesh.parts)
    if (p.kind == Part::Kind::solid && !(p.through > 0))
      glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(p.count), GL_UNSIGNED_INT,
                     reinterpret_cast<const void*>(p.first * sizeof(std::uint32_t)));

  glDisable(GL_DEPTH_TEST);
  glBindVertexArray(*nothing_);
  glActiveTexture(GL_TEXTURE0);
  glBindFramebuffer(GL_FRAMEBUFFER, *blurring_);
  glViewport(0, 0, shade_size, shade_size);
  blur_.use();
  blur_.set("source", 0);
  blur_.set("size", shade_size);
  blur(heights_, shade_a_, heights_size / shade_size, {2, 0}, 1e-6 * frame.top);
  blur(shade_a_, shade_b_, 1, {0, 2}, -1);
}

void Renderer::set_view(const Program& program, const Frame& frame) {
  const Quality& q = frame.quality;
  program.use();
  program.set("size", Eigen::Vector2f(float(q.width * q.supersample), float(q.height * q.supersample)));
  program.set("depth", Eigen::Vector2f(frame.far, 1 / (frame.near - frame.far)));
  program.set("supersample", double(q.supersample));
  program.set("to_light", frame.to_light);
  program.set("outline", 0.0);
}

// Of the tile now drawn: the parts that can touch it, solids and opaque surfaces first, then lines and outlines, then ghosts, then
// translucent surfaces, then what shows through. Of ghosts the depths come first, so that only the nearest surface of all of them tints
// what is behind.
bool Renderer::draw_tile(const Frame& frame, int x, int y, int width, int height) {
  const int s = frame.quality.supersample;
  std::vector<const Part*> here;
  for (const Part& p : frame.mesh.parts)
    if (p.right + 3 >= float(x) && p.left - 3 <= float(x + width) && p.bottom + 3 >= float(y) && p.top - 3 <= float(y + height))
      here.push_back(&p);
  if (here.empty()) return false;

  glBindFramebuffer(GL_FRAMEBUFFER, *sampled_);
  // The viewport is the whole picture's, moved: a tile differs from the picture by nothing but an offset of whole pixels.
  glViewport(-x * s, -y * s, frame.quality.width * s, frame.quality.height * s);
  glEnable(GL_MULTISAMPLE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glBindVertexArray(*vertices_);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, *heights_);
  glFrontFace(GL_CW);  // rows run from the top down, which mirrors every triangle
  const auto draw = [](const Part& p) {
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(p.count), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(p.first * sizeof(std::uint32_t)));
  };
  const auto each = [&](Part::Kind kind) {
    for (const Part* p : here)
      if (p->kind == kind) draw(*p);
  };
  solid_.use();
  each(Part::Kind::solid);
  surface_.use();
  each(Part::Kind::surface);

  plain_.use();
  plain_.set("opacity", 1.0);
  plain_.set("ink", no_ink);
  each(Part::Kind::line);
  glEnable(GL_CULL_FACE);
  glCullFace(GL_FRONT);
  plain_.set("outline", outline_width);
  plain_.set("ink", outline_ink);
  each(Part::Kind::solid);
  glDisable(GL_CULL_FACE);

  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  if (std::ranges::any_of(here, [](const Part* p) { return p->kind == Part::Kind::ghost; })) {
    solid_.use();
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    each(Part::Kind::ghost);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    each(Part::Kind::ghost);
    glDepthFunc(GL_LESS);
    glEnable(GL_CULL_FACE);
    plain_.use();
    plain_.set("opacity", ghost_outline);
    each(Part::Kind::ghost);
    glDisable(GL_CULL_FACE);
  }

  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  surface_.use();
  each(Part::Kind::film);

  glDepthFunc(GL_GREATER);
  plain_.use();
  plain_.set("outline", 0.0);
  plain_.set("ink", no_ink);
  for (const Part* p : here)
    if (p->through > 0) {
      plain_.set("opacity", double(p->through));
      draw(*p);
    }
  glDisable(GL_BLEND);
  return true;
}

void Renderer::develop(bool any, int x, int y, int width, int height, Image& image) {
  glBindFramebuffer(GL_FRAMEBUFFER, *developing_);
  glViewport(0, 0, width, height);
  glDisable(GL_DEPTH_TEST);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, *shade_b_);
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, *samples_);
  develop_.use();
  develop_.set("any", any ? 1 : 0);
  develop_.set("origin", Eigen::Vector2f(float(x), float(y)));
  glBindVertexArray(*nothing_);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glPixelStorei(GL_PACK_ROW_LENGTH, image.width);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE,
               image.rgba.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)));
}

Image Renderer::draw(const Scene& scene, const Camera& camera, const Quality& quality) {
  context_.make_current();
  const int s = quality.supersample;
  GLint most = 0;
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
  if (quality.width < 1 || quality.height < 1 || s < 1 || s > tile_ || quality.width > most / s || quality.height > most / s)
    throw std::runtime_error(fmt::format("no picture of {} x {} pixels, supersampled {} times: OpenGL draws from 1 to {} samples a side",
                                         quality.width, quality.height, s, most));
  const View view(camera, quality.width, quality.height);
  const Mesh mesh = tessellate(scene, view);
  const Frame frame(scene, camera, quality, view, mesh);
  upload(mesh);
  cast_shadow(frame);

  glEnable(GL_FRAMEBUFFER_SRGB);
  set_view(plain_, frame);
  const Eigen::Vector3f up = view.turn(Eigen::Vector3d::UnitZ()).cast<float>();
  set_view(surface_, frame);
  surface_.set("up", up);
  set_view(solid_, frame);
  solid_.set("up", up);
  solid_.set("heights", 0);
  solid_.set("map_size", double(heights_size));
  solid_.set("shade_bias", 0.012 * frame.half);
  solid_.set("shade_reach", 3.0);

  // The ground under pixel (x, y): along the line of sight, whose direction has the vertical component `steep`.
  const double steep = view.towards().z();
  const auto ground_at = [&](double x, double y) {
    const Eigen::Vector3d p = view.world({x, y, 0});
    return Eigen::Vector2d((p - view.towards() * ((p.z() - scene.ground) / steep)).head<2>());
  };
  develop_.use();
  develop_.set("samples", 1);
  develop_.set("shade", 0);
  develop_.set("supersample", s);
  develop_.set(
      "films",
      std::ranges::any_of(mesh.parts, [](const Part& p) { return p.kind == Part::Kind::film || p.kind == Part::Kind::ghost; }) ? 1 : 0);
  develop_.set("background", quality.transparent ? Eigen::Vector4f(0, 0, 0, 0) : Eigen::Vector4f(1, 1, 1, 1));
  constexpr double edge_on = 0.02;
  if (steep > edge_on) {
    const Eigen::Vector2d place = ground_at(0, 0);
    develop_.set("ground", 1);
    develop_.set("place", Eigen::Vector2f(place.cast<float>()));
    develop_.set("place_x", Eigen::Vector2f((ground_at(1, 0) - place).cast<float>()));
    develop_.set("place_y", Eigen::Vector2f((ground_at(0, 1) - place).cast<float>()));
    develop_.set("middle", frame.middle);
    develop_.set("fade_radius", frame.fade_radius);
  } else {
    const Eigen::Vector3d foot = view.see({camera.target.x(), camera.target.y(), scene.ground});
    develop_.set("ground", steep > -edge_on ? 2 : 0);
    develop_.set("middle", Eigen::Vector2f(float(foot.x()), 0));
    develop_.set("horizon", foot.y());
    develop_.set("fade_radius", frame.fade_radius * view.scale());
  }
  develop_.set("grid", scene.grid);
  develop_.set("to_shade", frame.to_shade);

  Image image{quality.width, quality.height, {}};
  image.rgba.resize(4 * static_cast<std::size_t>(quality.width) * static_cast<std::size_t>(quality.height));
  const int side = tile_ / s;
  for (int y = 0; y < quality.height; y += side)
    for (int x = 0; x < quality.width; x += side) {
      const int width = std::min(side, quality.width - x), height = std::min(side, quality.height - y);
      develop(draw_tile(frame, x, y, width, height), x, y, width, height, image);
    }
  glDisable(GL_FRAMEBUFFER_SRGB);
  if (const GLenum error = glGetError(); error != GL_NO_ERROR)
    throw std::runtime_error(fmt::format("the picture could not be drawn: OpenGL reports {}", error == GL_OUT_OF_MEMORY
                                                                                                  ? std::string("that memory ran out")
                                                                                                  : fmt::format("error 0x{:04x}", error)));
  return image;
}

}  // namespace pmreport::scene
