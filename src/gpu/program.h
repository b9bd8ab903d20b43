#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "core/result.h"
#include "gpu/gl_context.h"
#include "gpu/gl_objects.h"

namespace dimline {

struct ProgramKind {
  static GLuint make() { return glCreateProgram(); }
  static void destroy(GLuint id) { glDeleteProgram(id); }
};

/// A linked pair of shaders. Construction only starts the compiler; drivers that can compile several programs at the same time, so make all
/// of them first and ask for status() after, the later the better: the first question about a program waits for all that the driver was told before. So ask
/// before anything is drawn; a browser asks by itself when a program is first used. The one uniform block that a program has is at binding point 0.
class Program {
 public:
  /// The texts of each stage are joined in order, behind the version line, the precision and `defines` ("#define A 1\n#define B 2\n").
  /// `label` names the program in errors.
  struct Source {
    std::string_view label;
    std::initializer_list<std::string_view> vertex;
    std::initializer_list<std::string_view> fragment;
    std::string_view defines = {};
  };

  Program() = default;
  Program(const GlContext& context, const Source& source);

  /// Waits for the compiler. The error holds its log, with lines counted in the joined text from its first.
  [[nodiscard]] Status status();

  void use() const { glUseProgram(program_.id()); }
  /// -1, which GL ignores, when the program has no such uniform. Slow: ask once, not per frame.
  [[nodiscard]] GLint uniform(const char* name) const { return glGetUniformLocation(program_.id(), name); }
  /// Ties a sampler to a texture unit for good. Makes the program current.
  void bindSampler(const char* name, int unit) const;

  [[nodiscard]] GLuint id() const { return program_.id(); }
  explicit operator bool() const { return static_cast<bool>(program_); }

 private:
  GlObject<ProgramKind> program_;
  GLuint vertex_ = 0;   ///< deleted as soon as they are linked; the numbers are kept for their logs until status()
  GLuint fragment_ = 0;
  std::string label_;
};

}  // namespace dimline
