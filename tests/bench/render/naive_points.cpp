#include "tests/bench/render/naive_points.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>

#include "core/error.h"
#include "render/appearance/light.h"

namespace stipple {

namespace {

// Polynomials in place of powers: within 1/255 of the sRGB curve, and several times faster in software.
constexpr const char* kVertexShader = R"(#version 450 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 color;
uniform mat4 clipFromWorld;
uniform vec3 eye;
uniform vec3 key;  // world
uniform vec3 forward;
uniform vec3 light;  // ambient, diffuse, at the viewer
flat out vec4 shaded;
void main() {
  gl_Position = clipFromWorld * vec4(position, 1);
  float turned = dot(normal, position - eye) > 0 ? -1 : 1;
  vec3 n = turned * normal;
  float intensity = light.x + light.y * max(dot(n, key), 0) + light.z * max(-dot(n, forward), 0);
  vec3 albedo = color.rgb * (color.rgb * (color.rgb * 0.305306011 + 0.682171111) + 0.012522878);
  vec3 l = albedo * intensity, a = sqrt(l), b = sqrt(a), c = sqrt(b);
  shaded = vec4(0.662002687 * a + 0.684122060 * b - 0.323583601 * c - 0.0225411470 * l, 1);
}
)";

constexpr const char* kFragmentShader = R"(#version 450 core
flat in vec4 shaded;
out vec4 pixel;
void main() { pixel = shaded; }
)";

/// The shader above repeats light::shade: a baseline in another light would lose decibels for nothing.
void requireSameLight() {
  for (const glm::vec3& direction : {glm::vec3(0, 0, -1), glm::vec3(-1, -2, -2), glm::vec3(2, -1, -1)}) {
    const glm::vec3 n = glm::normalize(direction);
    const float here = light::kAmbient + light::kDiffuse * std::max(glm::dot(n, light::kKey), 0.f) +
                       light::kHead * std::max(-n.z, 0.f);
    if (std::abs(here - light::shade(n)) > 1e-5f)
      throw IoError("naive points are lit by another model than ours");
  }
}

struct Vertex {
  Eigen::Vector3f position, normal;
  Rgba8 color;
};
static_assert(sizeof(Vertex) == 28);

GLuint compile(GLenum kind, const char* source) {
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint isCompiled = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &isCompiled);
  std::array<char, 1024> log{};
  glGetShaderInfoLog(shader, log.size(), nullptr, log.data());
  if (!isCompiled) throw IoError(std::string("shader of naive points: ") + log.data());
  return shader;
}

GLuint linkProgram() {
  const GLuint program = glCreateProgram();
  for (const GLuint shader :
       {compile(GL_VERTEX_SHADER, kVertexShader), compile(GL_FRAGMENT_SHADER, kFragmentShader)}) {
    glAttachShader(program, shader);
    glDeleteShader(shader);
  }
  glLinkProgram(program);
  return program;
}

glm::mat4 clipFromWorld(const View& view) {
  const float w = 0.5f * static_cast<float>(view.width), h = 0.5f * static_cast<float>(view.height);
  // Depth from 1/100 of the focal distance of the scene on; y from the bottom.
  const float nearest = view.isPerspective() ? 0.01f * glm::length(view.eye) : 0.f;
  const float farthest = 100 * glm::length(view.eye);
  glm::mat4 projection(0);
  projection[0][0] = view.focalPx / w;
  projection[1][1] = -view.focalPx / h;
  if (view.isPerspective()) {
    projection[2][2] = (farthest + nearest) / (farthest - nearest);
    projection[3][2] = -2 * farthest * nearest / (farthest - nearest);
    projection[2][3] = 1;
  } else {
    projection[2][2] = 2 / (farthest - nearest);
    projection[3][2] = -(farthest + nearest) / (farthest - nearest);
    projection[3][3] = 1;
  }
  glm::mat4 viewFromWorld(view.viewFromWorld);
  viewFromWorld[3] = glm::vec4(-(view.viewFromWorld * view.eye), 1);
  return projection * viewFromWorld;
}

}  // namespace

struct NaivePoints::Context {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  GLuint program = 0, frame = 0;
  std::array<GLuint, 2> targets{};
  int width = 0, height = 0;

  Context() {
    display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (!eglInitialize(display, nullptr, nullptr)) throw IoError("EGL has no display without surfaces");
    eglBindAPI(EGL_OPENGL_API);
    const std::array<EGLint, 7> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                           4,
                                           EGL_CONTEXT_MINOR_VERSION,
                                           5,
                                           EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                           EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                           EGL_NONE};
    context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
    if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
      throw IoError("EGL offers no OpenGL 4.5");
    program = linkProgram();
    glCreateFramebuffers(1, &frame);
    glCreateRenderbuffers(2, targets.data());
  }
  ~Context() {
    glDeleteFramebuffers(1, &frame);
    glDeleteRenderbuffers(2, targets.data());
    glDeleteProgram(program);
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context);
  }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  static std::shared_ptr<Context> shared() {
    static std::weak_ptr<Context> last;
    std::shared_ptr<Context> context = last.lock();
    if (!context) last = context = std::make_shared<Context>();
    return context;
  }

  void resize(int w, int h) {
    if (w == width && h == height) return;
    width = w;
    height = h;
    glNamedRenderbufferStorage(targets[0], GL_RGBA8, w, h);
    glNamedRenderbufferStorage(targets[1], GL_DEPTH_COMPONENT32F, w, h);
    glNamedFramebufferRenderbuffer(frame, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, targets[0]);
    glNamedFramebufferRenderbuffer(frame, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, targets[1]);
  }
};

struct NaivePoints::Buffer {
  GLuint vertices = 0, array = 0;
  GLsizei count = 0;

  explicit Buffer(const std::vector<Vertex>& points) : count(static_cast<GLsizei>(points.size())) {
    glCreateBuffers(1, &vertices);
    glNamedBufferStorage(vertices, static_cast<GLsizeiptr>(points.size() * sizeof(Vertex)), points.data(), 0);
    glCreateVertexArrays(1, &array);
    glVertexArrayVertexBuffer(array, 0, vertices, 0, sizeof(Vertex));
    glVertexArrayAttribFormat(array, 0, 3, GL_FLOAT, GL_FALSE, offsetof(Vertex, position));
    glVertexArrayAttribFormat(array, 1, 3, GL_FLOAT, GL_FALSE, offsetof(Vertex, normal));
    glVertexArrayAttribFormat(array, 2, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(Vertex, color));
    for (GLuint attribute = 0; attribute < 3; ++attribute) {
      glVertexArrayAttribBinding(array, attribute, 0);
      glEnableVertexArrayAttrib(array, attribute);
    }
  }
  ~Buffer() {
    glDeleteVertexArrays(1, &array);
    glDeleteBuffers(1, &vertices);
  }
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;
};

NaivePoints::NaivePoints(const scenes::SurfaceSamples& samples, std::span<const Index> order)
    : context_(Context::shared()) {
  requireSameLight();
  std::vector<Vertex> points(samples.positions.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t point = order.empty() ? i : order[i];
    points[i] = {samples.positions[point], samples.normals[point], samples.colors[point]};
  }
  buffer_ = std::make_unique<Buffer>(points);
}

NaivePoints::~NaivePoints() = default;

void NaivePoints::draw(const View& view, const Rgba8& background) {
  context_->resize(view.width, view.height);
  const GLuint program = context_->program;
  const glm::mat3 worldFromView = glm::transpose(view.viewFromWorld);
  const glm::vec3 key = worldFromView * light::kKey, forward = worldFromView[2];
  glBindFramebuffer(GL_FRAMEBUFFER, context_->frame);
  glViewport(0, 0, view.width, view.height);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glClearColor(background.r / 255.f, background.g / 255.f, background.b / 255.f, 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glUseProgram(program);
  glUniformMatrix4fv(glGetUniformLocation(program, "clipFromWorld"), 1, GL_FALSE,
                     glm::value_ptr(clipFromWorld(view)));
  glUniform3fv(glGetUniformLocation(program, "eye"), 1, glm::value_ptr(view.eye));
  glUniform3fv(glGetUniformLocation(program, "key"), 1, glm::value_ptr(key));
  glUniform3fv(glGetUniformLocation(program, "forward"), 1, glm::value_ptr(forward));
  glUniform3f(glGetUniformLocation(program, "light"), light::kAmbient, light::kDiffuse, light::kHead);
  glBindVertexArray(buffer_->array);
  glPointSize(1);
  glDrawArrays(GL_POINTS, 0, buffer_->count);
  glFinish();
}

DrawnPicture NaivePoints::picture() const {
  const int width = context_->width, height = context_->height;
  const std::size_t pixels = static_cast<std::size_t>(width) * height;
  std::vector<Rgba8> rows(pixels);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rows.data());
  DrawnPicture picture{{width, height, std::vector<Rgba8>(pixels)}, std::vector<float>(pixels)};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      Rgba8 pixel = rows[static_cast<std::size_t>(height - 1 - y) * width + x];
      picture.depth[static_cast<std::size_t>(y) * width + x] = pixel.a ? 0 : kNoDepth;
      pixel.a = 255;
      picture.image.at(x, y) = pixel;
    }
  }
  return picture;
}

std::string NaivePoints::device() const {
  const auto text = [](GLenum name) { return std::string(reinterpret_cast<const char*>(glGetString(name))); };
  return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

}  // namespace stipple
