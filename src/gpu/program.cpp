#include "gpu/program.h"

namespace dimline {

namespace {

constexpr std::string_view kPrefix =
    "#version 300 es\n"
    "precision highp float;\nprecision highp int;\nprecision highp sampler3D;\nprecision highp sampler2DShadow;\n"
    "precision highp usampler2D;\n";

GLuint compile(GLenum stage, std::string_view defines, std::initializer_list<std::string_view> texts) {
  std::string joined(kPrefix);
  joined += defines;
  joined += "#line 1\n";
  for (const std::string_view text : texts) joined += text;
  const GLuint shader = glCreateShader(stage);
  const char* const pointer = joined.data();
  const GLint length = static_cast<GLint>(joined.size());
  glShaderSource(shader, 1, &pointer, &length);
  glCompileShader(shader);
  return shader;
}

std::string shaderLog(GLuint shader) {
  GLint length = 0;
  glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length > 0 ? length : 0), '\0');
  if (length > 0) glGetShaderInfoLog(shader, length, nullptr, log.data());
  while (!log.empty() && (log.back() == '\0' || log.back() == '\n')) log.pop_back();
  return log;
}

std::string programLog(GLuint program) {
  GLint length = 0;
  glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length > 0 ? length : 0), '\0');
  if (length > 0) glGetProgramInfoLog(program, length, nullptr, log.data());
  while (!log.empty() && (log.back() == '\0' || log.back() == '\n')) log.pop_back();
  return log;
}

}  // namespace

Program::Program(const GlContext& context, const Source& source) : program_(context), label_(source.label) {
  vertex_ = compile(GL_VERTEX_SHADER, source.defines, source.vertex);
  fragment_ = compile(GL_FRAGMENT_SHADER, source.defines, source.fragment);
  glAttachShader(program_.id(), vertex_);
  glAttachShader(program_.id(), fragment_);
  glLinkProgram(program_.id());
  // Flagged only: they live on until the program that they are attached to goes.
  glDeleteShader(vertex_);
  glDeleteShader(fragment_);
}

Status Program::status() {
  GLint linked = 0;
  glGetProgramiv(program_.id(), GL_LINK_STATUS, &linked);
  if (linked != 0) return okStatus();
  for (const GLuint shader : {vertex_, fragment_}) {
    GLint compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled == 0) {
      return Error{"The " + std::string(shader == vertex_ ? "vertex" : "fragment") + " shader of \"" + label_ +
                   "\" does not compile on this graphics driver: " + shaderLog(shader)};
    }
  }
  return Error{"The shaders of \"" + label_ + "\" do not link on this graphics driver: " + programLog(program_.id())};
}

void Program::bindSampler(const char* name, int unit) const {
  use();
  glUniform1i(uniform(name), unit);
}

}  // namespace dimline
