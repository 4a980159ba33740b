#include <fmt/core.h>

#include <reports/scene/gl_objects.hpp>
#include <stdexcept>
#include <string>

namespace pmreport::scene {

namespace {

GLuint compile(GLenum kind, const char* source) {
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint done = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
  if (done != GL_TRUE) {
    std::string words(2000, '\0');
    GLsizei length = 0;
    glGetShaderInfoLog(shader, static_cast<GLsizei>(words.size()), &length, words.data());
    words.resize(static_cast<std::size_t>(length));
    glDeleteShader(shader);
    throw std::runtime_error("no picture can be drawn: OpenGL refuses a shader: " + words);
  }
  return shader;
}

}  // namespace

Program::Program(const char* vertex, const char* fragment) : name_(glCreateProgram()) {
  for (const auto& [kind, source] : {std::pair{GL_VERTEX_SHADER, vertex}, std::pair{GL_FRAGMENT_SHADER, fragment}}) {
    const GLuint shader = compile(static_cast<GLenum>(kind), source);
    glAttachShader(name_, shader);
    glDeleteShader(shader);
  }
  glLinkProgram(name_);
  GLint done = 0;
  glGetProgramiv(name_, GL_LINK_STATUS, &done);
  if (done != GL_TRUE) throw std::runtime_error("no picture can be drawn: OpenGL cannot link a program");
}

void require_complete(const char* what) {
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE)
    throw std::runtime_error(fmt::format("no picture can be drawn: OpenGL cannot draw to {} (status 0x{:04x})", what, status));
}

}  // namespace pmreport::scene
