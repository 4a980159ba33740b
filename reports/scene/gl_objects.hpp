// OpenGL's programs, textures, framebuffers and buffers as values that clean up after themselves. A context must be current.
#pragma once

#include <Eigen/Core>
#include <reports/scene/gl.hpp>
#include <utility>

namespace pmreport::scene {

template <auto make, auto drop>
class GlName {
 public:
  GlName() { make(1, &name_); }
  GlName(const GlName&) = delete;
  GlName& operator=(const GlName&) = delete;
  ~GlName() { drop(1, &name_); }
  GLuint operator*() const { return name_; }

 private:
  GLuint name_ = 0;
};
using Texture = GlName<glGenTextures, glDeleteTextures>;
using Renderbuffer = GlName<glGenRenderbuffers, glDeleteRenderbuffers>;
using Framebuffer = GlName<glGenFramebuffers, glDeleteFramebuffers>;
using VertexArray = GlName<glGenVertexArrays, glDeleteVertexArrays>;
using Buffer = GlName<glGenBuffers, glDeleteBuffers>;

// Throws std::runtime_error with the compiler's words.
class Program {
 public:
  Program(const char* vertex, const char* fragment);
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program() { glDeleteProgram(name_); }
  void use() const { glUseProgram(name_); }
  // Of the program in use.
  void set(const char* name, int x) const { glUniform1i(at(name), x); }
  void set(const char* name, double x) const { glUniform1f(at(name), static_cast<float>(x)); }
  void set(const char* name, const Eigen::Vector2i& x) const { glUniform2iv(at(name), 1, x.data()); }
  void set(const char* name, const Eigen::Vector2f& x) const { glUniform2fv(at(name), 1, x.data()); }
  void set(const char* name, const Eigen::Vector3f& x) const { glUniform3fv(at(name), 1, x.data()); }
  void set(const char* name, const Eigen::Vector4f& x) const { glUniform4fv(at(name), 1, x.data()); }
  void set(const char* name, const Eigen::Matrix4f& x) const { glUniformMatrix4fv(at(name), 1, GL_FALSE, x.data()); }

 private:
  GLint at(const char* name) const { return glGetUniformLocation(name_, name); }
  GLuint name_;
};

// Throws std::runtime_error when the framebuffer now bound cannot be drawn to.
void require_complete(const char* what);

}  // namespace pmreport::scene
