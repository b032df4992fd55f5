#version 450 core
// From the mean of frames (linear, premultiplied) to sRGB with straight alpha, over the background.
#include "frame.glsl"

layout(binding = 0) uniform sampler2D mean;

layout(location = 0) out vec4 result;

vec3 srgbFromLinear(vec3 l) {
  l = clamp(l, 0, 1);
  return mix(1.055 * pow(l, vec3(1 / 2.4)) - 0.055, 12.92 * l, lessThanEqual(l, vec3(0.0031308)));
}

void main() {
  vec4 front = texelFetch(mean, ivec2(gl_FragCoord.xy), 0);
  vec4 over = front + (1 - front.a) * vec4(frame.background.rgb * frame.background.a, frame.background.a);
  result = vec4(over.a > 0 ? srgbFromLinear(over.rgb / over.a) : vec3(0), over.a);
}
