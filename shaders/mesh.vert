#version 450 core
#include "frame.glsl"

layout(location = 0) in vec3 position;  // world
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 color;  // sRGB, share that is selected

out Corner {
  vec3 inView;
  vec3 normal;
  vec3 albedo;
} result;

out float gl_ClipDistance[1];

void main() {
  result.inView = frame.viewFromWorld * (position - frame.eye);
  result.normal = frame.viewFromWorld * normal;
  result.albedo = albedoOf(color);
  gl_ClipDistance[0] = result.inView.z - frame.nearDepth;
  // w is what perspective divides by; depth is written by the fragment shader.
  float w = frame.isPerspective != 0 ? result.inView.z : 1;
  vec2 px = frame.principalPx * w + frame.focalPx * result.inView.xy;
  gl_Position = vec4(2 * px / frame.sizePx - w, 0, w);
}
