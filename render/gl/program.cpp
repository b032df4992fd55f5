#include "render/gl/program.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include "core/error.h"
#include "render/gl/shader_source.h"

namespace stipple::gl {

namespace {

void destroyShader(unsigned name) {
  glDeleteShader(name);
}
using Shader = ObjectName<destroyShader>;

std::string logOf(const Shader& shader) {
  GLint length = 0;
  glGetShaderiv(shader.get(), GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length), '\0');
  glGetShaderInfoLog(shader.get(), length, &length, log.data());
  log.resize(static_cast<std::size_t>(length));
  return log;
}

Shader compile(const std::filesystem::path& folder, const std::string& file, GLenum stage) {
  const ShaderSource source = readShader(folder, file);
  Shader shader(glCreateShader(stage));
  const char* text = source.text.c_str();
  glShaderSource(shader.get(), 1, &text, nullptr);
  glCompileShader(shader.get());
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader.get(), GL_COMPILE_STATUS, &compiled);
  if (!compiled) {
    throw IoError(fmt::format("the driver does not compile the shader {}: {}", (folder / file).string(),
                              nameFiles(logOf(shader), source.files)));
  }
  return shader;
}

}  // namespace

void destroyProgram(unsigned name) {
  glDeleteProgram(name);
}

Program::Program(const std::filesystem::path& folder, const std::string& vertex,
                 const std::string& fragment) {
  const Shader vertexShader = compile(folder, vertex, GL_VERTEX_SHADER);
  const Shader fragmentShader = compile(folder, fragment, GL_FRAGMENT_SHADER);
  name_ = ObjectName<destroyProgram>(glCreateProgram());
  for (const Shader* shader : {&vertexShader, &fragmentShader}) glAttachShader(name_.get(), shader->get());
  glLinkProgram(name_.get());
  for (const Shader* shader : {&vertexShader, &fragmentShader}) glDetachShader(name_.get(), shader->get());
  GLint linked = GL_FALSE;
  glGetProgramiv(name_.get(), GL_LINK_STATUS, &linked);
  if (linked) return;

  GLint length = 0;
  glGetProgramiv(name_.get(), GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length), '\0');
  glGetProgramInfoLog(name_.get(), length, &length, log.data());
  log.resize(static_cast<std::size_t>(length));
  throw IoError(fmt::format("the driver does not link the shaders {} and {}: {}", vertex, fragment, log));
}

void Program::use() const {
  glUseProgram(name_.get());
}

void Program::setUniform(int location, std::uint32_t value) {
  glProgramUniform1ui(name_.get(), location, value);
}

}  // namespace stipple::gl
