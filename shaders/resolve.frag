#version 450 core
// Normalizes, lights, draws edges and the brush: one frame in linear light, premultiplied.
#include "frame.glsl"
#include "octahedron.glsl"

layout(binding = 0) uniform usampler2D visibleTexels;
layout(binding = 1) uniform sampler2D colorSums;
layout(binding = 2) uniform sampler2D normalSums;

layout(location = 0) out vec4 result;

struct Surface {
  vec3 albedo;
  vec3 normal;
};

Surface surfaceAt(ivec2 pixel, uvec4 visible) {
  if (frame.isBlended != 0) {
    vec4 color = texelFetch(colorSums, pixel, 0), normal = texelFetch(normalSums, pixel, 0);
    return Surface(color.rgb / color.a, normal.xyz / max(length(normal.xyz), 1e-12));
  }
  return Surface(albedoOf(unpackUnorm4x8(visible.z)), fromOctahedron(unpackSnorm2x16(visible.y)));
}

// The mean depth of what is blended: smooth where discs meet at an angle.
float depthAt(ivec2 pixel, uvec4 visible) {
  float depth = uintBitsToFloat(visible.w);
  if (frame.isBlended == 0) return depth;
  return depth + texelFetch(normalSums, pixel, 0).w / texelFetch(colorSums, pixel, 0).a;
}

// How far the neighbor at `offset` lies in front.
float edgeTowards(ivec2 pixel, ivec2 offset, float depth) {
  ivec2 neighbor = pixel + offset;
  if (any(lessThan(neighbor, ivec2(0))) || any(greaterThanEqual(neighbor, ivec2(frame.sizePx)))) return 0;
  uvec4 visible = texelFetch(visibleTexels, neighbor, 0);
  if (visible.x == kNothing) return 0;
  float other = depthAt(neighbor, visible);
  float response = frame.isPerspective != 0 ? log2(depth / other) : (depth - other) * frame.focalPx / frame.sizePx.y;
  return max(response, 0);
}

// Eye-dome lighting (Boucheny 2009).
float edgeShade(ivec2 pixel, float depth) {
  float response = 0;
  for (int reach = 1; reach <= 2; ++reach) {
    response += edgeTowards(pixel, ivec2(reach, 0), depth) + edgeTowards(pixel, ivec2(-reach, 0), depth) +
                edgeTowards(pixel, ivec2(0, reach), depth) + edgeTowards(pixel, ivec2(0, -reach), depth);
  }
  return max(exp(-frame.edgeStrength * response / 8), 0.25);
}

float shadeOf(vec3 normal) {
  return frame.ambient + frame.diffuse * max(dot(normal, frame.keyLight), 0) + frame.headLight * max(-normal.z, 0);
}

vec3 drawBrush(vec3 color, vec3 inView, float depth) {
  float distancePx = (distance(inView, frame.brushCenter) - frame.brushRadius) * pixelsPerUnit(depth);
  float line = clamp(1.25 - abs(distancePx), 0, 1);
  float fill = distancePx < 0 ? 0.12 : 0;
  return mix(color, frame.brushColor, max(line, fill));
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uvec4 visible = texelFetch(visibleTexels, pixel, 0);
  result = vec4(0);
  if (visible.x == kNothing) return;
  Surface surface = surfaceAt(pixel, visible);
  float depth = depthAt(pixel, visible);
  vec3 color = surface.albedo;
  if (frame.isLit != 0) color *= shadeOf(surface.normal);
  if (frame.edgeStrength > 0) color *= edgeShade(pixel, depth);
  if (frame.brushRadius > 0) color = drawBrush(color, fromPixels(gl_FragCoord.xy, depth), depth);
  result = vec4(color, 1);
}
