#version 450 core
// The nearest splat of every pixel, and the depth there.
#include "frame.glsl"
#include "footprint.glsl"

flat in mat3x4 packedFootprint;
flat in uvec3 splat;

layout(location = 0) out uvec4 visible;
layout(depth_less) out float gl_FragDepth;  // behind where the triangle lies

void main() {
  Footprint footprint = unpack(packedFootprint);
  float depth;
  if (distanceIn(footprint, gl_FragCoord.xy, depth) > frame.visibleShare) discard;
  gl_FragDepth = depthOrder(depth);
  visible = uvec4(splat, floatBitsToUint(depth));
}
