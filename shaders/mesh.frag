#version 450 core
// The nearest triangle of every pixel, as if one splat lay there.
#include "frame.glsl"

in Corner {
  vec3 inView;
  vec3 normal;
  vec3 albedo;
} corner;

layout(location = 0) out uvec4 visible;
layout(location = 1) out vec4 colorSum;
layout(location = 2) out vec4 normalSum;

void main() {
  vec3 normal = normalize(corner.normal);
  if (frame.isTwoSided != 0 && dot(normal, towardsEye(corner.inView)) < 0) normal = -normal;
  visible = uvec4(kTriangle, 0, 0, floatBitsToUint(corner.inView.z));
  colorSum = vec4(corner.albedo, 1);
  normalSum = vec4(normal, 0);
  gl_FragDepth = depthOrder(corner.inView.z);
}
