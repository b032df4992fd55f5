#version 450 core
// Adds up what belongs to the visible surface: not far behind it, and not turned away from it.
#include "frame.glsl"
#include "octahedron.glsl"
#include "footprint.glsl"

flat in mat3x4 packedFootprint;
flat in uint node;
flat in vec3 normal;
flat in vec3 albedo;

layout(binding = 0) uniform usampler2D visibleTexels;

layout(location = 0) out vec4 colorSum;   // albedo * w, w
layout(location = 1) out vec4 normalSum;  // normal * w, pixels behind the visible splat * w

void main() {
  Footprint footprint = unpack(packedFootprint);
  float depth;
  float q = distanceIn(footprint, gl_FragCoord.xy, depth);
  if (q > 1) discard;
  uvec4 visible = texelFetch(visibleTexels, ivec2(gl_FragCoord.xy), 0);
  float visibleDepth = uintBitsToFloat(visible.w);
  if (visible.x != node) {
    vec3 visibleNormal = fromOctahedron(unpackSnorm2x16(visible.y));
    bool isBehind = depth > visibleDepth + frame.depthBand * footprint.radius;
    if (isBehind || dot(normal, visibleNormal) < frame.normalCosine) discard;
  }
  float share = (1 - q) * (1 - q);
  if (frame.isOneOfMany != 0) share *= share;
  float w = max(share, frame.leastWeight);
  colorSum = w * vec4(albedo, 1);
  normalSum = w * vec4(normal, (depth - visibleDepth) * pixelsPerUnit(visibleDepth));
}
