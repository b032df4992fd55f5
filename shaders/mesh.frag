#version 450 core
// The nearest triangle of every pixel, as if one splat lay there.
#include "frame.glsl"

in Corner {
  vec3 inView;
  vec3 normal;
  vec4 color;
} corner;

layout(location = 0) out uvec4 visible;
layout(location = 1) out vec4 colorSum;
layout(location = 2) out vec4 normalSum;

// Of the corners; where they have none or cancel out, of the triangle's plane, towards where corners turn counterclockwise
// in (x, y) seen along z.
vec3 normalHere() {
  float size = length(corner.normal);
  if (size > 0 && !isinf(size)) return corner.normal / size;
  vec3 across = cross(dFdx(corner.inView), dFdy(corner.inView));
  return normalize(gl_FrontFacing ? across : -across);
}

void main() {
  vec3 normal = normalHere();
  if (frame.isTwoSided != 0 && dot(normal, towardsEye(corner.inView)) < 0) normal = -normal;
  visible = uvec4(kTriangle, 0, 0, floatBitsToUint(corner.inView.z));
  colorSum = vec4(withSelection(corner.color.rgb, corner.color.a), 1);
  normalSum = vec4(normal, 0);
  gl_FragDepth = depthOrder(corner.inView.z);
}
